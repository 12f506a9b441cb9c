// The Milky Way as drawn against its map: its light in fields of all sizes, its places, what the air does to it.
#include "render/render_fixture.hpp"
#include "support/truth.hpp"

#include "vesper/assets/cube_texels.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/sky/dark_sky.hpp"
#include "vesper/sky/milky_way.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace vesper::test {
namespace {

std::shared_ptr<const CubePyramid> milky_way_of(int face_size, const std::function<Vec4(const Vec3&)>& light) {
  std::vector<float> texels;
  for (std::size_t i = 0; i < cube_texel_count(face_size); ++i) {
    const Vec4 here = light(cube_texel(face_size, i).direction);
    for (int channel = 0; channel < 4; ++channel) {
      texels.push_back(static_cast<float>(here[channel]));
    }
  }
  return std::make_shared<const CubePyramid>(face_size, std::move(texels));
}

/// A round cloud whose light falls to a half at a distance of 1.18 times `width_rad` from its middle.
std::shared_ptr<const CubePyramid> cloud_at(const Vec3& middle, double width_rad, int face_size) {
  return milky_way_of(face_size, [&](const Vec3& direction) {
    const double away = glm::length(direction - middle) / width_rad;
    return Vec4(0.9, 1.0, 0.8, 2.0) * std::exp(-0.5 * away * away);
  });
}

class MilkyWayTest : public RenderTest {
protected:
  MilkyWayTest() {
    options = bare_stars();
    options.layers.reset().set(static_cast<std::size_t>(Layer::milky_way));
    sky.stars.horizon_from_icrs =
        Mat3(glm::normalize(Vec3(0.3, 0.8, -0.2)), Vec3(0.0), Vec3(0.0)); // no axis along the cube's
    Mat3& axes = sky.stars.horizon_from_icrs;
    axes[1] = glm::normalize(glm::cross(Vec3(0.1, 0.2, 1.0), axes[0]));
    axes[2] = glm::cross(axes[0], axes[1]);
    view.width = view.height = 128;
  }

  void look(Projection projection, Angle azimuth, Angle altitude, Angle fov) {
    view.projection = projection;
    view.azimuth = azimuth;
    view.altitude = altitude;
    view.fov = fov;
  }
  gpu::Frame draw() { return renderer.render(sky, view, plan_frame(sky, view, {}, options)); }
  /// Lux, of Y.
  double light_of(const gpu::Frame& frame) const { return illuminance_in(frame, view, 0, 0, view.width, view.height); }
  /// Of its light.
  Vec3 middle_of(const gpu::Frame& frame) const {
    Vec3 moment(0.0);
    for (int row = 0; row < frame.height; ++row) {
      for (int column = 0; column < frame.width; ++column) {
        const auto light = static_cast<double>(frame.pixel(column, row)[1]);
        if (light > 0.0) {
          moment += light * pixel_solid_angle(view, column, row) * direction_at(view, {column + 0.5, row + 0.5});
        }
      }
    }
    return glm::normalize(moment);
  }
  /// Over which the map is averaged there: two texels, each two pixels wide.
  Angle width_at(const Vec2& pixel) const { return 4.0 * f64::pixel_width(pixel, pixel_frame(view)) * rad; }
  /// ICRS direction of one of the horizon frame.
  Vec3 icrs(const Vec3& horizon) const { return glm::transpose(sky.stars.horizon_from_icrs) * horizon; }
  static double sum_of(const CubePyramid& map) {
    double sum = 0.0;
    const CubePyramid::Level& level = map.levels().front();
    for (std::size_t i = 0; i < cube_texel_count(level.face_size); ++i) {
      sum += static_cast<double>(level.texels[4 * i + 1]) * cube_texel(level.face_size, i).solid_angle_sr;
    }
    return sum;
  }

  SkyState sky = still_sky();
  FrameOptions options;
  View view;
};

TEST_F(MilkyWayTest, TheWholeSkysLightIsTheMaps) {
  const double wanted = sum_of(*default_milky_way());
  ErrorSum errors;
  for (const int size : {48, 100, 200}) {
    view.width = view.height = size;
    look(Projection::fisheye, 30.0 * deg, 20.0 * deg, 360.0 * deg);
    errors.add(100.0 * (light_of(draw()) / wanted - 1.0));
    view.width = 2 * size;
    look(Projection::equirectangular, 200.0 * deg, 0.0 * deg, 360.0 * deg);
    errors.add(100.0 * (light_of(draw()) / wanted - 1.0));
    view.width = size / 2;
    view.height = 6 * view.width;
    look(Projection::cubemap, 70.0 * deg, 50.0 * deg, 90.0 * deg);
    errors.add(100.0 * (light_of(draw()) / wanted - 1.0));
  }
  errors.hold("light of the drawn Milky Way, the whole sky at 48 to 200 pixels, from its map's sum", 0.5, "%");
}

TEST_F(MilkyWayTest, ACloudsLightIsTheSameInEveryField) {
  const Vec3 middle = test::direction(60.0 * deg, 40.0 * deg);
  options.dark_sky.milky_way = cloud_at(icrs(middle), 0.03, 256);
  const double wanted = sum_of(*options.dark_sky.milky_way);
  view.width = view.height = 256;
  ErrorSum errors;
  for (const auto& [projection, fov] :
       {std::pair(Projection::perspective, 30.0), std::pair(Projection::perspective, 60.0),
        std::pair(Projection::perspective, 120.0), std::pair(Projection::fisheye, 90.0),
        std::pair(Projection::fisheye, 180.0), std::pair(Projection::fisheye, 360.0),
        std::pair(Projection::stereographic, 60.0), std::pair(Projection::stereographic, 270.0)}) {
    for (const double aside : {0.0, 7.0}) {
      look(projection, (30.0 + aside) * deg, 36.0 * deg, fov * deg);
      errors.add(100.0 * (light_of(draw()) / wanted - 1.0));
    }
  }
  errors.hold("light of a cloud 4 degrees wide in fields of 30 to 360 degrees, from its map's sum", 0.5, "%");
}

TEST_F(MilkyWayTest, NothingShimmersAsTheViewMoves) {
  // One texel that shines, finer than all that a map holds without its stars; and a cloud as fine as it may hold. In
  // the wide fields both are finer than a pixel.
  const Vec3 middle = test::direction(60.0 * deg, 40.0 * deg);
  constexpr int side = 256;
  std::vector<float> texels(4 * cube_texel_count(side), 0.0F);
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < cube_texel_count(side); ++i) {
    if (glm::dot(cube_texel(side, i).direction, icrs(middle)) >
        glm::dot(cube_texel(side, nearest).direction, icrs(middle))) {
      nearest = i;
    }
  }
  std::fill_n(texels.begin() + static_cast<std::ptrdiff_t>(4 * nearest), 4, 1.0F);
  const auto texel = std::make_shared<const CubePyramid>(side, std::move(texels));
  const auto cloud = cloud_at(icrs(middle), 2.0 / side, side);
  for (const auto& [map, fov, held] :
       {std::tuple(texel, 30.0, 8.0), std::tuple(texel, 180.0, 2.0), std::tuple(texel, 360.0, 2.0),
        std::tuple(cloud, 30.0, 0.5), std::tuple(cloud, 180.0, 2.0), std::tuple(cloud, 360.0, 2.0)}) {
    options.dark_sky.milky_way = map;
    const double wanted = sum_of(*map);
    ErrorSum errors;
    for (int step = 0; step < 8; ++step) {
      const double pixel = fov / view.width;
      look(fov < 90.0 ? Projection::perspective : Projection::fisheye, (30.0 + 0.37 * pixel * step) * deg,
           (38.0 + 0.21 * pixel * step) * deg, fov * deg);
      errors.add(100.0 * (light_of(draw()) / wanted - 1.0));
    }
    errors.hold(std::string("light of a ") + (map == texel ? "single texel" : "cloud two texels wide") +
                    " as a field of " + std::to_string(static_cast<int>(fov)) + " degrees moves by parts of a pixel",
                held, "%");
  }
}

TEST_F(MilkyWayTest, CloudsStandWhereTheMapHasThem) {
  const double texel = 2.0 / 64.0;
  for (const auto& [projection, fov] :
       {std::pair(Projection::perspective, 60.0), std::pair(Projection::fisheye, 180.0),
        std::pair(Projection::stereographic, 120.0), std::pair(Projection::equirectangular, 360.0)}) {
    view.width = projection == Projection::equirectangular ? 256 : 128;
    ErrorSum errors;
    for (const auto& [azimuth, altitude] : {std::pair(0.0, 0.0), std::pair(90.0, 45.0), std::pair(200.0, -35.3),
                                            std::pair(315.0, 89.0), std::pair(135.0, 20.0)}) {
      const Vec3 middle = test::direction((90.0 - azimuth) * deg, altitude * deg);
      options.dark_sky.milky_way = cloud_at(icrs(middle), 2.0 * texel, 64);
      look(projection, (azimuth + 8.0) * deg, std::clamp(altitude - 5.0, -90.0, 90.0) * deg, fov * deg);
      const gpu::Frame frame = draw();
      errors.add(separation(middle_of(frame), middle).to(rad) / texel);
    }
    errors.hold("place of a cloud, " + std::string(projection_names()[static_cast<std::size_t>(projection)]), 0.05,
                "texels");
  }
}

TEST_F(MilkyWayTest, EachPixelIsWhatTheLightOfTheAirTakesItFor) {
  sky.stars.horizon_from_icrs = Mat3(1.0);
  const DarkSky dark = dark_sky(sky, options.dark_sky);
  for (const auto& [projection, fov] :
       {std::pair(Projection::perspective, 30.0), std::pair(Projection::fisheye, 360.0),
        std::pair(Projection::stereographic, 200.0), std::pair(Projection::equirectangular, 360.0)}) {
    look(projection, 266.0 * deg, -29.0 * deg, fov * deg);
    const gpu::Frame frame = draw();
    ErrorSum errors;
    for (int row = 1; row < frame.height; row += 5) {
      for (int column = 2; column < frame.width; column += 5) {
        const Vec2 pixel(column + 0.5, row + 0.5);
        if (f64::pixels_per_steradian(pixel, pixel_frame(view)) <= 0.0) {
          continue;
        }
        const Vec4 wanted = faint_starlight(dark, direction_at(view, pixel), width_at(pixel));
        for (int channel = 0; channel < 4; ++channel) {
          errors.add(100.0 * (static_cast<double>(frame.pixel(column, row)[channel]) / wanted[channel] - 1.0));
        }
      }
    }
    // Textures are read between texels in steps of 1/256 of their distance.
    errors.hold("pixels of the Milky Way against the same map on the CPU, " +
                    std::string(projection_names()[static_cast<std::size_t>(projection)]),
                1.0, "%");
  }
}

TEST_F(MilkyWayTest, TheAirBendsAndDimsIt) {
  options.air = AirOptions();
  options.air.medium = std::make_shared<const Medium>(clear_medium());
  sky.refraction = with_table(standard_refraction(0.0 * metre, Tier::standard));
  sky.stars.horizon_from_icrs = Mat3(1.0);
  ErrorSum places;
  ErrorSum apparents;
  ErrorSum shares;
  for (const double altitude : {0.7, 3.0, 40.0}) {
    const Vec3 middle = test::direction(50.0 * deg, altitude * deg);
    options.dark_sky.milky_way = cloud_at(middle, 0.003, 512);
    look(Projection::perspective, 40.0 * deg, altitude * deg, 3.0 * deg);
    const FramePlan plan = plan_frame(sky, view, {}, options);
    const gpu::Frame frame = renderer.render(sky, view, plan);
    // What is seen is what the air leaves of the map's light where each pixel truly looks.
    const DarkSky dark = dark_sky(sky, options.dark_sky);
    double found = 0.0;
    double wanted = 0.0;
    Vec3 moment(0.0);
    Vec3 wanted_moment(0.0);
    for (int row = 0; row < frame.height; ++row) {
      for (int column = 0; column < frame.width; ++column) {
        const Vec2 pixel(column + 0.5, row + 0.5);
        const Vec3 seen = direction_at(view, pixel);
        const Vec4 light = faint_starlight(dark, true_direction(seen, plan.refraction), width_at(pixel));
        const double here = light.y > 1.0e-9 ? (light * star_extinction(plan.extinction->table, seen.z, light)).y : 0.0;
        found += static_cast<double>(frame.pixel(column, row)[1]);
        wanted += here;
        moment += static_cast<double>(frame.pixel(column, row)[1]) * seen;
        wanted_moment += here * seen;
      }
    }
    shares.add(100.0 * (found / wanted - 1.0));
    places.add(separation(glm::normalize(moment), glm::normalize(wanted_moment)).to(arcsec));
    options.air.extinction = false; // which shifts it up by an arc minute near the horizon
    const Vec3 apparent = apparent_direction(middle, plan.refraction);
    apparents.add(separation(middle_of(draw()), apparent).to(arcmin));
    options.air.extinction = true;
  }
  apparents.hold("place of a cloud behind air that bends alone, from refraction", 0.2, "arcmin");
  shares.hold("light of a cloud behind the air, 0.7 to 40 degrees high, from the CPU's", 0.2, "%");
  places.hold("place of a cloud behind the air, from the CPU's", 2.0, "arcsec");
}

TEST_F(MilkyWayTest, EvenLightStaysEvenOverSeamsPolesAndHorizons) {
  options.dark_sky.milky_way = milky_way_of(16, [](const Vec3&) { return Vec4(3.0, 2.0, 1.0, 4.0); });
  sky.stars.horizon_from_icrs = Mat3(1.0); // the cube's seams along the picture's
  for (const Projection projection : {Projection::perspective, Projection::fisheye, Projection::stereographic,
                                      Projection::equirectangular, Projection::cubemap}) {
    for (const double altitude : {90.0, 0.0, -90.0, 35.264389}) {
      look(projection, 45.0 * deg, projection == Projection::equirectangular ? 0.0 * deg : altitude * deg,
           projection == Projection::perspective ? 120.0 * deg : 300.0 * deg);
      view.width = 30;
      view.height = projection == Projection::cubemap ? 180 : 30;
      const gpu::Frame frame = draw();
      for (int row = 0; row < frame.height; ++row) {
        for (int column = 0; column < frame.width; ++column) {
          if (f64::pixels_per_steradian({column + 0.5, row + 0.5}, pixel_frame(view)) > 0.0) {
            ASSERT_NEAR(frame.pixel(column, row)[1], 2.0F, 2.0e-4F) << column << " " << row;
            ASSERT_NEAR(frame.pixel(column, row)[3], 4.0F, 4.0e-4F) << column << " " << row;
          }
        }
      }
    }
  }
}

TEST_F(MilkyWayTest, AMapWithoutLightIsDarkAndAnotherTakesItsPlace) {
  look(Projection::fisheye, 0.0 * deg, 90.0 * deg, 180.0 * deg);
  options.air.extinction = true;
  options.air.medium = std::make_shared<const Medium>(clear_medium());
  options.dark_sky.milky_way = milky_way_of(16, [](const Vec3&) { return Vec4(0.0); });
  for (const float value : draw().xyzs) {
    ASSERT_EQ(value, 0.0F);
  }
  options.dark_sky.milky_way = nullptr;
  EXPECT_GT(light_of(draw()), 1.0e-5);
}

} // namespace
} // namespace vesper::test
