#include "vesper/gpu/eye_optics.hpp"

#include "vesper/base/error.hpp"
#include "vesper/base/shader_math.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <numbers>
#include <span>

namespace vesper::gpu {
namespace {

constexpr int block_side = 4;    ///< pixels: shaders/eye_block.glsl
constexpr int finest_veil = 1;   ///< level: likewise
constexpr int most_cells = 576;  ///< each is a light to every texel of the far veil
constexpr int group = 8;         ///< of most stages, along both axes
constexpr int group_of_row = 64; ///< of eye_blocks.comp and eye_cells.comp

/// shaders/eye_block.glsl in std140.
struct EyeBlock {
  std::array<float, 4> optics;
  std::array<float, 4> media;
  std::array<float, 2> size;
  float focal;
  std::int32_t cell_level;
  std::int32_t columns;
  std::int32_t lights;
  std::int32_t wraps;
  std::int32_t glare;
  std::int32_t acuity;
  std::array<std::int32_t, 3> padding;
};
static_assert(offsetof(EyeBlock, size) == 32 && offsetof(EyeBlock, cell_level) == 44 && sizeof(EyeBlock) == 80);

/// shaders/eye_lights.glsl in std430.
struct EyeLight {
  std::array<float, 4> light;
  std::array<float, 4> direction;
  std::array<float, 4> solid_angle;
};
static_assert(sizeof(EyeLight) == 48);

void require(bool holds, const char* what, double value, const char* remedy) {
  if (!holds) {
    throw Error(ErrorKind::argument, fmt::format("{} {} of the eye is out of range", what, value), {"", "", remedy});
  }
}

void validate(const View& view, const EyeOpticsSettings& settings) {
  validate(view);
  if (view.projection == Projection::cubemap) {
    throw Error(ErrorKind::argument, "an eye does not see a cube map from outside",
                {"", "", "Turn glare and acuity off, or choose another projection"});
  }
  require(settings.age_years >= 0.0 && settings.age_years <= 100.0, "age", settings.age_years, "Give 0 to 100 years");
  require(settings.pigmentation >= 0.0 && settings.pigmentation <= 1.5, "pigmentation", settings.pigmentation,
          "Give 0 to 1.5");
  require(settings.magnification > 0.0 && std::isfinite(settings.magnification), "magnification",
          settings.magnification, "Give more than 0");
}

int up(int value, int step) { return (value + step - 1) / step; }

/// Integral of the CIE's function over the sphere.
double light_over_sphere(const f64::EyeScatter& eye) {
  // The substitution theta = pi u^6 crowds the nodes where the function is steep.
  constexpr int steps = 2000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) / steps;
    const double fifth = u * u * u * u * u;
    const double theta = std::numbers::pi * fifth * u;
    const double degrees = theta * 180.0 / std::numbers::pi;
    sum += f64::eye_spread(degrees * degrees, eye) * std::sin(theta) * 6.0 * std::numbers::pi * fifth;
  }
  return sum * 2.0 * std::numbers::pi / steps;
}

void run(const ProgramHandle& program, int width, int height = 1, int side = group, int other_side = group) {
  glUseProgram(program.name());
  glDispatchCompute(static_cast<GLuint>(up(width, side)), static_cast<GLuint>(up(height, other_side)), 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

/// A texture with mipmaps, read between texels but not between levels.
Texture make_levels(int width, int height, int levels, GLenum format) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  Texture texture(name);
  glTextureStorage2D(name, levels, format, width, height);
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  require_no_error("creating a texture");
  return texture;
}

void set_wrap(const Texture& texture, bool wraps) {
  glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_S, wraps ? GL_REPEAT : GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

} // namespace

/// Textures of a picture's size. Level 0 has a texel for a block.
struct EyeOptics::Pyramid {
  Pyramid(int picture_width, int picture_height, std::size_t unseen_lights)
      : width(picture_width), height(picture_height), unseen(unseen_lights) {
    while (cells() > most_cells) {
      ++cell_level;
    }
    const int side = block_side << cell_level;
    columns = up(width, side);
    rows = up(height, side);
    const int blocks_across = columns << cell_level;
    const int blocks_down = rows << cell_level;
    const int levels = cell_level + 1;
    light = make_levels(blocks_across, blocks_down, levels, GL_RGBA32F);
    centre = make_levels(blocks_across, blocks_down, levels, GL_RG32F);
    extended = make_texture(blocks_across, 2 * blocks_down, PixelFormat::rgba32f);
    spread = make_levels(blocks_across, blocks_down, levels, GL_RGBA32F);
    veil = make_levels(blocks_across, blocks_down, levels, GL_RGBA32F);
    far_veil = make_levels(2 * columns, 2 * rows, 1, GL_RGBA32F);
    near_shares = make_levels(2 * columns, 2 * rows, 1, GL_RG32F);
    const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) + unseen;
    lights = make_dynamic_buffer(sizeof(std::array<float, 4>) + count * sizeof(EyeLight));
    light_texels = make_buffer_texture(lights, 4);
  }

  [[nodiscard]] int cells() const {
    const int side = block_side << cell_level;
    return up(width, side) * up(height, side);
  }
  [[nodiscard]] int across(int level) const { return columns << (cell_level - level); }
  [[nodiscard]] int down(int level) const { return rows << (cell_level - level); }

  int width;
  int height;
  std::size_t unseen;
  int cell_level = finest_veil + 1;
  int columns = 0; ///< of cells
  int rows = 0;
  Texture light;
  Texture centre;
  Texture extended; ///< all levels, one above the other: a level that differs from texel to texel is found faster so
  Texture spread;
  Texture veil;
  Texture far_veil;
  Texture near_shares;
  Buffer lights;
  Texture light_texels; ///< the same
};

EyeOptics::EyeOptics(const ShaderLibrary& library) : uniforms_(make_dynamic_buffer(sizeof(EyeBlock))) {
  for (const char* stage : {"eye_blocks.comp", "eye_points.comp", "eye_halve.comp", "eye_spread.comp", "eye_cells.comp",
                            "eye_beyond.comp", "eye_far.comp", "eye_veil.comp", "eye_seen.comp"}) {
    stages_.emplace_back(library, std::vector<std::string>{stage});
  }
}

EyeOptics::~EyeOptics() = default;

void EyeOptics::see(const Texture& frame, const View& view, const EyeOpticsSettings& settings) {
  start(view, settings);
  add(frame, {0, view.height});
  finish();
}

const Texture& EyeOptics::blocks() const { return pyramid_->extended; }

void EyeOptics::start(const View& view, const EyeOpticsSettings& settings) {
  validate(view, settings);
  if (!pyramid_ || pyramid_->width != view.width || pyramid_->height != view.height ||
      pyramid_->unseen != settings.unseen.size()) {
    pyramid_.reset();
    pyramid_ = std::make_unique<Pyramid>(view.width, view.height, settings.unseen.size());
    added_ = make_levels(pyramid_->across(0), pyramid_->down(0), 1, GL_RGBA32F);
    shares_ = make_levels(pyramid_->across(0), pyramid_->down(0), 1, GL_RG32F);
  }
  const Pyramid& levels = *pyramid_;

  if (observer_.age_years != settings.age_years || observer_.pigmentation != settings.pigmentation) {
    const f64::EyeScatter cie = f64::eye_scatter(settings.age_years, settings.pigmentation);
    observer_ = {settings.age_years, settings.pigmentation, f64::eye_scatter_times(cie, 1.0 / light_over_sphere(cie))};
  }
  const f64::EyeScatter& eye = observer_.scatter;
  glare_ = settings.glare;
  defines_ = {fmt::format("PROJECTION {}", static_cast<int>(view.projection))};
  const f64::ProjectionFrame projection = projection_frame(view);
  wraps_ = view.projection == Projection::equirectangular && view.width == block_side * levels.across(0);
  const auto real = [](double value) { return static_cast<float>(value); };
  EyeBlock block{};
  block.optics = {real(eye.narrow), real(eye.wide), real(eye.pigmented), real(eye.skirt)};
  block.media = {real(eye.iris), real(eye.parabola), real(eye.wall), real(settings.magnification)};
  block.size = {real(view.width), real(view.height)};
  block.focal = real(projection.focal);
  block.cell_level = levels.cell_level;
  block.columns = levels.columns;
  block.lights = levels.cells() + static_cast<int>(levels.unseen);
  block.wraps = wraps_ ? 1 : 0;
  block.glare = settings.glare ? 1 : 0;
  block.acuity = settings.acuity ? 1 : 0;
  update_buffer(uniforms_, std::as_bytes(std::span(&block, 1)));
  if (levels.unseen > 0) {
    const Mat3 turn = view_from_horizon(view);
    std::vector<EyeLight> unseen;
    for (const UnseenSource& source : settings.unseen) {
      const Vec3 direction = turn * source.direction;
      const Vec4& light = source.light_lux;
      unseen.push_back({{real(light.x), real(light.y), real(light.z), real(light.w)},
                        {real(direction.x), real(direction.y), real(direction.z), 0.0F},
                        {}});
    }
    const std::size_t first =
        sizeof(std::array<float, 4>) + static_cast<std::size_t>(levels.cells()) * sizeof(EyeLight);
    glNamedBufferSubData(levels.lights.name(), static_cast<GLintptr>(first),
                         static_cast<GLsizeiptr>(unseen.size() * sizeof(EyeLight)), unseen.data());
  }
  const std::array<const Texture*, 6> interpolated{&levels.spread,      &levels.veil, &levels.far_veil,
                                                   &levels.near_shares, &added_,      &shares_};
  for (const Texture* texture : interpolated) {
    set_wrap(*texture, wraps_);
  }
}

void EyeOptics::add(const Texture& frame, const Strip& strip) {
  const Pyramid& levels = *pyramid_;
  const ProgramHandle& program = program_of(Stage::blocks);
  glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
  glProgramUniform2i(program.name(), 0, strip.first_row / block_side, strip.rows);
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms_.name());
  write_image(0, levels.light, 0, GL_RGBA32F);
  write_image(1, levels.centre, 0, GL_RG32F);
  glBindTextureUnit(0, frame.name());
  write_image(2, levels.extended, 0, GL_RGBA32F);
  run(program, levels.across(0), up(strip.rows, block_side), group_of_row, 1);
}

void EyeOptics::add(const StripLight& light) {
  add(light.frame, light.strip);
  const GLuint program = program_of(Stage::points).name();
  glProgramUniform2i(program, 0, light.strip.first_row / block_side, light.strip.rows);
  glUseProgram(program);
  glBindTextureUnit(1, light.points.name());
  light.tiles.dispatch(true);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void EyeOptics::finish() {
  const Pyramid& levels = *pyramid_;
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, levels.lights.name());
  for (int level = 1; level <= levels.cell_level; ++level) {
    const ProgramHandle& halve = program_of(Stage::halve);
    glProgramUniform1i(halve.name(), 0, level);
    read_image(0, levels.light, level - 1, GL_RGBA32F);
    read_image(1, levels.centre, level - 1, GL_RG32F);
    write_image(2, levels.light, level, GL_RGBA32F);
    write_image(3, levels.centre, level, GL_RG32F);
    glBindImageTexture(4, levels.extended.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    run(halve, levels.across(level), levels.down(level));
  }
  if (glare_) {
    scatter();
  }
  glBindTextureUnit(0, levels.spread.name());
  glBindTextureUnit(1, levels.veil.name());
  glBindTextureUnit(2, levels.far_veil.name());
  glBindTextureUnit(3, levels.near_shares.name());
  read_image(2, levels.extended, 0, GL_RGBA32F);
  write_image(0, added_, 0, GL_RGBA32F);
  write_image(1, shares_, 0, GL_RG32F);
  run(program_of(Stage::seen), levels.across(0), levels.down(0));
  require_no_error("seeing a picture with an eye");
}

const ProgramHandle& EyeOptics::program_of(Stage stage) {
  return stages_.at(static_cast<std::size_t>(stage)).get(defines_);
}

void EyeOptics::scatter() {
  const Pyramid& levels = *pyramid_;
  for (int level = finest_veil; level <= levels.cell_level; ++level) {
    const ProgramHandle& spread = program_of(Stage::spread);
    glProgramUniform1i(spread.name(), 0, level);
    read_image(0, levels.light, level, GL_RGBA32F);
    read_image(1, levels.centre, level, GL_RG32F);
    write_image(2, levels.spread, level, GL_RGBA32F);
    run(spread, levels.across(level), levels.down(level));
  }
  glBindTextureUnit(0, levels.light.name());
  glBindTextureUnit(1, levels.centre.name());
  run(program_of(Stage::cells), levels.cells(), 1, group_of_row, 1);
  run(program_of(Stage::beyond), 1, 1, 1, 1);
  write_image(0, levels.far_veil, 0, GL_RGBA32F);
  write_image(1, levels.near_shares, 0, GL_RG32F);
  glBindTextureUnit(0, levels.light_texels.name());
  run(program_of(Stage::far), 2 * levels.columns, 2 * levels.rows);
  glBindTextureUnit(0, levels.spread.name());
  glBindTextureUnit(1, levels.veil.name());
  glBindTextureUnit(2, levels.far_veil.name());
  for (int level = levels.cell_level; level >= finest_veil; --level) {
    const ProgramHandle& veil = program_of(Stage::veil);
    glProgramUniform1i(veil.name(), 0, level);
    write_image(0, levels.veil, level, GL_RGBA32F);
    run(veil, levels.across(level), levels.down(level));
  }
}

} // namespace vesper::gpu
