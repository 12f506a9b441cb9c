// Pictures of the whole sky in any format that OpenImageIO reads.
#pragma once

#include "vesper/assets/image_file.hpp"
#include "vesper/catalog_tools/picture_source.hpp"

#include <filesystem>
#include <vector>

namespace vesper {

/// A picture whose row 0 is on top. Whole numbers are taken for sRGB and come as linear light, 0 to 1; floating-point
/// numbers come as they are. One channel or three; alpha is left out, but where it is 0 the picture is missing.
class ImagePicture : public PictureSource {
public:
  /// Throws Error(file) for what is no picture, Error(input) for other than one or three channels.
  explicit ImagePicture(const std::filesystem::path& path);

  [[nodiscard]] int width() const override { return rows_.width(); }
  [[nodiscard]] int height() const override { return rows_.height(); }
  [[nodiscard]] int channels() const override { return channels_; }
  /// The least value above zero that 8 bits express; 0 for floating-point numbers.
  [[nodiscard]] double least_value() const;
  void read(int channel, int first_row, std::span<float> values) override;

private:
  ImageRows rows_;
  int channels_ = 0;
  int held_row_ = -1;       ///< the first of the rows below
  std::vector<float> held_; ///< as the file has them, for the other channels
};

} // namespace vesper
