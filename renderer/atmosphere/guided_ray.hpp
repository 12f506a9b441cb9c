// Where along a ray a random path goes on: more often where light reaches the ray from.
#pragma once

#include "vesper/atmosphere/transport_guide.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace vesper {

/// A straight ray with densities of its places, one density for each of the guide's wavelengths. Nine tenths of each go
/// after the light that the guide expects from there, a tenth after the matter that scatters alone, so that no place
/// which sends light is left out. The ground, where it ends the ray, is a place of its own.
class GuidedRay {
public:
  using Values = TransportGuide::Values;

  GuidedRay(const SampledAir& air, const SpectralAir& optics, const TransportGuide& guide, const Vec3& light_direction);

  /// \param origin_km from the planet's centre, not below the ground but by rounding
  void lay(const Vec3& origin_km, const Vec3& direction);

  [[nodiscard]] const Vec3& direction() const { return direction_; }

  struct Place {
    Vec3 place_km; ///< from the planet's centre
    double radius_km = 0.0;
    bool on_ground = false;
    SampledAir::PerComponent columns_km{}; ///< from the ray's origin
    Values density{};                      ///< 1/km; on the ground a plain probability
  };
  /// None where nothing on the ray scatters.
  /// \param k of the guide's wavelengths
  /// \param u uniform in [0, 1)
  [[nodiscard]] std::optional<Place> draw(std::size_t k, double u) const;

private:
  /// A piece within which places are drawn evenly; the ground has no length.
  struct Cell {
    double from_km = 0.0;
    double to_km = 0.0;
    SampledAir::PerComponent columns_km{}; ///< from the ray's begin to from_km
    Values guided{};                       ///< weight after the guide's light
    Values plain{};                        ///< weight as if light were everywhere alike
  };
  /// What has been passed on the way to the cells that are not there yet.
  struct Passed {
    SampledAir::PerComponent columns_km{};
    Values optical_depth{};
  };

  [[nodiscard]] double cos_light_zenith(double place_km) const;
  void find_phases();
  void add_cell(double from_km, double to_km, Passed& passed);
  void add_ground(const Passed& passed);
  void add(const Cell& cell);
  [[nodiscard]] double share(const Cell& cell, std::size_t k) const;

  const SampledAir& air_;
  const SpectralAir& optics_;
  const TransportGuide& guide_;
  Vec3 light_direction_;
  // At the guide's wavelengths, by component.
  std::array<Values, SampledAir::most_components> scattering_per_km_{};
  std::array<Values, SampledAir::most_components> extinction_per_km_{};

  AirRay ray_;
  Vec3 origin_km_{};
  Vec3 direction_{};
  double cos_light_ = 0.0;          ///< of the angle between ray and light
  double light_at_origin_km_ = 0.0; ///< how far the origin lies from the centre toward the light
  std::array<Values, SampledAir::most_components> phase_{};
  std::vector<Cell> cells_;
  Values guided_sum_{};
  Values plain_sum_{};
};

} // namespace vesper
