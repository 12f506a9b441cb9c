#include "vesper/sky/sky_background.hpp"

#include "vesper/astro/spherical.hpp"
#include "vesper/atmosphere/spread_light.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/sky/dark_sky_sources.hpp"
#include "vesper/sky/sky_light.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vesper {
namespace {

/// The dark sky at one place and instant.
class DarkBackground {
public:
  DarkBackground(const DarkSky& dark, const Medium& medium, const std::shared_ptr<const SkyTables>& tables,
                 Length height, const std::vector<Angle>& altitudes)
      : dark_(dark), air_(medium, height, std::nullopt), scattered_(tables, height, altitudes),
        airglow_(spread_airglow(dark, scattered_.lowest())),
        zodiacal_(spread_zodiacal_light(dark, scattered_.lowest())),
        starlight_(spread_starlight(dark, scattered_.lowest())) {
    if (dark.glow.zenith > Luminance()) {
      glow_.emplace(medium, height, dark.glow.distance);
    }
  }

  void add_to(SkyBackground& sum, std::size_t view, const Vec3& direction, Angle azimuth) const {
    const double sine = direction.z;
    sum.airglow = air_.airglow(dark_, sine) + airglow_.scattered(scattered_, view, azimuth);
    sum.zodiacal =
        air_.zodiacal_share(sine) * zodiacal_light(dark_, direction) + zodiacal_.scattered(scattered_, view, azimuth);
    sum.starlight = air_.starlight_share(sine) * faint_starlight(dark_, direction, starlight_field) +
                    starlight_.scattered(scattered_, view, azimuth);
    if (glow_) {
      sum.sky_glow = dark_.glow.zenith.to(candela_per_m2) * sky_glow_color() *
                     (dark_.glow.azimuth ? glow_->toward(sine, azimuth - *dark_.glow.azimuth) : glow_->around(sine));
    }
  }

private:
  const DarkSky& dark_;
  DarkSkyAir air_;
  SpreadLightViews scattered_;
  SpreadSource airglow_, zodiacal_, starlight_;
  std::optional<CityGlowPattern> glow_;
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
