// Compiled shader programs.
#pragma once

#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/shader_library.hpp"

#include <map>
#include <string>
#include <vector>

namespace vesper::gpu {

/// Compiles and links stages; the stage's kind follows from its file's ending (.vert, .frag, .comp). On failure throws
/// Error(gpu) whose message holds the driver's log, with the names of the files that its numbers count.
[[nodiscard]] ProgramHandle build_program(const ShaderLibrary& library, const std::vector<std::string>& stages,
                                          const std::vector<std::string>& defines = {});

/// Programs of one pass by their defines, built when first asked for.
class ProgramVariants {
public:
  ProgramVariants(const ShaderLibrary& library, std::vector<std::string> stages)
      : library_(library), stages_(std::move(stages)) {}

  [[nodiscard]] const ProgramHandle& get(const std::vector<std::string>& defines);

private:
  const ShaderLibrary& library_;
  std::vector<std::string> stages_;
  std::map<std::vector<std::string>, ProgramHandle> programs_;
};

} // namespace vesper::gpu
