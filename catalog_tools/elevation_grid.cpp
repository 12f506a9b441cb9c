#include "vesper/catalog_tools/elevation_grid.hpp"

#include "vesper/base/error.hpp"
#include "vesper/base/units.hpp"
#include "vesper/catalog_tools/moon_products.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace vesper {
namespace {

static_assert(std::endian::native == std::endian::little, "samples are swapped or not as if this machine were");

// Reference spheres of the Moon differ by less.
constexpr double radius_tolerance_m = 1000.0;

struct SampleKind {
  const char* name; ///< SAMPLE_TYPE
  int bits;
  bool big_endian;
};
constexpr std::array<SampleKind, 8> sample_kinds = {{{"LSB_INTEGER", 16, false},
                                                     {"PC_INTEGER", 16, false},
                                                     {"VAX_INTEGER", 16, false},
                                                     {"MSB_INTEGER", 16, true},
                                                     {"INTEGER", 16, true},
                                                     {"SUN_INTEGER", 16, true},
                                                     {"MAC_INTEGER", 16, true},
                                                     {"PC_REAL", 32, false}}};

/// What the label says of the samples.
struct Layout {
  int lines = 0;
  int samples = 0;
  SampleKind kind{};
  double metres_by_unit = 1;
  double scale = 1; ///< height in units = scale * sample + offset
  double offset = 0;
  double west_edge_deg = 0;
  std::optional<double> missing; ///< a sample's value
};

class LayoutReader {
public:
  explicit LayoutReader(const PdsLabel& label) : label_(label) {}

  [[nodiscard]] Layout read() const {
    Layout layout;
    layout.kind = sample_kind();
    read_projection(layout);
    read_scale(layout);
    if (const auto* missing = label_.find("IMAGE", "MISSING_CONSTANT")) {
      layout.missing = label_.number(*missing);
    }
    if (const auto* bands = label_.find("IMAGE", "BANDS")) {
      require(*bands, 1.0, "1");
    }
    for (const char* key : {"LINE_PREFIX_BYTES", "LINE_SUFFIX_BYTES"}) {
      if (const auto* bytes = label_.find("IMAGE", key)) {
        require(*bytes, 0.0, "0");
      }
    }
    return layout;
  }

private:
  void require(const PdsLabel::Statement& statement, double expected, const std::string& allowed) const {
    if (!(std::abs(label_.number(statement) - expected) <= 1.0e-9 * std::max(1.0, std::abs(expected)))) {
      label_.refuse(statement, allowed);
    }
  }

  [[nodiscard]] SampleKind sample_kind() const {
    const auto& type = label_.get("IMAGE", "SAMPLE_TYPE");
    const auto* found = std::find_if(sample_kinds.begin(), sample_kinds.end(),
                                     [&](const SampleKind& kind) { return type.value == kind.name; });
    if (found == sample_kinds.end()) {
      label_.refuse(type, "LSB_INTEGER, MSB_INTEGER or PC_REAL");
    }
    require(label_.get("IMAGE", "SAMPLE_BITS"), found->bits, fmt::format("{} with {}", found->bits, found->name));
    return *found;
  }

  void read_projection(Layout& layout) const {
    const std::string object = "IMAGE_MAP_PROJECTION";
    const auto& type = label_.get(object, "MAP_PROJECTION_TYPE");
    if (type.value != "SIMPLE CYLINDRICAL" && type.value != "SIMPLE_CYLINDRICAL") {
      label_.refuse(type, "SIMPLE CYLINDRICAL");
    }
    const auto& direction = label_.get(object, "POSITIVE_LONGITUDE_DIRECTION");
    if (direction.value != "EAST") {
      label_.refuse(direction, "EAST");
    }
    require(label_.get(object, "MAXIMUM_LATITUDE"), 90.0, "90, for a map of the whole globe");
    require(label_.get(object, "MINIMUM_LATITUDE"), -90.0, "-90, for a map of the whole globe");
    layout.west_edge_deg = label_.number(label_.get(object, "WESTERNMOST_LONGITUDE"));
    if (!(std::abs(layout.west_edge_deg) <= 360.0)) {
      label_.refuse(label_.get(object, "WESTERNMOST_LONGITUDE"), "-360 to 360");
    }
    require(label_.get(object, "EASTERNMOST_LONGITUDE"), layout.west_edge_deg + 360.0,
            fmt::format("{}, for a map of the whole globe", layout.west_edge_deg + 360.0));
    const auto& lines = label_.get("IMAGE", "LINES");
    const auto& samples = label_.get("IMAGE", "LINE_SAMPLES");
    layout.lines = label_.whole(lines);
    layout.samples = label_.whole(samples);
    const auto& resolution = label_.get(object, "MAP_RESOLUTION");
    const double pixels_per_deg = label_.number(resolution);
    if (resolution.unit.find("PIX") != 0 || !(pixels_per_deg >= 0.1 && pixels_per_deg <= 4096.0)) {
      label_.refuse(resolution, "0.1 to 4096 <pix/deg>");
    }
    require(lines, 180.0 * pixels_per_deg, fmt::format("{} by MAP_RESOLUTION", 180.0 * pixels_per_deg));
    require(samples, 360.0 * pixels_per_deg, fmt::format("{} by MAP_RESOLUTION", 360.0 * pixels_per_deg));
    const auto& radius = label_.get(object, "A_AXIS_RADIUS");
    if (radius.unit != "KM" ||
        !(std::abs(label_.number(radius) - moon_reference_radius.to(kilometre)) <= radius_tolerance_m / 1000.0)) {
      label_.refuse(radius, "the Moon's, about 1737.4 <km>");
    }
  }

  /// Samples are radii less OFFSET where it is the radius of a sphere, and heights where there is none.
  void read_scale(Layout& layout) const {
    const auto* unit = label_.find("IMAGE", "UNIT");
    if (unit != nullptr && unit->value.starts_with("KILOMETER")) {
      layout.metres_by_unit = 1000.0;
    } else if (unit != nullptr && !unit->value.starts_with("METER")) {
      label_.refuse(*unit, "METER or KILOMETER");
    }
    if (const auto* scale = label_.find("IMAGE", "SCALING_FACTOR")) {
      layout.scale = label_.number(*scale);
      if (!(layout.scale > 0.0)) {
        label_.refuse(*scale, "a number above 0");
      }
    }
    const auto* offset = label_.find("IMAGE", "OFFSET");
    const double radius_km = label_.number(label_.get("IMAGE_MAP_PROJECTION", "A_AXIS_RADIUS"));
    double sphere_m = 1000.0 * radius_km;
    if (offset != nullptr && label_.number(*offset) != 0.0) {
      sphere_m = label_.number(*offset) * layout.metres_by_unit;
      if (!(std::abs(sphere_m - 1000.0 * radius_km) <= radius_tolerance_m)) {
        label_.refuse(*offset, fmt::format("0 or the radius of the sphere, {} km by A_AXIS_RADIUS", radius_km));
      }
    }
    layout.offset = (sphere_m - moon_reference_radius.to(metre)) / layout.metres_by_unit;
  }

  const PdsLabel& label_;
};

/// A sample as its type and byte order say.
double sample(const std::byte* bytes, const SampleKind& kind, bool big_endian) {
  if (kind.bits == 32) {
    float value = 0;
    std::memcpy(&value, bytes, sizeof(value));
    return static_cast<double>(value);
  }
  std::uint16_t value = 0;
  std::memcpy(&value, bytes, sizeof(value));
  const auto swapped = static_cast<std::uint16_t>((value << 8U) | (value >> 8U));
  return std::bit_cast<std::int16_t>(big_endian ? swapped : value);
}

struct Extremes {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
};

class GridReader {
public:
  GridReader(const PdsLabel& label, std::span<const std::byte> content, const std::filesystem::path& file)
      : label_(label), content_(content), file_(file), layout_(LayoutReader(label).read()) {}

  [[nodiscard]] GlobeGrid read() const {
    check_name();
    check_size();
    const Extremes found = extremes(layout_.kind.big_endian);
    if (const std::string fault = fault_of(found); !fault.empty()) {
      const bool swapped = layout_.kind.bits == 16 && fault_of(extremes(!layout_.kind.big_endian)).empty();
      fail(fault + (swapped ? "; with their bytes swapped they would be" : ""),
           swapped ? fmt::format("Set SAMPLE_TYPE in {} to {}", label_.file(),
                                 layout_.kind.big_endian ? "LSB_INTEGER" : "MSB_INTEGER")
                   : fmt::format("Fetch image and label again, or have MISSING_CONSTANT in the object IMAGE of {} name "
                                 "the value of missing samples",
                                 label_.file()),
           place_of_first_outside());
    }
    GlobeGrid grid{layout_.samples, layout_.lines, layout_.west_edge_deg, {}, file_.string()};
    grid.values.reserve(count());
    for (std::size_t i = 0; i < count(); ++i) {
      const double value = raw(i, layout_.kind.big_endian);
      grid.values.push_back(is_missing(value) ? std::numeric_limits<float>::quiet_NaN()
                                              : static_cast<float>(height_m(value)));
    }
    return grid;
  }

private:
  [[noreturn]] void fail(const std::string& message, const std::string& remedy, const std::string& place = "") const {
    throw Error(ErrorKind::input, message, {file_.string(), place, remedy});
  }

  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(layout_.lines) * static_cast<std::size_t>(layout_.samples);
  }
  [[nodiscard]] double raw(std::size_t i, bool big_endian) const {
    return sample(content_.data() + i * static_cast<std::size_t>(layout_.kind.bits / 8), layout_.kind, big_endian);
  }
  [[nodiscard]] bool is_missing(double value) const { return std::isnan(value) || value == layout_.missing; }
  [[nodiscard]] double height_m(double value) const {
    return (layout_.scale * value + layout_.offset) * layout_.metres_by_unit;
  }

  /// The label must mean this file. Names differ in case where a file was copied through another system.
  void check_name() const {
    const PdsLabel::Statement* pointer = nullptr;
    for (const auto& statement : label_.statements()) {
      if (statement.key == "^IMAGE") {
        pointer = &statement;
      }
    }
    if (pointer == nullptr) {
      throw Error(ErrorKind::input, "^IMAGE is missing: the label describes no image",
                  {label_.file(), "", "Give the label of the elevation grid"});
    }
    const std::string name = file_.filename().string();
    const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
    if (!std::equal(name.begin(), name.end(), pointer->value.begin(), pointer->value.end(), same)) {
      label_.refuse(*pointer, fmt::format("\"{}\", the name of the image", name));
    }
  }

  void check_size() const {
    const std::size_t expected = count() * static_cast<std::size_t>(layout_.kind.bits / 8);
    if (content_.size() != expected) {
      fail(fmt::format("the file has {} bytes; by its label ({} x {} samples of {} bits) it should have {}",
                       content_.size(), layout_.samples, layout_.lines, layout_.kind.bits, expected),
           "Fetch image and label again");
    }
  }

  [[nodiscard]] Extremes extremes(bool big_endian) const {
    Extremes found;
    for (std::size_t i = 0; i < count(); ++i) {
      if (const double value = raw(i, big_endian); !is_missing(value)) {
        found.least = std::min(found.least, value);
        found.most = std::max(found.most, value);
      }
    }
    return found;
  }

  [[nodiscard]] bool is_moons(double value) const {
    return height_m(value) >= lowest_moon_elevation_m && height_m(value) <= highest_moon_elevation_m;
  }

  /// Of the first sample that is no height of the Moon; "" where all are.
  [[nodiscard]] std::string place_of_first_outside() const {
    for (std::size_t i = 0; i < count(); ++i) {
      if (const double value = raw(i, layout_.kind.big_endian); !is_missing(value) && !is_moons(value)) {
        const auto across = static_cast<std::size_t>(layout_.samples);
        return fmt::format("line {}, sample {}", i / across + 1, i % across + 1);
      }
    }
    return "";
  }

  /// What is wrong with the samples between these, or "".
  [[nodiscard]] std::string fault_of(const Extremes& found) const {
    if (found.least > found.most) {
      return "every sample is missing";
    }
    if (!is_moons(found.least) || !is_moons(found.most)) {
      return fmt::format("heights run from {:.1f} to {:.1f} m; allowed are those of the Moon, {:.0f} to {:.0f} m",
                         height_m(found.least), height_m(found.most), lowest_moon_elevation_m,
                         highest_moon_elevation_m);
    }
    for (const auto& [key, value] : {std::pair{"MINIMUM", found.least}, std::pair{"MAXIMUM", found.most}}) {
      const auto* stated = label_.find("IMAGE", key);
      // Floats are printed with a few digits, and a published label was seen to be off by one.
      const double tolerance = layout_.kind.bits == 32 ? 1.0e-4 * std::max(std::abs(value), 1.0) : 2.0;
      if (stated != nullptr && !(std::abs(label_.number(*stated) - value) <= tolerance)) {
        return fmt::format("the {} of its samples is {}; the label {} says {}",
                           key == std::string_view("MINIMUM") ? "least" : "largest", value, label_.file(),
                           stated->value);
      }
    }
    return "";
  }

  const PdsLabel& label_;
  std::span<const std::byte> content_;
  const std::filesystem::path& file_;
  Layout layout_;
};

} // namespace

std::filesystem::path find_pds_label(const std::filesystem::path& image) {
  for (const char* ending : {".LBL", ".lbl"}) {
    std::filesystem::path label = image;
    label.replace_extension(ending);
    if (std::filesystem::exists(label)) {
      return label;
    }
  }
  throw Error(ErrorKind::file, "has no label (.LBL) beside it",
              {image.string(), "", "Put the label that was published with it into its folder, or name it by --label"});
}

GlobeGrid read_elevation_grid(const PdsLabel& label, std::span<const std::byte> content,
                              const std::filesystem::path& file) {
  return GridReader(label, content, file).read();
}

} // namespace vesper
