// The light of cities in the air above them.
#pragma once

#include "vesper/atmosphere/medium.hpp"
#include "vesper/base/units.hpp"

#include <optional>
#include <vector>

namespace vesper {

/// Distances to a city that its law holds for, and between which a city is seen at all.
inline constexpr double nearest_city_km = 1.0;
inline constexpr double farthest_city_km = 300.0;

/// What is said of artificial light: how bright it makes the zenith, and where it comes from.
struct CityGlow {
  Luminance zenith;                   ///< of artificial light alone, at the observer; none by default
  std::optional<Angle> azimuth;       ///< of the city, north through east; without one, cities all around
  Length distance = 30.0 * kilometre; ///< to the city

  [[nodiscard]] friend bool operator==(const CityGlow&, const CityGlow&) = default;
};

/// Throws Error(argument) naming what is out of its range.
void validate(const CityGlow& glow);

/// How a city's light falls off over the sky: light that the medium scatters once, at 550 nm, out of what a small city
/// sends upward by Garstang's law (1986, PASP 98, 364: a share F above the horizontal, with the fourth power of the
/// angle from the zenith, the rest down to a ground that reflects G of it evenly; F = G = 0.15 is customary), through
/// the air on both ways. The Earth is flat but for the height that a far place of the view gains on it; scattering more
/// than once, which fills the sky far from the city, is left out, as is the observer's own surroundings' light.
class CityGlowPattern {
public:
  /// \param height of the observer above the ground \param distance to the city
  CityGlowPattern(const Medium& medium, Length height, Length distance);

  /// Relative to the zenith, 1 there. 0 below the horizontal, and for an observer above the air.
  /// \param sin_altitude of the view \param azimuth of the view from the city's
  [[nodiscard]] double toward(double sin_altitude, Angle azimuth) const;
  /// The mean over the azimuth: cities all around.
  [[nodiscard]] double around(double sin_altitude) const;

private:
  struct Air {
    double scattering_per_km;
    double extinction_per_km;
    PhaseKind kind;
    double parameter;
    HeightProfile profile;
  };
  [[nodiscard]] double depth_below(double height_km) const;
  [[nodiscard]] double scattered(double sin_altitude, double cos_azimuth) const;

  std::vector<Air> air_;
  std::vector<double> depths_; ///< of a column from the ground to equal steps of height
  double height_km_;
  double distance_km_;
  double radius_km_;
  double zenith_ = 0.0;
};

} // namespace vesper
