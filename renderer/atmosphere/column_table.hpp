// Columns of air toward a distant light, looked up.
#pragma once

#include "vesper/atmosphere/sampled_air.hpp"

#include <cstddef>
#include <vector>

namespace vesper {

/// Columns of all components from a point to space, by height and zenith angle: interpolated logarithms for rays that
/// rise, and by the symmetry about the perigee for rays that pass it first. The transmittance to space of the presets
/// holds within 0.002 (tests/accuracy/light_field_test.cpp).
class ColumnTable {
public:
  explicit ColumnTable(const SampledAir& air, unsigned threads);

  /// \param radius_km within the air, from the planet's centre
  /// \return whether the ray goes free of the ground; only then the columns
  [[nodiscard]] bool to_space(double radius_km, double cos_zenith, SampledAir::PerComponent& columns_km) const;

private:
  static constexpr std::size_t heights = 256;
  static constexpr std::size_t angles = 96;

  void rising(double radius_km, double cos_zenith, SampledAir::PerComponent& columns_km) const;

  const SampledAir& air_;
  std::vector<float> logarithms_; ///< by height, angle, component
};

} // namespace vesper
