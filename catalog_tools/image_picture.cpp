#include "vesper/catalog_tools/image_picture.hpp"

#include "vesper/base/error.hpp"

#include <cmath>
#include <limits>

namespace vesper {
namespace {

/// IEC 61966-2-1.
float linear_of_srgb(float v) { return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F); }

} // namespace

ImagePicture::ImagePicture(const std::filesystem::path& path) : rows_(path) {
  const bool alpha = rows_.alpha_channel() >= 0;
  channels_ = rows_.channels() - (alpha ? 1 : 0);
  if ((channels_ != 1 && channels_ != 3) || (alpha && rows_.alpha_channel() != channels_)) {
    throw Error(ErrorKind::input, std::to_string(channels_) + " channels, but one or three are needed",
                {path.string(), "", "Convert it to grey or RGB"});
  }
}

double ImagePicture::least_value() const {
  return rows_.floating() ? 0.0 : static_cast<double>(linear_of_srgb(1.0F / 255.0F));
}

void ImagePicture::read(int channel, int first_row, std::span<float> values) {
  const auto all = static_cast<std::size_t>(rows_.channels());
  if (first_row != held_row_ || held_.size() != values.size() * all) {
    held_.resize(values.size() * all);
    rows_.read(first_row, held_);
    held_row_ = first_row;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float* pixel = held_.data() + i * all;
    const float value = pixel[static_cast<std::size_t>(channel)];
    const bool missing = rows_.alpha_channel() >= 0 && !(pixel[static_cast<std::size_t>(rows_.alpha_channel())] > 0.0F);
    values[i] = missing ? std::numeric_limits<float>::quiet_NaN() : rows_.floating() ? value : linear_of_srgb(value);
  }
}

} // namespace vesper
