#include "report/dark_light.hpp"

#include "vesper/base/gauss_legendre.hpp"
#include "vesper/sky/dark_sky_sources.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

namespace vesper {
namespace {

const Vec3 zenith(0.0, 0.0, 1.0);

double glow_illuminance(const Medium& medium, Length height, Length distance) {
  const CityGlowPattern pattern(medium, height, distance);
  double lux_sum = 0.0;
  for (const QuadratureNode& node : gauss_legendre(12)) {
    // The square of the sine, over which a level surface sees the sky evenly.
    lux_sum += node.weight * std::numbers::pi * pattern.around(std::sqrt(node.place));
  }
  return lux_sum;
}

/// \param direct X, Y, Z, S in cd/m2 of what comes through the air from the zenith
/// \param share that comes through at a sine of altitude
DarkSourceLight source_light(const DarkAir& air, const SpreadSource& source, const Vec4& direct,
                             const std::function<double(double)>& share) {
  const Vec4 zenith_light = direct + source.scattered(air.scattered, 0, Angle());
  DarkSourceLight sum{(source.from_sunlight * air.scattered.illuminance(source.light)).y, zenith_light.y,
                      zenith_light.w};
  for (const SpreadLight::Ring& ring : source.light.rings) {
    const double sine = std::sin(ring.altitude.to(rad));
    sum.illuminance_lux += sine > 0.0 ? sine * ring.even * share(sine) : 0.0;
  }
  return sum;
}

} // namespace

DarkAir::DarkAir(const Medium& medium, std::shared_ptr<const SkyTables> tables, Length height, const CityGlow& glow)
    : direct(medium, height, std::nullopt), scattered(std::move(tables), height, {90.0 * deg}),
      glow_lux(glow.zenith > Luminance() ? glow_illuminance(medium, height, glow.distance) : 0.0) {}

DarkSourceLight DarkLight::sum() const {
  DarkSourceLight all;
  for (const DarkSourceLight& part : {airglow, zodiacal, starlight, sky_glow}) {
    all.illuminance_lux += part.illuminance_lux;
    all.zenith_luminance_cd_m2 += part.zenith_luminance_cd_m2;
    all.zenith_scotopic_cd_m2 += part.zenith_scotopic_cd_m2;
  }
  return all;
}

DarkLight dark_light(const SkyState& sky, const DarkAir& air, const DarkSkyOptions& options) {
  const DarkSky dark = dark_sky(sky, options);
  const Angle lowest = air.scattered.lowest();
  DarkLight light;
  light.airglow = source_light(air, spread_airglow(dark, lowest), air.direct.airglow(dark, 1.0), [&](double sine) {
    return air.direct.airglow(dark, sine).y / airglow_above(dark, sine).y;
  });
  light.zodiacal = source_light(air, spread_zodiacal_light(dark, lowest),
                                air.direct.zodiacal_share(1.0) * zodiacal_light(dark, zenith),
                                [&](double sine) { return air.direct.zodiacal_share(sine).y; });
  light.starlight = source_light(air, spread_starlight(dark, lowest),
                                 air.direct.starlight_share(1.0) * faint_starlight(dark, zenith, starlight_field),
                                 [&](double sine) { return air.direct.starlight_share(sine).y; });
  const double glow = air.glow_lux > 0.0 ? options.glow.zenith.to(candela_per_m2) : 0.0;
  light.sky_glow = {glow * air.glow_lux, glow, glow * sky_glow_color().w};
  return light;
}

} // namespace vesper
