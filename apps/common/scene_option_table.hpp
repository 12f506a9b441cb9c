// Each scene option described once: name, help, type, range and meaning.
#pragma once

#include "common/scene_options.hpp"

#include <span>

namespace vesper {

/// What a scene file may hold for an option.
enum class SceneValueKind {
  text,
  time,   ///< text or a TOML date-time
  number, ///< integer or float
  number_or_text,
  integer,      ///< integer
  list,         ///< comma-separated text or an array of text
  name_or_file, ///< text; a file without an absolute path lies beside the scene file
  file,         ///< likewise
};

struct SceneOptionDescription {
  std::string_view name; ///< without dashes
  SceneValueKind kind;
  std::string_view value_name; ///< shown by --help
  std::string_view group;      ///< heading in --help
  std::string_view help;
  /// Sets the option in `scene`, in which all options before this one in the table are set already.
  /// \return what is allowed, when `text` is not; else "". Where more is to be said, it throws Error(argument)
  std::string (*apply)(std::string_view text, SceneOptions& scene);
};

[[nodiscard]] std::span<const SceneOptionDescription> scene_option_table();

/// Whether the value of an option of kind name_or_file is a file: it has a slash in it or ends in .toml.
[[nodiscard]] bool names_a_file(std::string_view value);

} // namespace vesper
