#include "vesper/catalog_tools/panorama_stars.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace vesper {
namespace {

constexpr double ring_px = 3.0; // width of the ring
constexpr double growth = 1.5;  // of the aperture, a step
constexpr int most_growths = 4;
constexpr double furthest_epoch_yr = 100.0;
constexpr double clip = 2.5; // standard deviations
constexpr int clip_rounds = 3;
constexpr std::size_t least_ring_pixels = 12;
constexpr double significant = 3.0;      // standard errors
constexpr double wing_share = 0.02;      // of the background
constexpr double steepest_wing = 0.4;    // of the mean in the aperture: above it is a cloud, no star
constexpr double least_contrast = 1.3;   // of the mean in the inner half of the aperture to that in the outer one
constexpr double neighbour_share = 0.05; // of a star's light, that another nearby may have

/// A plane over a star's surroundings, and the scatter of what it was fitted to.
struct Plane {
  Vec3 coefficients{0.0}; ///< constant, along u, along v
  double scatter = 0.0;

  [[nodiscard]] double at(const Vec2& place) const {
    return coefficients.x + coefficients.y * place.x + coefficients.z * place.y;
  }
};

struct Sample {
  Vec2 place; ///< pixels from the star
  double value;
};

/// Least squares without outliers; none for too few samples.
std::optional<Plane> fit_plane(std::vector<Sample> samples) {
  Plane plane;
  for (int round = 0; round <= clip_rounds; ++round) {
    if (samples.size() < least_ring_pixels) {
      return std::nullopt;
    }
    Mat3 normal(0.0);
    Vec3 right(0.0);
    for (const Sample& s : samples) {
      const Vec3 row(1.0, s.place.x, s.place.y);
      normal += outerProduct(row, row);
      right += s.value * row;
    }
    if (!(std::abs(determinant(normal)) > 0.0)) {
      return std::nullopt;
    }
    plane.coefficients = inverse(normal) * right;
    double squares = 0.0;
    for (const Sample& s : samples) {
      const double off = s.value - plane.at(s.place);
      squares += off * off;
    }
    plane.scatter = std::sqrt(squares / static_cast<double>(samples.size() - 3));
    const std::size_t before = samples.size();
    samples.erase(
        std::remove_if(samples.begin(), samples.end(),
                       [&](const Sample& s) { return std::abs(s.value - plane.at(s.place)) > clip * plane.scatter; }),
        samples.end());
    if (samples.size() == before) {
      break;
    }
  }
  return plane;
}

} // namespace

/// A pixel of a star's surroundings.
struct PanoramaStars::Pixel {
  int x, y;
  Vec2 place;      ///< from the star, in pixels of the larger scale, along east and north
  double distance; ///< the same
  double solid_angle_sr;
};

PanoramaStars::PanoramaStars(const StarCatalogue& catalogue, const std::string& catalogue_file, PictureWcs wcs,
                             int width, int height, const PanoramaStarOptions& options)
    : wcs_(std::move(wcs)), width_(width), height_(height), options_(options) {
  const double years = options.epoch_jyear - catalogue.provenance.epoch_jyear;
  if (!(std::abs(years) <= furthest_epoch_yr)) {
    throw Error(ErrorKind::input,
                fmt::format("the stars stand at the epoch J{}, the picture was taken at J{}",
                            catalogue.provenance.epoch_jyear, options.epoch_jyear),
                {catalogue_file, "epoch_jyear",
                 "Give a star buffer of the picture's century, or the picture's epoch with --epoch"});
  }
  for (std::size_t i = 0; i < catalogue.stars.size(); ++i) {
    const StarRecord& star = catalogue.stars[i];
    const auto vector = [](const std::array<float, 3>& v) { return Vec3(v[0], v[1], v[2]); };
    Target target;
    target.direction = normalize(vector(star.position) + years * vector(star.proper_motion));
    target.magnitude = static_cast<double>(catalogue.identities[i].magnitude);
    target.illuminance_lux = static_cast<double>(star.illuminance);
    const auto place = wcs_.place(target.direction);
    if (!place) {
      continue;
    }
    target.place = *place;
    // A map that goes round may be cut anywhere.
    for (const double turns : {-1.0, 1.0}) {
      const Vec2 turned = *place + turns * wcs_.period().value_or(Vec2(0.0));
      if (std::abs(turned.x - 0.5 * width_) < std::abs(target.place.x - 0.5 * width_)) {
        target.place = turned;
      }
    }
    const Vec2& p = target.place;
    if (p.x < 0.0 || p.y < 0.0 || p.x > width_ || p.y > height_) {
      continue;
    }
    const Vec3 across = wcs_.direction(p + Vec2(0.5, 0.0)) - wcs_.direction(p - Vec2(0.5, 0.0));
    const Vec3 up = wcs_.direction(p + Vec2(0.0, 0.5)) - wcs_.direction(p - Vec2(0.0, 0.5));
    constexpr double no_pixel_rad = 0.5; // a place beside the sky stands for the zero vector
    target.pixel_rad = std::max(length(across), length(up));
    constexpr double squeeze = 0.5;
    target.squeezed = std::min(length(across), length(up)) < squeeze * target.pixel_rad;
    if (target.pixel_rad > 0.0 && target.pixel_rad < no_pixel_rad) {
      targets_.push_back(target);
    }
  }
  // Alone is who has no neighbour of some brightness within reach of aperture and ring, searched by declination.
  std::sort(targets_.begin(), targets_.end(),
            [](const Target& a, const Target& b) { return a.direction.z < b.direction.z; });
  const double reach_px = options_.radius_px + ring_px + 2.0;
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    Target& star = targets_[i];
    const double reach = reach_px * star.pixel_rad;
    const auto disturbed_by = [&](const Target& other) {
      const double apart = distance(star.direction, other.direction);
      return apart < reach && apart > 0.0 && other.illuminance_lux > neighbour_share * star.illuminance_lux;
    };
    star.alone = true;
    for (std::size_t j = i + 1; j < targets_.size() && targets_[j].direction.z - star.direction.z < reach; ++j) {
      star.alone = star.alone && !disturbed_by(targets_[j]);
    }
    for (std::size_t j = i; j > 0 && star.direction.z - targets_[j - 1].direction.z < reach; --j) {
      star.alone = star.alone && !disturbed_by(targets_[j - 1]);
    }
  }
  std::stable_sort(targets_.begin(), targets_.end(),
                   [](const Target& a, const Target& b) { return a.place.y < b.place.y; });
}

void PanoramaStars::process(PictureStrip& strip, int end) {
  for (; next_ < targets_.size() && targets_[next_].place.y < end; ++next_) {
    treat(strip, targets_[next_]);
  }
}

int PanoramaStars::whole_turn_px() const {
  const Vec2 period = wcs_.period().value_or(Vec2(0.0));
  const double columns = std::abs(period.x);
  constexpr double tolerance_px = 0.1;
  const bool whole = std::abs(period.y) < tolerance_px && std::abs(columns - std::round(columns)) < tolerance_px;
  return whole ? static_cast<int>(std::round(columns)) : 0;
}

std::vector<PanoramaStars::Pixel> PanoramaStars::pixels_around(const PictureStrip& strip, const Target& target,
                                                               double reach_px) {
  const Vec3 across = wcs_.direction(target.place + Vec2(0.5, 0.0)) - wcs_.direction(target.place - Vec2(0.5, 0.0));
  const double stretch = target.pixel_rad / std::max(length(across), 1e-9);
  const int reach_x = static_cast<int>(std::min(std::ceil(reach_px * stretch), 0.5 * width_ - 1.0));
  const int reach_y = static_cast<int>(std::ceil(reach_px));
  const int turn = whole_turn_px();
  std::vector<int> columns;
  for (int x = static_cast<int>(target.place.x) - reach_x; x <= static_cast<int>(target.place.x) + reach_x; ++x) {
    const int column = x < 0 ? x + turn : x >= width_ ? x - turn : x;
    if (column >= 0 && column < width_) {
      columns.push_back(column);
    }
  }
  const int y0 = std::max({static_cast<int>(target.place.y) - reach_y, 0, strip.first_row});
  const int y1 = std::min({static_cast<int>(target.place.y) + reach_y + 1, height_, strip.first_row + strip.rows});
  const Vec3 pole(0.0, 0.0, 1.0);
  const Vec3 east =
      normalize(cross(std::abs(target.direction.z) < 0.99 ? pole : Vec3(1.0, 0.0, 0.0), target.direction));
  const Vec3 north = cross(target.direction, east);
  std::vector<Pixel> pixels;
  std::vector<Vec2> centres;
  std::vector<Vec3> directions;
  for (int y = y0; y < y1; ++y) {
    centres.clear();
    for (const int x : columns) {
      centres.emplace_back(x + 0.5, y + 0.5);
    }
    for (const Vec2& half : {Vec2(-0.5, 0.0), Vec2(0.5, 0.0), Vec2(0.0, -0.5), Vec2(0.0, 0.5)}) {
      centres.push_back(Vec2(target.place.x, y + 0.5) + half);
    }
    directions.resize(centres.size());
    wcs_.directions(centres, directions);
    const Vec3* ends = directions.data() + directions.size() - 4;
    const double solid_angle = length(cross(ends[1] - ends[0], ends[3] - ends[2]));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Vec3& direction = directions[i];
      const Vec2 place = Vec2(dot(direction, east), dot(direction, north)) / target.pixel_rad;
      if (dot(direction, target.direction) > 0.0 && length(place) < reach_px) {
        pixels.push_back({columns[i], y, place, length(place), solid_angle});
      }
    }
  }
  return pixels;
}

void PanoramaStars::treat(PictureStrip& strip, const Target& target) {
  std::vector<Pixel> pixels = pixels_around(strip, target, options_.radius_px + ring_px);
  const auto value = [&](const Pixel& p, int channel) { return static_cast<double>(strip.row(channel, p.y)[p.x]); };
  const auto is_saturated = [&](const Pixel& p) {
    bool any = false;
    for (int channel = 0; channel < strip.channels && options_.saturation; ++channel) {
      any = any || value(p, channel) >= *options_.saturation;
    }
    return any;
  };
  const auto plane_around = [&](double from, double to, int channel) {
    std::vector<Sample> samples;
    for (const Pixel& p : pixels) {
      if (p.distance >= from && p.distance < to && std::isfinite(value(p, channel)) && !is_saturated(p)) {
        samples.push_back({p.place, value(p, channel)});
      }
    }
    return fit_plane(std::move(samples));
  };

  double radius = options_.radius_px;
  std::array<Plane, 3> planes;
  MeasuredStar star{target.magnitude, target.illuminance_lux, {}, false};
  bool stands_out = false;
  bool saturated = false;
  for (int step = 0; step <= most_growths; ++step) {
    if (step > 0) {
      radius *= growth;
      pixels = pixels_around(strip, target, radius + ring_px);
    }
    std::array<Plane, 3> found;
    bool wings = false;
    bool fitted = true;
    std::array<double, 3> sum{};
    double excess = 0.0;
    double inner_excess = 0.0;
    double outer_excess = 0.0;
    double variance = 0.0;
    for (int channel = 0; channel < strip.channels && fitted; ++channel) {
      const auto c = static_cast<std::size_t>(channel);
      const auto near = plane_around(radius, radius + ring_px, channel);
      fitted = near.has_value();
      if (!fitted) {
        break;
      }
      found[c] = *near;
      double count = 0.0;
      double plain_sum = 0.0;
      double inner_sum = 0.0;
      double inner_count = 0.0;
      for (const Pixel& p : pixels) {
        if (p.distance < radius && std::isfinite(value(p, channel))) {
          const double above = value(p, channel) - near->at(p.place);
          sum[c] += above * p.solid_angle_sr;
          plain_sum += above;
          count += 1.0;
          if (p.distance < 0.5 * radius) {
            inner_sum += above;
            inner_count += 1.0;
          }
        }
      }
      excess += plain_sum;
      inner_excess += inner_sum / std::max(inner_count, 1.0);
      outer_excess += (plain_sum - inner_sum) / std::max(count - inner_count, 1.0);
      variance += near->scatter * near->scatter * count;
      // The star's wings surround the aperture, a neighbour fills but a part of the way around.
      std::vector<double> rim;
      for (const Pixel& p : pixels) {
        if (p.distance >= radius && p.distance < radius + 1.0 && std::isfinite(value(p, channel))) {
          rim.push_back(value(p, channel) - near->at(p.place));
        }
      }
      if (!rim.empty()) {
        const auto middle = rim.begin() + static_cast<std::ptrdiff_t>(rim.size() / 2);
        std::nth_element(rim.begin(), middle, rim.end());
        const double error = near->scatter / std::sqrt(static_cast<double>(rim.size()));
        wings = wings || (*middle > wing_share * std::abs(near->coefficients.x) && *middle > significant * error &&
                          *middle < steepest_wing * plain_sum / count);
      }
    }
    if (!fitted) {
      if (step == 0) {
        return;
      }
      break;
    }
    planes = found;
    star.light = sum;
    saturated = std::any_of(pixels.begin(), pixels.end(),
                            [&](const Pixel& p) { return p.distance < radius && is_saturated(p); });
    stands_out = excess > significant * std::sqrt(variance) && excess > 0.0 &&
                 (saturated || inner_excess > least_contrast * outer_excess);
    const bool cut_off = std::any_of(pixels.begin(), pixels.end(), [&](const Pixel& p) {
      return p.distance >= radius && p.distance < radius + 1.0 && is_saturated(p);
    });
    if (!stands_out || (!wings && !cut_off)) {
      break;
    }
  }
  ++report_.in_picture;
  if (!stands_out) {
    return;
  }
  ++report_.found;
  report_.catalogue_lux += target.illuminance_lux;
  star.fit_for_calibration = target.alone && !target.squeezed && !saturated;
  measured_.push_back(star);
  if (!options_.remove) {
    return;
  }
  for (const Pixel& p : pixels) {
    if (p.distance >= radius) {
      continue;
    }
    for (int channel = 0; channel < strip.channels; ++channel) {
      const auto c = static_cast<std::size_t>(channel);
      float& pixel = strip.row(channel, p.y)[p.x];
      const double background = planes[c].at(p.place);
      if (std::isfinite(pixel)) {
        report_.removed.light[c] += (static_cast<double>(pixel) - background) * p.solid_angle_sr;
      }
      pixel = static_cast<float>(background);
    }
    report_.removed.solid_angle_sr += p.solid_angle_sr;
  }
}

} // namespace vesper
