#include "vesper/catalog_tools/panorama.hpp"

#include "vesper/assets/cube_texels.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/worker_pool.hpp"
#include "vesper/catalog_tools/panorama_resampling.hpp"
#include "vesper/light/star_color.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vesper {
namespace {

constexpr int strip_rows = 64;

/// The picture's rows on their way: read ahead as far as stars need, made linear.
class PictureReader {
public:
  PictureReader(PictureSource& picture, const PanoramaOptions& options) : picture_(picture), options_(options) {}

  /// Makes rows [first, last) those of the strip, of which earlier ones may be changed and are kept.
  void move_to(PictureStrip& strip, int first, int last) const {
    PictureStrip next{first, last - first, picture_.width(), picture_.channels(), {}};
    const auto width = static_cast<std::size_t>(next.width);
    next.values.resize(static_cast<std::size_t>(next.channels) * static_cast<std::size_t>(next.rows) * width);
    const int held = std::clamp(strip.first_row + strip.rows, first, last);
    for (int channel = 0; channel < next.channels; ++channel) {
      if (held > first) {
        std::copy_n(strip.row(channel, first), width * static_cast<std::size_t>(held - first),
                    next.row(channel, first));
      }
      if (last > held) {
        picture_.read(channel, held, {next.row(channel, held), width * static_cast<std::size_t>(last - held)});
      }
    }
    make_linear(next, held);
    strip = std::move(next);
  }

  void set_law(const AnchoredLaw& law) { law_ = law; }

private:
  void make_linear(PictureStrip& strip, int first) const {
    if (!options_.missing && !law_) {
      return;
    }
    const int last = strip.first_row + strip.rows;
    parallel_for(static_cast<std::size_t>(last - first), 16, [&](std::size_t begin, std::size_t end) {
      for (int y = first + static_cast<int>(begin); y < first + static_cast<int>(end); ++y) {
        for (int x = 0; x < strip.width; ++x) {
          make_pixel_linear(strip, x, y);
        }
      }
    });
  }

  void make_pixel_linear(PictureStrip& strip, int x, int y) const {
    Vec3 pixel(0.0);
    bool missing = options_.missing.has_value();
    for (int channel = 0; channel < strip.channels; ++channel) {
      pixel[channel] = static_cast<double>(strip.row(channel, y)[x]);
      missing = missing && pixel[channel] == *options_.missing;
    }
    double factor = missing ? std::numeric_limits<double>::quiet_NaN() : 1.0;
    if (law_ && !missing) {
      const double luminance = (options_.transform.xyz_from_channels * pixel).y;
      factor = luminance > 0.0 ? std::pow(luminance, law_->exponent - 1.0) : 0.0;
    }
    for (int channel = 0; channel < strip.channels; ++channel) {
      strip.row(channel, y)[x] = static_cast<float>(factor * pixel[channel]);
    }
  }

  PictureSource& picture_;
  const PanoramaOptions& options_;
  std::optional<AnchoredLaw> law_;
};

/// The pixels of the picture that lie in a field.
std::vector<AnchorSample> samples_of(const PictureStrip& strip, PictureWcs& wcs, const Vec3& middle, const Mat3& xyz) {
  constexpr int block = 16; // pixels a side, looked at together
  const double radius = field_radius_deg * std::numbers::pi / 180.0;
  std::vector<AnchorSample> samples;
  for (int y0 = strip.first_row; y0 < strip.first_row + strip.rows; y0 += block) {
    for (int x0 = 0; x0 < strip.width; x0 += block) {
      const Vec3 centre = wcs.direction({x0 + 0.5 * block, y0 + 0.5 * block});
      const Vec3 corner = wcs.direction({x0, y0});
      if (distance(centre, middle) > radius + 2.0 * distance(centre, corner)) {
        continue;
      }
      for (int y = y0; y < std::min(y0 + block, strip.first_row + strip.rows); ++y) {
        for (int x = x0; x < std::min(x0 + block, strip.width); ++x) {
          const std::array<Vec2, 3> places{Vec2(x + 0.5, y + 0.5), Vec2(x + 1.0, y + 0.5), Vec2(x + 0.5, y + 1.0)};
          std::array<Vec3, 3> directions{};
          wcs.directions(places, directions);
          Vec3 pixel(0.0);
          for (int channel = 0; channel < strip.channels; ++channel) {
            pixel[channel] = static_cast<double>(strip.row(channel, y)[x]);
          }
          const double luminance = (xyz * pixel).y;
          if (distance(directions[0], middle) < radius && std::isfinite(luminance)) {
            samples.push_back(
                {luminance, 4.0 * length(cross(directions[1] - directions[0], directions[2] - directions[0]))});
          }
        }
      }
    }
  }
  return samples;
}

AnchoredLaw find_law(PictureSource& picture, PictureWcs wcs, const std::string& file, const PanoramaOptions& options) {
  const PictureReader reader(picture, options);
  AnchorSamples samples;
  const std::array wanted{&samples.poles, &samples.poles, &samples.anticentre, &samples.sagittarius};
  PictureStrip strip;
  for (int y = 0; y < picture.height(); y += strip_rows) {
    reader.move_to(strip, y, std::min(y + strip_rows, picture.height()));
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const auto more = samples_of(strip, wcs, direction_of(sky_fields()[i]), options.transform.xyz_from_channels);
      wanted.at(i)->insert(wanted.at(i)->end(), more.begin(), more.end());
    }
    options.progress(0);
  }
  return fit_anchors(samples, file);
}

/// Pixels of rows [first, last) that were cut off become holes. \return their number
std::size_t open_saturated(PictureStrip& strip, int first, int last, double saturation) {
  std::size_t count = 0;
  for (int y = first; y < last; ++y) {
    for (int x = 0; x < strip.width; ++x) {
      bool cut_off = false;
      for (int channel = 0; channel < strip.channels; ++channel) {
        cut_off = cut_off || static_cast<double>(strip.row(channel, y)[x]) >= saturation;
      }
      if (cut_off) {
        strip.row(0, y)[x] = std::numeric_limits<float>::quiet_NaN();
        ++count;
      }
    }
  }
  return count;
}

LightTotal total_of(const CubeSum& cube) {
  LightTotal total;
  for (const LightSum& sum : cube.sums) {
    for (std::size_t i = 0; i < sum.light.size(); ++i) {
      total.light[i] += static_cast<double>(sum.light[i]);
    }
    total.solid_angle_sr += static_cast<double>(sum.solid_angle_sr);
  }
  return total;
}

/// To 11 bits of the mantissa, within 0.025 %: half the size of a compressed file.
float rounded(float value) {
  constexpr std::uint32_t dropped = 0xFFFU;
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return std::bit_cast<float>((bits + (dropped >> 1) + 1) & ~dropped);
}

/// Sums of the finished map: its light, and the mean over each field.
void measure(const Panorama& map, PanoramaReport& report) {
  const double radius = field_radius_deg * std::numbers::pi / 180.0;
  std::vector<Vec3> middles;
  std::vector<double> covered(sky_fields().size());
  for (const SkyField& field : sky_fields()) {
    report.fields.push_back({field, {}});
    middles.push_back(direction_of(field));
  }
  for (std::size_t i = 0; i < map.cube().sums.size(); ++i) {
    const auto light = map.texel(i);
    const CubeTexel texel = cube_texel(map.face_size(), i);
    for (std::size_t c = 0; c < light.size(); ++c) {
      report.out_xyzs[c] += static_cast<double>(light[c]) * texel.solid_angle_sr;
    }
    for (std::size_t f = 0; f < middles.size(); ++f) {
      if (distance(texel.direction, middles[f]) < radius) {
        covered[f] += texel.solid_angle_sr;
        for (std::size_t c = 0; c < light.size(); ++c) {
          report.fields[f].xyzs[c] += static_cast<double>(light[c]) * texel.solid_angle_sr;
        }
      }
    }
  }
  for (std::size_t f = 0; f < middles.size(); ++f) {
    for (double& value : report.fields[f].xyzs) {
      value /= std::max(covered[f], 1e-12);
    }
  }
}

} // namespace

Panorama::Panorama(CubeSum cube, const ChannelTransform& transform, double cd_m2_per_unit)
    : cube_(std::move(cube)), xyz_from_channels_(cd_m2_per_unit * transform.xyz_from_channels) {}

Panorama::Panorama(CubeSum cube, const ChannelTransform& transform, const AnchoredLaw& law)
    : Panorama(std::move(cube), transform, law.scale_cd_m2) {
  law_ = law;
  const LightTotal total = total_of(cube_);
  const Xyzs color = star_color(milky_way_b_v);
  // A single channel has a colour already: its matrix has no inverse and gains come out as no numbers.
  const Vec3 wanted = inverse(xyz_from_channels_) * Vec3(color.x, color.y, color.z);
  const Vec3 gains = wanted / Vec3(total.light[0], total.light[1], total.light[2]);
  if (std::isfinite(gains.x + gains.y + gains.z) && gains.x > 0.0 && gains.y > 0.0 && gains.z > 0.0) {
    gains_ = gains;
  }
}

std::array<float, 4> Panorama::texel(std::size_t index) const {
  const LightSum& sum = cube_.sums[index];
  if (!(sum.solid_angle_sr > 0.0F)) {
    return {};
  }
  const Vec3 channels = Vec3(sum.light[0], sum.light[1], sum.light[2]) / static_cast<double>(sum.solid_angle_sr);
  Vec3 xyz = xyz_from_channels_ * channels;
  const Xyzs color = star_color(milky_way_b_v);
  const Vec3 mean(color.x, color.y, color.z);
  if (gains_) {
    // Another colour, the same luminance. Pictures for a display have their colours enhanced.
    constexpr double chroma = 0.5;
    const Vec3 tinted = xyz_from_channels_ * (*gains_ * channels);
    xyz = tinted.y > 0.0 ? xyz.y * mix(mean, tinted / tinted.y, chroma) : Vec3(0.0);
  }
  if (law_) {
    xyz += law_->black_cd_m2 * mean;
  }
  std::array<float, 4> light{static_cast<float>(xyz.x), static_cast<float>(xyz.y), static_cast<float>(xyz.z),
                             static_cast<float>(dot(scotopic_of_xyz(), xyz))};
  if (law_) {
    std::transform(light.begin(), light.end(), light.begin(), rounded);
  }
  return light;
}

void Panorama::fill_rows(int first_row, std::span<float> xyzs) const {
  const std::size_t first = static_cast<std::size_t>(first_row) * static_cast<std::size_t>(cube_.face_size);
  for (std::size_t i = 0; i < xyzs.size() / 4; ++i) {
    const auto light = texel(first + i);
    std::copy(light.begin(), light.end(), xyzs.begin() + static_cast<std::ptrdiff_t>(4 * i));
  }
}

PanoramaProduct make_panorama(PictureSource& picture, const PictureWcs& wcs, const std::string& file,
                              const std::string& place, const PanoramaOptions& options) {
  PanoramaReport report;
  PictureReader reader(picture, options);
  double scale = options.cd_m2_per_unit;
  if (options.calibration == PanoramaCalibration::anchors) {
    report.anchors = find_law(picture, wcs, file, options);
    reader.set_law(*report.anchors);
  }
  std::optional<PanoramaStars> stars;
  if (options.stars != nullptr) {
    stars.emplace(*options.stars, options.star_file, wcs, picture.width(), picture.height(), options.star_options);
  }
  PanoramaResampler resampler(wcs, options.face_size);
  // Stars that touch the rows to be spread lie up to a margin beyond them and need another to see their own
  // surroundings.
  const int margin = stars ? PanoramaStars::margin_rows : 0;
  PictureStrip strip;
  for (int first = 0; first < picture.height(); first += strip_rows) {
    const int last = std::min(first + strip_rows, picture.height());
    reader.move_to(strip, first, std::min(last + 2 * margin, picture.height()));
    if (stars) {
      stars->process(strip, last == picture.height() ? last + 1 : last + margin);
    }
    if (options.fill_saturated && options.star_options.saturation) {
      report.saturated_pixels += open_saturated(strip, first, last, *options.star_options.saturation);
    }
    resampler.add(strip, first, last);
    options.progress(static_cast<std::size_t>(last - first));
  }
  if (!(resampler.total().solid_angle_sr > 0.0)) {
    throw Error(ErrorKind::input, "no pixel on the sky has a value: all are blank",
                {file, place + ", BLANK, BSCALE, BZERO", "Check the data, and --missing if you gave it"});
  }
  report.in = resampler.total();
  if (stars) {
    report.stars = stars->report();
    report.removed = stars->report().removed;
    for (std::size_t i = 0; i < 3; ++i) {
      report.in.light[i] += report.removed.light[i];
    }
  }
  if (options.calibration == PanoramaCalibration::stars && stars) {
    report.fit = fit_zero_point(stars->measured(), options.transform, options.fit_range, file);
    scale = report.fit->cd_m2_per_unit;
  }
  const CubeFillReport fill = fill_cube(resampler.cube(), options.largest_hole_sr);
  report.filled = fill.filled;
  report.overlapped = fill.overlapped;
  report.holes = fill.holes;
  report.dark_sr = fill.dark_sr;
  if (report.anchors && options.least_value > 0.0) {
    constexpr double steps = 16.0; // of the picture's numbers, below which its contours show
    const Mat3& xyz = options.transform.xyz_from_channels;
    soften_faint(resampler.cube(), Vec3(xyz[0].y, xyz[1].y, xyz[2].y),
                 std::pow(steps * options.least_value, report.anchors->exponent));
  }
  report.out = total_of(resampler.cube());
  Panorama map = report.anchors ? Panorama(std::move(resampler.cube()), options.transform, *report.anchors)
                                : Panorama(std::move(resampler.cube()), options.transform, scale);
  measure(map, report);
  return {std::move(map), std::move(report)};
}

} // namespace vesper
