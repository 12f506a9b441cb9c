// Scattered light in the air under a distant light, solved once for all places: what light is scattered anew from.
#pragma once

#include "vesper/atmosphere/light_field_solution.hpp"
#include "vesper/atmosphere/sky_query.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace vesper {

/// Light above an irradiance of 1, of all orders of scattering and reflection, by angular moments.
///
/// What molecules scatter needs no more of the radiance around a place than its mean and second moments; what aerosol
/// scatters is kept by direction (shaders/lib/light_field.glsl). The field is iterated by orders; the first, the
/// light's own, is scattered exactly where it meets the observer. How near that comes to the reference transport stands
/// in docs/ACCURACY.md, light field.
class LightField {
public:
  static constexpr std::size_t most_wavelengths = LightFieldModel::most_wavelengths;

  /// Solves the field, in seconds. `air` and `optics` are of one medium and outlive this object.
  /// \param threads 0 for one per core; the result does not depend on it
  /// Throws Error(argument) for more wavelengths than that and for a size out of its range.
  LightField(const SampledAir& air, const SpectralAir& optics, const LightFieldSize& size = {}, unsigned threads = 0);
  /// Takes a solution of the model's.
  LightField(LightFieldModel model, LightFieldSolution solution);

  /// Radiance of all orders toward an observer, 1/sr, at the optics' wavelengths; where the horizon cuts the light it
  /// is a disc of the query's radius. Throws Error(argument) for a query out of its range (sky_query.hpp).
  [[nodiscard]] std::vector<double> radiance(const SkyQuery& query) const;

  /// Irradiance of level ground by scattered light.
  [[nodiscard]] std::vector<double> diffuse_irradiance(double cos_light_zenith) const;

  /// A ray toward an observer, with what does not depend on where the light stands.
  struct ViewRay {
    LightRay direct; ///< in fine steps, for the light's own
    LightRay later;  ///< for what was scattered before, which is smoother
  };
  /// \param radius_km of the observer from the planet's centre, any not below the ground
  [[nodiscard]] ViewRay view_ray(double radius_km, double cos_zenith) const;

  /// Radiance, 1/sr, by wavelength; behind the last of the optics' wavelengths without meaning.
  using Spectrum = std::array<float, most_wavelengths>;
  struct RayLight {
    Spectrum single_aerosol{}; ///< scattered once, by what is no molecule
    Spectrum other{};          ///< all other light from the air
    Spectrum ground{};         ///< what the ground at the ray's far end sends through the air
  };
  /// Radiance along the ray; the light's azimuth is counted from the ray's.
  [[nodiscard]] RayLight light(const ViewRay& ray, double cos_light_zenith, double cos_azimuth,
                               Angle light_angular_radius) const;

  /// How many orders were followed, and by which share of the light at any node the estimate of the later may be wrong.
  [[nodiscard]] int orders() const { return solution_.orders; }
  [[nodiscard]] double rest() const { return solution_.rest; }

private:
  LightFieldModel model_;
  LightFieldSolution solution_;
};

} // namespace vesper
