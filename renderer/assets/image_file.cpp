// The only file that includes OpenImageIO: it is slow to compile.
#include "vesper/assets/image_file.hpp"

#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace vesper {
namespace {

/// Encodes in memory, so that the file is replaced in one step and every write error is seen.
void write(const std::filesystem::path& path, const char* format, OIIO::ImageSpec spec, const OIIO::TypeDesc& type,
           const void* pixels, OIIO::stride_t pixel_stride, const ImageMetadata& metadata) {
  // Without these the library stamps the current time and its own version into the file.
  spec.attribute("DateTime", "");
  spec.attribute("Software", "vesper");
  for (const auto& [name, value] : metadata) {
    spec.attribute(name, value);
  }
  std::vector<unsigned char> encoded;
  OIIO::Filesystem::IOVecOutput memory(encoded);
  const auto output = OIIO::ImageOutput::create(format, &memory);
  if (!output || !output->open(path.string(), spec) ||
      !output->write_image(type, pixels, pixel_stride, OIIO::AutoStride, OIIO::AutoStride) || !output->close()) {
    throw Error(ErrorKind::file, "cannot be encoded: " + (output ? output->geterror() : OIIO::geterror()),
                {path.string(), "", "Check the OpenImageIO installation"});
  }
  write_file_atomically(path, std::as_bytes(std::span(encoded)));
}

FloatImage read(const std::string& name, OIIO::Filesystem::IOProxy* memory) {
  const auto input = OIIO::ImageInput::open(name, nullptr, memory);
  if (!input) {
    throw Error(ErrorKind::file, "cannot be read: " + OIIO::geterror(), {name, "", "Give a picture file"});
  }
  const OIIO::ImageSpec& spec = input->spec();
  FloatImage image;
  image.width = spec.width;
  image.height = spec.height;
  image.channels = spec.channelnames;
  image.floating = spec.format.is_floating_point();
  image.alpha_channel = spec.alpha_channel;
  image.values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  for (const OIIO::ParamValue& value : spec.extra_attribs) {
    if (value.type() == OIIO::TypeDesc::STRING) {
      image.metadata.emplace_back(value.name().string(), value.get_string());
    }
  }
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data())) {
    throw Error(ErrorKind::input, "cannot be decoded: " + input->geterror(), {name, "", "Write the picture again"});
  }
  return image;
}

} // namespace

void write_exr(const std::filesystem::path& path, int width, int height, std::span<const float> xyzs,
               const ImageMetadata& metadata) {
  ImageMetadata with_space = metadata;
  with_space.emplace_back("oiio:ColorSpace", "XYZ");
  write_exr(path, width, height, {"X", "Y", "Z", "S"}, xyzs, with_space);
}

void write_exr(const std::filesystem::path& path, int width, int height, const std::vector<std::string>& channels,
               std::span<const float> values, const ImageMetadata& metadata) {
  OIIO::ImageSpec spec(width, height, static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames = channels;
  spec.attribute("compression", "zip");
  write(path, "exr", spec, OIIO::TypeDesc::FLOAT, values.data(), OIIO::AutoStride, metadata);
}

void write_png(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgba,
               const ImageMetadata& metadata) {
  OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  write(path, "png", spec, OIIO::TypeDesc::UINT8, rgba.data(), 4, metadata);
}

FloatImage read_image(const std::filesystem::path& path) { return read(path.string(), nullptr); }

FloatImage decode_image(std::span<const std::byte> bytes, const std::string& name) {
  // The reader only reads, though its interface is written for both.
  OIIO::Filesystem::IOMemReader memory(const_cast<std::byte*>(bytes.data()), bytes.size()); // NOLINT
  return read(name, &memory);
}

} // namespace vesper
