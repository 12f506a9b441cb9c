#include "vesper/atmosphere/height_profile.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace vesper {

HeightProfile HeightProfile::exponential(double scale_km) {
  if (!(scale_km > 0.0) || !std::isfinite(scale_km)) {
    throw Error(ErrorKind::argument, "a scale height of " + std::to_string(scale_km) + " km",
                {"", "", "Give a positive height"});
  }
  HeightProfile profile;
  profile.scale_km_ = scale_km;
  // A thin layer under a high top would slip between the nodes of a quadrature that does not know its scale. Beyond
  // 64 scale heights the density is below 1e-27.
  profile.breaks_km_ = {scale_km, 4.0 * scale_km, 16.0 * scale_km, 64.0 * scale_km};
  return profile;
}

HeightProfile HeightProfile::tent(double lowest_km, double peak_km, double highest_km) {
  return table({lowest_km, peak_km, highest_km}, {0.0, 1.0, 0.0}, Between::linear);
}

HeightProfile HeightProfile::table(std::vector<double> heights_km, std::vector<double> densities, Between between) {
  if (heights_km.size() < 2 || heights_km.size() != densities.size()) {
    throw Error(ErrorKind::argument,
                "a profile of " + std::to_string(heights_km.size()) + " heights and " +
                    std::to_string(densities.size()) + " densities",
                {"", "", "Give at least two heights and one density for each"});
  }
  for (std::size_t i = 0; i < heights_km.size(); ++i) {
    const double floor_km = i == 0 ? 0.0 : heights_km[i - 1];
    if (!(heights_km[i] >= floor_km) || !std::isfinite(heights_km[i])) {
      throw Error(ErrorKind::argument,
                  "height " + std::to_string(heights_km[i]) + " km of a profile after " + std::to_string(floor_km),
                  {"", "", "Give heights from 0 upwards, in order"});
    }
    const bool possible = between == Between::linear ? densities[i] >= 0.0 : densities[i] > 0.0;
    if (!possible || !std::isfinite(densities[i])) {
      throw Error(ErrorKind::argument,
                  "density " + std::to_string(densities[i]) + " at " + std::to_string(heights_km[i]) + " km",
                  {"", "", "Give densities that are not negative, positive ones for logarithmic interpolation"});
    }
  }
  HeightProfile profile;
  profile.between_ = between;
  profile.breaks_km_ = std::move(heights_km);
  profile.densities_ = std::move(densities);
  if (between == Between::logarithmic) {
    for (double& density : profile.densities_) {
      density = std::log(density);
    }
  }
  return profile;
}

double HeightProfile::at(double height_km) const {
  if (scale_km_ > 0.0) {
    return std::exp(-height_km / scale_km_);
  }
  const std::vector<double>& heights = breaks_km_;
  if (!(height_km >= heights.front() && height_km < heights.back())) {
    return 0.0;
  }
  const auto i =
      static_cast<std::size_t>(std::upper_bound(heights.begin(), heights.end(), height_km) - heights.begin());
  const double t = (height_km - heights[i - 1]) / (heights[i] - heights[i - 1]);
  const double value = densities_[i - 1] + t * (densities_[i] - densities_[i - 1]);
  return between_ == Between::linear ? value : std::exp(value);
}

} // namespace vesper
