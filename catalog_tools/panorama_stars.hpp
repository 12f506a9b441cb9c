// Catalogue stars in a picture of the sky: measured, and taken out where they are drawn as stars.
#pragma once

#include "vesper/assets/star_catalogue.hpp"
#include "vesper/catalog_tools/panorama_resampling.hpp"
#include "vesper/catalog_tools/picture_wcs.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace vesper {

struct PanoramaStarOptions {
  bool remove = true;
  double epoch_jyear = 2000.0;      ///< of the picture: the stars are moved there from their own epoch
  double radius_px = 3.0;           ///< of the aperture, in pixels of the larger scale at the star
  std::optional<double> saturation; ///< values from here on are cut off
};

/// A star's light in the picture above the background around it.
struct MeasuredStar {
  double magnitude = 0.0;           ///< V of the catalogue
  double illuminance_lux = 0.0;     ///< of the catalogue
  std::array<double, 3> light{};    ///< by channel, in the picture's unit times sr
  bool fit_for_calibration = false; ///< alone in its surroundings, not saturated, not squeezed by the projection
};

struct PanoramaStarReport {
  std::size_t in_picture = 0; ///< catalogue stars whose surroundings lie in the picture
  std::size_t found = 0;      ///< of these, stars that stand out by three standard errors, towards their middle
  LightTotal removed;         ///< light taken out, and the solid angle that it was taken from
  double catalogue_lux = 0.0; ///< of the stars that were found
};

/// Goes through a picture's rows in step with their reading. Each star's background is the plane through the ring of
/// 3 pixels around its aperture, fitted without what stands out of it by 2.5 standard deviations; what the aperture
/// holds above that is the star's, and removing the star puts the plane in its place. The aperture grows, up to four
/// times, until the star's wings on its rim (the median all the way around) are below 2 % of the background or lost in
/// its noise, and nothing there is cut off.
class PanoramaStars {
public:
  /// Rows that must be in memory above and below a star.
  static constexpr int margin_rows = 24;

  /// Throws Error(input), naming `catalogue_file`, for an epoch more than a century from the picture's: the motions are
  /// straight lines.
  PanoramaStars(const StarCatalogue& catalogue, const std::string& catalogue_file, PictureWcs wcs, int width,
                int height, const PanoramaStarOptions& options);

  /// Deals with the stars whose centre lies in rows before `end` and was not yet dealt with.
  void process(PictureStrip& strip, int end);

  [[nodiscard]] const PanoramaStarReport& report() const { return report_; }
  [[nodiscard]] const std::vector<MeasuredStar>& measured() const { return measured_; }

private:
  struct Target {
    Vec2 place;
    Vec3 direction;
    double magnitude = 0.0;
    double illuminance_lux = 0.0;
    double pixel_rad = 0.0; ///< the larger side of a pixel there
    bool alone = false;
    bool squeezed = false; ///< pixels far from square
  };
  struct Pixel;
  /// The columns after which the picture repeats itself; 0 where it does not, or not by whole pixels.
  [[nodiscard]] int whole_turn_px() const;
  [[nodiscard]] std::vector<Pixel> pixels_around(const PictureStrip& strip, const Target& target, double reach_px);
  void treat(PictureStrip& strip, const Target& target);

  PictureWcs wcs_;
  int width_, height_;
  PanoramaStarOptions options_;
  std::vector<Target> targets_; ///< by row
  std::size_t next_ = 0;
  PanoramaStarReport report_;
  std::vector<MeasuredStar> measured_;
};

} // namespace vesper
