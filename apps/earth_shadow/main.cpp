// Makes the map of the light in the Earth's shadow that is embedded for the default medium.
#include "vesper/atmosphere/earth_shadow_file.hpp"
#include "vesper/atmosphere/medium_presets.hpp"

#include <cstdio>
#include <exception>
#include <stdexcept>

int main(int argc, char** argv) {
  try {
    if (argc != 2) {
      throw std::runtime_error("takes the file to write");
    }
    vesper::write_earth_shadow_light(argv[1], vesper::make_earth_shadow_light(vesper::clear_medium()));
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "vesper_make_earth_shadow: %s\n", e.what());
    return 1;
  }
}
