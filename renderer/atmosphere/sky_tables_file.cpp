#include "vesper/atmosphere/sky_tables_file.hpp"

#include "vesper/base/data_folders.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/sha256.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <type_traits>

namespace vesper {
namespace {

constexpr std::array<char, 8> magic{'V', 'S', 'P', 'R', 'S', 'K', 'Y', '\0'};
constexpr std::uint32_t byte_order = 0x01020304;
constexpr std::uint32_t version = 2;
constexpr std::size_t digest_size = 64;

using Digest = std::array<char, digest_size>;

Digest to_digest(std::string_view text) {
  Digest digest{};
  std::copy_n(text.begin(), std::min(text.size(), digest_size), digest.begin());
  return digest;
}

std::string_view view_of(const Digest& digest) { return {digest.data(), digest.size()}; }

/// The numbers of the tables, without their texels.
struct Header {
  std::array<char, 8> magic;
  std::uint32_t byte_order;
  std::uint32_t version;
  Digest fingerprint;
  std::int32_t heights, views_below, views_above, lights, phase_nodes, transmittance_altitudes, transmittance_heights;
  float ground_km, top_km;
  std::array<float, 4> light, albedo;
};
static_assert(std::is_trivially_copyable_v<Header> && sizeof(Header) == 148);

std::array<float, 4> to_array(const f32::vec4& v) { return {v.x, v.y, v.z, v.w}; }
f32::vec4 to_vec4(const std::array<float, 4>& v) { return {v[0], v[1], v[2], v[3]}; }

/// Lists of texels in the order of the file.
constexpr std::array parts{&SkyTables::aerosol, &SkyTables::other, &SkyTables::ground, &SkyTables::phase,
                           &SkyTables::transmittance};

/// How many texels each has.
std::array<std::size_t, parts.size()> counts(const Header& header) {
  const auto product = [](auto... sizes) { return (std::size_t{1} * ... * static_cast<std::size_t>(sizes)); };
  const std::size_t scattering =
      product(header.heights, header.views_below + header.views_above, header.lights, f32::sky_azimuths);
  return {scattering, scattering, product(header.lights), product(header.phase_nodes),
          2 * product(header.transmittance_altitudes, header.transmittance_heights)};
}

std::size_t file_size(const Header& header) {
  const auto texels = counts(header);
  return sizeof(header) + std::accumulate(texels.begin(), texels.end(), std::size_t{0}) * sizeof(f32::vec4) +
         digest_size;
}

/// Whether numbers can be of tables at all: texels are logarithms to base 2 that a float's range must hold.
bool sound(const Header& header) {
  const auto nodes = {header.heights,
                      header.views_below,
                      header.views_above,
                      header.lights,
                      header.phase_nodes,
                      header.transmittance_altitudes,
                      header.transmittance_heights};
  const auto light = [](float value) { return std::isfinite(value) && value >= 0.0F; };
  return std::all_of(nodes.begin(), nodes.end(), [](std::int32_t n) { return n >= 2 && n <= 1024; }) &&
         header.ground_km > 0.0F && header.top_km > header.ground_km && std::isfinite(header.top_km) &&
         std::all_of(header.light.begin(), header.light.end(), light) &&
         std::all_of(header.albedo.begin(), header.albedo.end(), light);
}

bool sound(const std::vector<f32::vec4>& texels) {
  return std::all_of(texels.begin(), texels.end(), [](const f32::vec4& texel) {
    // Not-a-numbers fail too.
    return std::abs(texel.x) <= 126.0F && std::abs(texel.y) <= 126.0F && std::abs(texel.z) <= 126.0F &&
           std::abs(texel.w) <= 126.0F;
  });
}

[[noreturn]] void fail(const std::string& name, const std::string& place, const std::string& what) {
  throw Error(ErrorKind::input, what, {name, place, "Delete the file; it is made anew when it is needed"});
}

std::string byte(std::size_t offset) { return "byte " + std::to_string(offset); }

} // namespace

Bytes encode_sky_tables(const SkyTables& tables, std::string_view fingerprint) {
  const f32::SkyTableFrame& frame = tables.frame;
  const Header header{magic,
                      byte_order,
                      version,
                      to_digest(fingerprint),
                      frame.heights,
                      frame.views_below,
                      frame.views_above,
                      frame.lights,
                      static_cast<std::int32_t>(tables.phase.size()),
                      tables.transmittance_frame.altitudes,
                      tables.transmittance_frame.heights,
                      frame.ground_km,
                      frame.top_km,
                      to_array(tables.light),
                      to_array(tables.albedo)};
  Bytes bytes(file_size(header));
  std::byte* place = bytes.data();
  const auto put = [&](const void* data, std::size_t size) {
    std::memcpy(place, data, size);
    place += size;
  };
  put(&header, sizeof(header));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::vector<f32::vec4>& texels = tables.*parts[i];
    if (texels.size() != counts(header)[i]) {
      throw Error(ErrorKind::argument, "sky tables with " + std::to_string(texels.size()) + " texels in a part for " +
                                           std::to_string(counts(header)[i]));
    }
    put(texels.data(), texels.size() * sizeof(f32::vec4));
  }
  const std::string digest = sha256_hex(std::span(bytes).first(bytes.size() - digest_size));
  put(digest.data(), digest_size);
  return bytes;
}

SkyTables decode_sky_tables(std::span<const std::byte> bytes, const std::string& name, std::string_view fingerprint) {
  Header header{};
  if (!bytes.empty()) {
    std::memcpy(&header, bytes.data(), std::min(bytes.size(), sizeof(header)));
  }
  if (header.magic != magic) {
    fail(name, byte(0), "is no file of sky tables");
  }
  if (bytes.size() < sizeof(header) + digest_size) {
    fail(name, byte(bytes.size()), "ends before its tables begin");
  }
  if (header.byte_order != byte_order) {
    fail(name, byte(offsetof(Header, byte_order)), "comes from a machine with another byte order");
  }
  if (header.version != version) {
    fail(name, byte(offsetof(Header, version)),
         "has version " + std::to_string(header.version) + " of the format, and " + std::to_string(version) +
             " is the one read here");
  }
  if (!sound(header)) {
    fail(name, byte(offsetof(Header, heights)), "has sizes or numbers that no tables have");
  }
  const std::size_t size = file_size(header);
  if (size != bytes.size()) {
    fail(name, byte(std::min(size, bytes.size())),
         "has " + std::to_string(bytes.size()) + " bytes where " + std::to_string(size) + " belong to its sizes");
  }
  const std::span<const std::byte> covered = bytes.first(bytes.size() - digest_size);
  Digest digest{};
  std::memcpy(digest.data(), bytes.data() + covered.size(), digest.size());
  if (sha256_hex(covered) != view_of(digest)) {
    fail(name, byte(covered.size()), "has been altered: its SHA-256 is another");
  }
  if (view_of(header.fingerprint) != fingerprint) {
    fail(name, byte(offsetof(Header, fingerprint)), "was made from another medium, size or solver");
  }
  SkyTables tables;
  tables.frame = {header.ground_km,   header.top_km,      header.heights,
                  header.views_below, header.views_above, header.lights};
  tables.transmittance_frame = {header.transmittance_altitudes, header.transmittance_heights};
  tables.light = to_vec4(header.light);
  tables.albedo = to_vec4(header.albedo);
  const std::byte* place = bytes.data() + sizeof(header);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<f32::vec4>& texels = tables.*parts[i];
    texels.resize(counts(header)[i]);
    std::memcpy(texels.data(), place, texels.size() * sizeof(f32::vec4));
    if (!sound(texels)) {
      fail(name, byte(static_cast<std::size_t>(place - bytes.data())), "has numbers that no tables have");
    }
    place += texels.size() * sizeof(f32::vec4);
  }
  return tables;
}

std::string sky_tables_file_name(std::string_view fingerprint) {
  return "sky-" + std::string(fingerprint.substr(0, 32)) + ".tables";
}

SkyTables read_sky_tables(const std::filesystem::path& path, std::string_view fingerprint) {
  return decode_sky_tables(read_file(path), path.string(), fingerprint);
}

std::optional<SkyTables> installed_sky_tables(std::string_view fingerprint) {
  const std::filesystem::path path = find_data_file(sky_tables_file_name(fingerprint));
  return path.empty() ? std::nullopt : std::optional(read_sky_tables(path, fingerprint));
}

void write_sky_tables(const std::filesystem::path& path, const SkyTables& tables, std::string_view fingerprint) {
  write_file_atomically(path, encode_sky_tables(tables, fingerprint));
}

} // namespace vesper
