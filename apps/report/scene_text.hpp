// A scene in words: what stands in the sky.
#pragma once

#include "report/dark_light.hpp"
#include "report/table_light.hpp"

#include "vesper/assets/star_catalogue.hpp"
#include "vesper/sky/sky_state.hpp"

#include <optional>
#include <string>

namespace vesper {

/// Time, place, sky condition, Sun and Moon (airless; apparent too where refraction can show them), the Moon's
/// libration, their light on level ground and in the zenith, planets and brightest stars up and figures that stand
/// high, as lines of text.
[[nodiscard]] std::string scene_text(const SkyState& sky, const StarCatalogue& catalogue, const SceneLight& light,
                                     const DarkLight& dark, std::optional<double> limiting_magnitude = {});

/// One of 16 compass points for an azimuth: "N", "NNE", ...
[[nodiscard]] std::string_view compass_point(Angle azimuth);

/// "day", "civil twilight", "nautical twilight", "astronomical twilight" or "night": the Sun's centre above -0.833, -6,
/// -12, -18 degrees or below.
[[nodiscard]] std::string_view sky_condition(Angle sun_altitude);

/// "new Moon", "waxing crescent", ... for an illuminated fraction.
/// \param waxing whether the Moon stands east of the Sun
[[nodiscard]] std::string_view moon_phase_name(double illuminated_fraction, bool waxing);

} // namespace vesper
