// What makes one eclipse of the Moon darker than another: dust above the weather, and clouds.
#pragma once

#include "vesper/atmosphere/medium.hpp"

#include <array>

namespace vesper {

/// Danjon's scale of luminosity L: 0, the Moon almost invisible, to 4, copper-red or orange with a bluish rim.
inline constexpr double least_danjon = 0.0;
inline constexpr double most_danjon = 4.0;

/// The Earth's air around the terminator, in the mean.
struct EarthShadowLoad {
  double stratospheric_optical_depth; ///< at 550 nm from below, beside what the medium holds
  double cloud_height_km;             ///< above which half of the light that passes level is met by no cloud
};

/// For L = 0, 1, 2, 3 and 4.
///
/// Dust: 0.08 is what El Chichon and Pinatubo left over the whole Earth for a year (Keen 1983, Science 222, 1011, found
/// such depths from eclipses), 0.002 with the 0.005 of clear air the cleanest years. Clouds: half of all level paths
/// are free above 6 to 8 km. Between these ends both were chosen so that eclipses have the magnitudes measured:
/// 11.75 mag darker on 28 September 2015 (L = 1.9), V = -1.7 on 3 March 2007 (2.5, the default: within 0.25 mag) and
/// -3.3 on 9 February 1990 (4), and so that over all total eclipses the Moon falls by 10^4.2 for L = 4 and 10^5.7 for
/// L = 0, in the mean.
inline constexpr std::array<EarthShadowLoad, 5> earth_shadow_loads{
    {{0.08, 9.5}, {0.05, 8.5}, {0.028, 7.5}, {0.012, 6.0}, {0.002, 4.0}}};

/// Share of the light with its lowest point at a height that is met by no cloud or mountain.
[[nodiscard]] double share_past_clouds(const EarthShadowLoad& load, double height_km);

/// The medium and, as its last component, dust of the stratosphere with an optical depth of 1 at 550 nm.
[[nodiscard]] Medium with_stratospheric_dust(Medium medium);

} // namespace vesper
