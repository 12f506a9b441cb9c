// The Moon's cube map against analytic Moons, and the built-in one against the places of its craters and seas.
#include "support/moon_inputs.hpp"
#include "support/truth.hpp"

#include "vesper/assets/cube_texels.hpp"
#include "vesper/catalog_tools/moon_products.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace vesper {
namespace {

using test::ErrorSum;
using test::globe_grid;

constexpr double radius_m = 1737400.0;

GlobeGrid flat() {
  return globe_grid(90, 0.0, [](const Vec3&) { return 0.0; });
}
GlobeGrid grey() {
  return globe_grid(90, 0.0, [](const Vec3&) { return 0.5; });
}

double albedo_of(const MoonMap& map, std::size_t texel) { return static_cast<double>(map.texels[4 * texel]); }
Vec3 normal_of(const MoonMap& map, std::size_t texel) {
  const float* n = &map.texels[4 * texel + 1];
  return {n[0], n[1], n[2]};
}

/// Whether a texel lies at the edge of a face.
bool at_edge(int face_size, std::size_t texel) {
  const auto n = static_cast<std::size_t>(face_size);
  const std::size_t column = texel % n;
  const std::size_t row = texel / n % n;
  return column == 0 || row == 0 || column == n - 1 || row == n - 1;
}

TEST(MoonMapAccuracy, AnEvenMoonStaysEven) {
  const MoonMap map = make_moon_product(grey(), flat(), {64}).map;
  ErrorSum albedo;
  ErrorSum normal;
  for (std::size_t i = 0; i < cube_texel_count(64); ++i) {
    albedo.add(100.0 * (albedo_of(map, i) / 0.1207 - 1.0));
    normal.add(test::separation(normal_of(map, i), cube_texel(64, i).direction).to(deg));
  }
  albedo.hold("albedo of an even Moon, 16-bit floats", 0.0489, "%");
  normal.hold("normal of a sphere, 16-bit floats", 0.02, "deg");
}

/// The mean of a function over a texel, from 8 by 8 points of its own.
template <class Function> auto texel_mean(int face_size, std::size_t texel, const Function& value) {
  constexpr int finer = 8;
  const auto n = static_cast<std::size_t>(face_size);
  decltype(value(Vec3()) * 1.0) sum{};
  double area = 0.0;
  for (std::size_t j = 0; j < finer; ++j) {
    for (std::size_t i = 0; i < finer; ++i) {
      const CubeTexel part = cube_texel(face_size * finer, (texel / n * finer + j) * n * finer + texel % n * finer + i);
      sum += part.solid_angle_sr * value(part.direction);
      area += part.solid_angle_sr;
    }
  }
  return sum / area;
}

TEST(MoonMapAccuracy, ALinearAlbedoIsRecovered) {
  const auto albedo = [](const Vec3& d) { return 1.0 + 0.5 * d.x - 0.3 * d.y + 0.4 * d.z; };
  // The picture's rows and columns lie askew to the faces; its left edge is at no border of theirs.
  const MoonProduct product = make_moon_product(globe_grid(720, 17.3, albedo), flat(), {64});
  ErrorSum inside;
  ErrorSum edges;
  ErrorSum poles;
  for (std::size_t i = 0; i < cube_texel_count(64); ++i) {
    const double found = albedo_of(product.map, i) / product.report.albedo_scale;
    const double error = 100.0 * (found / texel_mean(64, i, albedo) - 1.0);
    (std::abs(cube_texel(64, i).direction.z) > std::cos(0.1) ? poles : at_edge(64, i) ? edges : inside).add(error);
  }
  // Of this 0.0489 % is the rounding to 16 bits.
  inside.hold("linear albedo inside of faces", 0.06, "%");
  edges.hold("linear albedo at edges of faces", 0.06, "%");
  poles.hold("linear albedo within 6 deg of the poles", 0.06, "%");
}

/// Heights that spherical harmonics of degree 1 to 3 make, and their gradient on the sphere of radius 1.
struct Hills {
  double metres;
  [[nodiscard]] double height(const Vec3& d) const { return metres * (d.x * d.z + 0.4 * d.y + 0.3 * d.x * d.y * d.z); }
  [[nodiscard]] Vec3 gradient(const Vec3& d) const {
    const Vec3 full = metres * Vec3(d.z + 0.3 * d.y * d.z, 0.4 + 0.3 * d.x * d.z, d.x + 0.3 * d.x * d.y);
    return full - glm::dot(full, d) * d;
  }
  [[nodiscard]] Vec3 normal(const Vec3& d) const { return glm::normalize(d - gradient(d) / (radius_m + height(d))); }
};

TEST(MoonMapAccuracy, NormalsAreThoseOfTheSurface) {
  // Hills of 100 km: slopes of some degrees as broad as the Moon.
  const Hills hills{100000.0};
  const GlobeGrid elevation = globe_grid(720, 0.0, [&](const Vec3& d) { return hills.height(d); });
  const MoonMap map = make_moon_product(grey(), elevation, {64}).map;
  ErrorSum inside;
  ErrorSum edges;
  ErrorSum poles;
  double steepest = 0.0;
  for (std::size_t i = 0; i < cube_texel_count(64); ++i) {
    const Vec3 direction = cube_texel(64, i).direction;
    const Vec3 normal = texel_mean(64, i, [&](const Vec3& d) { return hills.normal(d); });
    const double error = test::separation(normal_of(map, i), normal).to(deg);
    steepest = std::max(steepest, test::separation(direction, hills.normal(direction)).to(deg));
    (std::abs(direction.z) > std::cos(0.1) ? poles : at_edge(64, i) ? edges : inside).add(error);
  }
  EXPECT_GT(steepest, 3.0);
  // Of this 0.02 degrees are the rounding to 16 bits.
  inside.hold("normals of hills inside of faces", 0.03, "deg");
  edges.hold("normals of hills at edges of faces", 0.03, "deg");
  poles.hold("normals of hills within 6 deg of the poles", 0.03, "deg");
}

TEST(MoonMapAccuracy, LightIsConserved) {
  // A speckled Moon: bright points of single pixels, on a picture three times as fine as the map.
  std::uint64_t state = 1;
  const GlobeGrid picture = globe_grid(512, 0.0, [&](const Vec3&) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return state >> 60U == 0 ? 5.0 : 1.0;
  });
  double light = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < picture.values.size(); ++i) {
    const std::size_t row = i / 1024;
    const double weight = std::sin((static_cast<double>(row) + 0.5) * std::numbers::pi / 512);
    light += weight * static_cast<double>(picture.values[i]);
    area += weight;
  }
  const MoonProduct product = make_moon_product(picture, flat(), {128});
  double map_light = 0.0;
  double map_area = 0.0;
  for (std::size_t i = 0; i < cube_texel_count(128); ++i) {
    const double weight = cube_texel(128, i).solid_angle_sr;
    map_light += weight * albedo_of(product.map, i) / product.report.albedo_scale;
    map_area += weight;
  }
  ErrorSum sum;
  sum.add(100.0 * (map_light / map_area / (light / area) - 1.0));
  sum.hold("light of a speckled picture over the sphere", 0.05, "%");
  EXPECT_NEAR(moon_disc_albedo(product.map) / 0.1207, 1.0, 1e-4);
}

/// The map's texel at a place.
const float* texel_at(const MoonMap& map, const Vec3& direction) {
  const int face = f64::cube_face(direction, 0);
  const Vec3 place = glm::transpose(f64::cube_face_axes(face)) * direction;
  const auto index = [&](double v) {
    return std::clamp(static_cast<int>(0.5 * (v / place.z + 1.0) * map.face_size), 0, map.face_size - 1);
  };
  return &map.texels[4 * (static_cast<std::size_t>(face * map.face_size + index(-place.y)) *
                              static_cast<std::size_t>(map.face_size) +
                          static_cast<std::size_t>(index(place.x)))];
}

/// A crater by the IAU's Gazetteer of Planetary Nomenclature.
struct Floor {
  const char* name;
  double latitude_deg, longitude_deg;
  double radius_deg; ///< of the floor, about
};

/// The place near the floor's where a measure is largest, from it in degrees east and north.
template <class Measure> Vec2 best_offset(const Floor& floor, const Measure& measure) {
  const Vec3 centre = test::direction(floor.longitude_deg * deg, floor.latitude_deg * deg);
  const Vec3 east = glm::normalize(glm::cross(Vec3(0, 0, 1), centre));
  const Vec3 north = glm::cross(centre, east);
  Vec2 best;
  double most = -1e9;
  constexpr double step = 0.05;
  for (int j = -20; j <= 20; ++j) {
    for (int i = -20; i <= 20; ++i) {
      const Vec2 offset = step * Vec2(i, j);
      const double found = measure([&](double angle, double distance_deg) {
        const Vec2 at = (std::numbers::pi / 180.0) * (offset + distance_deg * Vec2(std::cos(angle), std::sin(angle)));
        return std::pair(glm::normalize(centre + at.x * east + at.y * north),
                         std::cos(angle) * east + std::sin(angle) * north);
      });
      if (found > most) {
        most = found;
        best = offset;
      }
    }
  }
  return best;
}

TEST(MoonMapAccuracy, TheBuiltInMapShowsSeasAndCratersWhereTheyAre) {
  const MoonMap& map = default_moon_map();
  // Few craters have floors darker than their surroundings; walls have all.
  constexpr std::array<Floor, 4> dark = {{{"Plato", 51.6192, -9.3825, 1.5},
                                          {"Billy", -13.8324, -50.2382, 0.7},
                                          {"Crueger", -16.6769, -66.9602, 0.7},
                                          {"Endymion", 53.6067, 56.4832, 1.7}}};
  constexpr std::array<Floor, 6> walled = {{{"Tycho", -43.2958, -11.2153, 1.2},
                                            {"Copernicus", 9.6209, -20.0786, 1.3},
                                            {"Plato", 51.6192, -9.3825, 1.5},
                                            {"Theophilus", -11.4524, 26.2847, 1.4},
                                            {"Langrenus", -8.8604, 61.0380, 1.9},
                                            {"Jules Verne", -34.8456, 147.2755, 2.1}}};
  ErrorSum albedo;
  for (const Floor& floor : dark) {
    const Vec2 offset = best_offset(floor, [&](const auto& at) {
      double sum = 0.0;
      for (int k = 0; k < 64; ++k) {
        const double angle = k * std::numbers::pi / 32.0;
        for (const double r : {0.2, 0.45, 0.7}) {
          sum -= static_cast<double>(texel_at(map, at(angle, r * floor.radius_deg).first)[0]);
        }
        for (const double r : {1.15, 1.3, 1.45}) {
          sum += static_cast<double>(texel_at(map, at(angle, r * floor.radius_deg).first)[0]);
        }
      }
      return sum;
    });
    std::printf("%s by albedo: %.2f deg east, %.2f deg north\n", floor.name, offset.x, offset.y);
    albedo.add(glm::length(offset));
  }
  ErrorSum relief;
  for (const Floor& floor : walled) {
    const Vec2 offset = best_offset(floor, [&](const auto& at) {
      double inward = 0.0;
      for (int k = 0; k < 64; ++k) {
        for (const double r : {0.8, 1.0, 1.15}) {
          const auto [direction, outward] = at(k * std::numbers::pi / 32.0, r * floor.radius_deg);
          const float* texel = texel_at(map, direction);
          inward -= glm::dot(Vec3(texel[1], texel[2], texel[3]) - direction, outward);
        }
      }
      EXPECT_TRUE(std::isfinite(inward));
      return inward;
    });
    std::printf("%s by relief: %.2f deg east, %.2f deg north\n", floor.name, offset.x, offset.y);
    relief.add(glm::length(offset));
  }
  // 0.34 degrees in the middle of the disc are 0.3 % of the Moon's diameter, and about a texel.
  albedo.hold("dark floors of the built-in map against the gazetteer", 0.34, "deg");
  relief.hold("crater walls of the built-in map against the gazetteer", 0.34, "deg");
}

TEST(MoonMapAccuracy, TheBuiltInMapHasMeasuredAlbedos) {
  const MoonMap& map = default_moon_map();
  const auto mean = [&](double latitude_deg, double longitude_deg, double radius_deg) {
    const Vec3 centre = test::direction(longitude_deg * deg, latitude_deg * deg);
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < cube_texel_count(map.face_size); ++i) {
      if (test::separation(cube_texel(map.face_size, i).direction, centre) < radius_deg * deg) {
        sum += albedo_of(map, i);
        ++count;
      }
    }
    return sum / count;
  };
  // Seas 0.06 to 0.08, highlands 0.13 to 0.17, the brightest places above 0.18.
  for (const auto& [name, latitude, longitude] : {std::tuple{"Mare Tranquillitatis", 8.5, 31.0},
                                                  {"Oceanus Procellarum", 18.0, -57.0},
                                                  {"Mare Imbrium", 33.0, -16.0}}) {
    const double albedo = mean(latitude, longitude, 4.0);
    std::printf("%s: %.3f\n", name, albedo);
    EXPECT_GT(albedo, 0.055) << name;
    EXPECT_LT(albedo, 0.085) << name;
  }
  for (const auto& [name, latitude, longitude] :
       {std::tuple{"Albategnius", -12.0, 4.0}, {"southern highlands", -45.0, 20.0}, {"Descartes", -9.0, 15.5}}) {
    const double albedo = mean(latitude, longitude, 3.0);
    std::printf("%s: %.3f\n", name, albedo);
    EXPECT_GT(albedo, 0.13) << name;
    EXPECT_LT(albedo, 0.17) << name;
  }
  EXPECT_GT(mean(23.7, -47.5, 0.5), 0.18) << "Aristarchus";
  EXPECT_GT(mean(-43.3, -11.2, 1.0), 0.18) << "Tycho";
}

} // namespace
} // namespace vesper
