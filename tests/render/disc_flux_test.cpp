// The light of Moon and Sun is conserved: their pixels' luminance times solid angle sums to the illuminance that the
// sky was lit with, in any projection, field and place between the pixels.
#include "render/render_fixture.hpp"
#include "support/moon_relief.hpp"
#include "support/truth.hpp"
#include "support/turned_sky.hpp"

#include "vesper/sky/moon_illumination.hpp"

#include <array>
#include <cstdio>
#include <string>

namespace vesper::test {
namespace {

enum class Body { moon, sun };

struct DiscCase {
  Projection projection;
  double fov_deg;
  int size;
};

class DiscFlux : public RenderTest {
protected:
  DiscFlux() {
    options = bare_stars();
    options.layers.reset();
    options.discs.moon = make_moon_globe(map_of(waved_surface, 128));
  }

  /// The sum over a picture in Y against what the body gives above the air.
  double light_of(Body body, const SkyState& sky, const View& view) {
    options.layers.reset().set(static_cast<std::size_t>(body == Body::moon ? Layer::moon : Layer::sun));
    const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, {}, options));
    return illuminance_in(frame, view, 0, 0, view.width, view.height);
  }

  /// Errors at several places of a body between the pixels and about the picture.
  ErrorSum errors(Body body, const SkyState& sky, const DiscCase& of, int count) {
    View view;
    view.projection = of.projection;
    view.fov = of.fov_deg * deg;
    view.width = of.size;
    view.height = of.projection == Projection::equirectangular ? of.size / 2
                  : of.projection == Projection::cubemap       ? 6 * of.size
                                                               : of.size;
    view.altitude = 31.0 * deg;
    view.azimuth = 120.0 * deg;
    view.roll = 7.0 * deg;
    const Xyzs light =
        body == Body::moon ? integrate_xyzs(moonlight_of(sky)) : integrate_xyzs(sun_disc(sky).irradiance);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> normal;
    ErrorSum sum;
    const bool sphere = of.projection == Projection::equirectangular || of.projection == Projection::cubemap;
    for (int i = 0; i < count; ++i) {
      Vec3 at = glm::normalize(Vec3(normal(random), normal(random), normal(random)));
      if (!sphere) {
        // Near the middle, with all of the disc in the picture.
        const double free = std::max(0.5 * of.fov_deg - 0.3, 0.0) / of.fov_deg * of.size * 0.6;
        at = direction_at(view, Vec2(0.5 * of.size) + free * Vec2(2.0 * unit(random) - 1.0, 2.0 * unit(random) - 1.0));
      }
      const SkyState there = body == Body::moon ? with_moon_at(sky, at) : with_sun_at(sky, at);
      sum.add(light_of(body, there, view) / light.y - 1.0);
    }
    return sum;
  }

  void hold(Body body, const char* name, const SkyState& sky, double limit) {
    for (const DiscCase& of : std::initializer_list<DiscCase>{{Projection::perspective, 0.6, 160},
                                                              {Projection::perspective, 2.0, 64},
                                                              {Projection::perspective, 10.0, 100},
                                                              {Projection::perspective, 60.0, 400},
                                                              {Projection::fisheye, 180.0, 800},
                                                              {Projection::fisheye, 180.0, 64},
                                                              {Projection::stereographic, 2.0, 128},
                                                              {Projection::equirectangular, 0.0, 1600},
                                                              {Projection::cubemap, 0.0, 400},
                                                              {Projection::cubemap, 0.0, 60}}) {
      const std::string what = std::string("light of the ") + name + ", " +
                               std::string(projection_names()[static_cast<std::size_t>(of.projection)]) + " " +
                               (of.fov_deg > 0.0 ? std::to_string(of.fov_deg).substr(0, 5) + " deg, " : "") +
                               std::to_string(of.size) + " px";
      errors(body, sky, of, of.size >= 400 ? 2 : 4).hold(what, limit, "of it");
    }
  }

  FrameOptions options;
};

SkyState sky_at(const char* stamp) { return sky_state(parse_instant(stamp), {50.0 * deg, 10.0 * deg, 100.0 * metre}); }

// One renderer for three phases: compiling its programs costs more than drawing.
TEST_F(DiscFlux, Moon) {
  hold(Body::moon, "full Moon", sky_at("2026-05-01T20:00:00Z"), 5.0e-3);
  hold(Body::moon, "first quarter", sky_at("2026-05-23T20:00:00Z"), 5.0e-3);
  hold(Body::moon, "crescent", sky_at("2026-05-19T20:00:00Z"), 5.0e-3);
}

TEST_F(DiscFlux, EclipsedMoon) {
  // The Earth's shadow lies differently over maria and highlands: the real map. Partial from the first stamp on, total
  // from the fourth.
  options.discs.moon = nullptr;
  options.layers.reset().set(static_cast<std::size_t>(Layer::moon));
  const Observer new_york{40.7 * deg, -74.0 * deg, 0.0 * metre};
  ErrorSum y;
  ErrorSum others;
  for (const char* stamp : {"2010-12-21T06:50:00Z", "2010-12-21T07:15:00Z", "2010-12-21T07:38:00Z",
                            "2010-12-21T07:45:00Z", "2010-12-21T08:17:00Z"}) {
    const SkyState sky = sky_state(parse_instant(stamp), new_york);
    const Xyzs light = integrate_xyzs(moonlight_of(sky));
    for (const double fov_deg : {1.0, 60.0}) {
      View view;
      view.projection = Projection::perspective;
      view.fov = fov_deg * deg;
      view.width = view.height = 401;
      view.azimuth = sky.moon.place.azimuth + 1.3e-3 * view.fov;
      view.altitude = sky.moon.place.altitude + 0.7e-3 * view.fov;
      view.roll = 20.0 * deg;
      const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, {}, options));
      const auto error = [&](int channel, double expected) {
        return 100.0 * (illuminance_in(frame, view, 0, 0, view.width, view.height, channel) / expected - 1.0);
      };
      y.add(error(1, light.y));
      for (const double off : {error(0, light.x), error(2, light.z), error(3, light.s)}) {
        others.add(off);
      }
    }
  }
  y.hold("Y of the eclipsed Moon's pixels against its light", 0.5, "%");
  others.hold("X, Z and S of them", 0.7, "%");
}

TEST_F(DiscFlux, TheRealMoonFromAFewPixelsOn) {
  options.discs.moon = nullptr;
  for (const auto& [name, stamp] :
       {std::pair("full", "2026-05-01T20:00:00Z"), std::pair("gibbous", "2026-05-27T20:00:00Z"),
        std::pair("half", "2026-05-23T20:00:00Z")}) {
    ErrorSum sum;
    for (const double fov_deg : {40.0, 25.0, 18.0, 9.0, 2.0}) {
      sum.add(errors(Body::moon, sky_at(stamp), {Projection::perspective, fov_deg, 340}, 6).worst());
    }
    sum.hold(std::string("light of the real map from 4 px on, ") + name, 5.0e-3, "of it");
  }
}

TEST_F(DiscFlux, CrescentsOfTheRealMoonFromAFewPixelsOn) {
  options.discs.moon = nullptr;
  // Before and after a new Moon, which light other limbs.
  for (const double hours : {15.0, 30.0, 48.0, 96.0}) {
    for (const double way : {-1.0, 1.0}) {
      const SkyState sky = sky_state(later(parse_instant("2026-05-16T20:00:00Z"), way * 3600.0 * hours),
                                     {50.0 * deg, 10.0 * deg, 100.0 * metre});
      ErrorSum sum;
      for (const double wide_px : {6.0, 16.5, 23.0, 40.0, 90.0, 200.0, 400.0}) {
        const double fov_deg = 0.53 * std::max(64.0, 1.2 * wide_px) / wide_px;
        sum.add(
            errors(Body::moon, sky, {Projection::perspective, fov_deg, static_cast<int>(fov_deg / 0.53 * wide_px)}, 3)
                .worst());
      }
      char what[80];
      std::snprintf(what, sizeof(what), "light of the real map from 6 to 400 px, phase angle %.1f degrees",
                    sky.moon.phase_angle.to(deg));
      sum.hold(what, 5.0e-3, "of it");
    }
  }
}

TEST_F(DiscFlux, Sun) { hold(Body::sun, "Sun", sky_at("2026-05-19T10:00:00Z"), 5.0e-3); }

} // namespace
} // namespace vesper::test
