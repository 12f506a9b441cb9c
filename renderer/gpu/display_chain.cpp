#include "vesper/gpu/display_chain.hpp"

#include "vesper/base/error.hpp"
#include "vesper/gpu/display_uniforms.hpp"

#include <algorithm>
#include <cmath>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace vesper::gpu {
namespace {

constexpr GLint display_location = 20; // of shaders/display_chain.comp

void require_settings(const DisplaySettings& settings) {
  if (settings.format == PixelFormat::rgba32f) {
    throw Error(ErrorKind::argument, "a display takes no code values of 32-bit floats",
                {"", "", "Give rgba8 or rgba16"});
  }
  if (!std::isfinite(settings.tone.stops) || !std::isfinite(settings.tone.exposure_value.value_or(0.0))) {
    throw Error(ErrorKind::argument, "exposures must be finite", {"", "", "Give stops of, say, -30 to 30"});
  }
}

/// A picture that shows angles larger than they are is looked at as through a telescope; one that shows them smaller is
/// still what the naked eye sees.
double magnification(const View& view, const Display& display) {
  return std::max(1.0, view_pixels_per_degree(view) / display.pixels_per_degree);
}

/// The curve at the eighths of octaves by which floats count, so that the GPU needs no logarithm, and what is shown in
/// shares of the display's range: shaders/display_chain.comp.
Texture texture_of(const ToneCurve& curve, double range_cd_m2) {
  const f64::sampler1D nodes{curve.nodes.data(), static_cast<int>(curve.nodes.size())};
  const auto at = [&nodes](int eighth, double part) {
    const int octave = f64::tone_lowest_octave + eighth / f64::tone_nodes_per_octave;
    const double mantissa = 1.0 + (eighth % f64::tone_nodes_per_octave + part) / f64::tone_nodes_per_octave;
    return f64::tone_curve(std::ldexp(mantissa, octave), nodes);
  };
  std::vector<float> rgba;
  for (int eighth = 0; eighth < f64::tone_nodes; ++eighth) {
    const double here = at(eighth, 0.0).x / range_cd_m2;
    const double next = at(eighth + 1, 0.0).x / range_cd_m2;
    const f64::vec3 middle = at(eighth, 0.5);
    for (const double value : {here, next - here, middle.y / range_cd_m2, middle.z}) {
      rgba.push_back(static_cast<float>(value));
    }
  }
  return make_row_texture(rgba);
}

} // namespace

DisplayChain::DisplayChain(const ShaderLibrary& library, const DisplaySettings& settings)
    : library_(library), programs_(library, {"display_chain.comp"}), meter_(library) {
  use(settings);
}

void DisplayChain::use(const DisplaySettings& settings) {
  require_settings(settings);
  const f64::DisplayModel display = display_model(settings.display);
  const Vec3 white = glm::inverse(display.rgb_from_xyz) * Vec3(1.0);
  color_adaptation_ = settings.light ? adapted_to_light(*settings.light, white) : ColorAdaptation{};
  display_ = display;
  settings_ = settings;
}

void DisplayChain::start(const View& view) {
  view_ = view;
  meter_.start(view, settings_.metering);
  EyeOpticsSettings optics = settings_.optics;
  through_optics_ = (optics.glare || optics.acuity) && view.projection != Projection::cubemap;
  if (through_optics_) {
    if (!optics_) {
      optics_ = std::make_unique<EyeOptics>(library_);
    }
    optics.magnification = magnification(view, settings_.display);
    optics_->start(view, optics);
  }
}

void DisplayChain::look(const StripLight& light) {
  if (through_optics_) {
    optics_->add(light);
  } else {
    meter_.add(light);
  }
  looked_ = true;
}

void DisplayChain::find_curve() {
  if (through_optics_) {
    optics_->finish();
    meter_.add(*optics_);
  }
  histogram_ = meter_.histogram();
  curve_ = make_tone_curve(settings_.tone, histogram_, settings_.adaptation.value_or(adapted_to(histogram_)), display_);
  nodes_ = texture_of(curve_, display_.range_cd_m2);
  std::vector<std::string> defines{fmt::format("PROJECTION {}", static_cast<int>(view_.projection)),
                                   fmt::format("TRANSFER {}", display_.transfer)};
  if (settings_.tone.tone == ToneOperator::false_color) {
    defines.emplace_back("FALSE_COLOR");
  }
  if (through_optics_) {
    defines.emplace_back("EYE");
  }
  if (settings_.noise) {
    defines.emplace_back("NOISE");
  }
  for (const bool with_points : {false, true}) {
    if (with_points) {
      defines.emplace_back("POINTS");
    }
    const ProgramHandle& handle = programs_.get(defines);
    of_tiles_.at(with_points ? 1 : 0) = &handle;
    const GLuint program = handle.name();
    glProgramUniform2f(program, 0, static_cast<float>(view_.width), static_cast<float>(view_.height));
    glProgramUniform1f(program, 1, static_cast<float>(projection_frame(view_).focal));
    glProgramUniform1f(program, 3, settings_.format == PixelFormat::rgba16 ? 65535.0F : 255.0F);
    glProgramUniform1ui(program, 4, settings_.seed);
    glProgramUniform1i(program, 5, settings_.night_vision ? 1 : 0);
    glProgramUniform1i(program, 6, settings_.tone.tone == ToneOperator::photographic ? 0 : 1);
    if (through_optics_) {
      glProgramUniform1i(program, 11, optics_->wraps() ? 1 : 0);
    }
    if (settings_.noise) {
      glProgramUniform1f(program, 7, static_cast<float>(settings_.seconds));
    }
    const f32::mat3 signal_from_xyz(display_.rgb_from_xyz * color_adaptation_.shown_from_xyz);
    glProgramUniformMatrix3fv(program, 8, 1, GL_FALSE, &signal_from_xyz[0][0]);
    const f32::vec3 rod_hue(color_adaptation_.rod_hue);
    glProgramUniform3fv(program, 9, 1, &rod_hue[0]);
    const bool burns_out = settings_.tone.tone == ToneOperator::photographic;
    glProgramUniform1f(program, 10, burns_out ? 0.0F : f32::kept_color);
    set_display(handle, display_location, display_);
  }
  looked_ = false;
}

void DisplayChain::map(const StripLight& light, const Texture& pixels) {
  if (looked_) {
    find_curve();
  }
  write_image(0, pixels, 0, gl_format(settings_.format));
  read_image(1, light.frame, 0, GL_RGBA32F);
  read_image(2, light.points, 0, GL_RGBA32F);
  read_image(5, nodes_, 0, GL_RGBA32F);
  if (through_optics_) {
    read_image(3, optics_->added(), 0, GL_RGBA32F);
    read_image(4, optics_->shares(), 0, GL_RG32F);
  }
  for (const bool with_points : {false, true}) {
    const GLuint program = of_tiles_.at(with_points ? 1 : 0)->name();
    glProgramUniform2i(program, 2, light.strip.first_row, light.strip.rows);
    glUseProgram(program);
    light.tiles.dispatch(with_points);
  }
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

} // namespace vesper::gpu
