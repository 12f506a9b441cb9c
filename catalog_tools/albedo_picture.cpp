#include "vesper/catalog_tools/albedo_picture.hpp"

#include "vesper/assets/image_file.hpp"
#include "vesper/base/error.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace vesper {
namespace {

// A picture of fewer rows shows no Moon.
constexpr int least_height = 32;

float linear_from_srgb(float v) { return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F); }

/// Reads the albedo of a pixel from its channels.
class PixelReader {
public:
  PixelReader(const FloatImage& image, AlbedoEncoding encoding)
      : alpha_(image.alpha_channel),
        decode_(encoding == AlbedoEncoding::srgb || (encoding == AlbedoEncoding::automatic && !image.floating)) {
    for (int channel = 0; channel < static_cast<int>(image.channels.size()) && colors_.size() < 3; ++channel) {
      if (channel != alpha_) {
        colors_.push_back(channel);
      }
    }
    if (colors_.size() < 3) {
      colors_.resize(1);
    }
  }

  [[nodiscard]] float albedo(const float* pixel) const {
    constexpr float missing = std::numeric_limits<float>::quiet_NaN();
    if (alpha_ >= 0 && !(pixel[alpha_] >= 1.0F)) {
      return missing;
    }
    const auto value = [&](std::size_t i) { return decode_ ? linear_from_srgb(pixel[colors_[i]]) : pixel[colors_[i]]; };
    const float light = colors_.size() == 1 ? value(0) : 0.2126F * value(0) + 0.7152F * value(1) + 0.0722F * value(2);
    return light > 0.0F && std::isfinite(light) ? light : missing;
  }

private:
  int alpha_;
  bool decode_;
  std::vector<int> colors_;
};

} // namespace

AlbedoEncoding parse_albedo_encoding(std::string_view name) {
  if (name == "automatic") {
    return AlbedoEncoding::automatic;
  }
  if (name == "srgb") {
    return AlbedoEncoding::srgb;
  }
  if (name == "linear") {
    return AlbedoEncoding::linear;
  }
  throw Error(ErrorKind::argument, fmt::format("\"{}\" is no encoding of albedo", name),
              {"", "", "Allowed are automatic, srgb and linear"});
}

GlobeGrid read_albedo_picture(const std::filesystem::path& path, const AlbedoPictureOptions& options) {
  const FloatImage image = read_image(path);
  if (image.width != 2 * image.height || image.height < least_height) {
    throw Error(ErrorKind::input,
                fmt::format("the picture has {} x {} pixels; allowed are maps twice as wide as high, from {} x {}",
                            image.width, image.height, 2 * least_height, least_height),
                {path.string(), "", "Give an equirectangular map of the whole Moon"});
  }
  const PixelReader reader(image, options.encoding);
  GlobeGrid grid{image.width, image.height, options.centre_longitude.to(deg) - 180.0, {}, path.string()};
  const std::size_t channels = image.channels.size();
  grid.values.reserve(image.values.size() / channels);
  for (std::size_t i = 0; i < image.values.size(); i += channels) {
    grid.values.push_back(reader.albedo(&image.values[i]));
  }
  return grid;
}

} // namespace vesper
