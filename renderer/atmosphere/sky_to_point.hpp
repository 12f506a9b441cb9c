// The air between an observer and an object at a distance: what it takes from the object's light and what it adds.
#pragma once

#include "vesper/atmosphere/sky_query.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/base/units.hpp"

namespace vesper {

/// Of the air on the way from an object to an observer.
struct SkyWay {
  Xyzs light;         ///< scattered toward the observer between the two, cd/m2 above 1 lux of sunlight
  Xyzs transmittance; ///< share of X, Y, Z and S that passes, 0 to 1, of light of the sunlight's spectrum
};

/// Looks the way up in a medium's tables; an object of luminance B is seen as B * transmittance + E * light under an
/// illuminance of E outside the air (for another light than the Sun, through response_matrix). Both are continuous over
/// the distance: no light and 1 at none; over the whole ray the light is all that the air sends along it. How near they
/// come to the solved light stands in docs/ACCURACY.md, sky to a point.
/// \param query observer, light and the object's direction along straight rays; observers outside the air too
/// \param distance of the object, >= 0, infinity included; behind the ground's surface as at it
/// Throws Error(argument) for a query out of its range (sky_query.hpp), for a distance below zero or none, and for
/// tables that hold small ones.
[[nodiscard]] SkyWay sky_way(const SkyTables& tables, const SkyQuery& query, Length distance);

} // namespace vesper
