// An OpenGL context without a window.
#pragma once

#include <memory>
#include <string>

namespace vesper::gpu {

/// A current OpenGL 4.5 core context through EGL, without a surface: EGL_EXT_platform_device, preferring hardware, else
/// EGL_MESA_platform_surfaceless. Current on the constructing thread until destroyed; one at a time per thread.
///
/// Switches Mesa's shader cache off for the process (it has produced wrong pixels). Throws Error(gpu) when no device
/// offers OpenGL 4.5.
class HeadlessContext {
public:
  HeadlessContext();
  HeadlessContext(HeadlessContext&&) noexcept;
  HeadlessContext& operator=(HeadlessContext&&) noexcept;
  ~HeadlessContext();

  /// The driver's name of the renderer and its OpenGL version.
  [[nodiscard]] std::string description() const;

private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

} // namespace vesper::gpu
