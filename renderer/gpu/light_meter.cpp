#include "vesper/gpu/light_meter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace vesper::gpu {
namespace {

constexpr std::size_t meter_bins = f64::tone_bins;
using Counts = std::array<std::uint32_t, 2 * meter_bins + 1>;

/// No more solid angle than the samples of a picture have: pixels are largest in the middle, or the whole sphere.
double most_steradians(const View& view) {
  const f64::ProjectionFrame projection = projection_frame(view);
  const f64::PixelFrame frame{projection.kind, projection.size, projection.focal};
  const double side = view.projection == Projection::cubemap ? view.width : view.height;
  const double largest = 1.0 / f64::pixels_per_steradian({0.5 * view.width, 0.5 * side}, frame);
  const double sphere = 4.0 * std::numbers::pi;
  return view.projection == Projection::equirectangular ? sphere : std::min(sphere, largest * view.width * view.height);
}

GLuint meter_groups(int size, int group) { return static_cast<GLuint>((size + group - 1) / group); }

} // namespace

LightMeter::LightMeter(const ShaderLibrary& library)
    : cell_programs_(library, {"meter_cells.comp"}),
      histogram_program_(build_program(library, {"meter_histogram.comp"})), bins_(make_dynamic_buffer(sizeof(Counts))) {
}

void LightMeter::start(const View& view, Metering metering) {
  const MeteringGrid grid = metering_grid(view);
  if (!cells_ || grid.columns * grid.rows != grid_.columns * grid_.rows) {
    cells_ = make_dynamic_buffer(4 * sizeof(float) * static_cast<std::size_t>(grid.columns * grid.rows));
  }
  grid_ = grid;
  view_ = view;
  metering_ = metering;
  defines_ = {fmt::format("PROJECTION {}", static_cast<int>(view.projection))};
  if (metering == Metering::foveal) {
    defines_.emplace_back("FOVEAL");
  }
  clear_buffer(cells_);
  clear_buffer(bins_);
  // All weights stay below 2^31; a sample stands for as many pixels as there are fewer of them.
  const double samples = static_cast<double>(grid.columns) * grid.rows * grid.samples * grid.samples;
  const double pixels = static_cast<double>(view.width) * view.height;
  counts_ = std::exp2(31.0) / (most_steradians(view) * samples / pixels);
}

void LightMeter::add(const StripLight& light) {
  glBindTextureUnit(0, light.frame.name());
  glBindTextureUnit(1, light.points.name());
  add_cells(defines_, light.strip);
}

void LightMeter::add(const EyeOptics& optics) {
  glBindTextureUnit(0, optics.blocks().name());
  glBindTextureUnit(3, optics.added().name());
  glBindTextureUnit(4, optics.shares().name());
  std::vector<std::string> defines = defines_;
  defines.emplace_back("EYE");
  add_cells(defines, {0, view_.height});
}

void LightMeter::add_cells(const std::vector<std::string>& defines, const Strip& strip) {
  const GLuint program = cell_programs_.get(defines).name();
  glProgramUniform2f(program, 0, static_cast<float>(view_.width), static_cast<float>(view_.height));
  glProgramUniform1f(program, 1, static_cast<float>(projection_frame(view_).focal));
  glProgramUniform2i(program, 2, strip.first_row, strip.rows);
  glProgramUniform2i(program, 3, grid_.columns, grid_.rows);
  glProgramUniform1i(program, 4, grid_.samples);
  if (metering_ == Metering::foveal) {
    const double half_at_sr = 2.0 * (1.0 - std::cos((5.0 * deg).to(rad)));
    glProgramUniform1f(program, 5, static_cast<float>(std::numbers::ln2 / half_at_sr));
  }
  glUseProgram(program);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, cells_.name());
  glDispatchCompute(meter_groups(grid_.columns, 8), meter_groups(grid_.rows, 8), 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

LightHistogram LightMeter::histogram() {
  const int cells = grid_.columns * grid_.rows;
  glProgramUniform1i(histogram_program_.name(), 0, cells);
  glProgramUniform1f(histogram_program_.name(), 1, static_cast<float>(counts_));
  glUseProgram(histogram_program_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, cells_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, bins_.name());
  glDispatchCompute(meter_groups(cells, 64), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  Counts counts{};
  glGetNamedBufferSubData(bins_.name(), 0, sizeof(counts), counts.data());
  LightHistogram histogram;
  const double all = std::max<double>(counts.back(), 1.0);
  for (std::size_t bin = 0; bin < meter_bins; ++bin) {
    histogram.seen.at(bin) = counts.at(bin) / all;
    histogram.scotopic.at(bin) = counts.at(meter_bins + bin) / all;
  }
  return histogram;
}

} // namespace vesper::gpu
