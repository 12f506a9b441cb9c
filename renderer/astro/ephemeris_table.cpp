#include "vesper/astro/ephemeris_table.hpp"

#include "vesper/base/embedded.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>

namespace vesper {

extern const EmbeddedTable embedded_ephemeris;

namespace {

static_assert(std::endian::native == std::endian::little, "the table is read as it lies in memory");

constexpr const char* file_name = "ephemeris_1960_2059.bin";
constexpr double au_km = astronomical_unit.to(kilometre);
constexpr double earth_moon_mass_ratio = 81.30056; // DE405's EMRAT
constexpr std::uint32_t most_orders = 32;

struct Head {
  char magic[8];
  double first_jd;
  double days;
  std::uint32_t series;
  std::uint32_t file_bytes;
};
struct Row {
  char name[16];
  double quantum;
  std::uint32_t place;
  std::uint32_t segments;
  std::uint32_t orders;
  std::uint32_t wide_orders;
};
static_assert(sizeof(Head) == 32 && sizeof(Row) == 40);

/// The series in the order of EphemerisTable::Body.
constexpr std::string_view series_names[] = {"moon",    "earth-moon", "sun",    "mercury", "venus",     "mars",
                                             "jupiter", "saturn",     "uranus", "neptune", "moon axes", "nutation"};

[[noreturn]] void fail(const std::string& message, const std::string& place) {
  throw Error(ErrorKind::input, message,
              {file_name, place, "Make the table with data/make_ephemeris.py and build again"});
}

/// The caller has checked that the bytes are there.
template <class T> T read(std::span<const unsigned char> bytes, std::size_t place) {
  T value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

/// Sums of c_k T_k(x) and of their derivatives, fed from the highest order down (Clenshaw 1955).
class ChebyshevSum {
public:
  explicit ChebyshevSum(double x) : two_x_(2.0 * x) {}

  template <class Integer> const unsigned char* add(const unsigned char* from, int orders) {
    for (int k = 0; k < orders; ++k, from += 3 * sizeof(Integer)) {
      Integer c[3];
      std::memcpy(c, from, sizeof c);
      step({c[0], c[1], c[2]}, two_x_);
    }
    return from;
  }
  /// The last order, c_0, enters with half the factor.
  void finish(const unsigned char* from) {
    std::int32_t c[3];
    std::memcpy(c, from, sizeof c);
    step({c[0], c[1], c[2]}, 0.5 * two_x_, 1.0);
  }
  [[nodiscard]] const Vec3& value() const { return b1_; }
  [[nodiscard]] const Vec3& derivative() const { return d1_; }

private:
  void step(const Vec3& c, double factor, double carried = 2.0) {
    const Vec3 d = carried * b1_ + factor * d1_ - d2_;
    const Vec3 b = c + factor * b1_ - b2_;
    d2_ = d1_;
    d1_ = d;
    b2_ = b1_;
    b1_ = b;
  }

  double two_x_;
  Vec3 b1_{}, b2_{}, d1_{}, d2_{};
};

} // namespace

EphemerisTable::EphemerisTable(std::span<const unsigned char> bytes) {
  static_assert(std::size(series_names) == bodies);
  constexpr std::size_t directory_bytes = sizeof(Head) + bodies * sizeof(Row);
  if (bytes.size() < directory_bytes) {
    fail(fmt::format("has {} bytes, less than its directory of {}", bytes.size(), directory_bytes), "");
  }
  const Head head = read<Head>(bytes, 0);
  if (std::string_view(head.magic, sizeof head.magic) != "VESPEPH1") {
    fail("does not begin with VESPEPH1", "byte 0");
  }
  if (!(std::isfinite(head.first_jd) && head.days > 0.0 && std::isfinite(head.days))) {
    fail("has no finite span", "byte 8");
  }
  if (head.series != bodies) {
    fail(fmt::format("has {} series instead of {}", head.series, int{bodies}), "byte 24");
  }
  if (head.file_bytes != bytes.size()) {
    fail(fmt::format("has {} bytes instead of {}", bytes.size(), head.file_bytes), "byte 28");
  }
  first_jd_ = head.first_jd;
  days_ = head.days;
  std::size_t place = directory_bytes;
  for (std::size_t i = 0; i < bodies; ++i) {
    const Row row = read<Row>(bytes, sizeof(Head) + i * sizeof(Row));
    const std::string where = fmt::format("series {}", i);
    const std::string_view name(row.name, ::strnlen(row.name, sizeof row.name));
    if (name != series_names[i]) {
      fail(fmt::format("is named '{}' instead of '{}'", name, series_names[i]), where);
    }
    if (row.segments == 0 || row.wide_orders == 0 || row.wide_orders > row.orders || row.orders > most_orders ||
        !(row.quantum > 0.0 && std::isfinite(row.quantum))) {
      fail(fmt::format("has {} segments of {} orders, {} of them wide, and a quantum of {}", row.segments, row.orders,
                       row.wide_orders, row.quantum),
           where);
    }
    const std::uint32_t narrow_orders = row.orders - row.wide_orders;
    const std::uint32_t segment_bytes = 3 * (2 * narrow_orders + 4 * row.wide_orders);
    const std::size_t size = std::size_t{row.segments} * segment_bytes;
    if (row.place != place || size > bytes.size() - place) {
      fail(fmt::format("places {} bytes at byte {} of {}, where byte {} is next", size, row.place, bytes.size(), place),
           where);
    }
    series_[i] = {bytes.data() + place,
                  segment_bytes,
                  row.segments - 1,
                  static_cast<int>(narrow_orders),
                  static_cast<int>(row.wide_orders),
                  days_ / row.segments,
                  row.quantum};
    place += size;
  }
  if (place != bytes.size()) {
    fail(fmt::format("has {} bytes after the last series", bytes.size() - place), "");
  }
}

const EphemerisTable& EphemerisTable::embedded() {
  static const EphemerisTable table = [] {
    const EmbeddedFile* file = embedded_ephemeris.find(file_name);
    if (file == nullptr) {
      throw Error(ErrorKind::file, "is not embedded", {file_name, "", "Build the library again"});
    }
    return EphemerisTable(file->data);
  }();
  return table;
}

EphemerisTable::Value EphemerisTable::evaluate(Body body, double day, double fraction) const {
  const Series& series = series_[static_cast<std::size_t>(body)];
  // Both parts of the date are taken up separately: from the epoch alone a double resolves no better than a
  // microsecond.
  const double segments = std::floor(((day - first_jd_) + fraction) / series.segment_days);
  const std::uint32_t index = std::min(static_cast<std::uint32_t>(segments), series.last_segment);
  const double days_into_segment = (day - (first_jd_ + index * series.segment_days)) + fraction;
  const double x = 2.0 * days_into_segment / series.segment_days - 1.0;

  ChebyshevSum sum(x);
  const unsigned char* from = series.segments + std::size_t{index} * series.segment_bytes;
  from = sum.add<std::int16_t>(from, series.narrow_orders);
  from = sum.add<std::int32_t>(from, series.wide_orders - 1);
  sum.finish(from);
  return {series.quantum * sum.value(), (series.quantum * 2.0 / series.segment_days) * sum.derivative()};
}

StateVector EphemerisTable::state(Body body, JulianDate<TDB> tdb) const {
  const Value km = evaluate(body, tdb.day, tdb.fraction);
  return {km.value / au_km, km.per_day / au_km};
}

std::optional<SunEarthMoon> EphemerisTable::sun_earth_moon(JulianDate<TDB> tdb) const {
  if (!covers(tdb)) {
    return std::nullopt;
  }
  SunEarthMoon at;
  at.sun = state(sun, tdb);
  at.moon = state(moon, tdb);
  const StateVector barycentre = state(earth_moon, tdb);
  constexpr double moons_share = 1.0 / (1.0 + earth_moon_mass_ratio);
  at.earth.position_au = at.sun.position_au + barycentre.position_au - moons_share * at.moon.position_au;
  at.earth.velocity_au_d = at.sun.velocity_au_d + barycentre.velocity_au_d - moons_share * at.moon.velocity_au_d;
  return at;
}

std::optional<StateVector> EphemerisTable::planet_heliocentric(Planet planet, JulianDate<TDB> tdb) const {
  if (!covers(tdb)) {
    return std::nullopt;
  }
  return state(static_cast<Body>(first_planet + static_cast<int>(planet)), tdb);
}

std::optional<Nutation> EphemerisTable::nutation(JulianDate<TT> tt) const {
  if (!contains(tt.day, tt.fraction)) {
    return std::nullopt;
  }
  const Vec3 angles = evaluate(earth_nutation, tt.day, tt.fraction).value;
  return Nutation{angles.x, angles.y, angles.z};
}

std::optional<LunarAngles> EphemerisTable::lunar_angles(JulianDate<TDB> tdb) const {
  if (!covers(tdb)) {
    return std::nullopt;
  }
  const Vec3 angles = evaluate(moon_axes, tdb.day, tdb.fraction).value;
  return LunarAngles{angles.x, angles.y, angles.z};
}

} // namespace vesper
