#include "report/light_columns.hpp"

#include "report/sky_light.hpp"

#include "vesper/atmosphere/random_stream.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/light/spectral_weights.hpp"
#include "vesper/light/sunlight.hpp"

#include <array>
#include <bit>

namespace vesper {
namespace {

enum Measure : std::uint64_t { illuminance, zenith_luminance };

/// A stream of random numbers of this scene's own.
std::uint64_t stream_of(const SkyState& sky, Measure measure, std::size_t light) {
  std::uint64_t stream = 2 * measure + light;
  for (const double part : {sky.instant.tt.value(), sky.observer.latitude.to(deg), sky.observer.longitude.to(deg),
                            sky.observer.height.to(metre)}) {
    stream = RandomStream::mix(stream ^ std::bit_cast<std::uint64_t>(part));
  }
  return stream;
}

/// Sun and Moon, each to be seen by the eye.
std::vector<WeightedLight> lights_for_eyes(const ReportedScene& scene, Measure measure) {
  std::vector<WeightedLight> weighted;
  for (SkyLight& light : lights_of(scene.sky)) {
    const std::vector<double> y = spectral_weights(light.irradiance, scene.air.transport().wavelengths_nm()).y;
    const std::uint64_t stream = stream_of(scene.sky, measure, light.name == "sun" ? 0 : 1);
    weighted.push_back({std::move(light), {y}, stream});
  }
  return weighted;
}

// A hundredth of the darkest night. What is fainter would take long to be known as well, and nobody could tell.
constexpr double faint_lux = 6.0e-6;
constexpr double faint_cd_m2 = 1.7e-6;

double horizontal_illuminance_lux(const ReportedScene& scene) {
  return level_light(scene.air.transport(), height_in_air(scene.sky.observer), lights_for_eyes(scene, illuminance),
                     {scene.air.budget(), faint_lux})
      .total.mean;
}

double zenith_luminance_cd_m2(const ReportedScene& scene) {
  return sky_radiance(scene.air.transport(), height_in_air(scene.sky.observer), {0.0, 0.0, 1.0},
                      lights_for_eyes(scene, zenith_luminance), 1, {scene.air.budget(), faint_cd_m2})
      .quantities[0]
      .mean;
}

double zenith_extinction(const ReportedScene& scene) {
  return zenith_extinction_v_mag(scene.air.medium(), height_in_air(scene.sky.observer), solar_irradiance_1au());
}

constexpr std::array columns{
    SceneColumn{"zenith_extinction_v_mag", zenith_extinction},
    SceneColumn{"horizontal_illuminance_lux", horizontal_illuminance_lux, true},
    SceneColumn{"zenith_luminance_cd_m2", zenith_luminance_cd_m2, true},
};

} // namespace

std::span<const SceneColumn> light_columns() { return columns; }

} // namespace vesper
