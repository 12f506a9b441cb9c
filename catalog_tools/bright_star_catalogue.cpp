#include "vesper/catalog_tools/bright_star_catalogue.hpp"

#include "vesper/base/error.hpp"
#include "vesper/catalog_tools/fixed_width.hpp"
#include "vesper/catalog_tools/gzip.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>
#include <unordered_map>

namespace vesper {
namespace {

constexpr std::size_t record_size = 197;
// The real catalogue has 1.7 MB.
constexpr std::size_t largest_catalogue = std::size_t{32} << 20;

constexpr Field hr_field{1, 4, "HR number"};
constexpr Field flamsteed_field{5, 7, "Flamsteed number"};
constexpr Field bayer_field{8, 10, "Bayer letter"};
constexpr Field superscript_field{11, 11, "Bayer superscript"};
constexpr Field constellation_field{12, 14, "constellation"};
constexpr Field hd_field{26, 31, "HD number"};
constexpr Field multiple_field{44, 44, "multiplicity"};
constexpr Field ads_field{45, 49, "ADS number"};
constexpr Field variable_field{52, 60, "variable star"};
constexpr Field ra_hours_field{76, 77, "right ascension, hours,"};
constexpr Field ra_minutes_field{78, 79, "right ascension, minutes,"};
constexpr Field ra_seconds_field{80, 83, "right ascension, seconds,"};
constexpr Field dec_sign_field{84, 84, "sign of declination"};
constexpr Field dec_degrees_field{85, 86, "declination, degrees,"};
constexpr Field dec_minutes_field{87, 88, "declination, arc minutes,"};
constexpr Field dec_seconds_field{89, 90, "declination, arc seconds,"};
constexpr Field position_field{76, 90, "position"};
constexpr Field v_field{103, 107, "V magnitude"};
constexpr Field b_v_field{110, 114, "colour B-V"};
constexpr Field type_field{128, 147, "spectral type"};
constexpr Field pm_ra_field{149, 154, "proper motion in right ascension"};
constexpr Field pm_dec_field{155, 160, "proper motion in declination"};
constexpr Field parallax_field{162, 166, "parallax"};
constexpr Field velocity_field{167, 170, "radial velocity"};

constexpr Range hr_range{1, 9999};
constexpr Range hd_range{0, 999999};
constexpr Range hours_range{0, 23};
constexpr Range sixtieths_range{0, 59};
constexpr Range seconds_range{0, 59.999};
constexpr Range degrees_range{0, 90};
constexpr Range v_range{-2, 20};
constexpr Range b_v_range{-0.6, 6};
constexpr Range motion_range{-20, 20};
constexpr Range parallax_range{-1, 1};
constexpr Range velocity_range{-999, 999};

constexpr const char* whole_remedy =
    "Give the fixed-width file of the Bright Star Catalogue, 5th edition, plain or gzipped";

bool is_positionless(unsigned hr) {
  return std::find(positionless_bright_stars.begin(), positionless_bright_stars.end(), hr) !=
         positionless_bright_stars.end();
}

[[noreturn]] void fail_file(const std::string& file, const std::string& place, const std::string& message) {
  throw Error(ErrorKind::input, message, {file, place, whole_remedy});
}

/// Only printable ASCII is a catalogue. Names the column of the first other byte.
void require_text(const FixedWidthRecord& record, std::string_view line, const std::string& file) {
  const auto* found = std::find_if(line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; });
  if (found != line.end()) {
    fail_file(file, fmt::format("line {}, column {}", record.line(), found - line.begin() + 1),
              fmt::format("byte 0x{:02x} is not text: not a star catalogue", static_cast<unsigned char>(*found)));
  }
}

unsigned read_hr(const FixedWidthRecord& record, std::string_view line, const std::string& file) {
  const std::string_view text = record.text(hr_field);
  const bool number = !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
  if (!number && record.line() == 1) {
    fail_file(
        file, "line 1, column 1",
        fmt::format("begins with \"{}\" where an HR number must stand: not a star catalogue", line.substr(0, 16)));
  }
  if (text.empty()) {
    record.fail(hr_field, "the HR number is blank; allowed are 1 to 9999",
                "Correct columns 1 to 4 of this line or fetch the catalogue again");
  }
  return *record.whole(hr_field, hr_range);
}

/// "Alp CMa" from the letter, or "33 Psc" from the number where there is none.
std::string read_name(const FixedWidthRecord& record) {
  const std::string_view constellation = record.text(constellation_field);
  const std::string_view letter = record.text(bayer_field);
  const std::string_view number = record.text(flamsteed_field);
  if (constellation.empty() || (letter.empty() && number.empty())) {
    return "";
  }
  return fmt::format("{}{} {}", letter.empty() ? number : letter,
                     letter.empty() ? std::string_view() : record.text(superscript_field), constellation);
}

void read_position(const FixedWidthRecord& record, BrightStar& star) {
  star.has_position = !record.blank(position_field);
  if (!star.has_position) {
    return;
  }
  star.right_ascension_deg =
      15.0 * (record.required(ra_hours_field, hours_range) + record.required(ra_minutes_field, sixtieths_range) / 60.0 +
              record.required(ra_seconds_field, seconds_range) / 3600.0);
  const std::string_view sign = record.text(dec_sign_field);
  if (sign != "+" && sign != "-") {
    record.fail(dec_sign_field,
                fmt::format("sign of declination \"{}\"; allowed are + and -", record.raw(dec_sign_field)),
                "Correct column 84 of this line or fetch the catalogue again");
  }
  const double declination = record.required(dec_degrees_field, degrees_range) +
                             record.required(dec_minutes_field, sixtieths_range) / 60.0 +
                             record.required(dec_seconds_field, sixtieths_range) / 3600.0;
  if (declination > 90.0) {
    record.fail(dec_sign_field,
                fmt::format("declination {}{:.4f} deg is out of range; allowed are -90 to +90", sign, declination),
                "Correct columns 84 to 90 of this line or fetch the catalogue again");
  }
  star.declination_deg = sign == "-" ? -declination : declination;
}

BrightStar read_record(const FixedWidthRecord& record, std::string_view line, const std::string& file) {
  require_text(record, line, file);
  BrightStar star;
  star.hr = read_hr(record, line, file);
  if (line.size() > record_size) {
    record.fail({record_size + 1, line.size(), ""},
                fmt::format("the record of HR {} has {} columns; allowed are {}", star.hr, line.size(), record_size),
                whole_remedy);
  }
  if (record.size() < v_field.last && !is_positionless(star.hr)) {
    record.fail({record.size() + 1, v_field.last, ""},
                fmt::format("the record of HR {} ends before its V magnitude (columns {} to {})", star.hr,
                            v_field.first, v_field.last),
                "Fetch the catalogue again: this line is truncated");
  }
  star.hd = record.whole(hd_field, hd_range).value_or(0);
  star.name = read_name(record);
  star.multiple = !record.blank(multiple_field) || !record.blank(ads_field);
  star.variable = !record.blank(variable_field);
  read_position(record, star);
  star.v_magnitude = record.number(v_field, v_range);
  star.b_v = record.number(b_v_field, b_v_range);
  star.spectral_type = record.text(type_field);
  star.pm_ra_arcsec_yr = record.number(pm_ra_field, motion_range);
  star.pm_dec_arcsec_yr = record.number(pm_dec_field, motion_range);
  star.parallax_arcsec = record.number(parallax_field, parallax_range);
  star.radial_velocity_km_s = record.number(velocity_field, velocity_range);
  return star;
}

std::vector<BrightStar> read_lines(std::string_view text, const std::string& file) {
  std::vector<BrightStar> stars;
  std::unordered_map<unsigned, std::size_t> line_of_hr;
  std::size_t line_number = 0;
  while (!text.empty()) {
    const std::size_t length = text.find('\n');
    std::string_view line = text.substr(0, length);
    text.remove_prefix(length == std::string_view::npos ? text.size() : length + 1);
    ++line_number;
    if (!line.empty() && line.back() == '\r') {
      line.remove_suffix(1);
    }
    const std::size_t last = line.find_last_not_of(' ');
    if (last == std::string_view::npos) {
      continue;
    }
    const std::string_view trimmed = line.substr(0, std::max(last + 1, std::min(line.size(), record_size)));
    const FixedWidthRecord record(trimmed, file, line_number);
    stars.push_back(read_record(record, trimmed, file));
    const auto [earlier, is_new] = line_of_hr.emplace(stars.back().hr, line_number);
    if (!is_new) {
      record.fail(hr_field, fmt::format("HR {} occurs again, first in line {}", stars.back().hr, earlier->second),
                  "Remove one of the two lines");
    }
  }
  if (stars.empty()) {
    fail_file(file, "", "the file holds no record");
  }
  return stars;
}

} // namespace

std::vector<BrightStar> read_bright_star_catalogue(std::span<const std::byte> content, const std::string& file) {
  if (content.empty()) {
    fail_file(file, "", "the file is empty");
  }
  if (is_gzip(content)) {
    const Bytes unpacked = gunzip(content, file, largest_catalogue);
    return read_lines({reinterpret_cast<const char*>(unpacked.data()), unpacked.size()}, file);
  }
  return read_lines({reinterpret_cast<const char*>(content.data()), content.size()}, file);
}

} // namespace vesper
