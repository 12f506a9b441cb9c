// A coarse solution of the light transport, made to tell random paths where the light is.
#pragma once

#include "vesper/atmosphere/random_stream.hpp"
#include "vesper/atmosphere/spectral_air.hpp"
#include "vesper/base/vector.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace vesper {

/// Light of a parallel beam of irradiance 1 over height and solar zenith angle, at a few wavelengths of a medium:
/// transmitted, scattered, and the directions that scattered light comes from. Good to some ten percent, a guess of
/// density for importance sampling and of nothing else: its sources scatter alike into all directions, but for the
/// beam's own light.
class TransportGuide {
public:
  static constexpr std::size_t most_wavelengths = 4;
  /// A number a wavelength of the guide.
  using Values = std::array<double, most_wavelengths>;

  /// \param wavelengths which of the optics' wavelengths, 1 to most_wavelengths
  TransportGuide(const SampledAir& air, const SpectralAir& optics, std::vector<std::size_t> wavelengths,
                 unsigned threads);

  [[nodiscard]] const std::vector<std::size_t>& wavelengths() const { return wavelengths_; }

  struct Light {
    Values beam;      ///< transmittance to the light
    Values scattered; ///< mean radiance of scattered and reflected light over the sphere
  };
  [[nodiscard]] Light light(double radius_km, double cos_light_zenith) const;

  /// Irradiance of the ground, direct and diffuse.
  [[nodiscard]] Values ground_irradiance(double cos_light_zenith) const;

  /// A direction at a point that favours where light comes from. Directions are by cosine of the zenith angle and
  /// azimuth from the light's.
  struct Direction {
    double cos_zenith;
    double azimuth_rad;
  };
  /// A cell of the guide, for its histogram of directions.
  [[nodiscard]] std::size_t cell(double radius_km, double cos_light_zenith) const;
  /// \return whether any light arrives in this cell at the guide's wavelength k; without it there is nothing to sample
  [[nodiscard]] bool lit(std::size_t cell, std::size_t k) const;
  [[nodiscard]] Direction sample(std::size_t cell, std::size_t k, RandomStream& random) const;
  /// Density of `sample`, 1/sr; 0 in unlit cells.
  [[nodiscard]] Values density(std::size_t cell, Direction direction) const;

private:
  static constexpr std::size_t heights = 24;
  static constexpr std::size_t angles = 129; ///< in equal steps of the cosine of the light's zenith angle, -1 to 1
  static constexpr std::size_t below_bins = 10;
  static constexpr std::size_t above_bins = 14;
  static constexpr std::size_t zenith_bins = below_bins + above_bins;
  static constexpr std::size_t azimuth_bins = 8; ///< from the light's azimuth to its opposite, on both sides
  static constexpr std::size_t bins = zenith_bins * azimuth_bins;

  struct Corner {
    std::size_t height;
    std::size_t angle;
    double height_fraction;
    double angle_fraction;
  };
  struct Step;
  struct ViewRay;
  struct LightPlace;
  /// Of all light that arrives at a cell: its mean radiance over the sphere, and what it gives a level surface.
  struct Gathered {
    Values mean;
    Values irradiance;
  };

  struct HeightPlace {
    std::size_t below;
    double fraction;
  };
  [[nodiscard]] HeightPlace height_place(double height_km) const;
  [[nodiscard]] static Corner corner(HeightPlace height, double cos_light_zenith);
  [[nodiscard]] std::size_t zenith_bin(std::size_t height, double cos_zenith) const;
  [[nodiscard]] Values between(const std::vector<Values>& table, const Corner& corner) const;
  [[nodiscard]] static Values on_ground(const std::vector<Values>& by_angle, double cos_light_zenith);
  [[nodiscard]] static double cos_light_zenith(std::size_t angle);
  [[nodiscard]] double bin_cos_zenith(std::size_t height, std::size_t zenith_bin) const;
  [[nodiscard]] double bin_sr(std::size_t height, std::size_t zenith_bin) const;

  void solve_beam(unsigned threads);
  void solve_scattered(unsigned threads);
  /// Fills the cell's histogram with radiance(view, light, place in `cumulative_` for the first wavelength).
  template <class Radiance>
  [[nodiscard]] Gathered gather(std::size_t cell, const std::vector<ViewRay>& views, Radiance&& radiance);
  /// Turns histograms into sums over their bins, up to 1.
  void accumulate_histograms();
  [[nodiscard]] ViewRay view_ray(std::size_t height, std::size_t zenith_bin) const;
  // Radiance along a view: what the ground sends of an irradiance by angle, what the air and the ground send of the
  // beam, and of the light that they have scattered before.
  [[nodiscard]] Values reflected(const ViewRay& view, const LightPlace& light,
                                 const std::vector<Values>& irradiance) const;
  [[nodiscard]] Values scattered_once(const ViewRay& view, const LightPlace& light,
                                      const std::vector<Values>& ground) const;
  [[nodiscard]] Values scattered_again(const ViewRay& view, const LightPlace& light, const std::vector<Values>& mean,
                                       const std::vector<Values>& ground) const;

  const SampledAir& air_;
  const SpectralAir& optics_;
  std::vector<std::size_t> wavelengths_;
  std::array<double, heights> heights_km_{};
  std::vector<unsigned char> height_below_; ///< by height in small steps: the next node at or below
  std::array<std::array<double, zenith_bins + 1>, heights> zenith_edges_{}; ///< cosines, ascending
  std::vector<Values> beam_;                                                ///< by height, then angle
  std::vector<Values> scattered_;                                           ///< likewise
  std::vector<Values> ground_;                                              ///< by angle
  std::vector<float> cumulative_; ///< by cell, wavelength, bin; up to 1, or all 0
};

inline TransportGuide::Corner TransportGuide::corner(HeightPlace height, double cos_light_zenith) {
  const double place = std::clamp(0.5 * (cos_light_zenith + 1.0), 0.0, 1.0) * static_cast<double>(angles - 1);
  const auto below = std::min(static_cast<std::size_t>(place), angles - 2);
  return {height.below, below, height.fraction, place - static_cast<double>(below)};
}

inline TransportGuide::Values TransportGuide::between(const std::vector<Values>& table, const Corner& corner) const {
  const Values* low = &table[corner.height * angles + corner.angle];
  const Values* high = low + angles;
  const double t = corner.angle_fraction;
  const double s = corner.height_fraction;
  Values result{};
  for (std::size_t k = 0; k < most_wavelengths; ++k) {
    const double below = low[0][k] + t * (low[1][k] - low[0][k]);
    const double above = high[0][k] + t * (high[1][k] - high[0][k]);
    result[k] = below + s * (above - below);
  }
  return result;
}

} // namespace vesper
