// The eclipses of a span of years, as a table.
#pragma once

#include "common/scene_options.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/lunar_eclipse.hpp"
#include "vesper/astro/time.hpp"

#include <string>
#include <string_view>

namespace vesper {

enum class EclipseKind { lunar, solar };

struct EclipseRequest {
  EclipseKind kind = EclipseKind::lunar;
  ShadowModel shadow = ShadowModel::danjon;       ///< of lunar ones
  double umbral_radius_ratio = moon_radius_ratio; ///< k of second and third contacts of solar ones
  Instant from;                                   ///< of the greatest phase
  Instant to;                                     ///< exclusive
  SceneOptions scene;                             ///< the observer's
};

/// A request from the texts of --kind, --shadow, --lunar-radius, --from and --to. The last two take a year or an ISO
/// date, whose end is meant by --to, or an instant. Throws Error(argument) naming option, value and what is allowed.
/// \param scene the observer, and the time scale and calendar of `from` and `to`
[[nodiscard]] EclipseRequest eclipse_request(std::string_view kind, std::string_view shadow,
                                             std::string_view lunar_radius, std::string_view from, std::string_view to,
                                             const SceneOptions& scene);

struct EclipseReport {
  std::string text;        ///< CSV or JSON
  bool any_in_ut1 = false; ///< whether an eclipse lies outside the leap seconds known
};

/// One row an eclipse, in order.
///
/// Lunar: greatest, type, gamma, umbral_magnitude, penumbral_magnitude, P1, U1, U2, U3, U4, P4 and, at the
/// observer's place and greatest eclipse, the Moon's altitude, magnitude and, of total ones, Danjon's L
/// (body_columns.hpp). Solar: greatest, type, gamma, the place of greatest eclipse; then local_type and, unless that is
/// "none" because the Moon's shadow or the Sun stays away from the observer's place, C1, C2, max, C3, C4, magnitude,
/// obscuration and the Sun's altitude at maximum. Times are UTC ("...Z") inside the leap seconds known, else UT1 ("...
/// UT1"); what does not exist is blank, in JSON null.
[[nodiscard]] EclipseReport eclipse_report(const EclipseRequest& request, bool json);

} // namespace vesper
