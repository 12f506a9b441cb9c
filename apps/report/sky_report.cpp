#include "report/sky_report.hpp"

#include "report/sky_partial.hpp"
#include "report/table_light.hpp"

#include "common/progress_bar.hpp"

#include "vesper/astro/spherical.hpp"
#include "vesper/atmosphere/level_illuminance.hpp"
#include "vesper/base/csv.hpp"
#include "vesper/base/worker_pool.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <mutex>

namespace vesper {
namespace {

/// The transport of a request, solved when a first unit needs it.
class SkyWork {
public:
  SkyWork(const SkyRequest& request, unsigned threads) : request_(request), threads_(threads) {}

  [[nodiscard]] std::vector<double> operator()(std::size_t index, unsigned threads) {
    std::call_once(made_, [this] { transport_.emplace(*request_.medium, request_.wavelengths_nm, threads_); });
    const auto start = std::chrono::steady_clock::now();
    const SkyPoint& point = request_.points[index];
    std::vector<WeightedLight> lights = request_.lights;
    for (WeightedLight& weighted : lights) {
      // Two streams a point, one for each light.
      weighted.stream += 2 * index;
      if (point.sun && weighted.light.name == "sun") {
        weighted.light.direction = point.sun->direction();
      }
    }
    LightBudget budget{request_.budget};
    budget.paths.threads = threads;
    SkyEstimate estimate =
        sky_radiance(*transport_, request_.height, point.place.direction(), lights, request_.quantities.size(), budget);
    std::vector<double> values;
    for (const Estimate& quantity : estimate.quantities) {
      values.insert(values.end(), {quantity.mean, quantity.standard_error});
    }
    if (request_.illuminance) {
      for (WeightedLight& weighted : lights) {
        weighted.stream += illuminance_streams;
      }
      const LevelLight level = level_light(*transport_, request_.height, lights, budget);
      values.insert(values.end(), {level.total.mean, level.total.standard_error, level.direct});
      estimate.paths += level.paths;
    }
    values.push_back(static_cast<double>(estimate.paths));
    if (request_.timings) {
      values.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return values;
  }

private:
  static constexpr std::uint64_t illuminance_streams = std::uint64_t{1} << 63U;

  const SkyRequest& request_;
  unsigned threads_;
  std::once_flag made_;
  std::optional<ReferenceTransport> transport_;
};

/// Names of the numbers of a result.
std::vector<std::string> value_names(const SkyRequest& request) {
  const bool by_chance = request.model == SkyModel::reference;
  std::vector<std::string> names;
  for (const SkyQuantity& quantity : request.quantities) {
    names.push_back(quantity.name + "_" + quantity.unit);
    if (by_chance) {
      names.push_back(quantity.name + "_error_" + quantity.unit);
    }
  }
  if (request.illuminance) {
    names.emplace_back("horizontal_illuminance_lux");
    if (by_chance) {
      names.emplace_back("horizontal_illuminance_error_lux");
    }
    names.emplace_back("direct_illuminance_lux");
  }
  if (by_chance) {
    names.emplace_back("paths");
  }
  if (request.timings) {
    names.emplace_back("seconds");
  }
  return names;
}

using NamedNumber = std::pair<std::string_view, double>;

/// What tells a point from others.
std::vector<NamedNumber> place_of(const SkyRequest& request, const SkyPoint& point) {
  std::vector<NamedNumber> place;
  if (request.picture) {
    place = {{"pixel_x", point.pixel[0]}, {"pixel_y", point.pixel[1]}};
  }
  place.emplace_back("altitude_deg", point.place.altitude_deg);
  place.emplace_back("azimuth_deg", point.place.azimuth_deg);
  if (point.sun) {
    place.emplace_back("sun_altitude_deg", point.sun->altitude_deg);
    place.emplace_back("sun_azimuth_deg", point.sun->azimuth_deg);
  }
  return place;
}

std::string_view name_of(SkyModel model) {
  switch (model) {
  case SkyModel::tables:
    return "tables";
  case SkyModel::small_tables:
    return "small-tables";
  case SkyModel::reference:
    break;
  }
  return "reference";
}

double altitude_deg(const Vec3& direction) { return latitude_of(direction).to(deg); }
double azimuth_deg(const Vec3& direction) { return whole_turn_atan2(direction.x, direction.y).to(deg); }

} // namespace

SkyResults sky_results(const SkyRequest& request, const std::string& partial, Crew& crew) {
  SkyResults results(request.points.size());
  std::optional<PartialResults> kept;
  if (crew.leads() && !partial.empty()) {
    kept.emplace(partial, "vesper-report sky " + fingerprint(request), request.points.size(),
                 value_names(request).size());
    for (const auto& [index, values] : kept->finished()) {
      results[index] = values;
    }
  }
  std::vector<std::size_t> left;
  for (std::size_t index = 0; index < results.size(); ++index) {
    if (results[index].empty()) {
      left.push_back(index);
    }
  }
  ProgressBar progress("directions", results.size());
  progress.advance(results.size() - left.size());
  const unsigned threads = crew.threads(request.budget.threads);
  SkyWork work(request, threads);
  crew.work(
      left, threads, [&](std::size_t index, unsigned for_it) { return work(index, for_it); },
      [&](std::size_t index, const std::vector<double>& values) {
        results[index] = values;
        if (kept) {
          kept->add(index, values);
        }
        progress.advance(1);
      });
  return results;
}

SkyResults sky_results(const SkyRequest& request, const SkyTables& tables) {
  std::vector<std::pair<SkyLight, Mat4>> lights;
  for (const WeightedLight& weighted : request.lights) {
    lights.emplace_back(weighted.light, from_table_light(weighted.light));
  }
  const auto result_of = [&](const SkyPoint& point) {
    const auto start = std::chrono::steady_clock::now();
    Vec4 luminance(0.0);
    double direct = 0.0;
    double diffuse = 0.0;
    for (const auto& [light, matrix] : lights) {
      const Vec3 direction = point.sun && light.name == "sun" ? point.sun->direction() : light.direction;
      luminance +=
          matrix *
          vector_of(sky_luminance(tables, {request.height, direction, light.angular_radius, point.place.direction()}));
      if (request.illuminance) {
        const Angle altitude = latitude_of(direction);
        direct += (matrix * vector_of(direct_illuminance(tables, request.height, altitude, light.angular_radius))).y;
        diffuse += (matrix * vector_of(diffuse_illuminance(tables, request.height, altitude))).y;
      }
    }
    std::vector<double> values{luminance.y, luminance.x, luminance.z, luminance.w};
    if (request.illuminance) {
      values.insert(values.end(), {direct + diffuse, direct});
    }
    if (request.timings) {
      values.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return values;
  };
  SkyResults results(request.points.size());
  parallel_for(
      results.size(), 256,
      [&](std::size_t begin, std::size_t end) {
        std::transform(request.points.begin() + static_cast<std::ptrdiff_t>(begin),
                       request.points.begin() + static_cast<std::ptrdiff_t>(end),
                       results.begin() + static_cast<std::ptrdiff_t>(begin), result_of);
      },
      request.budget.threads);
  return results;
}

std::string sky_report_csv(const SkyRequest& request, const SkyResults& results) {
  std::string csv;
  for (const auto& [name, value] : place_of(request, request.points.at(0))) {
    csv.append(name).append(",");
  }
  csv += fmt::format("{}\n", fmt::join(value_names(request), ","));
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (const auto& [name, value] : place_of(request, request.points[i])) {
      append_number(csv, value);
      csv += ',';
    }
    for (const double value : results[i]) {
      append_number(csv, value);
      csv += ',';
    }
    csv.back() = '\n';
  }
  return csv;
}

std::string sky_report_json(const SkyRequest& request, const SkyResults& results) {
  nlohmann::ordered_json json;
  json["medium"] = request.medium_name;
  json["height_m"] = request.height.to(metre);
  json["sky"] = name_of(request.model);
  if (request.model == SkyModel::reference) {
    json["relative_error"] = request.budget.relative_error;
    json["seed"] = request.budget.seed;
  }
  json["lights"] = nlohmann::ordered_json::array();
  for (const WeightedLight& weighted : request.lights) {
    nlohmann::ordered_json light;
    light["name"] = weighted.light.name;
    if (!request.points.at(0).sun || weighted.light.name != "sun") {
      light["altitude_deg"] = altitude_deg(weighted.light.direction);
      light["azimuth_deg"] = azimuth_deg(weighted.light.direction);
    }
    light["angular_radius_deg"] = weighted.light.angular_radius.to(deg);
    json["lights"].push_back(std::move(light));
  }
  json["directions"] = nlohmann::ordered_json::array();
  const std::vector<std::string> names = value_names(request);
  for (std::size_t i = 0; i < results.size(); ++i) {
    nlohmann::ordered_json row;
    for (const auto& [name, value] : place_of(request, request.points[i])) {
      row[std::string(name)] = value;
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
      const double value = results[i].at(k);
      row[names[k]] = names[k] == "paths" ? nlohmann::ordered_json(static_cast<std::uint64_t>(value))
                                          : nlohmann::ordered_json(value);
    }
    json["directions"].push_back(std::move(row));
  }
  return json.dump(2) + "\n";
}

std::vector<float> sky_picture(const SkyRequest& request, const SkyResults& results) {
  const View& view = request.picture.value();
  std::vector<float> xyzs(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height) * 4);
  // Where X, Y, Z and S stand among the quantities: luminance, x, z, s, by the reference each with its error.
  constexpr std::array<std::size_t, 4> places{1, 0, 2, 3};
  const std::size_t numbers = request.model == SkyModel::reference ? 2 : 1;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto [column, row] = request.points[i].pixel;
    const std::size_t pixel =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(column);
    for (std::size_t channel = 0; channel < places.size(); ++channel) {
      xyzs[4 * pixel + channel] = static_cast<float>(results[i].at(numbers * places.at(channel)));
    }
  }
  return xyzs;
}

ImageMetadata describe_picture(const SkyRequest& request) {
  const View& view = request.picture.value();
  ImageMetadata metadata{
      {"vesper:view", fmt::format("{}, azimuth {} deg, altitude {} deg, roll {} deg, fov {} deg",
                                  projection_names()[static_cast<std::size_t>(view.projection)], view.azimuth.to(deg),
                                  view.altitude.to(deg), view.roll.to(deg), view.fov.to(deg))},
      {"vesper:sky",
       fmt::format("{}, medium {}{}, height {} m", name_of(request.model), request.medium_name,
                   request.model == SkyModel::reference
                       ? fmt::format(", relative error {}, seed {}", request.budget.relative_error, request.budget.seed)
                       : "",
                   request.height.to(metre))},
      {"vesper:units", "X Y Z: CIE 1931, Y in cd/m2; S: scotopic luminance in cd/m2"}};
  for (const WeightedLight& weighted : request.lights) {
    metadata.emplace_back("vesper:" + weighted.light.name,
                          fmt::format("altitude {} deg, azimuth {} deg", altitude_deg(weighted.light.direction),
                                      azimuth_deg(weighted.light.direction)));
  }
  return metadata;
}

} // namespace vesper
