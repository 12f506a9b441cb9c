// The options that tell what a picture is shown on, for all programs that make pictures.
#pragma once

#include "vesper/plan/display.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <deque>
#include <span>
#include <string>
#include <string_view>

namespace vesper {

struct DisplayOptions {
  Display display;
  int bits = 8; ///< of a code value: 8 or 16
  bool black_given = false;
  bool ambient_given = false;
  bool pixels_per_degree_given = false;
};

/// An option described once: name, help, range and meaning.
struct DisplayOptionDescription {
  std::string_view name;       ///< without dashes
  std::string_view value_name; ///< shown by --help
  std::string_view help;
  /// Takes the text over; returns what is allowed if it is not.
  std::string (*apply)(std::string_view text, DisplayOptions& options);
};

[[nodiscard]] std::span<const DisplayOptionDescription> display_option_table();

/// The display options of one program.
class DisplayOptionSet {
public:
  /// Adds the options to `app`, which must outlive this object.
  explicit DisplayOptionSet(CLI::App& app);

  /// The display after parsing. Throws Error(argument) naming the option, its value and the allowed range. A black that
  /// is not given is a thousandth of the peak, the ambient light of a dome none.
  [[nodiscard]] DisplayOptions resolve() const;

private:
  struct Bound {
    const DisplayOptionDescription& description;
    const CLI::Option* option;
  };
  std::deque<std::string> values_; ///< what CLI11 writes to: must not move
  std::deque<Bound> bound_;
};

} // namespace vesper
