// One random path of light, followed backward from the observer at all wavelengths at once.
#pragma once

#include "vesper/atmosphere/guided_ray.hpp"
#include "vesper/atmosphere/random_stream.hpp"
#include "vesper/atmosphere/sky_query.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace vesper {

/// Backward paths for one query; one object a thread.
///
/// A path draws its next place along a ray after the guide's light there, and its next direction after the phase
/// functions or the guide's histogram. It draws for one of the guide's wavelengths, and each wavelength of the optics
/// weighs what it finds by the mean over all the guide's wavelengths of how likely the path was: the balance heuristic
/// (Veach 1997, thesis, ch. 9; Wilkie et al. 2014, Comput. Graph. Forum 33, 123, for wavelengths). Absorption is in
/// the weights; paths end by Russian roulette.
class PathTracer {
public:
  PathTracer(const SampledAir& air, const SpectralAir& optics, const TransportGuide& guide, const SkyQuery& query,
             int orders);

  enum class Quantity { radiance, irradiance };
  /// Sets `result` to what one path finds, a value a wavelength, above an irradiance of 1.
  /// \param k the wavelength of the guide to draw for
  void trace(Quantity quantity, std::size_t k, RandomStream& random, std::span<double> result);

private:
  using Values = TransportGuide::Values;

  struct Vertex {
    Vec3 place_km;
    double radius_km;
    Vec3 direction; ///< of the ray that came here
    bool on_ground;
    SampledAir::PerComponent density; ///< not on the ground
  };
  /// Axes at a point: z to the zenith, x toward the light's azimuth.
  struct LocalFrame {
    Vec3 x, y, z;
    double cos_light_zenith;
  };

  [[nodiscard]] bool next_place(const GuidedRay& ray, std::size_t k, RandomStream& random, Vertex& vertex);
  [[nodiscard]] bool next_direction(const Vertex& vertex, std::size_t k, RandomStream& random, Vec3& direction);
  [[nodiscard]] Vec3 any_direction(const Vertex& vertex, const LocalFrame& frame, std::size_t k,
                                   RandomStream& random) const;
  [[nodiscard]] bool survives(const Vertex& vertex, std::size_t k, RandomStream& random);
  void add_light(const Vertex& vertex, RandomStream& random, std::span<double> result);
  void scatter(const Vertex& vertex, const Vec3& toward, std::span<double> values) const;
  [[nodiscard]] Vec3 toward_light(RandomStream& random) const;
  [[nodiscard]] LocalFrame frame_at(const Vec3& place_km, double radius_km) const;
  void drawn(const Values& density, std::size_t k);

  const SampledAir& air_;
  const SpectralAir& optics_;
  const TransportGuide& guide_;
  SkyQuery query_;
  int orders_;
  double light_cos_radius_;
  Vec3 observer_km_;
  GuidedRay first_; ///< of a radiance: the same for all its paths
  GuidedRay ray_;
  std::vector<double> throughput_; ///< over the density of the path for the wavelength it is drawn for
  Values likelihood_{};            ///< density of the path for each of the guide's wavelengths, over the same
  std::vector<double> scattered_;  ///< scratch
};

} // namespace vesper
