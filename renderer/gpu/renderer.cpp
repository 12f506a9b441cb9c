#include "vesper/gpu/renderer.hpp"

#include "vesper/gpu/frame_graph.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <epoxy/gl.h>
#include <optional>

namespace vesper::gpu {
namespace {

/// Pixels a strip may hold: 512 MiB of frame.
constexpr std::int64_t strip_pixels = std::int64_t{1} << 25;

int strip_rows(const View& view, int limit) {
  const auto by_memory = std::max<std::int64_t>(1, strip_pixels / view.width);
  const auto fitting = std::min<std::int64_t>(largest_texture_side(), by_memory);
  const auto most = static_cast<int>(limit > 0 ? std::min<std::int64_t>(fitting, limit) : fitting);
  if (most >= view.height) {
    return view.height;
  }
  // From every fourth row on: drivers read maps for two by two pixels together, the eye's stage for four by four.
  return most >= 4 ? most - most % 4 : most;
}

template <class T>
void read_back(const Texture& texture, GLenum type, const Strip& strip, int width, std::vector<T>& to) {
  const std::size_t row = 4 * static_cast<std::size_t>(width);
  T* first = to.data() + row * static_cast<std::size_t>(strip.first_row);
  const std::size_t bytes = row * static_cast<std::size_t>(strip.rows) * sizeof(T);
  glGetTextureSubImage(texture.name(), 0, 0, 0, 0, width, strip.rows, 1, GL_RGBA, type, static_cast<GLsizei>(bytes),
                       first);
}

} // namespace

/// What a strip is drawn into. Points are kept and pixels made for a display mapping.
struct Renderer::Target {
  Target(int target_width, int target_rows, std::optional<PixelFormat> pixel_format)
      : width(target_width), rows(target_rows), format(pixel_format),
        frame(make_texture(width, rows, PixelFormat::rgba32f)) {
    if (format) {
      points = make_texture(width, rows, PixelFormat::rgba32f);
      pixels = make_texture(width, rows, *format);
    }
    framebuffer = make_framebuffer(frame, format ? &points : nullptr);
  }

  int width;
  int rows;
  std::optional<PixelFormat> format; ///< of the pixels
  Texture frame;
  Texture points;
  Texture pixels;
  Framebuffer framebuffer;
};

Renderer::Renderer(const ShaderLibrary& library)
    : star_pass_(library), planet_pass_(library), dark_sky_pass_(library), moon_pass_(library), sun_pass_(library),
      ground_pass_(library), sky_pass_(library), point_tiles_(library) {}

Renderer::~Renderer() = default;

Renderer::Target& Renderer::target(int width, int rows, const DisplayMapping* mapping) {
  const auto format = mapping != nullptr ? std::optional(mapping->format()) : std::nullopt;
  if (!target_ || target_->width != width || target_->rows != rows || target_->format != format) {
    target_.reset();
    target_ = std::make_unique<Target>(width, rows, format);
  }
  return *target_;
}

Frame Renderer::render(const SkyState& sky, const View& view, const FramePlan& plan, const RenderOutputs& outputs) {
  validate(view);
  Frame frame;
  frame.width = view.width;
  frame.height = view.height;
  const std::size_t values = 4 * static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
  if (outputs.xyzs) {
    frame.xyzs.resize(values);
  }
  const bool deep = outputs.mapping != nullptr && outputs.mapping->format() == PixelFormat::rgba16;
  if (outputs.mapping != nullptr) {
    frame.rgba.resize(deep ? 0 : values);
    frame.rgba16.resize(deep ? values : 0);
  }
  std::vector<PassTiming>* timings = outputs.timings ? &frame.timings : nullptr;

  const int rows = strip_rows(view, strip_limit_);
  const Target& on = target(view.width, rows, outputs.mapping);
  const auto keep = [&on](Attachments attachments) {
    if (on.points) {
      draw_into(on.framebuffer, attachments);
    }
  };
  const auto mark = [&](const auto& pass) {
    if (on.points) {
      pass.mark(point_tiles_);
    }
  };
  // Draws light of points, or covers it, in the frame and where it is kept by itself.
  const auto with_points = [&keep](auto& pass, const Strip& strip) {
    keep(Attachments::both);
    pass.draw(strip);
    keep(Attachments::first);
  };
  const auto with_disc = [&](auto& pass, const Strip& strip) {
    if (pass.is_point()) {
      with_points(pass, strip);
      return;
    }
    pass.draw(strip);
    if (on.points) {
      keep(Attachments::second);
      pass.hide(strip);
      keep(Attachments::first);
    }
  };

  if (on.points) {
    point_tiles_.start(view.width, view.height);
  }
  FrameGraph graph;
  graph.add("clear", [&](const Strip&) {
    const std::array<float, 4> black{};
    keep(Attachments::both);
    glClearBufferfv(GL_COLOR, 0, black.data());
    if (on.points) {
      glClearBufferfv(GL_COLOR, 1, black.data());
    }
    keep(Attachments::first);
  });
  if (plan.star_count > 0) {
    timed("stars", timings, [&] {
      star_pass_.place(sky, view, plan, outputs.star_shading);
      mark(star_pass_);
    });
    graph.add("stars", [&](const Strip& strip) { with_points(star_pass_, strip); });
  }
  if (has(plan.options.layers, Layer::planets)) {
    timed("planets", timings, [&] {
      planet_pass_.place(sky, view, plan);
      mark(planet_pass_);
    });
    graph.add("planets", [&](const Strip& strip) { with_points(planet_pass_, strip); });
  }
  if (plan.dark_sky) {
    dark_sky_pass_.prepare(view, plan);
    graph.add("zodiacal", [&](const Strip& strip) { dark_sky_pass_.draw_beyond(strip); });
  }
  if (plan.moon) {
    timed("moon", timings, [&] {
      moon_pass_.prepare(sky, view, plan, outputs.moon_shading);
      mark(moon_pass_);
    });
    graph.add("moon", [&](const Strip& strip) { with_disc(moon_pass_, strip); });
  }
  if (plan.sun) {
    timed("sun", timings, [&] {
      sun_pass_.prepare(sky, view, plan);
      mark(sun_pass_);
    });
    graph.add("sun", [&](const Strip& strip) { with_disc(sun_pass_, strip); });
  }
  if (has(plan.options.layers, Layer::ground)) {
    ground_pass_.prepare(view, plan);
    graph.add("ground", [&](const Strip& strip) { with_points(ground_pass_, strip); });
  }
  if (!plan.lights.empty()) {
    const bool with_dark_sky = plan.dark_sky && plan.dark_sky->air_with_sky;
    timed("sky map", timings,
          [&] { sky_pass_.prepare(sky, view, plan, with_dark_sky ? &dark_sky_pass_.air_map() : nullptr); });
    graph.add("sky", [&](const Strip& strip) { sky_pass_.draw(strip); });
  }
  if (plan.dark_sky && !plan.dark_sky->air_with_sky) {
    graph.add("airglow", [&](const Strip& strip) { dark_sky_pass_.draw_air(strip); });
  }

  const auto draw = [&](const Strip& strip) {
    glBindFramebuffer(GL_FRAMEBUFFER, on.framebuffer.name());
    glViewport(0, 0, view.width, strip.rows);
    graph.run(strip, timings);
    // Mappings read what was drawn.
    glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    if (on.points) {
      point_tiles_.list(strip);
    }
  };
  const auto for_each_strip = [&](const auto& work) {
    for (int first = 0; first < view.height; first += rows) {
      work(Strip{first, std::min(rows, view.height - first)});
    }
  };
  const bool whole = rows >= view.height;
  if (outputs.mapping != nullptr) {
    outputs.mapping->start(view);
    for_each_strip([&](const Strip& strip) {
      draw(strip);
      timed("look", timings, [&] { outputs.mapping->look({on.frame, on.points, point_tiles_, strip}); });
    });
  }
  for_each_strip([&](const Strip& strip) {
    if (outputs.mapping == nullptr || !whole) {
      draw(strip);
    }
    if (outputs.mapping != nullptr) {
      timed("display", timings, [&] { outputs.mapping->map({on.frame, on.points, point_tiles_, strip}, on.pixels); });
    }
    timed("read back", timings, [&] {
      if (outputs.xyzs) {
        read_back(on.frame, GL_FLOAT, strip, view.width, frame.xyzs);
      }
      if (outputs.mapping != nullptr && deep) {
        read_back(on.pixels, GL_UNSIGNED_SHORT, strip, view.width, frame.rgba16);
      } else if (outputs.mapping != nullptr) {
        read_back(on.pixels, GL_UNSIGNED_BYTE, strip, view.width, frame.rgba);
      }
    });
    require_no_error("reading the frame back");
  });
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return frame;
}

} // namespace vesper::gpu
