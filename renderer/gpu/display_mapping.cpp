#include "vesper/gpu/display_mapping.hpp"

#include "vesper/base/error.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/gpu/program.hpp"

#include <algorithm>
#include <cmath>
#include <epoxy/gl.h>
#include <numbers>

namespace vesper::gpu {

PlainExposure::PlainExposure(const ShaderLibrary& library, Luminance white, PixelFormat format)
    : program_(build_program(library, {"exposure.comp"})), white_(white), format_(format) {
  if (!(white > Luminance())) {
    throw Error(ErrorKind::argument, "the white luminance must be positive", {"", "", "Give more than 0 cd/m2"});
  }
}

void PlainExposure::map(const Texture& frame, const Texture& pixels, int width, int height, int first_row) {
  constexpr GLuint group = 16;
  const auto groups = [](int size) { return (static_cast<GLuint>(size) + group - 1) / group; };
  glProgramUniform1f(program_.name(), 0, static_cast<float>(white_.to(candela_per_m2)));
  glProgramUniform1i(program_.name(), 1, first_row);
  glProgramUniform1f(program_.name(), 2, format_ == PixelFormat::rgba16 ? 65535.0F : 255.0F);
  glUseProgram(program_.name());
  glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
  glBindImageTexture(0, frame.name(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);
  glBindImageTexture(1, pixels.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, gl_format(format_));
  glDispatchCompute(groups(width), groups(height), 1);
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

Luminance star_chart_white(const View& view) {
  constexpr double faint_magnitude = 5.0;
  constexpr double share_of_white = 1.0 / 6.0;
  const f64::ProjectionFrame projection = projection_frame(view);
  const f64::PixelFrame frame{projection.kind, projection.size, projection.focal};
  const double side = view.projection == Projection::cubemap ? view.width : view.height;
  const double illuminance = f64::zero_magnitude_lux * std::pow(10.0, -0.4 * faint_magnitude);
  const double sigma = f64::psf_sigma(illuminance);
  const double weight = 1.0 / (2.0 * std::numbers::pi * sigma * sigma);
  const double per_steradian = f64::pixels_per_steradian({0.5 * view.width, 0.5 * side}, frame);
  return illuminance * weight * per_steradian / share_of_white * candela_per_m2;
}

View metering_view(const View& view) {
  constexpr double side = 64.0; // the shorter one
  const double scale = std::min(1.0, side / std::min(view.width, view.height));
  View small = view;
  small.width = std::max(1, static_cast<int>(std::lround(scale * view.width)));
  small.height = view.projection == Projection::cubemap
                     ? 6 * small.width
                     : std::max(1, static_cast<int>(std::lround(scale * view.height)));
  return small;
}

Luminance metered_white(const Frame& frame, Luminance least) {
  constexpr double average_of_white = 1.0 / 3.0;
  double sum = 0.0;
  int lit = 0;
  for (std::size_t i = 1; i < frame.xyzs.size(); i += 4) {
    if (frame.xyzs[i] > 0.0F) {
      sum += std::log(static_cast<double>(frame.xyzs[i]));
      ++lit;
    }
  }
  return lit == 0 ? least : std::max(least, std::exp(sum / lit) / average_of_white * candela_per_m2);
}

Luminance white_before_discs(Luminance white, const Frame& discs) {
  constexpr double least_share = 1.0 / 500.0;
  constexpr double full_share = 1.0 / 20.0;
  constexpr double average_of_white = 0.5;
  const double sky_white = white.to(candela_per_m2);
  double sum = 0.0;
  std::size_t brighter = 0;
  for (std::size_t i = 1; i < discs.xyzs.size(); i += 4) {
    const auto luminance = static_cast<double>(discs.xyzs[i]);
    if (luminance > sky_white) {
      sum += std::log(luminance);
      ++brighter;
    }
  }
  if (brighter == 0) {
    return white;
  }
  const auto count = static_cast<double>(brighter);
  const double share = count / (0.25 * static_cast<double>(discs.xyzs.size()));
  const double weight = glm::smoothstep(std::log(least_share), std::log(full_share), std::log(share));
  const double disc_white = sum / count - std::log(average_of_white);
  return std::exp(glm::mix(std::log(sky_white), std::max(disc_white, std::log(sky_white)), weight)) * candela_per_m2;
}

} // namespace vesper::gpu
