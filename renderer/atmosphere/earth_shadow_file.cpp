#include "vesper/atmosphere/earth_shadow_file.hpp"

#include "vesper/base/embedded.hpp"
#include "vesper/base/error.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace vesper {

extern const EmbeddedTable embedded_atmosphere_tables;

namespace {

static_assert(std::endian::native == std::endian::little);

struct ShadowHeader {
  std::array<char, 8> magic;
  std::int32_t version, inner, outer, wavelengths;
  double first_km, rows_per_km, edge_km, clear_km, width_km, nearest_sun_au, farthest_sun_au;
};
static_assert(std::is_trivially_copyable_v<ShadowHeader> && sizeof(ShadowHeader) == 80);

constexpr std::array<char, 8> shadow_magic{'V', 'S', 'P', 'R', 'S', 'H', 'D', 'W'};
constexpr std::int32_t shadow_version = 1;

[[noreturn]] void fail_shadow(const std::string& name, std::size_t place, const std::string& what) {
  throw Error(ErrorKind::input, what,
              {name, "byte " + std::to_string(place), "Give a file made by vesper_make_earth_shadow"});
}

bool sound(const ShadowHeader& header) {
  const auto count = [](std::int32_t number) { return number >= 1 && number <= 4096; };
  const auto length = [](double number) { return number > 0.0 && std::isfinite(number); };
  return count(header.inner) && count(header.outer) && count(header.wavelengths) && length(header.first_km) &&
         length(header.rows_per_km) && length(header.edge_km) && length(header.clear_km) && length(header.width_km) &&
         length(header.nearest_sun_au) && header.farthest_sun_au > header.nearest_sun_au &&
         std::isfinite(header.farthest_sun_au);
}

} // namespace

Bytes encode_earth_shadow_light(const EarthShadowLight& light) {
  const f64::LunarEclipseMap& frame = light.frame;
  const ShadowHeader header{shadow_magic,
                            shadow_version,
                            frame.inner,
                            frame.outer,
                            static_cast<std::int32_t>(light.wavelengths_nm.size()),
                            frame.first_km,
                            frame.rows_per_km,
                            frame.edge_km,
                            frame.clear_km,
                            frame.width_km,
                            light.nearest_sun_au,
                            light.farthest_sun_au};
  if (light.log_shares.size() != light.size()) {
    throw Error(ErrorKind::argument, "a map of the Earth's shadow with " + std::to_string(light.log_shares.size()) +
                                         " numbers in place of " + std::to_string(light.size()));
  }
  Bytes bytes(sizeof(header) + light.wavelengths_nm.size() * sizeof(double) +
              light.log_shares.size() * sizeof(std::uint16_t));
  std::byte* place = bytes.data();
  const auto put = [&](const void* data, std::size_t size) {
    std::memcpy(place, data, size);
    place += size;
  };
  put(&header, sizeof(header));
  put(light.wavelengths_nm.data(), light.wavelengths_nm.size() * sizeof(double));
  put(light.log_shares.data(), light.log_shares.size() * sizeof(std::uint16_t));
  return bytes;
}

EarthShadowLight decode_earth_shadow_light(std::span<const std::byte> bytes, const std::string& name) {
  ShadowHeader header{};
  if (!bytes.empty()) {
    std::memcpy(&header, bytes.data(), std::min(bytes.size(), sizeof(header)));
  }
  if (header.magic != shadow_magic) {
    fail_shadow(name, 0, "is no map of the Earth's shadow");
  }
  if (bytes.size() < sizeof(header)) {
    fail_shadow(name, bytes.size(), "ends before its map begins");
  }
  if (header.version != shadow_version) {
    fail_shadow(name, offsetof(ShadowHeader, version),
                "has version " + std::to_string(header.version) + " of the format, and " +
                    std::to_string(shadow_version) + " is the one read here");
  }
  if (!sound(header)) {
    fail_shadow(name, offsetof(ShadowHeader, inner), "has sizes or numbers that no such map has");
  }
  EarthShadowLight light;
  light.frame = {header.inner,    header.outer,       static_cast<int>(EarthShadowLight::rows),
                 header.first_km, header.rows_per_km, header.edge_km,
                 header.clear_km, header.width_km};
  light.nearest_sun_au = header.nearest_sun_au;
  light.farthest_sun_au = header.farthest_sun_au;
  light.wavelengths_nm.resize(static_cast<std::size_t>(header.wavelengths));
  const std::size_t wavelengths_size = light.wavelengths_nm.size() * sizeof(double);
  const std::size_t logs_size = light.size() * sizeof(std::uint16_t);
  const std::size_t size = sizeof(header) + wavelengths_size + logs_size;
  if (bytes.size() != size) {
    fail_shadow(name, std::min(bytes.size(), size),
                "has " + std::to_string(bytes.size()) + " bytes where " + std::to_string(size) +
                    " belong to its sizes");
  }
  light.log_shares.resize(light.size());
  std::memcpy(light.wavelengths_nm.data(), bytes.data() + sizeof(header), wavelengths_size);
  std::memcpy(light.log_shares.data(), bytes.data() + sizeof(header) + wavelengths_size, logs_size);
  if (!(light.wavelengths_nm.front() > 0.0) || !std::isfinite(light.wavelengths_nm.back()) ||
      std::adjacent_find(light.wavelengths_nm.begin(), light.wavelengths_nm.end(),
                         [](double low, double high) { return !(low < high); }) != light.wavelengths_nm.end()) {
    fail_shadow(name, sizeof(header), "has wavelengths that do not rise");
  }
  return light;
}

EarthShadowLight read_earth_shadow_light(const std::filesystem::path& path) {
  return decode_earth_shadow_light(read_file(path), path.string());
}

void write_earth_shadow_light(const std::filesystem::path& path, const EarthShadowLight& light) {
  write_file_atomically(path, encode_earth_shadow_light(light));
}

const EarthShadowLight& default_earth_shadow_light() {
  static const EarthShadowLight light = [] {
    const EmbeddedFile* file = embedded_atmosphere_tables.find("earth_shadow.bin");
    return decode_earth_shadow_light(std::as_bytes(file->data), "earth_shadow.bin");
  }();
  return light;
}

} // namespace vesper
