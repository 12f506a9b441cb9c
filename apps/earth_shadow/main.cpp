// Makes what the tree holds of the light in the Earth's shadow: the map that is embedded for the default medium, and
// the picture of it in docs.
#include "earth_shadow/chart.hpp"

#include "vesper/atmosphere/earth_shadow_file.hpp"
#include "vesper/atmosphere/medium_presets.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>

int main(int argc, char** argv) {
  try {
    if (argc < 2 || argc > 3) {
      throw std::runtime_error("takes the map's file to write and, if wanted, the picture's (SVG)");
    }
    const vesper::EarthShadowLight light = vesper::make_earth_shadow_light(vesper::clear_medium());
    vesper::write_earth_shadow_light(argv[1], light);
    if (argc == 3) {
      vesper::write_file_atomically(argv[2], vesper::shadow_chart(light));
    }
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "vesper_make_earth_shadow: %s\n", e.what());
    return 1;
  }
}
