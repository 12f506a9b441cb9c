// The star catalogue that is built into the library.
#pragma once

#include "vesper/assets/star_catalogue.hpp"

namespace vesper {

/// The whole Bright Star Catalogue (data/bright_stars.glb): 9096 stars to V = 7.96, decoded at the first call.
[[nodiscard]] const StarCatalogue& default_star_catalogue();

} // namespace vesper
