// Zodiacal light and gegenschein as seen from the Earth's orbit.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/base/vector.hpp"

#include <vector>

namespace vesper {

// Directions are unit vectors with x towards the Sun in the ecliptic and z to the ecliptic's north pole. All light is
// that at 1 au from the Sun; at R au it is R^-2.3 of it (Leinert et al. 1998, A&AS 127, 1, sec. 8.2).

/// Radiance at 500 nm, 1e-8 W/(m2 sr um): Leinert et al. 1998, table 17, exactly at its places and smooth between them
/// (cubics in the logarithm, over the law of f64::log2_dust_law). Nearer to the Sun than the table goes, 15 degrees in
/// the ecliptic, that law leads on to the Sun's corona. The table is symmetric; that the dust's plane is tilted by 3
/// degrees against the ecliptic, and the Earth's place above or below it, is left out: up to 10 % by season.
[[nodiscard]] double zodiacal_radiance_500nm(const Vec3& direction);

/// X, Y, Z and S, cd/m2, in the colour of the elongation (zodiacal_spectrum in night_light.hpp).
[[nodiscard]] Vec4 zodiacal_luminance(const Vec3& direction);

/// The same as texels for f64::zodiacal_place, row by row. Linear between texels it keeps within 1 % of
/// zodiacal_luminance, and within 0.3 % more than 15 degrees from the Sun.
struct ZodiacalMap {
  static constexpr int columns = 97;
  static constexpr int rows = 512;
  std::vector<Vec4> texels;
};
[[nodiscard]] const ZodiacalMap& zodiacal_map();

} // namespace vesper
