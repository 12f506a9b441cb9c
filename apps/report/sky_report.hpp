// `vesper-report sky`: the work, and what is written of it.
#pragma once

#include "report/crew.hpp"
#include "report/sky_request.hpp"

#include "vesper/assets/image_file.hpp"
#include "vesper/atmosphere/sky_tables.hpp"

#include <string>

namespace vesper {

/// What is known of each of a request's points, in their order: mean and, by the reference, standard error of each
/// quantity; if asked for, illuminance, by the reference its standard error, and its direct part; by the reference the
/// number of paths, and with timings the seconds.
using SkyResults = std::vector<std::vector<double>>;

/// For requests by the reference. Does the work that `partial` does not hold yet, and keeps there what is finished;
/// random numbers belong to the point, so that neither threads, processes nor interruptions change a result. Only the
/// leading process gets results. \param partial file for what is finished; none if empty
[[nodiscard]] SkyResults sky_results(const SkyRequest& request, const std::string& partial, Crew& crew);
/// The same for requests by tables, in microseconds a point.
[[nodiscard]] SkyResults sky_results(const SkyRequest& request, const SkyTables& tables);

/// A row a point: for a picture `pixel_x, pixel_y`, then `altitude_deg, azimuth_deg`, for a Sun by row
/// `sun_altitude_deg, sun_azimuth_deg`, each quantity, the illuminances if asked for, with timings `seconds`; by the
/// reference errors and `paths` too.
[[nodiscard]] std::string sky_report_csv(const SkyRequest& request, const SkyResults& results);
/// The same with medium, height, lights and accuracy asked for.
[[nodiscard]] std::string sky_report_json(const SkyRequest& request, const SkyResults& results);

/// X, Y, Z and S by pixel, 0 where the picture shows no sky. For requests of a picture that hold them.
[[nodiscard]] std::vector<float> sky_picture(const SkyRequest& request, const SkyResults& results);
[[nodiscard]] ImageMetadata describe_picture(const SkyRequest& request);

} // namespace vesper
