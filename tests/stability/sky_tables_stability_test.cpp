// The tables of the sky where tables fail: any medium, the poles of the sky, the horizon, the ends of every axis,
// single precision, the way from the ground to space.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/worker_pool.hpp"
#include "vesper/light/spectral_weights.hpp"
#include "vesper/light/sunlight.hpp"

#include "support/media.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace vesper {
namespace {

using std::numbers::pi;

const SkyTableSize small_tables{6, 5, 8, 16, {8, 6, 3, 6, 3, 0.4, 2.0, 0.1, 3}};

bool possible(const Xyzs& light) {
  return std::isfinite(light.x) && std::isfinite(light.y) && std::isfinite(light.z) && std::isfinite(light.s) &&
         light.x >= 0.0 && light.y >= 0.0 && light.z >= 0.0 && light.s >= 0.0;
}

/// Random numbers that make valid media and questions, the ends of their ranges among them.
class Random {
public:
  explicit Random(unsigned seed) : engine_(seed) {}

  double between(double low, double high) { return std::lerp(low, high, std::uniform_real_distribution<>()(engine_)); }
  bool one_in(int count) { return std::uniform_int_distribution<>(1, count)(engine_) == 1; }
  template <class Value> Value one_of(const std::vector<Value>& values) {
    return values[std::uniform_int_distribution<std::size_t>(0, values.size() - 1)(engine_)];
  }

  Medium medium() {
    Medium result = published_medium();
    const double ground_km = std::pow(10.0, between(1.5, 5.5));
    const double thickness_km = between(10.0, one_in(4) ? 2000.0 : 150.0);
    result.ground_radius = ground_km * kilometre;
    result.top_radius = (ground_km + thickness_km) * kilometre;
    const auto albedo = one_of<double>({0.0, 0.3, 1.0});
    result.ground_albedo = constant_law(albedo);
    result.components[0].profile = HeightProfile::exponential(between(0.5, 20.0));
    result.components[1].profile = HeightProfile::exponential(between(0.1, 5.0));
    const auto g = one_of<double>({-0.99, -0.5, 0.0, 0.8, 0.99});
    result.components[1].phase = {
        one_of<PhaseKind>({PhaseKind::henyey_greenstein, PhaseKind::cornette_shanks, PhaseKind::schlick}),
        constant_law(g)};
    for (MediumComponent& part : result.components) {
      const double factor = one_in(4) ? 0.0 : std::pow(10.0, between(-4.0, 2.0));
      for (WavelengthLaw* law : {&part.scattering_per_km, &part.absorption_per_km}) {
        *law = [old = *law, factor](double nm) { return factor * old(nm); };
      }
    }
    if (one_in(3)) {
      result.wavelengths_nm = {550.0};
    }
    return result;
  }

  double altitude_deg() {
    return one_in(3) ? one_of<double>({90.0, -90.0, 0.0, 1.0e-9, -1.0e-9, 0.2666, -0.2666, -36.0, -36.1, -6.0})
                     : between(-90.0, 90.0);
  }
  SkyQuery query(double thickness_km) {
    const double height_km =
        one_in(3)
            ? one_of<double>({0.0, 1.0e-9, 1.0e-3, thickness_km - 0.05, thickness_km, thickness_km + 1.0e-9, 4.0e4})
            : thickness_km * std::pow(between(0.0, 1.1), 3.0);
    const double azimuth_deg = one_in(3) ? one_of<double>({0.0, 180.0, 90.0}) : between(0.0, 360.0);
    SkyQuery result{height_km * kilometre, test::toward(0.0, altitude_deg()), one_of<double>({0.0, 0.2666, 1.0}) * deg,
                    test::toward(azimuth_deg, altitude_deg())};
    if (one_in(20)) {
      result.view_direction = (one_in(2) ? 1.0 : -1.0) * result.light_direction;
    }
    return result;
  }

private:
  std::mt19937 engine_;
};

std::string text(const SkyQuery& query) {
  return "height " + std::to_string(query.height.to(kilometre)) + " km, light " +
         std::to_string(std::asin(query.light_direction.z) * 180.0 / pi) + ", view " +
         std::to_string(std::asin(query.view_direction.z) * 180.0 / pi);
}

/// As many random questions, from several threads.
void expect_possible(const SkyTables& tables, std::size_t count, unsigned seed, const std::string& name) {
  constexpr std::size_t chunk = 5000;
  std::atomic<int> failures = 0;
  parallel_for(count / chunk, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      Random random(seed + static_cast<unsigned>(k));
      for (std::size_t i = 0; i < chunk; ++i) {
        const SkyQuery query =
            random.query(static_cast<double>(tables.frame.top_km) - static_cast<double>(tables.frame.ground_km));
        const Xyzs light = sky_luminance(tables, query);
        if (!possible(light) && ++failures < 5) {
          ADD_FAILURE() << name << ", " << text(query) << ": " << light.x << " " << light.y << " " << light.z << " "
                        << light.s;
        }
      }
    }
  });
  EXPECT_EQ(failures, 0) << name;
}

TEST(SkyTablesStability, AMillionRandomLookUpsInRandomMedia) {
  constexpr unsigned media = 20;
  for (unsigned i = 0; i < media; ++i) {
    expect_possible(make_sky_tables(Random(i).medium(), small_tables), 50000, 1000 * i, "medium " + std::to_string(i));
  }
}

TEST(SkyTablesStability, NoAirTooMuchAirAndNoGround) {
  Medium black = clear_medium();
  black.ground_albedo = constant_law(0.0);
  Medium nothing = test::scaled(published_medium(), 0.0);
  nothing.ground_albedo = constant_law(0.0);
  expect_possible(make_sky_tables(black, small_tables), 20000, 1, "black ground");
  expect_possible(make_sky_tables(test::scaled(published_medium(), 100.0), small_tables), 20000, 2, "a hundredfold");
  expect_possible(make_sky_tables(test::scaled(published_medium(), 0.0), small_tables), 20000, 3, "no air");
  const SkyTables empty = make_sky_tables(nothing, small_tables);
  expect_possible(empty, 20000, 4, "nothing");
  EXPECT_LT(sky_luminance(empty, {0.0 * kilometre, test::toward(0.0, 30.0), 0.0 * deg, test::toward(50.0, 20.0)}).y,
            1.0e-20);
}

TEST(SkyTablesStability, SmallestTables) {
  expect_possible(make_sky_tables(published_medium(), {2, 2, 2, 2, small_tables.field}), 20000, 5,
                  "two nodes everywhere");
  EXPECT_THROW((void)make_sky_tables(published_medium(), {1, 5, 8, 16, small_tables.field}), Error);
  EXPECT_THROW((void)make_sky_tables(published_medium(), {6, 5, 8, 257, small_tables.field}), Error);
}

/// Tables as programs use them, made once.
const SkyTables& published() {
  static const SkyTables tables = make_sky_tables(published_medium());
  return tables;
}

double luminance(double height_km, const Vec3& light, const Vec3& view) {
  return sky_luminance(published(), {height_km * kilometre, light, 0.2666 * deg, view}).y;
}

TEST(SkyTablesStability, NothingDependsOnTheAzimuthWithTheLightAtAPole) {
  for (const double height_km : {0.0, 11.0, 300.0}) {
    for (const double altitude : {70.0, 10.0, 1.0e-6, -30.0, -80.0}) {
      const double one = luminance(height_km, test::toward(0.0, 90.0), test::toward(0.0, altitude));
      for (const double azimuth : {45.0, 133.0, 180.0}) {
        const double other = luminance(height_km, test::toward(0.0, 90.0), test::toward(azimuth, altitude));
        EXPECT_NEAR(other, one, 1.0e-4 * one) << height_km << " km, " << altitude << ", " << azimuth;
      }
    }
    // By night all is dark.
    EXPECT_LT(luminance(height_km, test::toward(0.0, -90.0), test::toward(20.0, 30.0)), 1.0e-12);
  }
}

TEST(SkyTablesStability, NoStepAtZenithNadirAndOpposition) {
  constexpr double aside_deg = 1.0e-4;
  for (const double light : {89.9999, 40.0, 0.0, -5.0}) {
    for (const double height_km : {0.0, 11.0}) {
      const Vec3 sun = test::toward(0.0, light);
      for (const double place : {90.0, -90.0}) {
        const double middle = luminance(height_km, sun, test::toward(0.0, place));
        for (const double azimuth : {0.0, 90.0, 180.0}) {
          const double beside =
              luminance(height_km, sun, test::toward(azimuth, place - std::copysign(aside_deg, place)));
          EXPECT_NEAR(beside, middle, 1.0e-4 * middle) << "light " << light << ", view " << place;
        }
      }
      if (light < 89.0) {
        // Straight at the light and away from it.
        for (const double azimuth : {0.0, 180.0}) {
          const double altitude = azimuth == 0.0 ? light : -light;
          if (std::abs(altitude) < 1.0) {
            continue; // that is the horizon's case
          }
          const double middle = luminance(height_km, sun, test::toward(azimuth, altitude));
          for (const double step : {-aside_deg, aside_deg}) {
            EXPECT_NEAR(luminance(height_km, sun, test::toward(azimuth + step, altitude)), middle, 2.0e-4 * middle);
            EXPECT_NEAR(luminance(height_km, sun, test::toward(azimuth, altitude + step)), middle, 2.0e-4 * middle);
          }
        }
      }
    }
  }
}

TEST(SkyTablesStability, TheHorizonHasNoBlocks) {
  // The change from one small_tables step of altitude to the next is itself nearly the same at the next: nothing glows
  // in bands, however high the exposure.
  for (const double light : {30.0, 1.0, -2.0, -4.0, -8.0, -12.0, -16.0}) {
    for (const double azimuth : {0.0, 60.0, 180.0}) {
      test::ErrorSum bends;
      constexpr double step_deg = 0.01;
      const auto logarithm = [&](int i) {
        return std::log(luminance(0.0, test::toward(0.0, light), test::toward(azimuth, 0.01 + i * step_deg)));
      };
      for (int i = 1; i < 500; ++i) {
        bends.add(100.0 * (logarithm(i - 1) - 2.0 * logarithm(i) + logarithm(i + 1)));
      }
      EXPECT_LT(bends.worst(), 0.25) << "light " << light << ", azimuth " << azimuth;
    }
  }
}

TEST(SkyTablesStability, BothSidesOfTheHorizonAreRight) {
  const Medium medium = published_medium();
  const ReferenceTransport reference(medium, medium.wavelengths_nm);
  const SpectralWeights weights = spectral_weights(solar_irradiance_1au(), medium.wavelengths_nm);
  const double lux = weights({1.0, 1.0, 1.0}).y;
  PathBudget budget;
  budget.relative_error = 0.01;
  test::ErrorSum errors;
  for (const double light : {30.0, 3.0, -3.0}) {
    for (const double height_km : {0.05, 1.0, 11.0, 60.0}) {
      const double dip_deg = std::acos(6360.0 / (6360.0 + height_km)) * 180.0 / pi;
      for (const double aside_deg : {-0.03, 0.03}) {
        const SkyQuery query{height_km * kilometre, test::toward(0.0, light), 0.2666 * deg,
                             test::toward(60.0, aside_deg - dip_deg)};
        ++budget.stream;
        const double exact = reference.radiance(query, {weights.y}, budget).functionals[0].mean / lux;
        errors.add(100.0 * (sky_luminance(published(), query).y / exact - 1.0));
      }
    }
  }
  errors.hold("published, 0.03 degree above and below the horizon, 50 m to 60 km, Sun 30 to -3 degrees", 6.0, "%");
}

TEST(SkyTablesStability, FromTheGroundToSpaceWithoutAJump) {
  for (const double light : {40.0, 5.0, -3.0}) {
    for (const double view : {90.0, 20.0, 3.0, -40.0, -90.0}) {
      const auto seen = [&](double height_km) {
        return luminance(height_km, test::toward(0.0, light), test::toward(70.0, view));
      };
      const double brightest = std::max(seen(0.0), seen(400.0));
      double last = seen(0.0);
      for (int i = 1; i <= 2000; ++i) {
        const double share = i / 2000.0;
        const double now = seen(400.0 * share * share * share);
        EXPECT_NEAR(now, last, 0.02 * std::max(now, last) + 1.0e-4 * brightest)
            << "light " << light << ", view " << view << ", " << 400.0 * share * share * share << " km";
        last = now;
      }
      // Through the top.
      const double inside = seen(99.999);
      EXPECT_NEAR(seen(100.001), inside, 1.0e-3 * inside + 1.0e-4 * brightest)
          << "light " << light << ", view " << view;
    }
  }
}

TEST(SkyTablesStability, AxesEndWithoutAStep) {
  const auto by_light = [](double light) { return luminance(0.0, test::toward(0.0, light), test::toward(40.0, 30.0)); };
  EXPECT_NEAR(by_light(90.0), by_light(89.999), 1.0e-4 * by_light(90.0));
  EXPECT_NEAR(by_light(-35.999), by_light(-36.001), 0.01 * by_light(-36.0));
  EXPECT_NEAR(by_light(-36.5), by_light(-80.0), 1.0e-3 * by_light(-80.0));
  EXPECT_LT(by_light(-36.0), 1.0e-10);
  const auto by_height = [](double height_km) {
    return luminance(height_km, test::toward(0.0, 20.0), test::toward(40.0, 30.0));
  };
  EXPECT_NEAR(by_height(0.0), by_height(1.0e-3), 1.0e-3 * by_height(0.0));
}

/// The tables in double precision.
struct Doubles {
  explicit Doubles(const std::vector<f32::vec4>& from) : texels(from.begin(), from.end()) {}
  std::vector<f64::vec4> texels;
};

TEST(SkyTablesStability, SinglePrecisionIsEnough) {
  const SkyTables& tables = published();
  const f32::SkyTableFrame& frame = tables.frame;
  const f64::SkyTableFrame frame64{static_cast<double>(frame.ground_km),
                                   static_cast<double>(frame.top_km),
                                   frame.heights,
                                   frame.views_below,
                                   frame.views_above,
                                   frame.lights};
  const f64::SkyTransmittanceFrame nodes64{tables.transmittance_frame.altitudes, tables.transmittance_frame.heights};
  const Doubles other(tables.other);
  const Doubles transmittance(tables.transmittance);
  const Doubles phase(tables.phase);
  const f32::sampler3D table32 = sampler(tables, tables.other);
  const f64::sampler3D table64{other.texels.data(), table32.width, table32.height, table32.depth};
  const f32::sampler2D plane32 = transmittance_sampler(tables);
  const f64::sampler2D plane64{transmittance.texels.data(), plane32.width, plane32.height};
  test::ErrorSum scattered;
  test::ErrorSum passed;
  test::ErrorSum to_ground;
  test::ErrorSum phases;
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const auto height = static_cast<float>(100.0 * std::pow(random.between(0.0, 1.0), 3.0));
    const float dip = f32::sky_dip(height, frame);
    const bool below = i % 2 == 0;
    const double share = std::pow(random.between(0.0, 1.0), 3.0);
    // Floats, that both precisions are asked the same.
    const auto view =
        static_cast<float>(below ? -static_cast<double>(dip) - share * (0.5 * pi - static_cast<double>(dip))
                                 : -static_cast<double>(dip) + share * 0.5 * pi);
    const auto light = static_cast<float>(random.between(-0.4, 0.5 * pi));
    const auto cosine = static_cast<float>(random.between(-1.0, 1.0));
    const double height64 = height;
    const double view64 = view;
    const double dip64 = f64::sky_dip(height64, frame64);
    const auto light32 = f32::sky_path_share(height, view, below, frame) *
                         glm::exp2(f32::sky_table_log2(table32, height, f32::sky_view_place(view, dip, below, frame),
                                                       light, cosine, frame));
    const auto light64 =
        f64::sky_path_share(height64, view64, below, frame64) *
        glm::exp2(f64::sky_table_log2(table64, height64, f64::sky_view_place(view64, dip64, below, frame64),
                                      static_cast<double>(light), static_cast<double>(cosine), frame64));
    scattered.add(100.0 * (static_cast<double>(light32.y) / light64.y - 1.0));
    if (below) {
      const auto a = glm::exp2(f32::sky_ground_view_log2(plane32, height, view, tables.transmittance_frame, frame));
      const auto b = glm::exp2(f64::sky_ground_view_log2(plane64, height64, view64, nodes64, frame64));
      to_ground.add(100.0 * (static_cast<double>(a.y) - b.y));
    } else {
      const auto a = glm::exp2(f32::sky_transmittance_log2(plane32, height, view, tables.transmittance_frame, frame));
      const auto b = glm::exp2(f64::sky_transmittance_log2(plane64, height64, view64, nodes64, frame64));
      passed.add(100.0 * (static_cast<double>(a.y) - b.y));
    }
    const auto count = static_cast<int>(tables.phase.size());
    const float phase32 = f32::sky_aerosol_phase(line_sampler(tables.phase), cosine, count);
    const double phase64 = f64::sky_aerosol_phase({phase.texels.data(), count}, static_cast<double>(cosine), count);
    phases.add(100.0 * (static_cast<double>(phase32) / phase64 - 1.0));
  }
  scattered.hold("scattered light in single precision", 0.2, "%");
  passed.hold("transmittance to space in single precision", 0.05, "%");
  to_ground.hold("transmittance to the ground in single precision", 0.5, "%");
  phases.hold("phase function in single precision", 0.02, "%");
}

} // namespace
} // namespace vesper
