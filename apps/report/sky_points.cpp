#include "report/sky_points.hpp"

#include "vesper/astro/spherical.hpp"

#include <cmath>

namespace vesper {

Vec3 SeenPlace::direction() const {
  const Vec3 north_east_up = unit_vector((azimuth_deg * deg).to(rad), (altitude_deg * deg).to(rad));
  return {north_east_up.y, north_east_up.x, north_east_up.z};
}

std::vector<SkyPoint> zenith_point() { return {{{90.0, 0.0}, std::nullopt, {}}}; }

bool table_has_sun(const CsvTable& table) { return table.find_column("sun_altitude_deg").has_value(); }

std::vector<SkyPoint> points_of_table(const CsvTable& table) {
  const std::size_t altitude = table.column("altitude_deg");
  const std::size_t azimuth = table.column("azimuth_deg");
  const auto sun_altitude = table.find_column("sun_altitude_deg");
  const auto sun_azimuth = table.find_column("sun_azimuth_deg");
  const auto place_of = [&](std::size_t row, std::size_t altitude_column, std::optional<std::size_t> azimuth_column) {
    return SeenPlace{table.number(row, altitude_column, -90.0, 90.0),
                     azimuth_column ? table.number(row, *azimuth_column, -360.0, 360.0) : 180.0};
  };
  if (table.row_count() == 0) {
    throw Error(ErrorKind::input, "the table has no rows", {table.file(), "", "Give a row a direction"});
  }
  std::vector<SkyPoint> points;
  points.reserve(table.row_count());
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    SkyPoint point;
    point.place = place_of(row, altitude, azimuth);
    if (sun_altitude) {
      point.sun = place_of(row, *sun_altitude, sun_azimuth);
    }
    points.push_back(point);
  }
  return points;
}

std::vector<SkyPoint> points_of_view(const View& view) {
  const f64::ProjectionFrame projection = projection_frame(view);
  const f64::PixelFrame frame{projection.kind, projection.size, projection.focal};
  const Mat3 horizon_from_view = glm::transpose(view_from_horizon(view));
  std::vector<SkyPoint> points;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      Vec3 in_view;
      if (!f64::unproject(Vec2(column + 0.5, row + 0.5), frame, in_view)) {
        continue;
      }
      const Vec3 seen = horizon_from_view * in_view;
      SkyPoint point;
      point.place = {latitude_of(seen).to(deg), whole_turn_atan2(seen.x, seen.y).to(deg)};
      point.pixel = {column, row};
      points.push_back(point);
    }
  }
  return points;
}

} // namespace vesper
