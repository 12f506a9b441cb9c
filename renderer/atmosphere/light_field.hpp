// Scattered light in the air under a distant light, solved once for all places: what light is scattered anew from.
#pragma once

#include "vesper/atmosphere/column_table.hpp"
#include "vesper/atmosphere/sky_query.hpp"
#include "vesper/atmosphere/spectral_air.hpp"
#include "vesper/base/vector.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vesper {

/// How finely a light field is solved.
struct LightFieldSize {
  std::size_t heights = 24;
  std::size_t zeniths = 20;  ///< directions above and below the horizon together
  std::size_t azimuths = 8;  ///< over half a turn
  double step_growth = 0.15; ///< a step's rise over its height
  double least_step_km = 0.3;
  int orders = 10;
};

/// Light above an irradiance of 1, of all orders of scattering and reflection, by angular moments.
///
/// What molecules scatter needs no more of the radiance around a place than its mean and second moments: with them
/// Rayleigh's phase function is exact. What aerosol scatters is kept by direction. Both are held as logarithms by
/// height and by the light's zenith angle, between which light that falls exponentially is linear. The field is
/// iterated by orders; the first, the light's own, is scattered exactly where it meets the observer. How near that
/// comes to the reference transport stands in docs/ACCURACY.md, light field.
class LightField {
public:
  static constexpr std::size_t most_wavelengths = 64;

  /// Solves the field, in seconds. `air` and `optics` are of one medium and outlive this object.
  /// \param threads 0 for one per core; the result does not depend on it
  /// Throws Error(argument) for more wavelengths than that.
  LightField(const SampledAir& air, const SpectralAir& optics, const LightFieldSize& size = {}, unsigned threads = 0);

  /// Radiance of all orders toward an observer, 1/sr, at the optics' wavelengths; where the horizon cuts the light it
  /// is a disc of the query's radius. Throws Error(argument) for a query out of its range (sky_query.hpp).
  [[nodiscard]] std::vector<double> radiance(const SkyQuery& query) const;

  /// Irradiance of level ground by scattered light.
  [[nodiscard]] std::vector<double> diffuse_irradiance(double cos_light_zenith) const;

  /// A ray toward an observer, with what does not depend on where the light stands.
  struct ViewRay;
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

private:
  // The moments of a place, over axes z to the zenith and x to the light's azimuth: the logarithm to base 2 of the mean
  // radiance over the sphere, and the means of products of direction cosines, weighted by radiance.
  enum Moment : std::size_t { mean_log2, xx, zz, xz, moments };

  // Directions of aerosol's sources: nodes in a coordinate that crowds at the horizon, and evenly in azimuth. J is the
  // mean radiance, weighted by the phase functions of what scatters at the node's height.
  static constexpr std::size_t nodes_below = 5;
  static constexpr std::size_t nodes_above = 9;
  static constexpr std::size_t zenith_nodes = nodes_below + nodes_above + 1;
  static constexpr std::size_t azimuth_nodes = 7;
  static constexpr std::size_t source_directions = zenith_nodes * azimuth_nodes;

  struct Place {
    std::size_t height;
    double height_fraction;
  };
  struct Step {
    double radius_km;
    Place place;
    double view_z;       ///< cosine of the view direction's zenith angle there
    double zenith_place; ///< of the view direction among the nodes of aerosol's sources
    // cos of the light's zenith angle there = from_vertical * cos(that at the origin)
    //                                       + from_level * sin(the same) * cos(azimuth from the light)
    double from_vertical;
    double from_level;
  };

  struct Corner {
    std::size_t node; ///< of the lower height and angle
    float height_fraction;
    float angle_fraction;
  };

  [[nodiscard]] Place place(double height_km) const;
  [[nodiscard]] Corner corner(const Place& place, double cos_light_zenith) const;
  [[nodiscard]] double node_height_km(std::size_t i) const;
  [[nodiscard]] ViewRay view_ray(double radius_km, double cos_zenith, double growth, double least_km) const;
  [[nodiscard]] double visible_light(double radius_km, double cos_light_zenith, double light_radius_rad) const;
  void add_direct(const ViewRay& ray, double cos_light_zenith, double sin_light_zenith, double cos_azimuth,
                  double light_radius_rad, float* by_molecules, float* by_aerosol, float* by_ground) const;
  void add_scattered(const ViewRay& ray, double cos_light_zenith, double sin_light_zenith, double cos_azimuth,
                     float* by_air, float* by_ground) const;
  [[nodiscard]] double dip(double radius_km) const;
  [[nodiscard]] static double zenith_place(double altitude_rad, double dip_rad);
  [[nodiscard]] static double node_altitude(std::size_t zenith_node, double dip_rad);
  [[nodiscard]] std::vector<float> phase_matrix(std::size_t height, const std::vector<Vec2>& directions,
                                                std::size_t azimuths) const;
  void solve(const LightFieldSize& size, unsigned threads);

  const SampledAir& air_;
  const SpectralAir& optics_;
  ColumnTable columns_;
  std::size_t lanes_;                ///< wavelengths, rounded up to a multiple of 4
  std::vector<bool> molecular_;      ///< by component: its phase function is Rayleigh's
  std::vector<float> second_moment_; ///< Legendre's of molecules, by wavelength
  std::size_t heights_;
  std::vector<double> angle_cos_; ///< of the nodes, falling
  std::vector<std::uint16_t> angle_lookup_;
  std::vector<float> aerosol_; ///< logarithm to base 2 of J below, by height, angle, direction, wavelength
  std::vector<float> field_;   ///< by height, angle, moment, wavelength
  std::vector<float> ground_;  ///< logarithm to base 2 of the ground's diffuse irradiance, by angle and wavelength
};

/// What sources along a ray send to its origin.
struct LightField::ViewRay {
  double cos_zenith = 1.0;
  double sin_zenith = 0.0;
  std::vector<Step> steps;
  /// A step: molecules' and aerosol's scattering, then that of each component; lanes each.
  std::vector<float> weights;
  bool meets_ground = false;
  Step ground{};
  std::vector<float> ground_weights; ///< transmittance times albedo over pi
};

} // namespace vesper
