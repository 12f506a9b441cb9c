// The subcommands of vesper-catalog. Each adds itself and its options to the program and returns what is to be done
// when it was chosen.
#pragma once

#include <CLI/App.hpp>

#include <functional>

namespace vesper {

[[nodiscard]] std::function<void()> add_stars_command(CLI::App& app);
[[nodiscard]] std::function<void()> add_moon_command(CLI::App& app);
[[nodiscard]] std::function<void()> add_panorama_command(CLI::App& app);
[[nodiscard]] std::function<void()> add_info_command(CLI::App& app);
[[nodiscard]] std::function<void()> add_check_command(CLI::App& app);

} // namespace vesper
