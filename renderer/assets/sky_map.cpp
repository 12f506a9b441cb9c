#include "vesper/assets/sky_map.hpp"

#include "vesper/assets/cube_texels.hpp"
#include "vesper/assets/image_file.hpp"
#include "vesper/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vesper {
namespace {

constexpr const char* sky_map_remedy = "Make the file again with vesper-catalog panorama";
constexpr std::array<const char*, 4> sky_channels = {"X", "Y", "Z", "S"};

struct ProvenanceField {
  const char* name;
  std::string SkyMapProvenance::*member;
};
constexpr std::array<ProvenanceField, 8> provenance_fields = {{{"source_files", &SkyMapProvenance::source_files},
                                                               {"source_sha256", &SkyMapProvenance::source_sha256},
                                                               {"coordinates", &SkyMapProvenance::coordinates},
                                                               {"tool", &SkyMapProvenance::tool},
                                                               {"options", &SkyMapProvenance::options},
                                                               {"calibration", &SkyMapProvenance::calibration},
                                                               {"credit", &SkyMapProvenance::credit},
                                                               {"budget", &SkyMapProvenance::budget}}};

void require_face_size(int face_size, ErrorKind kind, const std::string& file) {
  if (face_size < least_sky_face || face_size > most_sky_face) {
    throw Error(kind,
                "a face has " + std::to_string(face_size) + " texels a side; allowed are " +
                    std::to_string(least_sky_face) + " to " + std::to_string(most_sky_face),
                {file, "", sky_map_remedy});
  }
}

SkyMap sky_map_of(const FloatImage& image, const std::string& file) {
  const auto fail = [&](const std::string& place, const std::string& message) {
    throw Error(ErrorKind::input, message, {file, place, sky_map_remedy});
  };
  if (image.height != 6 * image.width) {
    fail("", "is no cube map: it has " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                 " pixels, six square faces below each other are six times as high as wide");
  }
  require_face_size(image.width, ErrorKind::input, file);
  SkyMap map{image.width, {}, {}};
  const std::size_t count = cube_texel_count(image.width);
  map.texels.resize(sky_channels.size() * count);
  for (std::size_t channel = 0; channel < sky_channels.size(); ++channel) {
    const auto found = std::find(image.channels.begin(), image.channels.end(), sky_channels[channel]);
    if (found == image.channels.end()) {
      fail("", std::string("is no map of the sky: it has no channel ") + sky_channels[channel]);
    }
    const auto from = static_cast<std::size_t>(found - image.channels.begin());
    for (std::size_t i = 0; i < count; ++i) {
      const float value = image.values[i * image.channels.size() + from];
      if (!std::isfinite(value)) {
        const auto width = static_cast<std::size_t>(image.width);
        fail("column " + std::to_string(i % width) + ", row " + std::to_string(i / width), "a number is not finite");
      }
      map.texels[sky_channels.size() * i + channel] = value;
    }
  }
  for (const ProvenanceField& field : provenance_fields) {
    const auto found = std::find_if(image.metadata.begin(), image.metadata.end(),
                                    [&](const auto& entry) { return entry.first == field.name; });
    if (found == image.metadata.end()) {
      fail(field.name, "is missing from the provenance");
    }
    map.provenance.*field.member = found->second;
  }
  return map;
}

} // namespace

std::array<double, 4> sky_illuminance(const SkyMap& map) {
  std::array<double, 4> sum{};
  for (std::size_t i = 0; i < cube_texel_count(map.face_size); ++i) {
    const double solid_angle = cube_texel(map.face_size, i).solid_angle_sr;
    for (std::size_t channel = 0; channel < sum.size(); ++channel) {
      sum.at(channel) += solid_angle * static_cast<double>(map.texels[sum.size() * i + channel]);
    }
  }
  return sum;
}

void write_sky_map(const std::filesystem::path& path, int face_size, const SkyMapProvenance& provenance,
                   const std::function<void(int first_row, std::span<float> xyzs)>& fill_rows) {
  require_face_size(face_size, ErrorKind::argument, path.string());
  ImageMetadata metadata{{"ImageDescription",
                          "Light of the sky beyond the air, cube map in ICRS axes (X to RA 0 Dec 0, Y to RA 90, Z to "
                          "the north pole), faces +X -X +Y -Y +Z -Z from the top: X Y Z S in cd/m2"}};
  for (const ProvenanceField& field : provenance_fields) {
    metadata.emplace_back(field.name, provenance.*field.member);
  }
  write_exr_rows(path, face_size, 6 * face_size, {sky_channels.begin(), sky_channels.end()}, metadata, fill_rows);
}

void write_sky_map(const std::filesystem::path& path, const SkyMap& map) {
  if (map.texels.size() != sky_channels.size() * cube_texel_count(map.face_size)) {
    throw Error(ErrorKind::argument, "holds another number of texels than its size says",
                {path.string(), "", sky_map_remedy});
  }
  const std::size_t row = sky_channels.size() * static_cast<std::size_t>(map.face_size);
  write_sky_map(path, map.face_size, map.provenance, [&](int first_row, std::span<float> xyzs) {
    std::copy_n(map.texels.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(first_row)),
                xyzs.size(), xyzs.begin());
  });
}

SkyMap read_sky_map(const std::filesystem::path& path) { return sky_map_of(read_image(path), path.string()); }

SkyMap decode_sky_map(std::span<const std::byte> bytes, const std::string& name) {
  return sky_map_of(decode_image(bytes, name), name);
}

} // namespace vesper
