#include "vesper/astro/refraction.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace vesper {
namespace {

/// The published formula's pressure and temperature (Meeus 1998, chapter 16).
double published_strength(const RefractionConditions& conditions) {
  return conditions.pressure_hpa / 1010.0 * 283.0 / (273.0 + conditions.temperature_c);
}

const RefractionTable& table_of(const Refraction& refraction) {
  if (refraction.table == nullptr) {
    throw Error(ErrorKind::argument, "a traced refraction lacks its table", {"", "", "Pass it through with_table()"});
  }
  return *refraction.table;
}

} // namespace

Angle apparent_altitude(Angle true_altitude, const RefractionTable& table) {
  const double altitude = true_altitude.to(rad);
  const double bend = f64::table_bend(std::sin(altitude), false, table.frame, refraction_sampler(table));
  return (altitude + bend * std::cos(altitude)) * rad;
}

Angle true_altitude(Angle apparent_altitude, const RefractionTable& table) {
  const double altitude = apparent_altitude.to(rad);
  const double bend = f64::table_bend(std::sin(altitude), true, table.frame, refraction_sampler(table));
  return (altitude - bend * std::cos(altitude)) * rad;
}

Refraction standard_refraction(Length height, Tier tier) {
  if (height > highest_refraction) {
    return {};
  }
  return {tier == Tier::cheap ? RefractionModel::published : RefractionModel::traced, standard_conditions(height),
          nullptr};
}

Refraction with_table(Refraction refraction) {
  validate(refraction.conditions);
  if (refraction.model == RefractionModel::traced && refraction.table == nullptr) {
    refraction.table = std::make_shared<const RefractionTable>(make_refraction_table(refraction.conditions));
  }
  return refraction;
}

f64::RefractionFrame refraction_frame(const Refraction& refraction, std::optional<double> wavelength_nm) {
  f64::RefractionFrame frame{};
  switch (refraction.model) {
  case RefractionModel::none:
    break;
  case RefractionModel::published:
    frame.kind = f64::refraction_published;
    frame.strength = published_strength(refraction.conditions);
    break;
  case RefractionModel::traced:
    frame = table_of(refraction).frame;
    if (wavelength_nm) {
      // The ratio does not depend on the air's density.
      frame.strength = air_refractivity(*wavelength_nm, 1000.0, 0.0) /
                       air_refractivity(table_of(refraction).conditions.wavelength_nm, 1000.0, 0.0);
    }
    break;
  }
  return frame;
}

f64::sampler1D refraction_sampler(const RefractionTable& table) {
  return {table.texels.data(), static_cast<int>(table.texels.size())};
}

f64::sampler1D refraction_sampler(const Refraction& refraction) {
  return refraction.table == nullptr ? f64::sampler1D{} : refraction_sampler(*refraction.table);
}

Vec3 apparent_direction(const Vec3& true_direction, const Refraction& refraction) {
  return f64::apparent_direction(true_direction, refraction_frame(refraction), refraction_sampler(refraction));
}

Vec3 true_direction(const Vec3& apparent_direction, const Refraction& refraction) {
  return f64::true_direction_of(apparent_direction, refraction_frame(refraction), refraction_sampler(refraction));
}

Angle horizon_altitude(const Refraction& refraction, Length height) {
  if (refraction.model == RefractionModel::traced) {
    return table_of(refraction).horizon;
  }
  constexpr double bent = 0.17; // share of the Earth's curvature that a level ray follows
  const double curvature = refraction.model == RefractionModel::published ? 1.0 - bent : 1.0;
  const double relative = std::max(height.to(kilometre), 0.0) * curvature / f64::earth_radius_km;
  return -std::acos(1.0 / (1.0 + relative)) * rad;
}

} // namespace vesper
