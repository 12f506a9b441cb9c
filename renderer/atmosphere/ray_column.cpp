#include "vesper/atmosphere/ray_column.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vesper {

void append_cuts(std::vector<double>& cuts, const HeightProfile& profile, const RaySpan& span, double ground_km) {
  const auto append = [&](double cut) {
    if (cut > span.begin_km && cut < span.end_km) {
      cuts.push_back(cut);
    }
  };
  append(0.0);
  for (const double height_km : profile.breaks_km()) {
    const double cut = crossing_km(span.perigee_km, ground_km + height_km);
    append(cut);
    append(-cut);
  }
}

Integral column(const HeightProfile& profile, const RaySpan& span, double ground_km) {
  std::vector<double> cuts{span.begin_km, span.end_km};
  append_cuts(cuts, profile, span, ground_km);
  std::sort(cuts.begin(), cuts.end());
  const auto density = [&](double s) { return profile.at(std::max(std::hypot(span.perigee_km, s) - ground_km, 0.0)); };
  Integral sum;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (cuts[i] > cuts[i - 1]) {
      const Integral piece = integrate(density, cuts[i - 1], cuts[i]);
      sum.value += piece.value;
      sum.error += piece.error;
    }
  }
  return sum;
}

} // namespace vesper
