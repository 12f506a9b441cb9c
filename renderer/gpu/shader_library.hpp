// The sources of the shader stages: embedded, or from a folder while developing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vesper::gpu {

/// A preprocessed stage. Line directives in the text count files; `files` names them.
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;
};

class ShaderLibrary {
public:
  /// The embedded sources.
  ShaderLibrary() = default;
  /// Sources from `folder`, which overrides the embedded ones file by file.
  explicit ShaderLibrary(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The stage with its includes resolved (each file once) and `defines` ("NAME" or "NAME VALUE") on top.
  /// Throws Error(gpu) naming a file that cannot be found.
  [[nodiscard]] ShaderSource stage(std::string_view name, const std::vector<std::string>& defines) const;

private:
  [[nodiscard]] std::string read(const std::string& name) const;
  void append(const std::string& name, ShaderSource& source) const;

  std::optional<std::filesystem::path> folder_;
};

} // namespace vesper::gpu
