// Reading reference tables and summing up errors.
#pragma once

#include "vesper/astro/observer.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/base/csv.hpp"
#include "vesper/base/vector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace vesper::test {

inline CsvTable truth_table(const std::string& name) {
  const std::string path = std::string(VESPER_TEST_DATA) + "/astro/" + name;
  return {read_file(path), path};
}

/// A row of a reference table by column names.
class TruthRow {
public:
  TruthRow(const CsvTable& table, std::size_t row) : table_(table), row_(row) {}
  [[nodiscard]] double number(std::string_view column) const { return table_.number(row_, table_.column(column)); }
  [[nodiscard]] Angle degrees(std::string_view column) const { return number(column) * deg; }
  [[nodiscard]] std::string text(std::string_view column) const {
    return std::string(table_.cell(row_, table_.column(column)));
  }
  /// The instant of `jd_tt` with the row's own Delta-T, so that an ephemeris is tested alone.
  [[nodiscard]] Instant instant() const {
    const double jd_tt = number("jd_tt");
    const double day = std::floor(jd_tt);
    return instant_from({day, jd_tt - day}, {day, jd_tt - day - number("delta_t") / 86400.0});
  }
  /// The instant of the stamp: time scales too.
  [[nodiscard]] Instant stamp() const {
    return parse_instant(text("utc"), text("scale") == "UT1" ? TimeScale::ut1 : TimeScale::utc);
  }
  /// The instant of a stamp in another column, in the row's time scale and with its own Delta-T.
  [[nodiscard]] Instant instant_in(std::string_view column) const {
    const bool ut1 = text("scale") == "UT1";
    const Instant instant = parse_instant(text(column), ut1 ? TimeScale::ut1 : TimeScale::utc);
    return ut1 ? instant_from({instant.ut1.day, instant.ut1.fraction + number("delta_t") / 86400.0}, instant.ut1)
               : instant;
  }
  /// Whether the row lies in the years that the embedded ephemeris is for, 1960 to 2059.
  [[nodiscard]] bool in_table_years() const {
    const double jd_tt = number("jd_tt");
    return jd_tt >= 2436934.5 && jd_tt < 2473459.5;
  }
  [[nodiscard]] Observer observer() const { return {degrees("lat"), degrees("lon"), number("height_m") * metre}; }

private:
  const CsvTable& table_;
  std::size_t row_;
};

/// Seconds of TT from `b` to `a`.
inline double seconds_between(const Instant& a, const Instant& b) { return a.tt.days_since(b.tt) * seconds_per_day; }

/// The unit vector of a longitude and a latitude.
inline Vec3 direction(Angle longitude, Angle latitude) {
  const double c = std::cos(latitude.to(rad));
  return {c * std::cos(longitude.to(rad)), c * std::sin(longitude.to(rad)), std::sin(latitude.to(rad))};
}

/// The unit vector of an azimuth and an altitude in degrees, with x where the azimuth is 0 and y where it is 90.
inline Vec3 toward(double azimuth_deg, double altitude_deg) { return direction(azimuth_deg * deg, altitude_deg * deg); }

/// The angle between two directions, exact for small ones.
inline Angle separation(const Vec3& a, const Vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * rad;
}

/// a - b brought to -180 to 180 degrees.
inline Angle angle_difference(Angle a, Angle b) { return std::remainder((a - b).to(deg), 360.0) * deg; }

/// Worst and RMS of a set of errors.
class ErrorSum {
public:
  void add(double error) {
    // What is no number stays, so that it cannot pass.
    worst_ = std::isnan(worst_) || std::abs(error) <= worst_ ? worst_ : std::abs(error);
    squares_ += error * error;
    ++count_;
  }
  [[nodiscard]] double worst() const { return worst_; }
  [[nodiscard]] double rms() const { return count_ == 0 ? 0.0 : std::sqrt(squares_ / static_cast<double>(count_)); }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Prints the figures with the limit they are held to, for the test and for docs/ACCURACY.md, and checks the worst.
  void hold(const std::string& what, double limit, const char* unit) const {
    std::printf("%s: worst %.3g %s, RMS %.3g %s, %zu rows, held to %g %s\n", what.c_str(), worst_, unit, rms(), unit,
                count_, limit, unit);
    EXPECT_GT(count_, 0U) << what;
    EXPECT_LE(worst_, limit) << what << " in " << unit;
  }
  void print(const char* what, const char* unit) const {
    std::printf("%s: worst %.6g %s, RMS %.6g %s, %zu rows\n", what, worst_, unit, rms(), unit, count_);
  }

private:
  double worst_ = 0.0;
  double squares_ = 0.0;
  std::size_t count_ = 0;
};

} // namespace vesper::test
