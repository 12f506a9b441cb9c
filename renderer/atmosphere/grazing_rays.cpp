#include "vesper/atmosphere/grazing_rays.hpp"

#include "vesper/astro/air_profile.hpp"
#include "vesper/astro/refraction_trace.hpp"
#include "vesper/atmosphere/refracted_columns.hpp"
#include "vesper/base/shader_math.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vesper {
namespace {

/// Where rays are followed from: above it nothing bends or takes light that counts.
constexpr double outside_km = 100.0;

double step_km(double height_km) { return 0.01 * std::max(1.0, std::pow(height_km / 20.0, 2.0)); }

} // namespace

std::vector<GrazingRay> grazing_rays(const Medium& medium) {
  const RefractionConditions conditions = standard_conditions(outside_km * kilometre);
  const AirProfile air(conditions);
  const RefractionTracer tracer(conditions, fast_trace);
  const RefractedColumns columns(medium, outside_km * kilometre, conditions);
  const auto impact = [&](double radius_km, double height_km) {
    return (1.0 + air.at(height_km).refractivity) * (radius_km + height_km);
  };
  const auto altitude = [&](double radius_km, double height_km) {
    return -std::acos(std::min(impact(radius_km, height_km) / impact(radius_km, outside_km), 1.0));
  };
  const double medium_radius_km = medium.ground_radius.to(kilometre);

  std::vector<GrazingRay> rays;
  double height = 0.0;
  while (height < outside_km) {
    rays.push_back({height, impact(f64::earth_radius_km, height), 0.0,
                    tracer.trace(altitude(f64::earth_radius_km, height) * rad).refraction.to(rad),
                    columns.columns_km(std::sin(altitude(medium_radius_km, height)))});
    height += step_km(height);
  }
  // The trapezoidal rule.
  for (std::size_t i = 0; i + 1 < rays.size(); ++i) {
    const double half = 0.5 * (rays[i + 1].impact_km - rays[i].impact_km);
    rays[i].impact_step_km += half;
    rays[i + 1].impact_step_km += half;
  }
  return rays;
}

} // namespace vesper
