#include "vesper/gpu/headless_context.hpp"

#include "vesper/base/error.hpp"

#include <array>
#include <cstdlib>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <string_view>
#include <vector>

namespace vesper::gpu {
namespace {

bool has_extension(const char* list, std::string_view name) {
  if (list == nullptr) {
    return false;
  }
  const std::string padded = " " + std::string(list) + " ";
  return padded.find(" " + std::string(name) + " ") != std::string::npos;
}

/// Displays in the order they should be tried: hardware devices, software devices, surfaceless.
std::vector<EGLDisplay> candidate_displays() {
  std::vector<EGLDisplay> displays;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (has_extension(client, "EGL_EXT_platform_device") && has_extension(client, "EGL_EXT_device_enumeration")) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_TRUE) {
      for (const bool software : {false, true}) {
        for (EGLint i = 0; i < count; ++i) {
          EGLDeviceEXT device = devices.at(static_cast<std::size_t>(i));
          const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
          if (has_extension(extensions, "EGL_MESA_device_software") == software) {
            displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
          }
        }
      }
    }
  }
  if (has_extension(client, "EGL_MESA_platform_surfaceless")) {
    displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  return displays;
}

} // namespace

struct HeadlessContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  Handles() = default;
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
  ~Handles() { release(); }

  /// True when a current OpenGL 4.5 core context was made on the display.
  bool open(EGLDisplay candidate) {
    display = candidate;
    EGLint major = 0;
    EGLint minor = 0;
    if (display == EGL_NO_DISPLAY || eglInitialize(display, &major, &minor) != EGL_TRUE) {
      display = EGL_NO_DISPLAY;
      return false;
    }
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    if (has_extension(extensions, "EGL_KHR_surfaceless_context") && eglBindAPI(EGL_OPENGL_API) == EGL_TRUE) {
      const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
      EGLConfig config = nullptr;
      EGLint configs = 0;
      eglChooseConfig(display, wanted.data(), &config, 1, &configs);
      const std::array<EGLint, 7> attributes{
          EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
          EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
      context = eglCreateContext(display, configs > 0 ? config : nullptr, EGL_NO_CONTEXT, attributes.data());
      if (context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) {
        return true;
      }
    }
    release();
    return false;
  }

  void release() {
    if (context != EGL_NO_CONTEXT) {
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      eglDestroyContext(display, context);
      context = EGL_NO_CONTEXT;
    }
    if (display != EGL_NO_DISPLAY) {
      eglTerminate(display);
      display = EGL_NO_DISPLAY;
    }
  }
};

HeadlessContext::HeadlessContext() : handles_(std::make_unique<Handles>()) {
  // A warm cache has silently given wrong pixels with Mesa 22.3.
  ::setenv("MESA_SHADER_CACHE_DISABLE", "1", 1);
  for (EGLDisplay display : candidate_displays()) {
    if (handles_->open(display)) {
      return;
    }
  }
  throw Error(ErrorKind::gpu, "no EGL device offers an OpenGL 4.5 core context",
              {"", "", "Install a driver, or Mesa's software renderer (package libgl1-mesa-dri)"});
}

HeadlessContext::HeadlessContext(HeadlessContext&&) noexcept = default;
HeadlessContext& HeadlessContext::operator=(HeadlessContext&&) noexcept = default;
HeadlessContext::~HeadlessContext() = default;

std::string HeadlessContext::description() const {
  const auto text = [](GLenum name) {
    const GLubyte* value = glGetString(name);
    return value == nullptr ? std::string("unknown") : std::string(reinterpret_cast<const char*>(value));
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

} // namespace vesper::gpu
