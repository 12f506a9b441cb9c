// The Yale Bright Star Catalogue in its original fixed-width records.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vesper {

/// One entry of the Bright Star Catalogue, in the catalogue's own units. Equinox and epoch J2000.0.
struct BrightStar {
  unsigned hr = 0;                            ///< Harvard Revised number, 1 to 9999
  unsigned hd = 0;                            ///< Henry Draper number, 0 if none
  std::string name;                           ///< "Alp CMa", "Pi1 Ori", "33 Psc"; "" if none
  bool multiple = false;                      ///< has a multiplicity code or a number in Aitken's double star catalogue
  bool variable = false;                      ///< has an entry in the columns of variable stars
  bool has_position = false;                  ///< novae, clusters and galaxies have none
  double right_ascension_deg = 0;             ///< [0, 360)
  double declination_deg = 0;                 ///< [-90, +90]
  std::optional<double> v_magnitude;          ///< Johnson V, or what the catalogue gives in its place
  std::optional<double> b_v;                  ///< colour index B-V
  std::string spectral_type;                  ///< without blanks around it
  std::optional<double> pm_ra_arcsec_yr;      ///< times cos(declination)
  std::optional<double> pm_dec_arcsec_yr;     ///<
  std::optional<double> parallax_arcsec;      ///< as in the catalogue: may be negative
  std::optional<double> radial_velocity_km_s; ///< positive receding
};

/// The entries of the 5th edition without a position: novae, clusters and galaxies.
inline constexpr std::array<unsigned, 14> positionless_bright_stars = {92,   95,   182,  1057, 1841, 2472, 2496,
                                                                       3515, 3671, 6309, 6515, 7189, 7539, 8296};

/// Reads the catalogue of Hoffleit and Warren 1991 (5th revised edition; byte layout of its own documentation) from
/// the content of a file, plain or gzipped. Lines end in LF or CRLF; trailing blanks may be missing; blank lines are
/// skipped. `file` is the name in messages.
///
/// Throws Error(input) with line, column, value, allowed range and remedy for: an empty file, one that is no such
/// catalogue, a broken gzip, a record that ends before its V magnitude (unless it is one of the 14 without a position)
/// or that is longer than 197 columns, fields that are not numbers, angles and other values out of range, a position of
/// which a part is blank, and an HR number that occurs twice.
[[nodiscard]] std::vector<BrightStar> read_bright_star_catalogue(std::span<const std::byte> content,
                                                                 const std::string& file);

} // namespace vesper
