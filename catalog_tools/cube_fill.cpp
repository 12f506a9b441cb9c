#include "vesper/catalog_tools/cube_fill.hpp"

#include "vesper/base/shader_math.hpp"
#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <cmath>

namespace vesper {
namespace {

/// A texel by face, column and row.
struct Texel {
  int face = 0, column = 0, row = 0;
};

Vec3 direction_of(const Texel& texel, int size) {
  const auto place = [&](int i) { return (2.0 * i + 1.0) / size - 1.0; };
  return f64::cube_direction(texel.face, {place(texel.column), -place(texel.row)});
}

Texel texel_of(const Vec3& direction, int size) {
  const int face = f64::cube_face(direction, 0);
  const Vec2 place = texel_place(transpose(f64::cube_face_axes(face)) * direction, size);
  const auto index = [&](double at) { return std::clamp(static_cast<int>(at), 0, size - 1); };
  return {face, index(place.x), index(place.y)};
}

/// The texel itself or, beyond an edge of its face, the one on the face next to it.
Texel on_cube(const Texel& texel, int size) {
  const auto within = [&](int i) { return i >= 0 && i < size; };
  return within(texel.column) && within(texel.row) ? texel : texel_of(direction_of(texel, size), size);
}

/// Brightness of the cube at one resolution; `known` is false for what is not there.
struct Level {
  explicit Level(int n) : size(n), light(6 * static_cast<std::size_t>(n) * static_cast<std::size_t>(n)) {}
  int size;
  std::vector<LightSum> light; ///< solid angle 0 where not known

  [[nodiscard]] std::size_t index(const Texel& t) const {
    return (static_cast<std::size_t>(t.face) * static_cast<std::size_t>(size) + static_cast<std::size_t>(t.row)) *
               static_cast<std::size_t>(size) +
           static_cast<std::size_t>(t.column);
  }
  [[nodiscard]] Texel texel(std::size_t i) const {
    const auto n = static_cast<std::size_t>(size);
    return {static_cast<int>(i / (n * n)), static_cast<int>(i % n), static_cast<int>(i / n % n)};
  }
};

/// Half the resolution: sums of up to four texels, of what is known.
Level halved(const Level& fine) {
  Level coarse((fine.size + 1) / 2);
  for (std::size_t i = 0; i < fine.light.size(); ++i) {
    if (fine.light[i].solid_angle_sr > 0.0F) {
      const Texel t = fine.texel(i);
      coarse.light[coarse.index({t.face, t.column / 2, t.row / 2})].add(fine.light[i]);
    }
  }
  return coarse;
}

/// The brightness at a direction, between the centres of the four texels around it. All of them must be known.
std::array<float, 3> brightness_at(const Level& level, const Vec3& direction) {
  const int face = f64::cube_face(direction, 0);
  const Vec2 place = texel_place(transpose(f64::cube_face_axes(face)) * direction, level.size) - 0.5;
  const Vec2 base = floor(place);
  const Vec2 part = place - base;
  std::array<float, 3> sum{};
  for (int corner = 0; corner < 4; ++corner) {
    const int right = corner % 2;
    const int down = corner / 2;
    const Texel texel = on_cube({face, static_cast<int>(base.x) + right, static_cast<int>(base.y) + down}, level.size);
    const auto weight = static_cast<float>((right == 1 ? part.x : 1.0 - part.x) * (down == 1 ? part.y : 1.0 - part.y));
    const LightSum& light = level.light[level.index(texel)];
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] += weight * light.light[i] / light.solid_angle_sr;
    }
  }
  return sum;
}

/// Gives what is not known in `fine` the brightness of `coarse`, where all is known.
void fill_from(const Level& coarse, Level& fine) {
  for (std::size_t i = 0; i < fine.light.size(); ++i) {
    if (!(fine.light[i].solid_angle_sr > 0.0F)) {
      fine.light[i] = {brightness_at(coarse, direction_of(fine.texel(i), fine.size)), 1.0F};
    }
  }
}

/// Brightness where the cube has none, from averages over wider and wider surroundings (Gortler et al. 1996, the
/// "pull-push" of the lumigraph).
class Surroundings {
public:
  explicit Surroundings(const Level& whole) : top_(whole.size) {
    const Level* last = &whole;
    while (last->size > 1) {
      levels_.push_back(halved(*last));
      last = &levels_.back();
    }
    // Six texels: a face that knows nothing takes the mean of the others.
    Level& six = levels_.back();
    LightSum mean;
    for (const LightSum& light : six.light) {
      mean.add(light);
    }
    for (LightSum& light : six.light) {
      light = light.solid_angle_sr > 0.0F ? light : mean;
    }
    for (std::size_t i = levels_.size() - 1; i > 0; --i) {
      fill_from(levels_[i], levels_[i - 1]);
    }
  }
  [[nodiscard]] std::array<float, 3> operator()(const Texel& texel) const {
    return brightness_at(levels_.front(), direction_of(texel, top_));
  }

private:
  int top_;
  std::vector<Level> levels_;
};

/// Whether one of the eight texels around is marked.
bool touches(const Level& level, const Texel& texel, const std::vector<bool>& marked) {
  for (int down = -1; down <= 1; ++down) {
    for (int right = -1; right <= 1; ++right) {
      if (marked[level.index(on_cube({texel.face, texel.column + right, texel.row + down}, level.size))]) {
        return true;
      }
    }
  }
  return false;
}

/// The texels that touch the first one of a hole, marked as seen.
std::vector<std::size_t> hole_around(const Level& level, std::size_t start, std::vector<bool>& seen) {
  std::vector<std::size_t> hole{start};
  seen[start] = true;
  for (std::size_t next = 0; next < hole.size(); ++next) {
    const Texel t = level.texel(hole[next]);
    for (const Texel& beside : {Texel{t.face, t.column - 1, t.row}, Texel{t.face, t.column + 1, t.row},
                                Texel{t.face, t.column, t.row - 1}, Texel{t.face, t.column, t.row + 1}}) {
      const std::size_t i = level.index(on_cube(beside, level.size));
      if (!seen[i] && !(level.light[i].solid_angle_sr > 0.0F)) {
        seen[i] = true;
        hole.push_back(i);
      }
    }
  }
  return hole;
}

} // namespace

CubeFillReport fill_cube(CubeSum& cube, double largest_hole_sr) {
  CubeFillReport report;
  Level level(cube.face_size);
  level.light.swap(cube.sums);
  const auto solid_angle = [&](std::size_t i) {
    const Texel t = level.texel(i);
    return texel_solid_angle_sr(t.column, t.row, level.size);
  };
  std::vector<std::vector<std::size_t>> holes;
  std::vector<bool> seen(level.light.size());
  std::vector<bool> dark(level.light.size());
  for (std::size_t i = 0; i < level.light.size(); ++i) {
    if (seen[i] || level.light[i].solid_angle_sr > 0.0F) {
      continue;
    }
    std::vector<std::size_t> hole = hole_around(level, i, seen);
    double size_sr = 0.0;
    for (const std::size_t texel : hole) {
      size_sr += solid_angle(texel);
    }
    if (size_sr > largest_hole_sr) {
      report.dark_sr += size_sr;
      for (const std::size_t texel : hole) {
        dark[texel] = true;
      }
    } else {
      holes.push_back(std::move(hole));
    }
  }
  report.holes = holes.size();
  // The brightness of holes, before the sums around them change.
  std::vector<std::pair<std::size_t, std::array<float, 3>>> fillings;
  if (!holes.empty()) {
    const Surroundings surroundings(level);
    for (const std::vector<std::size_t>& hole : holes) {
      for (const std::size_t i : hole) {
        fillings.emplace_back(i, surroundings(level.texel(i)));
      }
    }
  }
  for (std::size_t i = 0; i < level.light.size(); ++i) {
    LightSum& light = level.light[i];
    if (!(light.solid_angle_sr > 0.0F)) {
      continue;
    }
    const double whole = solid_angle(i);
    const double more = whole - static_cast<double>(light.solid_angle_sr);
    if (more > 0.0 && report.dark_sr > 0.0 && touches(level, level.texel(i), dark)) {
      light.solid_angle_sr = static_cast<float>(whole); // at the picture's end
      report.dark_sr += more;
      continue;
    }
    LightTotal& gain = more >= 0.0 ? report.filled : report.overlapped;
    const double factor = whole / static_cast<double>(light.solid_angle_sr);
    gain.solid_angle_sr += std::abs(more);
    for (std::size_t c = 0; c < light.light.size(); ++c) {
      const auto before = static_cast<double>(light.light[c]);
      gain.light[c] += std::abs(factor - 1.0) * before;
      light.light[c] = static_cast<float>(factor * before);
    }
    light.solid_angle_sr = static_cast<float>(whole);
  }
  for (const auto& [i, brightness] : fillings) {
    const double whole = solid_angle(i);
    LightSum& light = level.light[i];
    light.solid_angle_sr = static_cast<float>(whole);
    report.filled.solid_angle_sr += whole;
    for (std::size_t c = 0; c < brightness.size(); ++c) {
      light.light[c] = static_cast<float>(whole) * brightness[c];
      report.filled.light[c] += static_cast<double>(light.light[c]);
    }
  }
  cube.sums.swap(level.light);
  return report;
}

void soften_faint(CubeSum& cube, const Vec3& y_of_channels, double faint) {
  constexpr std::size_t coarsest = 5; // halvings
  std::vector<Level> levels;
  levels.reserve(coarsest);
  Level whole(cube.face_size);
  whole.light.swap(cube.sums);
  for (std::size_t i = 0; i < coarsest; ++i) {
    levels.push_back(halved(i == 0 ? whole : levels.back()));
  }
  std::vector<LightSum> softened(whole.light.size());
  constexpr std::size_t texels_a_call = std::size_t{1} << 14;
  parallel_for(whole.light.size(), texels_a_call, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const LightSum& own = whole.light[i];
      const Vec3 direction = direction_of(whole.texel(i), whole.size);
      const auto brightness = [&](std::size_t halvings) {
        if (halvings > 0) {
          const auto value = brightness_at(levels[halvings - 1], direction);
          return Vec3(value[0], value[1], value[2]);
        }
        return Vec3(own.light[0], own.light[1], own.light[2]) / static_cast<double>(own.solid_angle_sr);
      };
      Vec3 light = brightness(coarsest);
      for (std::size_t halvings = coarsest; halvings-- > 0;) {
        // A mean over more texels is good for fainter light.
        const double enough = faint / static_cast<double>(std::size_t{1} << halvings);
        const double trust = std::clamp(2.0 * dot(y_of_channels, light) / enough - 1.0, 0.0, 1.0);
        light = mix(light, brightness(halvings), trust);
      }
      for (glm::length_t channel = 0; channel < 3; ++channel) {
        softened[i].light[static_cast<std::size_t>(channel)] = static_cast<float>(light[channel]) * own.solid_angle_sr;
      }
      softened[i].solid_angle_sr = own.solid_angle_sr;
    }
  });
  cube.sums.swap(softened);
}

} // namespace vesper
