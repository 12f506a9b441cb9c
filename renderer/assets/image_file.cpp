// The only file that includes OpenImageIO: it is slow to compile.
#include "vesper/assets/image_file.hpp"

#include "vesper/assets/png_chunk.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"

#include <algorithm>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace vesper {
namespace {

void describe(OIIO::ImageSpec& spec, const ImageMetadata& metadata) {
  // Without these the library stamps the current time and its own version into the file.
  spec.attribute("DateTime", "");
  spec.attribute("Software", "vesper");
  for (const auto& [name, value] : metadata) {
    spec.attribute(name, value);
  }
}

/// Encodes in memory, so that the file is replaced in one step and every write error is seen.
void write(const std::filesystem::path& path, const char* format, OIIO::ImageSpec spec, const OIIO::TypeDesc& type,
           const void* pixels, OIIO::stride_t pixel_stride, const ImageMetadata& metadata,
           const ColorTags& colors = {}) {
  describe(spec, metadata);
  std::vector<unsigned char> encoded;
  OIIO::Filesystem::IOVecOutput memory(encoded);
  const auto output = OIIO::ImageOutput::create(format, &memory);
  if (!output || !output->open(path.string(), spec) ||
      !output->write_image(type, pixels, pixel_stride, OIIO::AutoStride, OIIO::AutoStride) || !output->close()) {
    throw Error(ErrorKind::file, "cannot be encoded: " + (output ? output->geterror() : OIIO::geterror()),
                {path.string(), "", "Check the OpenImageIO installation"});
  }
  for (const auto& [type_name, data] : colors.chunks) {
    insert_png_chunk(encoded, type_name, data);
  }
  write_file_atomically(path, std::as_bytes(std::span(encoded)));
}

/// Numbers of 8 or 16 bits.
template <class Number>
void write_rgb_png(const std::filesystem::path& path, int width, int height, std::span<const Number> rgba,
                   const ImageMetadata& metadata, const ColorTags& colors) {
  constexpr OIIO::TypeDesc type(sizeof(Number) == 1 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16);
  OIIO::ImageSpec spec(width, height, 3, type);
  if (colors.icc_profile.empty()) {
    spec.attribute("oiio:ColorSpace", "sRGB");
  } else {
    spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(colors.icc_profile.size())),
                   colors.icc_profile.data());
  }
  write(path, "png", spec, type, rgba.data(), 4 * sizeof(Number), metadata, colors);
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
  write_exr(path, width, height, {"X", "Y", "Z", "S"}, xyzs, ExrDepth::single, with_space);
}

void write_exr(const std::filesystem::path& path, int width, int height, const std::vector<std::string>& channels,
               std::span<const float> values, ExrDepth depth, const ImageMetadata& metadata) {
  OIIO::ImageSpec spec(width, height, static_cast<int>(channels.size()),
                       depth == ExrDepth::half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
  spec.channelnames = channels;
  spec.attribute("compression", "zip");
  write(path, "exr", spec, OIIO::TypeDesc::FLOAT, values.data(), OIIO::AutoStride, metadata);
}

void write_exr_rows(const std::filesystem::path& path, int width, int height, const std::vector<std::string>& channels,
                    const ImageMetadata& metadata,
                    const std::function<void(int first_row, std::span<float> values)>& fill_rows) {
  constexpr int rows_at_once = 64;
  OIIO::ImageSpec spec(width, height, static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames = channels;
  spec.attribute("compression", "zip");
  describe(spec, metadata);
  write_file_atomically(path, [&](const std::filesystem::path& temporary) {
    OIIO::Filesystem::IOFile file(temporary.string(), OIIO::Filesystem::IOProxy::Mode::Write);
    const auto output = OIIO::ImageOutput::create("exr", &file);
    const auto require = [&](bool done) {
      if (!done) {
        throw Error(
            ErrorKind::file, "cannot be written: " + (output ? output->geterror() : OIIO::geterror()),
            {path.string(), "", "Free some space or choose another place; the earlier file, if any, is unchanged"});
      }
    };
    require(output && output->open(path.string(), spec));
    std::vector<float> values;
    for (int row = 0; row < height; row += rows_at_once) {
      const int end = std::min(row + rows_at_once, height);
      values.resize(static_cast<std::size_t>(end - row) * static_cast<std::size_t>(width) * channels.size());
      fill_rows(row, values);
      require(output->write_scanlines(row, end, 0, OIIO::TypeDesc::FLOAT, values.data()));
    }
    require(output->close());
    file.close();
    require(file.error().empty());
  });
}

void write_png(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgba,
               const ImageMetadata& metadata, const ColorTags& colors) {
  write_rgb_png(path, width, height, rgba, metadata, colors);
}

void write_png(const std::filesystem::path& path, int width, int height, std::span<const std::uint16_t> rgba,
               const ImageMetadata& metadata, const ColorTags& colors) {
  write_rgb_png(path, width, height, rgba, metadata, colors);
}

void write_rgb_exr(const std::filesystem::path& path, int width, int height, std::span<const float> rgb,
                   const LinearColors& colors, const ImageMetadata& metadata) {
  OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::FLOAT);
  spec.attribute("compression", "zip");
  spec.attribute("chromaticities",
                 OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, static_cast<int>(colors.chromaticities.size())),
                 colors.chromaticities.data());
  spec.attribute("whiteLuminance", colors.white_cd_m2);
  write(path, "exr", spec, OIIO::TypeDesc::FLOAT, rgb.data(), OIIO::AutoStride, metadata);
}

FloatImage read_image(const std::filesystem::path& path) { return read(path.string(), nullptr); }

FloatImage decode_image(std::span<const std::byte> bytes, const std::string& name) {
  // The reader only reads, though its interface is written for both.
  OIIO::Filesystem::IOMemReader memory(const_cast<std::byte*>(bytes.data()), bytes.size()); // NOLINT
  return read(name, &memory);
}

struct ImageRows::Input {
  std::string name;
  std::unique_ptr<OIIO::ImageInput> file;
};

ImageRows::ImageRows(const std::filesystem::path& path)
    : input_(std::make_unique<Input>(Input{path.string(), OIIO::ImageInput::open(path.string())})) {
  if (!input_->file) {
    throw Error(ErrorKind::file, "cannot be read: " + OIIO::geterror(), {path.string(), "", "Give a picture file"});
  }
}

ImageRows::~ImageRows() = default;

int ImageRows::width() const { return input_->file->spec().width; }
int ImageRows::height() const { return input_->file->spec().height; }
int ImageRows::channels() const { return input_->file->spec().nchannels; }
bool ImageRows::floating() const { return input_->file->spec().format.is_floating_point(); }
int ImageRows::alpha_channel() const { return input_->file->spec().alpha_channel; }

void ImageRows::read(int first_row, std::span<float> values) {
  const auto row = static_cast<std::size_t>(width()) * static_cast<std::size_t>(channels());
  const int end = first_row + static_cast<int>(values.size() / row);
  const OIIO::ImageSpec& spec = input_->file->spec();
  if (!input_->file->read_scanlines(0, 0, spec.y + first_row, spec.y + end, spec.z, 0, spec.nchannels,
                                    OIIO::TypeDesc::FLOAT, values.data())) {
    throw Error(ErrorKind::input, "cannot be decoded: " + input_->file->geterror(),
                {input_->name, "row " + std::to_string(first_row), "Write the picture again as scan lines"});
  }
}

} // namespace vesper
