// From a picture of the sky to a cube map in cd/m2.
#pragma once

#include "vesper/assets/star_catalogue.hpp"
#include "vesper/catalog_tools/cube_fill.hpp"
#include "vesper/catalog_tools/cube_sum.hpp"
#include "vesper/catalog_tools/panorama_light.hpp"
#include "vesper/catalog_tools/panorama_stars.hpp"
#include "vesper/catalog_tools/picture_source.hpp"
#include "vesper/catalog_tools/picture_wcs.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace vesper {

/// How a picture's numbers become luminances.
enum class PanoramaCalibration {
  given,   ///< by PanoramaOptions::cd_m2_per_unit
  stars,   ///< a scale fitted to catalogue stars in the picture
  anchors, ///< for pictures made for a display: a power law over a black that is not dark, through the published
           ///< brightness of the Milky Way's poles and of two fields in it, and the integrated colour of the Milky Way
           ///< with half of the picture's contrast of colours around it. Uncalibrated: good for a look, not for
           ///< measuring
};

struct PanoramaOptions {
  int face_size = 1024; ///< least_sky_face to most_sky_face
  ChannelTransform transform;
  PanoramaCalibration calibration = PanoramaCalibration::given;
  double cd_m2_per_unit = 1.0;          ///< luminance of a picture whose Y, by the transform, is 1
  const StarCatalogue* stars = nullptr; ///< for a fit or to be removed; may be null for neither
  std::string star_file;                ///< its name in messages
  PanoramaStarOptions star_options;
  MagnitudeRange fit_range;
  bool fill_saturated = false;   ///< pixels at star_options.saturation and above are holes
  std::optional<double> missing; ///< pixels that have this value in all channels are holes
  /// For pictures tied to anchors: where they are darker than some sixteen of these steps they are smoothed
  /// (soften_faint).
  double least_value = 0.0;
  double largest_hole_sr = 0.1 * 4.0 * std::numbers::pi; ///< holes above this are no holes but the picture's outside
  /// Called after every strip with the number of rows done since the last call. What it throws ends the work.
  std::function<void(std::size_t rows)> progress = [](std::size_t) {};
};

/// The mean over a field of the map.
struct FieldLight {
  SkyField field;
  std::array<double, 4> xyzs{}; ///< cd/m2
};

/// The light's way through the tool, by channel of the picture, in its unit times sr. It holds that
/// in - removed - overlapped + filled = out.
struct PanoramaReport {
  LightTotal in;         ///< every pixel that was not missing, once
  LightTotal removed;    ///< of stars; its solid angle is that of the pixels that were changed
  LightTotal overlapped; ///< that came twice, where the picture goes round more than once
  LightTotal filled;     ///< holes and the rest of texels that the picture covers in part
  LightTotal out;        ///< of the map
  std::size_t holes = 0;
  double dark_sr = 0.0;             ///< outside of the picture
  std::size_t saturated_pixels = 0; ///< that became holes
  std::optional<PanoramaStarReport> stars;
  std::optional<ZeroPointFit> fit;
  std::optional<AnchoredLaw> anchors;
  std::array<double, 4> out_xyzs{}; ///< light of the map in lux: X, Y, Z, S times sr
  std::vector<FieldLight> fields;
};

/// The map before it is written: its texels are computed from the sums when they are asked for, so that a large map is
/// held once.
class Panorama {
public:
  Panorama(CubeSum cube, const ChannelTransform& transform, double cd_m2_per_unit);
  /// Of the sums of a picture whose pixels were raised to the law's exponent.
  Panorama(CubeSum cube, const ChannelTransform& transform, const AnchoredLaw& law);

  [[nodiscard]] int face_size() const { return cube_.face_size; }
  /// X, Y, Z, S in cd/m2 of a texel in the order of cube_texel.
  [[nodiscard]] std::array<float, 4> texel(std::size_t index) const;
  /// What write_sky_map asks for.
  void fill_rows(int first_row, std::span<float> xyzs) const;
  [[nodiscard]] const CubeSum& cube() const { return cube_; }

private:
  CubeSum cube_;
  Mat3 xyz_from_channels_;
  std::optional<AnchoredLaw> law_; ///< of an uncalibrated map, whose numbers are rounded within 0.025 % too
  std::optional<Vec3> gains_;      ///< of channels, that make the map's mean colour that of the Milky Way
};

struct PanoramaProduct {
  Panorama map;
  PanoramaReport report;
};

/// \param file,place of the picture, for messages: "sky.fits", "HDU 1"
/// Throws Error(input) for a picture without a single valid pixel, stars of another epoch, a fit without enough stars,
/// and what reading throws.
[[nodiscard]] PanoramaProduct make_panorama(PictureSource& picture, const PictureWcs& wcs, const std::string& file,
                                            const std::string& place, const PanoramaOptions& options);

} // namespace vesper
