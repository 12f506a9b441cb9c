// Rays of light traced through the air: what the refraction table is made from, and its judge.
#pragma once

#include "vesper/astro/air_profile.hpp"
#include "vesper/base/units.hpp"

#include <vector>

namespace vesper {

/// How finely a ray is integrated.
struct TraceQuality {
  int order;         ///< of Gauss's quadrature
  int panels;        ///< between two boundaries of height
  bool every_corner; ///< boundaries at all corners of the temperature, or only at those below 21 km
};
inline constexpr TraceQuality fast_trace{6, 1, false}; ///< within 0.01 arcsec of fine_trace up to 13 km
inline constexpr TraceQuality fine_trace{16, 4, true}; ///< the reference: within 1e-6 arcsec of finer ones

struct TracedRay {
  Angle refraction; ///< apparent less true altitude, >= 0
  bool hits_ground; ///< no light from the sky comes this way; then `refraction` is zero
  Length lowest;    ///< the lowest point between the observer and space
};

/// Traces rays backward from the observer through spherical shells of air.
///
/// Auer and Standish 2000 (AJ 119, 2472, eq. 3): the integral of -r n'/(n + r n') over the zenith angle along the ray,
/// which is regular at the horizon and at the lowest point of a ray that first descends. Gauss's quadrature between the
/// corners of the temperature profile; heights from Snell's law n r sin(zenith angle) = const by Newton's method.
class RefractionTracer {
public:
  /// Throws Error(argument) for conditions out of range.
  explicit RefractionTracer(const RefractionConditions& conditions, TraceQuality quality = fine_trace);

  /// \param apparent_altitude -90 to 90 degrees
  [[nodiscard]] TracedRay trace(Angle apparent_altitude) const;

  /// Apparent altitude of the ray that grazes the ground: 0, or the refracted dip (negative) of an observer above it.
  [[nodiscard]] Angle horizon() const;

private:
  /// n r in km, by which the rays bend, and what the integrand needs.
  struct Optics {
    double n_r;
    double n_r_slope;
    double bending; ///< -r n' / (n + r n')
  };
  [[nodiscard]] Optics optics(double height_km) const;
  [[nodiscard]] double lowest_of(double invariant_km) const;
  [[nodiscard]] double between(double low_km, double high_km, double invariant_km) const;

  AirProfile air_;
  double ground_km_; ///< sea level, or the observer if lower, or where rays would circle the Earth
  std::vector<double> boundaries_km_;
  std::vector<double> abscissae_; ///< of Gauss's quadrature over -1 to 1
  std::vector<double> weights_;
  int panels_; ///< between neighbouring boundaries
};

} // namespace vesper
