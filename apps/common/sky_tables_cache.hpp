// The tables of a scene's sky and the light in the Earth's shadow: from the user's cache, from those that came with the
// programs, or made now.
#pragma once

#include "common/scene_options.hpp"

#include "vesper/atmosphere/earth_shadow_light.hpp"
#include "vesper/atmosphere/sky_tables.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace vesper {

/// $XDG_CACHE_HOME/vesper, or the same under ~/.cache; empty when neither variable is set.
[[nodiscard]] std::filesystem::path user_cache_folder();

/// Tables of the default size for the scene's medium, cached in user_cache_folder(); made with a progress bar.
/// Throws Error(argument) as make_sky_tables does.
[[nodiscard]] std::shared_ptr<const SkyTables> scene_sky_tables(const SceneOptions& scene, unsigned threads = 0);

/// Reads the tables of a fingerprint in the folder or, if they are not there, those that came with the programs; else
/// makes them, and leaves them in the folder for the next time. A process that finds another making tables in the same
/// folder waits for it. A file that is not whole is replaced, with a warning. The twenty files used last stay. Where
/// the folder cannot be written to (warned of) or is empty (the path), only the keeping falls away.
[[nodiscard]] std::shared_ptr<const SkyTables> cached_sky_tables(const std::string& fingerprint,
                                                                 const std::function<SkyTables()>& make,
                                                                 const std::filesystem::path& folder);

/// The light in the Earth's shadow through a medium: from the folder or else made, in half a second, and left there
/// among the files above. A broken file is replaced, with a warning; where the folder cannot be written to (warned of)
/// or is empty (the path), only the keeping falls away.
[[nodiscard]] EarthShadowLight cached_earth_shadow_light(const Medium& medium, const std::filesystem::path& folder);

} // namespace vesper
