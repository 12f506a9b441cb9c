// What must hold for every star catalogue, in memory and in files.
#pragma once

#include "vesper/assets/star_catalogue.hpp"
#include "vesper/base/error.hpp"

#include <string>

namespace vesper {

/// What helps against a broken star catalogue.
inline constexpr const char* star_file_remedy = "Make the file again with vesper-catalog stars";

/// Largest relative difference allowed between the sum of the stars' illuminances and the one in the provenance.
inline constexpr double star_flux_tolerance = 1e-6;

/// Sum of the stars' illuminances in lux, added in double precision.
[[nodiscard]] double total_illuminance_lux(const StarCatalogue& catalogue);

/// Throws Error(kind) that names `file` and the first star (counted from 0) that breaks a rule: at least one star, one
/// identity each, all numbers finite, positions unit vectors, proper motions tangent to the sphere, parallaxes and
/// amplitudes not negative, illuminances positive, colours positive with Y = 1, sorted by magnitude, illuminance in
/// step with the magnitude, kept count and total illuminance as the provenance says.
void check_star_catalogue(const StarCatalogue& catalogue, ErrorKind kind, const std::string& file);

} // namespace vesper
