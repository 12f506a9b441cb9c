#include "report/dark_light.hpp"

#include "vesper/base/gauss_legendre.hpp"
#include "vesper/light/night_light.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/response_matrix.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/sky_light.hpp"

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

/// \param luminance above the air, cd/m2 \param direct X, Y, Z, S of what comes through of it in the zenith
/// \param share of it that comes through at a sine of altitude
DarkSourceLight source_light(const DarkAir& air, const Mat4& from_sunlight, const Vec4& direct,
                             const std::function<double(const Vec3&)>& luminance,
                             const std::function<double(double)>& share) {
  const SpreadLight light = spread_light(air.scattered.lowest(), luminance);
  const Vec4 zenith_light = direct + from_sunlight * air.scattered.luminance(0, Angle(), light);
  DarkSourceLight sum{(from_sunlight * air.scattered.illuminance(light)).y, zenith_light.y, zenith_light.w};
  for (const SpreadLight::Ring& ring : light.rings) {
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
  const Spectrum& sunlight = solar_irradiance_1au();
  static const Mat4 to_airglow = response_matrix(sunlight, airglow_spectrum());
  static const Mat4 to_zodiacal = response_matrix(sunlight, zodiacal_spectrum(0.5));
  static const Mat4 to_starlight = response_matrix(sunlight, faint_starlight_spectrum());
  DarkLight light;
  light.airglow = source_light(
      air, to_airglow, air.direct.airglow(dark, 1.0), [&](const Vec3& at) { return airglow_above(dark, at.z).y; },
      [&](double sine) { return air.direct.airglow(dark, sine).y / airglow_above(dark, sine).y; });
  light.zodiacal = source_light(
      air, to_zodiacal, air.direct.zodiacal_share(1.0) * zodiacal_light(dark, zenith),
      [&](const Vec3& at) { return zodiacal_light(dark, at).y; },
      [&](double sine) { return air.direct.zodiacal_share(sine).y; });
  light.starlight = source_light(
      air, to_starlight, air.direct.starlight_share(1.0) * faint_starlight(dark, zenith),
      [&](const Vec3& at) { return faint_starlight(dark, at).y; },
      [&](double sine) { return air.direct.starlight_share(sine).y; });
  const double glow = air.glow_lux > 0.0 ? options.glow.zenith.to(candela_per_m2) : 0.0;
  static const double lamp_sp_ratio = integrate_xyzs(lamp_spectrum()).s / integrate_xyzs(lamp_spectrum()).y;
  light.sky_glow = {glow * air.glow_lux, glow, glow * lamp_sp_ratio};
  return light;
}

} // namespace vesper
