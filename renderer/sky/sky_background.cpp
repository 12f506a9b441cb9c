#include "vesper/sky/sky_background.hpp"

#include "vesper/astro/spherical.hpp"
#include "vesper/atmosphere/spread_light.hpp"
#include "vesper/light/night_light.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/response_matrix.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/sky_light.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vesper {
namespace {

/// A source all over the sky, and what turns scattered sunlight into its own.
struct SpreadSource {
  SpreadLight light;
  Mat4 from_sunlight;
};

/// The dark sky at one place and instant.
class DarkBackground {
public:
  DarkBackground(const DarkSky& dark, const Medium& medium, const std::shared_ptr<const SkyTables>& tables,
                 Length height, const std::vector<Angle>& altitudes)
      : dark_(dark), air_(medium, height, std::nullopt), scattered_(tables, height, altitudes) {
    const Spectrum& sunlight = solar_irradiance_1au();
    static const Mat4 to_airglow = response_matrix(sunlight, airglow_spectrum());
    static const Mat4 to_zodiacal = response_matrix(sunlight, zodiacal_spectrum(0.5));
    static const Mat4 to_starlight = response_matrix(sunlight, faint_starlight_spectrum());
    const Angle lowest = scattered_.lowest();
    airglow_ = {spread_light(lowest, [&](const Vec3& at) { return airglow_above(dark, at.z).y; }), to_airglow};
    zodiacal_ = {spread_light(lowest, [&](const Vec3& at) { return zodiacal_light(dark, at).y; }), to_zodiacal};
    starlight_ = {spread_light(lowest, [&](const Vec3& at) { return faint_starlight(dark, at, spread_light_width).y; }),
                  to_starlight};
    if (dark.glow.zenith > Luminance()) {
      glow_.emplace(medium, height, dark.glow.distance);
      const Xyzs lamp = integrate_xyzs(lamp_spectrum());
      glow_zenith_ = dark.glow.zenith.to(candela_per_m2) * vector_of(lamp) / lamp.y;
    }
  }

  void add_to(SkyBackground& sum, std::size_t view, const Vec3& direction, Angle azimuth) const {
    const double sine = direction.z;
    const auto scattered = [&](const SpreadSource& source) {
      return source.from_sunlight * scattered_.luminance(view, azimuth, source.light);
    };
    sum.airglow = air_.airglow(dark_, sine) + scattered(airglow_);
    sum.zodiacal = air_.zodiacal_share(sine) * zodiacal_light(dark_, direction) + scattered(zodiacal_);
    sum.starlight =
        air_.starlight_share(sine) * faint_starlight(dark_, direction, starlight_field) + scattered(starlight_);
    if (glow_) {
      sum.sky_glow = glow_zenith_ *
                     (dark_.glow.azimuth ? glow_->toward(sine, azimuth - *dark_.glow.azimuth) : glow_->around(sine));
    }
  }

private:
  const DarkSky& dark_;
  DarkSkyAir air_;
  SpreadLightViews scattered_;
  SpreadSource airglow_, zodiacal_, starlight_;
  std::optional<CityGlowPattern> glow_;
  Vec4 glow_zenith_{};
};

} // namespace

std::vector<SkyBackground> sky_backgrounds(const SkyState& sky, const Medium& medium,
                                           const std::shared_ptr<const SkyTables>& tables,
                                           const DarkSkyOptions& options, const std::vector<Horizontal>& directions,
                                           const EclipsedSky* eclipse) {
  const Length height = height_in_air(sky.observer);
  std::vector<Angle> altitudes;
  altitudes.reserve(directions.size());
  for (const Horizontal& direction : directions) {
    altitudes.push_back(std::max(direction.altitude, Angle()));
  }
  const DarkSky dark = dark_sky(sky, options);
  const DarkBackground night(dark, medium, tables, height, altitudes);
  const std::vector<SkyLight> lights = lights_of(sky, SunInEclipse::outside_the_shadow);
  std::vector<SkyBackground> backgrounds(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    SkyBackground& sum = backgrounds[i];
    const Angle azimuth = directions[i].azimuth;
    const Vec3 direction = unit_vector((90.0 * deg - azimuth).to(rad), altitudes[i].to(rad));
    night.add_to(sum, i, direction, azimuth);
    for (const SkyLight& light : lights) {
      const Xyzs above = sky_luminance(*tables, {height, light.direction, light.angular_radius, direction});
      (light.name == "sun" ? sum.sun : sum.moon) = from_table_light(light) * vector_of(above);
    }
    if (eclipse != nullptr) {
      sum.sun *= Vec4(eclipse->ratios(direction).all);
    }
  }
  return backgrounds;
}

} // namespace vesper
