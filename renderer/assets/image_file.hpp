// Pictures in files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vesper {

/// Text that a picture file carries, name and value.
using ImageMetadata = std::vector<std::pair<std::string, std::string>>;

/// Writes a frame as OpenEXR: 32-bit float channels X, Y, Z, S, row 0 on top, lossless (ZIP). `xyzs` holds 4 floats a
/// pixel. Same input, same bytes. Throws Error(file); an earlier file is then unchanged.
void write_exr(const std::filesystem::path& path, int width, int height, std::span<const float> xyzs,
               const ImageMetadata& metadata);

enum class ExrDepth { half, single }; ///< floats of 16 or 32 bits in the file

/// The same with channels of other names: `values` holds `channels.size()` floats a pixel.
void write_exr(const std::filesystem::path& path, int width, int height, const std::vector<std::string>& channels,
               std::span<const float> values, ExrDepth depth, const ImageMetadata& metadata);

/// The same for pictures that are too large to be held twice: `fill_rows` is called for consecutive rows, a few at a
/// time, and fills the span, whose size is a multiple of `width` times `channels.size()`.
void write_exr_rows(const std::filesystem::path& path, int width, int height, const std::vector<std::string>& channels,
                    const ImageMetadata& metadata,
                    const std::function<void(int first_row, std::span<float> values)>& fill_rows);

/// What a PNG says of the colours that its numbers mean.
struct ColorTags {
  std::vector<std::byte> icc_profile;                                 ///< empty for sRGB
  std::vector<std::pair<std::string, std::vector<std::byte>>> chunks; ///< further ones, type and data
};

/// Writes code values of a display as PNG, RGB of 8 or 16 bits. `rgba` holds 4 numbers a pixel; alpha is dropped.
void write_png(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgba,
               const ImageMetadata& metadata, const ColorTags& colors = {});
void write_png(const std::filesystem::path& path, int width, int height, std::span<const std::uint16_t> rgba,
               const ImageMetadata& metadata, const ColorTags& colors = {});

/// What the numbers of an EXR's channels R, G and B mean.
struct LinearColors {
  std::array<float, 8> chromaticities{}; ///< x and y of red, green, blue and white
  float white_cd_m2 = 0.0F;              ///< luminance of 1, 1, 1
};

/// Writes linear components as OpenEXR: 32-bit float channels R, G, B, else as write_exr. `rgb` holds 3 floats a pixel.
void write_rgb_exr(const std::filesystem::path& path, int width, int height, std::span<const float> rgb,
                   const LinearColors& colors, const ImageMetadata& metadata);

/// A float picture as read back: `channels.size()` floats a pixel.
struct FloatImage {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;
  std::vector<float> values;
  bool floating = false;  ///< the file holds floating-point numbers; whole ones come as 0 to 1
  int alpha_channel = -1; ///< which of the channels is alpha, or -1
  ImageMetadata metadata; ///< text attributes only
};

/// Reads any picture OpenImageIO knows, as floats. Throws Error(file) or Error(input).
[[nodiscard]] FloatImage read_image(const std::filesystem::path& path);

/// The same from a file in memory, for formats that can be read so (EXR, PNG, JPEG and others).
/// \param name the file's name: its ending hints at the format, messages hold it
[[nodiscard]] FloatImage decode_image(std::span<const std::byte> bytes, const std::string& name);

/// A picture that is read a few rows at a time.
class ImageRows {
public:
  /// Throws Error(file) for what is no picture.
  explicit ImageRows(const std::filesystem::path& path);
  ImageRows(const ImageRows&) = delete;
  ImageRows& operator=(const ImageRows&) = delete;
  ~ImageRows();

  [[nodiscard]] int width() const;
  [[nodiscard]] int height() const;
  [[nodiscard]] int channels() const;
  [[nodiscard]] bool floating() const;     ///< as in FloatImage
  [[nodiscard]] int alpha_channel() const; ///< as in FloatImage
  /// Rows from `first_row` on, row 0 on top, `channels()` floats a pixel. Going back costs a new start in most formats.
  /// Throws Error(input) for data that cannot be decoded.
  void read(int first_row, std::span<float> values);

private:
  struct Input;
  std::unique_ptr<Input> input_;
};

} // namespace vesper
