// Views by their numbers, towards the zenith.
#pragma once

#include "vesper/plan/view.hpp"

namespace vesper::test {

inline View view_of(Projection projection, double fov_deg, int width, int height) {
  View view;
  view.projection = projection;
  view.fov = fov_deg * deg;
  view.width = width;
  view.height = height;
  return view;
}

} // namespace vesper::test
