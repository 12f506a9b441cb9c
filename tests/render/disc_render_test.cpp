// Discs of Moon and Sun in the picture: flattened and reddened by the air, hiding stars, larger or a point.
#include "render/render_fixture.hpp"
#include "support/moon_relief.hpp"
#include "support/truth.hpp"
#include "support/turned_sky.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/sky/moon_illumination.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace vesper::test {
namespace {

Vec3 at_altitude(double altitude_deg) { return direction(30.0 * deg, altitude_deg * deg); }

class Discs : public RenderTest {
protected:
  Discs() {
    options = bare_stars();
    only(Layer::moon);
    options.discs.moon = make_moon_globe(map_of(even_surface, 32));
    view.projection = Projection::perspective;
    view.fov = 0.8 * deg;
    view.width = view.height = 200;
  }
  void only(Layer layer) { options.layers.reset().set(static_cast<std::size_t>(layer)); }
  void aim(const Vec3& at) {
    const Horizontal horizontal = horizontal_of(at);
    view.azimuth = horizontal.azimuth;
    view.altitude = horizontal.altitude;
  }
  gpu::Frame render(const SkyState& sky) { return renderer.render(sky, view, plan_frame(sky, view, {}, options)); }
  double light_in(const gpu::Frame& frame) { return illuminance_in(frame, view, 0, 0, view.width, view.height); }
  static void expect_light(const gpu::Frame& frame) {
    for (const float value : frame.xyzs) {
      ASSERT_TRUE(std::isfinite(value) && value >= 0.0F);
    }
  }
  /// Centre of light in pixels.
  Vec2 centre_of(const gpu::Frame& frame) {
    Vec2 sum(0.0);
    double light = 0.0;
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const auto here = static_cast<double>(frame.pixel(x, y)[1]);
        sum += here * Vec2(x + 0.5, y + 0.5);
        light += here;
      }
    }
    return sum / light;
  }

  SkyState full_moon = sky_state(parse_instant("2026-05-01T20:00:00Z"), {50.0 * deg, 10.0 * deg, 0.0 * metre});
  SkyState quarter_moon = sky_state(parse_instant("2026-05-23T20:00:00Z"), {50.0 * deg, 10.0 * deg, 0.0 * metre});
  FrameOptions options;
  View view;
};

TEST_F(Discs, TheHorizonFlattensThemAsTheTableOfRefractionTells) {
  only(Layer::sun);
  options.air.refraction = true;
  SkyState sky = with_sun_at(full_moon, at_altitude(-0.35));
  sky.refraction = with_table(standard_refraction(0.0 * metre, Tier::standard));
  const RefractionTable& table = *sky.refraction.table;
  const Vec3 seen = apparent_direction(sky.sun.direction_horizon, sky.refraction);
  aim(seen);
  FramePlan plan = plan_frame(sky, view, {}, options);
  ASSERT_TRUE(plan.sun);
  // An even disc: lengths are sums over the middle.
  for (f64::vec4& term : plan.sun->disc.shading.limb) {
    term = f64::vec4(0.0);
  }
  plan.sun->disc.shading.limb[0] = f64::vec4(1.0);
  plan.sun->disc.shading.k_corona = plan.sun->disc.shading.f_corona = f64::vec4(0.0);
  const gpu::Frame frame = renderer.render(sky, view, plan);
  const auto level = static_cast<double>(frame.pixel(100, 100)[1]);
  double height = 0.0;
  double width = 0.0;
  for (int i = 0; i < 200; ++i) {
    height += static_cast<double>(frame.pixel(100, i)[1] + frame.pixel(99, i)[1]) / (2.0 * level);
    width += static_cast<double>(frame.pixel(i, 100)[1] + frame.pixel(i, 99)[1]) / (2.0 * level);
  }
  const Angle radius = plan.sun->disc.angular_radius;
  const Angle altitude = sky.sun.altitude;
  const double expected =
      (apparent_altitude(altitude + radius, table) - apparent_altitude(altitude - radius, table)) / (2.0 * radius);
  std::printf("setting Sun: %.4f as high as wide, by the table of refraction %.4f\n", height / width, expected);
  EXPECT_LT(expected, 0.9);
  EXPECT_NEAR(height / width, expected, 0.003);
}

TEST_F(Discs, AirDimsThemAsTheirSpectrumTells) {
  options.air.extinction = true;
  const Medium medium = clear_medium();
  for (const double altitude : {90.0, 30.0, 5.0, 1.0}) {
    const SkyState sky = with_moon_at(full_moon, at_altitude(altitude));
    aim(sky.moon.place.direction_horizon);
    const gpu::Frame frame = render(sky);
    // Straight rays from chords of an even disc (Gauss's rule with Chebyshev's polynomials of the second kind),
    // wavelength by wavelength.
    const Vec3 eye(0.0, 0.0, medium.ground_radius.to(kilometre));
    const Mat3 axes = horizon_from_disc(sky.moon.place.direction_horizon);
    const Spectrum above = moonlight_of(sky);
    std::vector<double> left(above.values().size(), 0.0);
    constexpr int chords = 7;
    for (int chord = 1; chord <= chords; ++chord) {
      const double angle = std::numbers::pi * chord / (chords + 1);
      const double weight = 2.0 / (chords + 1) * std::pow(std::sin(angle), 2);
      const double sine = std::cos(angle) * std::sin(1737.4 / sky.moon.place.distance.to(kilometre));
      const AirColumns columns = columns_to_space(medium, eye, glm::normalize(axes * Vec3(0.0, sine, 1.0)));
      for (std::size_t i = 0; i < left.size(); ++i) {
        left[i] +=
            weight * above.values()[i] * optical_depth(medium, columns, above.wavelengths_nm()[i]).transmittance();
      }
    }
    const Xyzs all = integrate_xyzs(above);
    const Xyzs some = integrate_xyzs({above.wavelengths_nm(), std::move(left)});
    const Vec4 expected(some.x / all.x, some.y / all.y, some.z / all.z, some.s / all.s);
    const Vec4 bare(all.x, all.y, all.z, all.s);
    for (int channel = 0; channel < 4; ++channel) {
      const double share = illuminance_in(frame, view, 0, 0, 200, 200, channel) / bare[channel];
      std::printf("altitude %g, channel %d: %.5f of the integral\n", altitude, channel, share / expected[channel]);
      EXPECT_NEAR(share / expected[channel], 1.0, altitude > 3.0 ? 0.006 : 0.03) << altitude << " " << channel;
    }
  }
}

TEST_F(Discs, TheMoonHidesStarsOnItsDarkSideToo) {
  const SkyState sky = with_moon_at(quarter_moon, at_altitude(40.0));
  const Vec3 at = sky.moon.place.direction_horizon;
  aim(at);
  options.layers.set(static_cast<std::size_t>(Layer::stars));
  const Mat3 axes = horizon_from_disc(at);
  SkyState resting = sky;
  resting.stars = StarFrame();
  resting.stars.horizon_from_icrs = Mat3(1.0);
  std::vector<StarRecord> stars;
  for (const Vec2& place : {Vec2(0.0, 0.0), Vec2(0.5, 0.0), Vec2(-0.5, 0.0), Vec2(0.0, 0.6), Vec2(0.0, -0.6)}) {
    stars.push_back(white_star(glm::normalize(axes * Vec3(0.0045 * place, 1.0)), 1.0e-4));
  }
  // One beside it.
  stars.push_back(white_star(glm::normalize(axes * Vec3(0.0062, 0.0, 1.0)), 1.0e-4));
  renderer.load(catalogue_of(stars));
  const FramePlan with = plan_frame(sky, view, stars, options);
  only(Layer::moon);
  const FramePlan without = plan_frame(sky, view, {}, options);
  const gpu::Frame moon = renderer.render(sky, view, without);
  const gpu::Frame both = renderer.render(resting, view, with);
  double added = 0.0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      const auto more = static_cast<double>(both.pixel(x, y)[1] - moon.pixel(x, y)[1]);
      const double r = glm::length(Vec2(x - 99.5, y - 99.5)) / projection_frame(view).focal;
      if (r < 0.0044) {
        ASSERT_EQ(more, 0.0) << x << " " << y;
      }
      added += more * pixel_solid_angle(view, x, y);
    }
  }
  EXPECT_NEAR(added, 1.0e-4, 2.0e-6);
}

TEST_F(Discs, BecomingAPointChangesNeitherLightNorItsCentre) {
  const SkyState sky = with_moon_at(quarter_moon, at_altitude(40.0));
  view.width = view.height = 64;
  aim(sky.moon.place.direction_horizon);
  const double diameter = 2.0 * std::asin(1737.4 / sky.moon.place.distance.to(kilometre));
  const auto found_at = [&](double pixels) {
    view.fov = 2.0 * std::atan(32.0 * diameter / pixels) * rad;
    const FramePlan plan = plan_frame(sky, view, {}, options);
    EXPECT_EQ(plan.moon->picture.point.has_value(), pixels < narrowest_disc_px);
    const gpu::Frame frame = renderer.render(sky, view, plan);
    return std::pair(light_in(frame), centre_of(frame));
  };
  const auto [disc, disc_centre] = found_at(3.01);
  const auto [point, point_centre] = found_at(2.99);
  std::printf("from disc to point: light %.5f times as much, centre %.3f pixels off\n", point / disc,
              glm::length(point_centre - disc_centre));
  EXPECT_NEAR(point / disc, 1.0, 4.0e-3);
  EXPECT_LT(glm::length(point_centre - disc_centre), 0.05);
  EXPECT_GT(glm::length(disc_centre - Vec2(32.0)), 0.3) << "a quarter Moon's light has its centre aside";
}

TEST_F(Discs, LargerOnesHaveTheSameLight) {
  const SkyState sky = with_moon_at(quarter_moon, at_altitude(40.0));
  aim(sky.moon.place.direction_horizon);
  const double lux_above = integrate_xyzs(moonlight_of(sky)).y;
  for (const double scale : {1.0, 3.0, 30.0, 100.0}) {
    options.discs.moon_scale = scale;
    view.fov = std::min(0.8 * scale, 80.0) * deg;
    EXPECT_NEAR(light_in(render(sky)) / lux_above, 1.0, 5.0e-3) << scale;
  }
  options.discs.moon_scale = 0.5;
  EXPECT_THROW(static_cast<void>(plan_frame(sky, view, {}, options)), Error);
}

TEST_F(Discs, TheyAreWholeAtTheZenithNadirAndHorizonAndAcrossSeams) {
  const double lux_above = integrate_xyzs(moonlight_of(full_moon)).y;
  for (const Projection projection : {Projection::fisheye, Projection::equirectangular, Projection::cubemap}) {
    view.projection = projection;
    view.fov = 360.0 * deg;
    view.width = projection == Projection::cubemap ? 360 : 1440;
    view.height = projection == Projection::cubemap ? 6 * view.width : 720;
    view.altitude = 0.0 * deg;
    view.azimuth = 0.0 * deg;
    for (const Vec3& at : {Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0), Vec3(0.0, -1.0, 0.0),
                           glm::normalize(Vec3(1.0, 1.0, 1.0)), Vec3(1.0, 0.0, 0.0)}) {
      if (projection == Projection::fisheye && at.y < -0.9) {
        continue; // its edge
      }
      const SkyState sky = with_moon_at(full_moon, at);
      const gpu::Frame frame = render(sky);
      expect_light(frame);
      EXPECT_NEAR(light_in(frame) / lux_above, 1.0, 5.0e-3)
          << projection_names()[static_cast<std::size_t>(projection)] << " " << at.x << " " << at.y << " " << at.z;
    }
  }
}

TEST_F(Discs, TheyMayFillTheFrameOrLieBehindTheCamera) {
  const SkyState sky = with_moon_at(full_moon, at_altitude(40.0));
  aim(sky.moon.place.direction_horizon);
  view.fov = 0.01 * deg;
  const gpu::Frame inside = render(sky);
  expect_light(inside);
  for (std::size_t i = 1; i < inside.xyzs.size(); i += 4) {
    ASSERT_NEAR(inside.xyzs[i] / inside.xyzs[1], 1.0F, 0.01F);
  }
  for (const double fov : {0.5, 60.0, 169.0}) {
    view.fov = fov * deg;
    aim(-sky.moon.place.direction_horizon);
    EXPECT_EQ(light_in(render(sky)), 0.0);
  }
}

TEST_F(Discs, StripsMakeNoDifference) {
  const SkyState sky = with_moon_at(quarter_moon, at_altitude(40.0));
  aim(sky.moon.place.direction_horizon);
  options.layers.set(static_cast<std::size_t>(Layer::sun));
  const gpu::Frame whole = render(sky);
  for (const int rows : {36, 37, 2, 5}) {
    renderer.limit_strip_rows(rows);
    EXPECT_EQ(render(sky).xyzs, whole.xyzs) << rows;
  }
}

TEST_F(Discs, TheMoonLeavesOfTheSunWhatTheEclipseSays) {
  // Partial from central Europe.
  const SkyState sky = sky_state(parse_instant("2026-08-12T18:00:00Z"), {42.35 * deg, -3.7 * deg, 900.0 * metre});
  ASSERT_GT(sky.solar_eclipse.obscuration, 0.1);
  aim(sky.sun.direction_horizon);
  options.layers.set(static_cast<std::size_t>(Layer::sun));
  FramePlan plan = plan_frame(sky, view, {}, options);
  plan.sun->disc.shading.k_corona = plan.sun->disc.shading.f_corona = f64::vec4(0.0);
  const double expected = integrate_xyzs(filtered(sun_disc(sky).irradiance, sunlight_past_moon(sky.solar_eclipse))).y;
  for (const double fov : {0.8, 8.0}) {
    view.fov = fov * deg;
    plan = plan_frame(sky, view, {}, options);
    EXPECT_NEAR(light_in(renderer.render(sky, view, plan)) / expected, 1.0, 3.0e-3) << fov;
  }
}

TEST_F(Discs, NoSunlightGetsPastTheMoonInTotality) {
  // Limbs that share a pixel are parallel, not independent.
  const SkyState sky = sky_state(parse_instant("2026-08-12T18:29:20Z"), {42.34 * deg, -3.7 * deg, 860.0 * metre});
  ASSERT_EQ(sky.solar_eclipse.obscuration, 1.0);
  only(Layer::sun);
  aim(sky.sun.direction_horizon);
  view.fov = 4.0 * deg;
  std::vector<double> lights;
  for (const int size : {48, 120, 400}) {
    view.width = view.height = size;
    const gpu::Frame frame = render(sky);
    expect_light(frame);
    // Baumbach's law at the limb, in units of the disc's centre, which is less than 1.4 of its mean.
    const double foot = 4.044e-6 * 1.4 * 1.96e9;
    for (std::size_t i = 1; i < frame.xyzs.size(); i += 4) {
      ASSERT_LT(static_cast<double>(frame.xyzs[i]), foot) << size;
    }
    lights.push_back(light_in(frame));
  }
  std::printf("light in totality at 48, 120 and 400 px: %.4g, %.4g, %.4g lx\n", lights[0], lights[1], lights[2]);
  EXPECT_NEAR(lights[0] / lights[2], 1.0, 0.02);
  EXPECT_NEAR(lights[1] / lights[2], 1.0, 0.01);
}

} // namespace
} // namespace vesper::test
