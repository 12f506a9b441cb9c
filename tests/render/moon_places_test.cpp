// Craters, terminator and bright limb in the picture against where independent figures of the librations, the axis, the
// zenith and the Sun put them.
#include "render/render_fixture.hpp"
#include "support/moon_relief.hpp"
#include "support/truth.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace vesper::test {
namespace {

struct Feature {
  const char* name;
  double longitude_deg; ///< selenographic, east positive
  double latitude_deg;
};
/// Gazetteer of Planetary Nomenclature (IAU, USGS).
constexpr std::array features{Feature{"Tycho", -11.22, -43.30}, Feature{"Copernicus", -20.08, 9.62},
                              Feature{"Plato", -9.38, 51.62}, Feature{"Grimaldi", -68.36, -5.38},
                              Feature{"Mare Crisium", 59.10, 16.18}};

Vec3 on_globe(const Feature& feature) { return direction(feature.longitude_deg * deg, feature.latitude_deg * deg); }

/// Dark ground with a bright spot of one degree at each feature.
SurfacePlace spotted_surface(const Vec3& at) {
  double albedo = 1.0e-4;
  for (const Feature& feature : features) {
    const double off = separation(at, on_globe(feature)).to(deg);
    albedo += off < 5.0 ? std::exp(-off * off) : 0.0;
  }
  return {std::min(albedo, 1.0), at};
}

/// A place on the disc, x east and y north on the sky in radii, as the figures of a row of the reference have it.
class ReferenceDisc {
public:
  explicit ReferenceDisc(const TruthRow& row)
      : sine_(std::sin(row.degrees("semidiam_topo").to(rad))), longitude_(row.degrees("lib_lon_topo")),
        latitude_(row.degrees("lib_lat_topo")), axis_(row.degrees("pa_axis")), zenith_(row.degrees("parallactic")),
        bright_limb_(row.degrees("pa_bright_limb")), phase_(row.degrees("phase_angle")) {}

  /// Level and upward, in radii.
  [[nodiscard]] Vec2 place_of(const Feature& feature) const {
    const double l = (feature.longitude_deg * deg - longitude_).to(rad);
    const double b = (feature.latitude_deg * deg).to(rad);
    const double b0 = latitude_.to(rad);
    const double aside = std::cos(b) * std::sin(l);
    const double north = std::cos(b0) * std::sin(b) - std::sin(b0) * std::cos(b) * std::cos(l);
    const double near = std::sin(b0) * std::sin(b) + std::cos(b0) * std::cos(b) * std::cos(l);
    // Lunar east is west on the sky.
    return seen(aside * along(axis_ - 90.0 * deg) + north * along(axis_), near);
  }

  /// Of the diameter through the bright limb's middle: where the Sun stands at an elevation.
  [[nodiscard]] Vec2 place_of_sun_at(Angle elevation) const {
    const double from_middle = (phase_ - 90.0 * deg + elevation).to(rad);
    return seen(std::sin(from_middle) * along(bright_limb_), std::cos(from_middle));
  }
  [[nodiscard]] Vec2 bright_limb() const { return along(bright_limb_); }
  [[nodiscard]] Angle phase() const { return phase_; }
  [[nodiscard]] double sine() const { return sine_; }

private:
  /// A direction on the sky by its position angle: level and upward.
  [[nodiscard]] Vec2 along(Angle position) const {
    const double off = (position - zenith_).to(rad);
    return {-std::sin(off), std::cos(off)};
  }
  /// A near place is larger.
  [[nodiscard]] Vec2 seen(const Vec2& across, double near) const {
    const double away = 1.0 - sine_ * near;
    return across / std::sqrt(away * away + sine_ * sine_ * glm::dot(across, across));
  }

  double sine_;
  Angle longitude_, latitude_, axis_, zenith_, bright_limb_, phase_;
};

class MoonPlaces : public RenderTest {
protected:
  static constexpr int dates = 20;

  MoonPlaces() {
    options = bare_stars();
    options.layers.reset().set(static_cast<std::size_t>(Layer::moon));
    view.projection = Projection::perspective;
    view.fov = 0.6 * deg;
    view.width = view.height = 400;
  }

  /// Rows with good librations, spread over the table.
  static std::vector<TruthRow> rows(const CsvTable& table) {
    std::vector<TruthRow> result;
    for (std::size_t i = 0; i < table.row_count() && result.size() < dates; i += 5) {
      const TruthRow row(table, i);
      if (row.text("lib_src") != "Meeus53") {
        result.push_back(row);
      }
    }
    return result;
  }

  SkyState aim(const TruthRow& row) {
    view.azimuth = row.degrees("az");
    view.altitude = row.degrees("alt");
    return sky_state(row.instant(), row.observer());
  }

  /// Pixel of a place on the disc of the reference, which the view is aimed at.
  [[nodiscard]] Vec2 pixel_of(const Vec2& place, const ReferenceDisc& disc) const {
    const double focal = projection_frame(view).focal;
    const Vec2 sine = disc.sine() * place;
    const double cosine = std::sqrt(1.0 - glm::dot(sine, sine));
    return {0.5 * view.width + focal * sine.x / cosine, 0.5 * view.height - focal * sine.y / cosine};
  }
  [[nodiscard]] double diameter_px(const ReferenceDisc& disc) const {
    return 2.0 * projection_frame(view).focal * disc.sine();
  }

  FrameOptions options;
  View view;
};

TEST_F(MoonPlaces, FeaturesLieWhereTheLibrationsPutThem) {
  options.discs.moon = make_moon_globe(map_of(spotted_surface, 400));
  const CsvTable table = truth_table("moon_topo.csv");
  std::array<ErrorSum, features.size()> errors;
  for (const TruthRow& row : rows(table)) {
    const SkyState sky = aim(row);
    FramePlan plan = plan_frame(sky, view, {}, options);
    ASSERT_TRUE(plan.moon);
    // Lit from behind the observer and flat: only places count.
    plan.moon->disc.lighting.to_sun = plan.moon->disc.to_observer;
    plan.moon->disc.lighting.sun_law = {2.0, 0.0};
    plan.moon->crescent_cells = 0.0;
    const gpu::Frame frame = renderer.render(sky, view, plan);
    const ReferenceDisc disc(row);
    for (std::size_t i = 0; i < features.size(); ++i) {
      const Vec2 expected = pixel_of(disc.place_of(features.at(i)), disc);
      constexpr int reach = 12;
      Vec2 sum(0.0);
      double light = 0.0;
      for (int y = static_cast<int>(expected.y) - reach; y <= static_cast<int>(expected.y) + reach; ++y) {
        for (int x = static_cast<int>(expected.x) - reach; x <= static_cast<int>(expected.x) + reach; ++x) {
          const auto here = static_cast<double>(frame.pixel(x, y)[1]);
          sum += here * Vec2(x + 0.5, y + 0.5);
          light += here;
        }
      }
      ASSERT_GT(light, 0.0);
      errors.at(i).add(100.0 * glm::length(sum / light - expected) / diameter_px(disc));
    }
  }
  for (std::size_t i = 0; i < features.size(); ++i) {
    EXPECT_EQ(errors.at(i).count(), static_cast<std::size_t>(dates));
    errors.at(i).hold(std::string(features.at(i).name) + " in the picture", 0.3, "% of the Moon's diameter");
  }
}

TEST_F(MoonPlaces, TerminatorAndBrightLimbFollowTheSun) {
  options.discs.moon = make_moon_globe(map_of(even_surface, 64));
  const CsvTable table = truth_table("moon_topo.csv");
  ErrorSum terminator;
  ErrorSum limb;
  for (const TruthRow& row : rows(table)) {
    const ReferenceDisc disc(row);
    const SkyState sky = aim(row);
    const FramePlan plan = plan_frame(sky, view, {}, options);
    // Under a law of cosines luminance tells the Sun's elevation.
    const gpu::Frame frame = renderer.render(sky, view, plan, {.moon_shading = gpu::MoonShading::lambert});
    const double overhead = 0.12 / std::numbers::pi * plan.moon->disc.lighting.sunlit.y;
    const auto sun_sine = [&](const Vec2& pixel) {
      const Vec2 at = pixel - 0.5;
      const auto x = static_cast<int>(std::floor(at.x));
      const auto y = static_cast<int>(std::floor(at.y));
      const auto value = [&](int dx, int dy) { return static_cast<double>(frame.pixel(x + dx, y + dy)[1]); };
      const Vec2 f = at - glm::floor(at);
      return glm::mix(glm::mix(value(0, 0), value(1, 0), f.x), glm::mix(value(0, 1), value(1, 1), f.x), f.y) / overhead;
    };
    // Where the Sun stands at 10 degrees, if that is no grazing place.
    const Angle elevation = 10.0 * deg;
    const Angle from_middle = disc.phase() - 90.0 * deg + elevation;
    if (std::abs(from_middle.to(deg)) < 70.0) {
      const Vec2 expected = pixel_of(disc.place_of_sun_at(elevation), disc);
      const Vec2 outward = Vec2(1.0, -1.0) * disc.bright_limb();
      const double slope = 0.5 * (sun_sine(expected + outward) - sun_sine(expected - outward));
      terminator.add(100.0 * (sun_sine(expected) - std::sin(elevation.to(rad))) / slope / diameter_px(disc));
    }
    // The centre of light lies towards the bright limb.
    Vec2 sum(0.0);
    double light = 0.0;
    for (int y = 0; y < view.height; ++y) {
      for (int x = 0; x < view.width; ++x) {
        const auto here = static_cast<double>(frame.pixel(x, y)[1]);
        sum += here * (Vec2(x + 0.5, y + 0.5) - 0.5 * Vec2(view.width, view.height));
        light += here;
      }
    }
    const Vec2 centre = Vec2(1.0, -1.0) * sum / light;
    const Vec2 aside(-disc.bright_limb().y, disc.bright_limb().x);
    limb.add(100.0 * glm::dot(centre, aside) / diameter_px(disc));
  }
  EXPECT_GE(terminator.count(), 12U);
  terminator.hold("terminator in the picture, where the Sun stands at 10 deg", 0.3, "% of the Moon's diameter");
  limb.hold("centre of light in the picture, off the line to the bright limb", 0.3, "% of the Moon's diameter");
}

} // namespace
} // namespace vesper::test
