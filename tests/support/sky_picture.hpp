// Pictures of the sky that tests make from known functions.
#pragma once

#include "vesper/catalog_tools/panorama.hpp"
#include "vesper/catalog_tools/picture_source.hpp"
#include "vesper/catalog_tools/picture_wcs.hpp"

#include <cstddef>
#include <fmt/format.h>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace vesper::test {

/// A picture in memory.
class MadePicture : public PictureSource {
public:
  MadePicture(int width, int height, int channels)
      : width_(width), height_(height),
        planes_(static_cast<std::size_t>(channels),
                std::vector<float>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))) {}

  [[nodiscard]] int width() const override { return width_; }
  [[nodiscard]] int height() const override { return height_; }
  [[nodiscard]] int channels() const override { return static_cast<int>(planes_.size()); }
  void read(int channel, int first_row, std::span<float> values) override {
    std::copy_n(planes_[static_cast<std::size_t>(channel)].begin() + static_cast<std::ptrdiff_t>(first_row) * width_,
                values.size(), values.begin());
  }
  [[nodiscard]] float& at(int channel, int x, int y) {
    return planes_[static_cast<std::size_t>(channel)]
                  [static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  }
  /// Each pixel the function at its centre; 0 where that is not on the sky.
  void paint(int channel, PictureWcs wcs, const std::function<double(const Vec3& direction)>& brightness) {
    std::vector<Vec2> places(static_cast<std::size_t>(width_));
    std::vector<Vec3> directions(places.size());
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        places[static_cast<std::size_t>(x)] = Vec2(x + 0.5, y + 0.5);
      }
      wcs.directions(places, directions);
      for (int x = 0; x < width_; ++x) {
        const Vec3& direction = directions[static_cast<std::size_t>(x)];
        at(channel, x, y) = direction == Vec3(0.0) ? 0.0F : static_cast<float>(brightness(direction));
      }
    }
  }

private:
  int width_, height_;
  std::vector<std::vector<float>> planes_;
};

inline std::string card(const std::string& keyword, const std::string& value) {
  return fmt::format("{:<80}", fmt::format("{:<8}= '{:<8}'", keyword, value));
}
inline std::string card(const std::string& keyword, double value) {
  return fmt::format("{:<80}", fmt::format("{:<8}= {:>20}", keyword, fmt::format("{:.12E}", value)));
}

/// The header of a picture that is centred on longitude and latitude of the frame, north up, longitude to the left.
struct SkyHeader {
  std::string projection = "CAR";
  std::string longitude = "RA--", latitude = "DEC-"; ///< first letters of CTYPE
  int width = 0, height = 0;
  double scale_deg = 1.0;
  double at_longitude_deg = 0.0, at_latitude_deg = 0.0;
  std::string more; ///< further cards

  [[nodiscard]] std::string cards() const {
    return card("CTYPE1", longitude + "-" + projection) + card("CTYPE2", latitude + "-" + projection) +
           card("CRPIX1", 0.5 * (width + 1.0)) + card("CRPIX2", 0.5 * (height + 1.0)) + card("CDELT1", -scale_deg) +
           card("CDELT2", scale_deg) + card("CRVAL1", at_longitude_deg) + card("CRVAL2", at_latitude_deg) + more;
  }
  [[nodiscard]] PictureWcs wcs() const { return {cards(), "made.fits", "HDU 1"}; }
  [[nodiscard]] MadePicture picture(int channels = 1) const { return {width, height, channels}; }
};

/// The whole sky, or for TAN a part of it, in a projection, with pixels of a degree divided by `finer`.
inline SkyHeader header_in(const std::string& projection, int finer = 2) {
  SkyHeader header;
  header.projection = projection;
  header.longitude = "GLON";
  header.latitude = "GLAT";
  header.scale_deg = 1.0 / finer;
  const bool zenithal = projection == "ZEA" || projection == "TAN";
  // ZEA ends at a radius of 2 rad; TAN here at 45 degrees; MOL and AIT at 162 x 81.
  const double half_width = projection == "ZEA"                          ? 114.7
                            : projection == "TAN"                        ? 57.3
                            : projection == "CAR" || projection == "HPX" ? 180.0
                                                                         : 162.1;
  const double half_height = zenithal ? half_width : projection == "CAR" || projection == "HPX" ? 90.0 : 81.1;
  header.width = static_cast<int>(std::ceil(2.0 * half_width * finer));
  header.height = static_cast<int>(std::ceil(2.0 * half_height * finer));
  if (projection == "TAN") {
    header.at_longitude_deg = 30.0;
    header.at_latitude_deg = 40.0;
  }
  return header;
}

/// Numbers as they are: Y of the map is the picture's only channel, in its own unit.
inline PanoramaOptions plain_options(int channels, int face_size) {
  PanoramaOptions options;
  options.face_size = face_size;
  options.transform = channels == 1 ? channel_transform("mono", 1) : channel_transform("1,0,0,0,1,0,0,0,1", 3);
  return options;
}

} // namespace vesper::test
