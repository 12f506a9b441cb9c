// The axes that pictures of the sky are laid along.
#pragma once

#include "vesper/base/vector.hpp"

#include <optional>
#include <string>

namespace vesper {

/// The rotation to ICRS of the axes that a FITS header names, and a name for reports.
struct CelestialAxes {
  Mat3 icrs_from_axes{1.0};
  std::string name;
};

/// \param longitude_type "RA", "GLON", "ELON" or "SLON", the first letters of CTYPE
/// \param radesys        RADESYS, empty if missing: then ICRS without an equinox, FK4 before 1984, FK5 after
/// \param equinox        EQUINOX, if there is one
/// None for what is not known: another system, or FK4 of another equinox than B1950.
[[nodiscard]] std::optional<CelestialAxes> celestial_axes(const std::string& longitude_type, const std::string& radesys,
                                                          std::optional<double> equinox);

} // namespace vesper
