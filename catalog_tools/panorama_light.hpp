// From the numbers of a picture of the sky to light.
#pragma once

#include "vesper/base/vector.hpp"
#include "vesper/catalog_tools/panorama_stars.hpp"
#include "vesper/light/response_functions.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vesper {

/// Luminance of a surface of V = 0 mag/arcsec2, cd/m2: one star of V = 0 an arcsec2, with 2.54e-6 lux a star.
inline constexpr double zero_magnitude_luminance_cd_m2 = 10.8e4;
[[nodiscard]] double luminance_of_magnitude(double mag_per_arcsec2);
/// +infinity for no light.
[[nodiscard]] double magnitude_of_luminance(double luminance_cd_m2);

/// The colour index B-V of a picture of one channel, and of the whole Milky Way where a picture's colours are not
/// known: its integrated light is that of a late G star.
inline constexpr double milky_way_b_v = 0.75;

/// A linear map from channels to X, Y, Z of any scale.
struct ChannelTransform {
  Mat3 xyz_from_channels{1.0};
  std::string name; ///< how it is written as an option
};

/// "srgb": the primaries of IEC 61966-2-1, white D65; "mono": one channel, the colour of B-V = 0.75; or nine numbers,
/// X of the channels first, "0.41,0.36,...". Throws Error(argument).
[[nodiscard]] ChannelTransform channel_transform(const std::string& text, int channels);

/// The scotopic luminance of light of these X, Y, Z as stars have it: S = a X + b Y + c Z, fitted by least squares to
/// stars of B-V = -0.3 to 2.0, within 1 % of each.
[[nodiscard]] const Vec3& scotopic_of_xyz();

/// The scale of a picture, found from its stars.
struct ZeroPointFit {
  double cd_m2_per_unit = 0.0; ///< luminance of a picture whose Y, by the transform, is 1
  std::size_t stars = 0;       ///< that it rests on
  std::size_t rejected = 0;    ///< beyond three standard deviations of the rest
  double residual_mag = 0.0;   ///< standard deviation of one star
};

/// The range of V magnitudes that the fit takes.
struct MagnitudeRange {
  double brightest = 2.0, faintest = 6.5;
};

/// The median ratio of the stars' illuminance to their light in the picture, then the mean of what lies within three
/// standard deviations of it. Throws Error(input), naming `file`, with fewer than eight stars.
[[nodiscard]] ZeroPointFit fit_zero_point(std::span<const MeasuredStar> stars, const ChannelTransform& transform,
                                          const MagnitudeRange& range, const std::string& file);

/// A field of the sky that figures are published or reported for.
struct SkyField {
  const char* name;
  double galactic_longitude_deg, galactic_latitude_deg;
  double anchor_mag_arcsec2; ///< what the Milky Way adds there, averaged over 5 degrees
};

/// Poles, anticentre and the Sagittarius star clouds. The anchors of the latter two are the middles of the ranges that
/// the literature gives for the added light: 20.0 to 20.8 in Sagittarius, 22.2 to 23 at the anticentre, V mag/arcsec2.
/// At the poles it is 30 S10(V), what counts of stars give there for those too faint to be seen one by one.
inline constexpr double field_radius_deg = 2.5;
[[nodiscard]] std::span<const SkyField> sky_fields();
/// ICRS direction of a field's middle.
[[nodiscard]] Vec3 direction_of(const SkyField& field);

/// A law that gives the pixels of a picture that was made for a display luminances that agree with the anchors:
/// luminance = black + scale x Y^exponent, with Y by the transform from decoded channels. Such a picture's black is not
/// that of the sky: what is as faint as the galactic poles was taken off as background.
struct AnchoredLaw {
  double scale_cd_m2 = 1.0;
  double exponent = 1.0;
  double black_cd_m2 = 0.0; ///< >= 0
};

/// One pixel in an anchored field.
struct AnchorSample {
  double y = 0.0;
  double solid_angle_sr = 0.0;
};

/// The pixels of the fields of AnchoredLaw.
struct AnchorSamples {
  std::vector<AnchorSample> poles; ///< both; without any the picture is taken to be black there
  std::vector<AnchorSample> anticentre;
  std::vector<AnchorSample> sagittarius;
};

/// The law under which the mean over each of the fields is its anchor. Throws Error(input), naming `file`, for a
/// picture without light in Sagittarius or at the anticentre, or that no exponent from 0.1 to 5 fits, or that has more
/// light at the poles than that leaves for its black.
[[nodiscard]] AnchoredLaw fit_anchors(const AnchorSamples& samples, const std::string& file);

} // namespace vesper
