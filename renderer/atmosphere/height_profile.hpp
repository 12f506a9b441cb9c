// How the density of a part of the air runs with height.
#pragma once

#include <vector>

namespace vesper {

/// Density by height above the ground, as a multiple of the density to which a component's coefficients belong (for
/// molecules and aerosol that at the ground).
///
/// All makers throw Error(argument) for what is not finite, negative or out of order.
class HeightProfile {
public:
  /// exp(-h / scale), the scale positive.
  [[nodiscard]] static HeightProfile exponential(double scale_km);
  /// Rises linearly from 0 at the lowest height to 1 at the peak and falls to 0 at the highest. Without thickness it
  /// holds nothing.
  [[nodiscard]] static HeightProfile tent(double lowest_km, double peak_km, double highest_km);

  enum class Between { linear, logarithmic };
  /// Densities at heights, interpolated between them and 0 outside. Heights may repeat: the density jumps there.
  /// \param heights_km at least two, not falling, from 0
  /// \param densities as many, >= 0; > 0 for logarithmic interpolation
  [[nodiscard]] static HeightProfile table(std::vector<double> heights_km, std::vector<double> densities,
                                           Between between);

  /// \param height_km >= 0
  [[nodiscard]] double at(double height_km) const;

  /// Ascending heights between which the density is smooth and changes at the pace of their distance, for quadrature.
  [[nodiscard]] const std::vector<double>& breaks_km() const { return breaks_km_; }

private:
  HeightProfile() = default;

  double scale_km_ = 0.0; ///< of the exponential, 0 for a table
  Between between_ = Between::linear;
  std::vector<double> breaks_km_; ///< the heights of a table
  std::vector<double> densities_; ///< their logarithms for logarithmic interpolation
};

} // namespace vesper
