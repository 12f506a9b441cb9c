#include "vesper/catalog_tools/panorama_light.hpp"

#include "vesper/base/error.hpp"
#include "vesper/base/units.hpp"
#include "vesper/catalog_tools/celestial_axes.hpp"
#include "vesper/light/star_color.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace vesper {
namespace {

constexpr std::size_t least_stars = 8;

constexpr double pole_mag_arcsec2 = 24.09; // 30 S10(V)
constexpr std::array<SkyField, 4> fields{{{"north galactic pole", 0.0, 90.0, pole_mag_arcsec2},
                                          {"south galactic pole", 0.0, -90.0, pole_mag_arcsec2},
                                          {"anticentre", 180.0, 0.0, 22.6},
                                          {"Sagittarius", 2.0, -3.5, 20.4}}};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace

double luminance_of_magnitude(double mag_per_arcsec2) {
  return zero_magnitude_luminance_cd_m2 * std::pow(10.0, -0.4 * mag_per_arcsec2);
}

double magnitude_of_luminance(double luminance_cd_m2) {
  return luminance_cd_m2 > 0.0 ? -2.5 * std::log10(luminance_cd_m2 / zero_magnitude_luminance_cd_m2)
                               : std::numeric_limits<double>::infinity();
}

ChannelTransform channel_transform(const std::string& text, int channels) {
  const auto refuse = [&](const std::string& allowed) {
    throw Error(ErrorKind::argument, fmt::format("--transform: \"{}\" is not {}", text, allowed), {});
  };
  if (channels == 1) {
    if (text != "mono") {
      refuse("mono, as a picture of one channel needs");
    }
    const Xyzs color = star_color(milky_way_b_v);
    ChannelTransform result{Mat3(0.0), text};
    result.xyz_from_channels[0] = Vec3(color.x, color.y, color.z);
    return result;
  }
  if (text == "srgb") {
    return {{{0.4124, 0.2126, 0.0193}, {0.3576, 0.7152, 0.1192}, {0.1805, 0.0722, 0.9505}}, text};
  }
  ChannelTransform result{Mat3(0.0), text};
  const char* at = text.data();
  const char* end = at + text.size();
  for (glm::length_t i = 0; i < 9; ++i) {
    double value = 0.0;
    const auto [next, status] = std::from_chars(at, end, value);
    const bool last = i == 8;
    if (status != std::errc() || !std::isfinite(value) || (last ? next != end : next == end || *next != ',')) {
      refuse("srgb or nine numbers, X of the channels first");
    }
    result.xyz_from_channels[i % 3][i / 3] = value;
    at = last ? next : next + 1;
  }
  return result;
}

const Vec3& scotopic_of_xyz() {
  static const Vec3 weights = [] {
    Mat3 normal(0.0);
    Vec3 right(0.0);
    constexpr int steps = 46;
    for (int i = 0; i <= steps; ++i) {
      const Xyzs color = star_color(-0.3 + 2.3 * i / steps);
      const Vec3 row = Vec3(color.x, color.y, color.z) / color.s; // relative errors count alike
      normal += outerProduct(row, row);
      right += row;
    }
    return inverse(normal) * right;
  }();
  return weights;
}

ZeroPointFit fit_zero_point(std::span<const MeasuredStar> stars, const ChannelTransform& transform,
                            const MagnitudeRange& range, const std::string& file) {
  std::vector<double> magnitudes;
  for (const MeasuredStar& star : stars) {
    const double y = (transform.xyz_from_channels * Vec3(star.light[0], star.light[1], star.light[2])).y;
    if (star.fit_for_calibration && y > 0.0 && star.magnitude >= range.brightest && star.magnitude <= range.faintest) {
      magnitudes.push_back(-2.5 * std::log10(star.illuminance_lux / y));
    }
  }
  ZeroPointFit fit;
  const auto require_enough = [&] {
    if (magnitudes.size() < least_stars) {
      throw Error(
          ErrorKind::input,
          fmt::format("only {} stars of V = {} to {} can be measured for the zero point, at least {} are needed",
                      magnitudes.size(), range.brightest, range.faintest, least_stars),
          {file, "", "Give the zero point with --zero-point, or --calibrate anchors"});
    }
  };
  const std::size_t before = magnitudes.size();
  for (int round = 0; round < 5; ++round) {
    require_enough();
    const double middle = median(magnitudes);
    std::vector<double> off;
    std::transform(magnitudes.begin(), magnitudes.end(), std::back_inserter(off),
                   [&](double m) { return std::abs(m - middle); });
    constexpr double normal_scatter = 1.4826; // of the median deviation
    const double limit = std::max(3.0 * normal_scatter * median(off), 1e-6);
    magnitudes.erase(
        std::remove_if(magnitudes.begin(), magnitudes.end(), [&](double m) { return std::abs(m - middle) > limit; }),
        magnitudes.end());
  }
  require_enough();
  double sum = 0.0;
  for (const double m : magnitudes) {
    sum += m;
  }
  const double mean = sum / static_cast<double>(magnitudes.size());
  double squares = 0.0;
  for (const double m : magnitudes) {
    squares += (m - mean) * (m - mean);
  }
  fit.cd_m2_per_unit = std::pow(10.0, -0.4 * mean);
  fit.stars = magnitudes.size();
  fit.rejected = before - magnitudes.size();
  fit.residual_mag = std::sqrt(squares / static_cast<double>(magnitudes.size() - 1));
  return fit;
}

std::span<const SkyField> sky_fields() { return fields; }

Vec3 direction_of(const SkyField& field) {
  const double l = (field.galactic_longitude_deg * deg).to(rad);
  const double b = (field.galactic_latitude_deg * deg).to(rad);
  static const Mat3 icrs_from_galactic = celestial_axes("GLON", "", std::nullopt)->icrs_from_axes;
  return icrs_from_galactic * Vec3(std::cos(b) * std::cos(l), std::cos(b) * std::sin(l), std::sin(b));
}

AnchoredLaw fit_anchors(const AnchorSamples& samples, const std::string& file) {
  const auto mean = [](std::span<const AnchorSample> field, double exponent) {
    double sum = 0.0;
    double solid_angle = 0.0;
    for (const AnchorSample& sample : field) {
      sum += std::pow(std::max(sample.y, 0.0), exponent) * sample.solid_angle_sr;
      solid_angle += sample.solid_angle_sr;
    }
    return solid_angle > 0.0 ? sum / solid_angle : 0.0;
  };
  const double least = luminance_of_magnitude(fields[0].anchor_mag_arcsec2);
  const double faint = luminance_of_magnitude(fields[2].anchor_mag_arcsec2);
  const double bright = luminance_of_magnitude(fields[3].anchor_mag_arcsec2);
  // The black and the scale cancel in the ratio of differences, which rises with the exponent.
  const auto excess = [&](double exponent) {
    const double dark = mean(samples.poles, exponent);
    return std::log((mean(samples.sagittarius, exponent) - dark) / (mean(samples.anticentre, exponent) - dark)) -
           std::log((bright - least) / (faint - least));
  };
  double low = 0.1;
  double high = 5.0;
  const bool bracketed = excess(low) < 0.0 && excess(high) > 0.0; // not where there is no light to compare
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (excess(middle) < 0.0 ? low : high) = middle;
  }
  AnchoredLaw law;
  law.exponent = low;
  const double dark = mean(samples.poles, low);
  law.scale_cd_m2 = (bright - least) / (mean(samples.sagittarius, low) - dark);
  law.black_cd_m2 = least - law.scale_cd_m2 * dark;
  if (!bracketed || !(law.black_cd_m2 >= 0.0)) {
    throw Error(ErrorKind::input,
                fmt::format("the picture cannot be tied to the published brightness of the Milky Way: its values in "
                            "Sagittarius are {:.3g}, at the anticentre {:.3g}, at the galactic poles {:.3g}",
                            mean(samples.sagittarius, 1.0), mean(samples.anticentre, 1.0), mean(samples.poles, 1.0)),
                {file, "", "Check --frame and --origin, or give --zero-point"});
  }
  return law;
}

} // namespace vesper
