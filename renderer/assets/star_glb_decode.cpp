#include "vesper/assets/star_catalogue_check.hpp"
#include "vesper/assets/star_glb.hpp"
#include "vesper/assets/star_glb_layout.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

namespace vesper {
namespace {

using Json = nlohmann::json;
using namespace star_glb;

struct Chunks {
  std::string_view json;
  std::span<const std::byte> bin;
};

class GlbDecoder {
public:
  GlbDecoder(std::span<const std::byte> bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  StarCatalogue decode() {
    const Chunks chunks = split();
    const Json root = parse(chunks.json);
    StarCatalogue catalogue;
    const Json& asset = object(root, "asset", "");
    if (const std::string version = text(asset, "version", "asset"); version != "2.0") {
      fail("asset.version", "glTF version " + version + ", not 2.0");
    }
    const Json& asset_extras = object(asset, "extras", "asset");
    catalogue.provenance = provenance(object(asset_extras, "provenance", "asset.extras"));
    const Json& mesh = only(root, "meshes");
    const Json& primitive = only(mesh, "primitives");
    const std::size_t count = check_layout(root, primitive, chunks.bin.size());
    catalogue.identities = identities(object(mesh, "extras", "meshes[0]"), count);
    catalogue.stars.resize(count);
    std::memcpy(catalogue.stars.data(), chunks.bin.data(), count * sizeof(StarRecord));
    check_star_catalogue(catalogue, ErrorKind::input, name_);
    check_bounds(root["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()], catalogue.stars);
    return catalogue;
  }

private:
  [[noreturn]] void fail(const std::string& place, const std::string& message) const {
    throw Error(ErrorKind::input, message, {name_, place, star_file_remedy});
  }

  [[noreturn]] void fail_at_byte(std::size_t offset, const std::string& message) const {
    fail("byte " + std::to_string(offset), message);
  }

  [[nodiscard]] std::uint32_t word(std::size_t offset) const {
    if (offset + 4 > bytes_.size()) {
      fail_at_byte(bytes_.size(), "the file ends inside a header");
    }
    std::uint32_t value = 0;
    std::memcpy(&value, bytes_.data() + offset, 4);
    return value;
  }

  /// The content of the chunk at `offset`, of which the kind must be `kind`.
  [[nodiscard]] std::span<const std::byte> chunk(std::size_t offset, std::uint32_t kind, const char* kind_name) const {
    const std::size_t length = word(offset);
    if (word(offset + 4) != kind) {
      fail_at_byte(offset + 4, std::string("expected the ") + kind_name + " chunk");
    }
    const std::size_t begin = offset + chunk_header_size;
    if (length > bytes_.size() - begin) {
      fail_at_byte(offset, std::string("the ") + kind_name + " chunk claims " + std::to_string(length) +
                               " bytes, the file has " + std::to_string(bytes_.size() - begin) + " left");
    }
    if (length % 4 != 0) {
      fail_at_byte(offset, std::string("the length of the ") + kind_name + " chunk, " + std::to_string(length) +
                               ", is no multiple of 4");
    }
    return bytes_.subspan(begin, length);
  }

  [[nodiscard]] Chunks split() const {
    if (bytes_.empty()) {
      fail("", "the file is empty");
    }
    if (bytes_.size() < 4 || word(0) != magic) {
      fail_at_byte(0, "not a binary glTF file: it does not begin with \"glTF\"");
    }
    if (const std::uint32_t found = word(4); found != version) {
      fail_at_byte(4, "binary glTF version " + std::to_string(found) + ", not 2");
    }
    if (const std::uint32_t length = word(8); length != bytes_.size()) {
      fail_at_byte(8, "the header says " + std::to_string(length) + " bytes, the file has " +
                          std::to_string(bytes_.size()));
    }
    const auto json = chunk(header_size, json_chunk, "JSON");
    const std::size_t bin_offset = header_size + chunk_header_size + json.size();
    const auto bin = chunk(bin_offset, bin_chunk, "BIN");
    if (const std::size_t end = bin_offset + chunk_header_size + bin.size(); end != bytes_.size()) {
      fail_at_byte(end, "unexpected bytes after the BIN chunk");
    }
    return {{reinterpret_cast<const char*>(json.data()), json.size()}, bin};
  }

  [[nodiscard]] Json parse(std::string_view json) const {
    try {
      return Json::parse(json);
    } catch (const Json::parse_error& error) {
      fail_at_byte(header_size + chunk_header_size + error.byte, "the JSON chunk is broken");
    } catch (const Json::exception&) {
      fail_at_byte(header_size + chunk_header_size, "the JSON chunk holds a number that is out of range");
    }
  }

  [[nodiscard]] const Json& member(const Json& parent, const char* key, const std::string& path) const {
    if (!parent.is_object()) {
      fail(path.empty() ? "JSON" : path, "is not an object");
    }
    const auto found = parent.find(key);
    if (found == parent.end()) {
      fail(join(path, key), "is missing");
    }
    return *found;
  }

  [[nodiscard]] static std::string join(const std::string& path, const char* key) {
    return path.empty() ? std::string(key) : path + "." + key;
  }

  [[nodiscard]] const Json& object(const Json& parent, const char* key, const std::string& path) const {
    const Json& value = member(parent, key, path);
    if (!value.is_object()) {
      fail(join(path, key), "is not an object");
    }
    return value;
  }

  /// The single object in an array.
  [[nodiscard]] const Json& only(const Json& parent, const char* key) const {
    const Json& list = member(parent, key, "");
    if (!list.is_array() || list.size() != 1 || !list[0].is_object()) {
      fail(key, "is not a list of one object");
    }
    return list[0];
  }

  [[nodiscard]] std::string text(const Json& parent, const char* key, const std::string& path) const {
    const Json& value = member(parent, key, path);
    if (!value.is_string()) {
      fail(join(path, key), "is not a text");
    }
    return value.get<std::string>();
  }

  [[nodiscard]] std::uint64_t whole(const Json& parent, const char* key, const std::string& path) const {
    const Json& value = member(parent, key, path);
    if (!value.is_number_unsigned()) {
      fail(join(path, key), "is not a whole number from 0");
    }
    return value.get<std::uint64_t>();
  }

  void require_whole(const Json& parent, const char* key, const std::string& path, std::uint64_t expected) const {
    if (const std::uint64_t found = whole(parent, key, path); found != expected) {
      fail(join(path, key), "is " + std::to_string(found) + ", not " + std::to_string(expected));
    }
  }

  [[nodiscard]] double number(const Json& parent, const char* key, const std::string& path) const {
    const Json& value = member(parent, key, path);
    if (!value.is_number()) {
      fail(join(path, key), "is not a number");
    }
    return value.get<double>();
  }

  [[nodiscard]] StarProvenance provenance(const Json& p) const {
    const std::string path = "asset.extras.provenance";
    return {text(p, "source", path),        text(p, "source_file", path),
            text(p, "source_sha256", path), text(p, "tool", path),
            text(p, "options", path),       text(p, "licence", path),
            number(p, "epoch_jyear", path), whole(p, "read", path),
            whole(p, "kept", path),         number(p, "illuminance_lux", path)};
  }

  /// Checks buffer, view, primitive and accessors against the one layout that there is. Returns the count of stars.
  [[nodiscard]] std::size_t check_layout(const Json& root, const Json& primitive, std::size_t bin_size) const {
    const std::uint64_t buffer_size = whole(only(root, "buffers"), "byteLength", "buffers[0]");
    // The chunk is padded to a multiple of 4, the buffer need not be.
    if (buffer_size > bin_size || bin_size - buffer_size > 3) {
      fail("buffers[0].byteLength",
           "is " + std::to_string(buffer_size) + ", the BIN chunk holds " + std::to_string(bin_size));
    }
    const Json& view = only(root, "bufferViews");
    const std::string view_path = "bufferViews[0]";
    require_whole(view, "buffer", view_path, 0);
    require_whole(view, "byteOffset", view_path, 0);
    require_whole(view, "byteLength", view_path, buffer_size);
    require_whole(view, "byteStride", view_path, sizeof(StarRecord));
    require_whole(view, "target", view_path, target_array_buffer);
    require_whole(primitive, "mode", "meshes[0].primitives[0]", mode_points);
    const std::string attributes_path = "meshes[0].primitives[0].attributes";
    const Json& members = object(primitive, "attributes", "meshes[0].primitives[0]");
    const Json& accessors = member(root, "accessors", "");
    for (const Attribute& attribute : attributes) {
      const std::uint64_t index = whole(members, attribute.name, attributes_path);
      if (!accessors.is_array() || index >= accessors.size()) {
        fail(join(attributes_path, attribute.name), "names accessor " + std::to_string(index) + ", which is not there");
      }
      check_accessor(accessors[index], "accessor " + std::to_string(index), attribute, buffer_size);
    }
    return buffer_size / sizeof(StarRecord);
  }

  void check_accessor(const Json& accessor, const std::string& path, const Attribute& attribute,
                      std::uint64_t buffer_size) const {
    require_whole(accessor, "bufferView", path, 0);
    require_whole(accessor, "componentType", path, component_float);
    require_whole(accessor, "byteOffset", path, attribute.offset);
    if (const std::string type = text(accessor, "type", path); type != attribute.type) {
      fail(join(path, "type"), attribute.name + std::string(" is ") + type + ", not " + attribute.type);
    }
    const std::uint64_t count = whole(accessor, "count", path);
    if (count != buffer_size / sizeof(StarRecord) || buffer_size % sizeof(StarRecord) != 0) {
      fail(join(path, "count"), "claims " + std::to_string(count) + " stars, the buffer of " +
                                    std::to_string(buffer_size) + " bytes holds " +
                                    std::to_string(buffer_size / sizeof(StarRecord)) + " of " +
                                    std::to_string(sizeof(StarRecord)));
    }
  }

  /// glTF demands the exact bounds of the positions: viewers place their camera by them.
  void check_bounds(const Json& accessor, const std::vector<StarRecord>& stars) const {
    for (const bool upper : {false, true}) {
      const char* key = upper ? "max" : "min";
      const std::array<float, 3> bound = position_bound(stars, upper);
      const Json& stated = member(accessor, key, "accessor of POSITION");
      const Json expected{static_cast<double>(bound[0]), static_cast<double>(bound[1]), static_cast<double>(bound[2])};
      if (stated != expected) {
        fail(join("accessor of POSITION", key), "is " + stated.dump() + ", the stars have " + expected.dump());
      }
    }
  }

  [[nodiscard]] const Json& column(const Json& extras, const char* key, std::size_t count) const {
    const std::string path = "meshes[0].extras";
    const Json& list = member(extras, key, path);
    if (!list.is_array() || list.size() != count) {
      fail(join(path, key), "is not a list of " + std::to_string(count) + " items, one a star");
    }
    return list;
  }

  [[nodiscard]] std::uint32_t identifier(const Json& value, const char* key, std::size_t star) const {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) {
      fail("star " + std::to_string(star), std::string("its ") + key + " is not a whole number from 0 to 4294967295");
    }
    return value.get<std::uint32_t>();
  }

  [[nodiscard]] std::vector<StarIdentity> identities(const Json& extras, std::size_t count) const {
    const Json& hr = column(extras, "hr", count);
    const Json& hd = column(extras, "hd", count);
    const Json& name = column(extras, "name", count);
    const Json& magnitude = column(extras, "magnitude", count);
    std::vector<StarIdentity> identities(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (!name[i].is_string()) {
        fail("star " + std::to_string(i), "its name is not a text");
      }
      // Compared as a double: a number beyond the floats must not reach the conversion below.
      if (!magnitude[i].is_number() || !(std::abs(magnitude[i].get<double>()) <= 100.0)) {
        fail("star " + std::to_string(i), "its magnitude is not a number from -100 to 100");
      }
      identities[i] = {identifier(hr[i], "hr", i), identifier(hd[i], "hd", i), magnitude[i].get<float>(),
                       name[i].get<std::string>()};
    }
    return identities;
  }

  std::span<const std::byte> bytes_;
  std::string name_;
};

} // namespace

StarCatalogue decode_star_glb(std::span<const std::byte> bytes, const std::string& name) {
  return GlbDecoder(bytes, name).decode();
}

StarCatalogue read_star_glb(const std::filesystem::path& path) {
  return decode_star_glb(read_file(path), path.string());
}

} // namespace vesper
