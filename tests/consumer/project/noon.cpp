#include "vesper/sky/sky_state.hpp"

#include <cstdio>

int main() {
  using namespace vesper;
  const Observer greenwich{51.4769 * deg, 0.0 * deg, 47.0 * metre};
  const SkyState sky = sky_state(parse_instant("2026-06-21T12:02:00Z"), greenwich);
  std::printf("Sun: %.2f deg\n", sky.sun.altitude.to(deg));
}
