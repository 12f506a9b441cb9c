// vesper-catalog: star catalogues and maps in, GPU buffers and cube maps out.

#include "catalog/commands.hpp"
#include "common/program.hpp"

#include "vesper/base/error.hpp"

#include <CLI/App.hpp>

// Only a lack of memory while the options are set up can leave this function.
int main(int argc, char** argv) { // NOLINT(bugprone-exception-escape)
  CLI::App app("Turns star catalogues into star buffers, pictures of the sky and maps of the Moon into cube maps",
               "vesper-catalog");
  vesper::prepare_program(app);
  app.require_subcommand(0, 1);
  const auto stars = vesper::add_stars_command(app);
  const auto moon = vesper::add_moon_command(app);
  const auto panorama = vesper::add_panorama_command(app);
  const auto info = vesper::add_info_command(app);
  const auto check = vesper::add_check_command(app);
  return vesper::run_program(argc, argv, app, [&] {
    if (app.got_subcommand("stars")) {
      stars();
    } else if (app.got_subcommand("moon")) {
      moon();
    } else if (app.got_subcommand("panorama")) {
      panorama();
    } else if (app.got_subcommand("info")) {
      info();
    } else if (app.got_subcommand("check")) {
      check();
    } else {
      throw vesper::Error(vesper::ErrorKind::argument, "no subcommand is given",
                          {"", "", "Allowed are stars, moon, panorama, info and check; see vesper-catalog --help"});
    }
  });
}
