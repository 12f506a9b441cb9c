// Spectral types of catalogues, as a stand-in for a missing colour index.
#pragma once

#include <optional>
#include <string_view>

namespace vesper {

/// Intrinsic B-V of a star from its spectral type as the Bright Star Catalogue writes it ("K2.5IIIb", "gG9", "A7/8Vm",
/// "WN7-A", "C5,5"). For composites ("G8III+A5V") the first component counts, for ranges their mean. Without a
/// luminosity class the prefixes g (giant), d (dwarf), c (supergiant), sg (subgiant), sd (subdwarf) decide; without
/// these, types from G5 on are taken for giants, as they are among bright stars, earlier ones for dwarfs. Peculiarities
/// and interstellar reddening are ignored. White dwarfs (DA, DB, ...), W, C, R, N and S stars have values of their own.
///
/// Returns nothing when no spectral class is found. Classes O to M after Schmidt-Kaler 1982 (Landolt-Boernstein VI/2b)
/// and Fitzgerald 1970 (A&A 4, 234); C, N, R, S are typical of bright stars of these kinds, not intrinsic colours.
[[nodiscard]] std::optional<double> b_v_of_spectral_type(std::string_view type);

} // namespace vesper
