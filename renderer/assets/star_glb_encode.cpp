#include "vesper/assets/star_catalogue_check.hpp"
#include "vesper/assets/star_glb.hpp"
#include "vesper/assets/star_glb_layout.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

namespace vesper {
namespace {

using OrderedJson = nlohmann::ordered_json;
using namespace star_glb;

/// The double with the float's shortest decimal form, so that 4.61 does not become 4.610000133514404 in the file. It
/// rounds back to the same float.
double shortest(float value) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
  double result = 0.0;
  std::from_chars(text.data(), written.ptr, result);
  return result;
}

// Not shortened: the glTF rules compare the bounds with the buffer bit for bit.
OrderedJson bound_json(const StarCatalogue& catalogue, bool upper) {
  const std::array<float, 3> bound = position_bound(catalogue.stars, upper);
  return {static_cast<double>(bound[0]), static_cast<double>(bound[1]), static_cast<double>(bound[2])};
}

OrderedJson provenance_json(const StarProvenance& p) {
  return {{"source", p.source},
          {"source_file", p.source_file},
          {"source_sha256", p.source_sha256},
          {"tool", p.tool},
          {"options", p.options},
          {"licence", p.licence},
          {"epoch_jyear", p.epoch_jyear},
          {"read", p.read},
          {"kept", p.kept},
          {"illuminance_lux", p.illuminance_lux}};
}

OrderedJson units_json() {
  return {{"POSITION", "ICRS unit vector at the epoch"},
          {"_PROPER_MOTION", "rad/year, tangent to the sphere"},
          {"_PARALLAX", "rad, 0 unknown"},
          {"_RADIAL_VELOCITY", "km/s, receding positive, 0 unknown"},
          {"_ILLUMINANCE", "lux above the atmosphere"},
          {"_COLOR", "X, Y, Z (CIE 1931) and S (CIE 1951 V', 1700 lm/W) for Y = 1 lux"},
          {"_VARIABILITY", "peak-to-peak V magnitudes, 0 none or unknown"},
          {"magnitude", "Johnson V above the atmosphere"}};
}

OrderedJson identities_json(const StarCatalogue& catalogue) {
  OrderedJson hr = OrderedJson::array();
  OrderedJson hd = OrderedJson::array();
  OrderedJson name = OrderedJson::array();
  OrderedJson magnitude = OrderedJson::array();
  for (const StarIdentity& star : catalogue.identities) {
    hr.push_back(star.hr);
    hd.push_back(star.hd);
    name.push_back(star.name);
    magnitude.push_back(shortest(star.magnitude));
  }
  return {{"hr", std::move(hr)}, {"hd", std::move(hd)}, {"name", std::move(name)}, {"magnitude", std::move(magnitude)}};
}

OrderedJson document(const StarCatalogue& catalogue) {
  const std::size_t size = catalogue.stars.size() * sizeof(StarRecord);
  OrderedJson accessors = OrderedJson::array();
  OrderedJson members = OrderedJson::object();
  for (const Attribute& attribute : attributes) {
    members[attribute.name] = accessors.size();
    OrderedJson accessor{{"bufferView", 0},
                         {"byteOffset", attribute.offset},
                         {"componentType", component_float},
                         {"count", catalogue.stars.size()},
                         {"type", attribute.type}};
    if (accessors.empty()) {
      accessor["min"] = bound_json(catalogue, false);
      accessor["max"] = bound_json(catalogue, true);
    }
    accessors.push_back(std::move(accessor));
  }
  OrderedJson primitive{{"attributes", std::move(members)}, {"mode", mode_points}};
  OrderedJson mesh{{"name", "stars"},
                   {"primitives", OrderedJson::array({std::move(primitive)})},
                   {"extras", identities_json(catalogue)}};
  OrderedJson view{{"buffer", 0},
                   {"byteOffset", 0},
                   {"byteLength", size},
                   {"byteStride", sizeof(StarRecord)},
                   {"target", target_array_buffer}};
  OrderedJson asset{{"version", "2.0"},
                    {"generator", catalogue.provenance.tool},
                    {"copyright", catalogue.provenance.licence},
                    {"extras", {{"provenance", provenance_json(catalogue.provenance)}, {"units", units_json()}}}};
  OrderedJson node{{"name", "stars"}, {"mesh", 0}};
  OrderedJson scene{{"name", "sky"}, {"nodes", OrderedJson::array({0})}};
  return {{"asset", std::move(asset)},
          {"scene", 0},
          {"scenes", OrderedJson::array({std::move(scene)})},
          {"nodes", OrderedJson::array({std::move(node)})},
          {"meshes", OrderedJson::array({std::move(mesh)})},
          {"accessors", std::move(accessors)},
          {"bufferViews", OrderedJson::array({std::move(view)})},
          {"buffers", OrderedJson::array({OrderedJson{{"byteLength", size}}})}};
}

void append(Bytes& bytes, const void* data, std::size_t size) {
  const auto* begin = static_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), begin, begin + size);
}

void append(Bytes& bytes, std::uint32_t value) { append(bytes, &value, sizeof(value)); }

} // namespace

Bytes encode_star_glb(const StarCatalogue& catalogue) {
  check_star_catalogue(catalogue, ErrorKind::argument, "");
  std::string json = document(catalogue).dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t bin_size = catalogue.stars.size() * sizeof(StarRecord);
  const std::size_t total = header_size + chunk_header_size + json.size() + chunk_header_size + bin_size;
  if (total > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorKind::argument, "the catalogue is too large for one .glb file (4 GiB)",
                {"", "", "Split it into tiles or set a magnitude limit"});
  }
  Bytes bytes;
  bytes.reserve(total);
  append(bytes, magic);
  append(bytes, version);
  append(bytes, static_cast<std::uint32_t>(total));
  append(bytes, static_cast<std::uint32_t>(json.size()));
  append(bytes, json_chunk);
  append(bytes, json.data(), json.size());
  append(bytes, static_cast<std::uint32_t>(bin_size));
  append(bytes, bin_chunk);
  append(bytes, catalogue.stars.data(), bin_size);
  return bytes;
}

void write_star_glb(const std::filesystem::path& path, const StarCatalogue& catalogue) {
  write_file_atomically(path, encode_star_glb(catalogue));
}

} // namespace vesper
