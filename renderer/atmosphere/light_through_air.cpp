#include "vesper/atmosphere/light_through_air.hpp"

#include "vesper/base/error.hpp"
#include "vesper/light/response_functions.hpp"

#include <cmath>

namespace vesper {

LightThroughAir::LightThroughAir(const Medium& medium, const Spectrum& light) {
  Vec4 all(0.0);
  for (int nm = response_first_nm; nm <= response_last_nm; ++nm) {
    const Vec4 weight = light(nm) * Vec4(cie_x_bar()(nm), cie_y_bar()(nm), cie_z_bar()(nm), cie_scotopic()(nm));
    if (weight == Vec4(0.0)) {
      continue;
    }
    all += weight;
    weights_.push_back(weight);
    std::vector<double>& extinction = extinction_per_km_.emplace_back();
    for (const MediumComponent& component : medium.components) {
      extinction.push_back(component.extinction_per_km(nm));
    }
  }
  if (!(all.x > 0.0 && all.y > 0.0 && all.z > 0.0 && all.w > 0.0)) {
    throw Error(ErrorKind::argument, "a light without any of X, Y, Z or S",
                {"", "", "Give a spectrum that is seen by day and by night"});
  }
  for (Vec4& weight : weights_) {
    weight /= all;
  }
}

Vec4 LightThroughAir::share(const std::vector<double>& columns_km) const {
  Vec4 sum(0.0);
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    double depth = 0.0;
    for (std::size_t k = 0; k < columns_km.size(); ++k) {
      depth += extinction_per_km_[i][k] * columns_km[k];
    }
    sum += std::exp(-depth) * weights_[i];
  }
  return sum;
}

} // namespace vesper
