#include "vesper/assets/moon_map.hpp"

#include "vesper/assets/cube_texels.hpp"
#include "vesper/assets/half_float.hpp"
#include "vesper/assets/image_file.hpp"
#include "vesper/base/csv.hpp"
#include "vesper/base/error.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace vesper {
namespace {

constexpr const char* moon_map_remedy = "Make the file again with vesper-catalog moon";
constexpr std::array<const char*, 4> channels = {"A", "NX", "NY", "NZ"};
// A unit vector of 16-bit floats is off by up to 5e-4.
constexpr double unit_tolerance = 1.0e-3;

struct TextField {
  const char* name;
  std::string MoonMapProvenance::*member;
};
constexpr std::array<TextField, 7> text_fields = {{{"albedo_file", &MoonMapProvenance::albedo_file},
                                                   {"albedo_sha256", &MoonMapProvenance::albedo_sha256},
                                                   {"elevation_file", &MoonMapProvenance::elevation_file},
                                                   {"elevation_sha256", &MoonMapProvenance::elevation_sha256},
                                                   {"label_sha256", &MoonMapProvenance::label_sha256},
                                                   {"tool", &MoonMapProvenance::tool},
                                                   {"options", &MoonMapProvenance::options}}};
struct CountField {
  const char* name;
  std::uint64_t MoonMapProvenance::*member;
};
constexpr std::array<CountField, 4> count_fields = {{{"albedo_pixels", &MoonMapProvenance::albedo_pixels},
                                                     {"albedo_filled", &MoonMapProvenance::albedo_filled},
                                                     {"elevation_pixels", &MoonMapProvenance::elevation_pixels},
                                                     {"elevation_filled", &MoonMapProvenance::elevation_filled}}};
constexpr const char* scale_field = "albedo_scale";

[[noreturn]] void fail(ErrorKind kind, const std::string& file, const std::string& place, const std::string& message) {
  throw Error(kind, message, {file, place, moon_map_remedy});
}

/// The rule that a texel breaks, or nullptr.
const char* fault_of(const float* texel, const Vec3& outward) {
  if (!std::all_of(texel, texel + 4, [](float v) { return std::isfinite(v); })) {
    return "a number is not finite";
  }
  if (!(texel[0] > 0.0F && texel[0] <= 1.0F)) {
    return "the albedo is not above 0 and at most 1";
  }
  const Vec3 normal(texel[1], texel[2], texel[3]);
  if (std::abs(glm::length(normal) - 1.0) > unit_tolerance) {
    return "the normal is not a unit vector";
  }
  return glm::dot(normal, outward) > 0.0 ? nullptr : "the normal points into the Moon";
}

void check(const MoonMap& map, ErrorKind kind, const std::string& file) {
  if (map.face_size < least_moon_face || map.face_size > most_moon_face || map.face_size % 2 != 0) {
    fail(kind, file, "",
         "a face has " + std::to_string(map.face_size) + " texels a side; allowed are even numbers from " +
             std::to_string(least_moon_face) + " to " + std::to_string(most_moon_face));
  }
  const std::size_t count = cube_texel_count(map.face_size);
  if (map.texels.size() != 4 * count) {
    fail(kind, file, "",
         "holds " + std::to_string(map.texels.size()) + " numbers where " + std::to_string(4 * count) + " belong");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (const char* fault = fault_of(&map.texels[4 * i], cube_texel(map.face_size, i).direction)) {
      const auto width = static_cast<std::size_t>(map.face_size);
      fail(kind, file, "column " + std::to_string(i % width) + ", row " + std::to_string(i / width), fault);
    }
  }
}

ImageMetadata metadata_of(const MoonMapProvenance& p) {
  ImageMetadata metadata{{"ImageDescription",
                          "Moon, cube map in mean-Earth axes (X to 0 E 0 N, Y to 90 E, Z to the north pole), faces +X "
                          "-X +Y -Y +Z -Z from the top: A normal albedo, NX NY NZ unit normal of the relief"}};
  for (const TextField& field : text_fields) {
    metadata.emplace_back(field.name, p.*field.member);
  }
  for (const CountField& field : count_fields) {
    metadata.emplace_back(field.name, std::to_string(p.*field.member));
  }
  std::string scale;
  append_number(scale, p.albedo_scale);
  metadata.emplace_back(scale_field, scale);
  return metadata;
}

class MoonMapDecoder {
public:
  MoonMapDecoder(const FloatImage& image, const std::string& file) : image_(image), file_(file) {}

  [[nodiscard]] MoonMap decode() const {
    if (image_.height != 6 * image_.width) {
      fail(ErrorKind::input, file_, "",
           "is no cube map: it has " + std::to_string(image_.width) + " x " + std::to_string(image_.height) +
               " pixels, six square faces below each other are six times as high as wide");
    }
    MoonMap map{image_.width, texels(), provenance()};
    check(map, ErrorKind::input, file_);
    return map;
  }

private:
  [[nodiscard]] std::vector<float> texels() const {
    const std::size_t count = image_.values.size() / image_.channels.size();
    std::vector<float> texels(4 * count);
    for (std::size_t channel = 0; channel < channels.size(); ++channel) {
      const auto found = std::find(image_.channels.begin(), image_.channels.end(), channels[channel]);
      if (found == image_.channels.end()) {
        fail(ErrorKind::input, file_, "", std::string("is no map of the Moon: it has no channel ") + channels[channel]);
      }
      const auto from = static_cast<std::size_t>(found - image_.channels.begin());
      for (std::size_t i = 0; i < count; ++i) {
        texels[4 * i + channel] = image_.values[i * image_.channels.size() + from];
      }
    }
    return texels;
  }

  [[nodiscard]] const std::string& attribute(const char* name) const {
    const auto found = std::find_if(image_.metadata.begin(), image_.metadata.end(),
                                    [&](const auto& entry) { return entry.first == name; });
    if (found == image_.metadata.end()) {
      fail(ErrorKind::input, file_, name, "is missing from the provenance");
    }
    return found->second;
  }

  template <class Number> [[nodiscard]] Number number(const char* name) const {
    const std::string& text = attribute(name);
    Number value{};
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc() || end != text.data() + text.size()) {
      fail(ErrorKind::input, file_, name, '"' + text + "\" is not a number");
    }
    return value;
  }

  [[nodiscard]] MoonMapProvenance provenance() const {
    MoonMapProvenance p;
    for (const TextField& field : text_fields) {
      p.*field.member = attribute(field.name);
    }
    for (const CountField& field : count_fields) {
      p.*field.member = number<std::uint64_t>(field.name);
    }
    p.albedo_scale = number<double>(scale_field);
    return p;
  }

  const FloatImage& image_;
  const std::string& file_;
};

} // namespace

double moon_disc_albedo(const MoonMap& map) {
  double light = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < cube_texel_count(map.face_size); ++i) {
    const CubeTexel texel = cube_texel(map.face_size, i);
    const double projected = std::max(texel.direction.x, 0.0) * texel.solid_angle_sr;
    light += projected * static_cast<double>(map.texels[4 * i]);
    area += projected;
  }
  return light / area;
}

void write_moon_map(const std::filesystem::path& path, const MoonMap& map) {
  check(map, ErrorKind::argument, path.string());
  write_exr(path, map.face_size, 6 * map.face_size, {channels.begin(), channels.end()}, map.texels,
            std::all_of(map.texels.begin(), map.texels.end(), is_half) ? ExrDepth::half : ExrDepth::single,
            metadata_of(map.provenance));
}

MoonMap read_moon_map(const std::filesystem::path& path) {
  const FloatImage image = read_image(path);
  const std::string file = path.string();
  return MoonMapDecoder(image, file).decode();
}

MoonMap decode_moon_map(std::span<const std::byte> bytes, const std::string& name) {
  const FloatImage image = decode_image(bytes, name);
  return MoonMapDecoder(image, name).decode();
}

} // namespace vesper
