// Where the umbra ends to the eye.
#pragma once

namespace vesper::test {

/// The distance from the shadow's axis at which log Y falls most steeply, near that of an Earth without air, km.
/// \param log_y log10 of the share of Y that is left, by distance from the axis in km
template <class LogY> double umbra_edge_km(double airless_km, const LogY& log_y) {
  double steepest = 0.0;
  double edge = 0.0;
  for (double off = 0.98 * airless_km; off < 1.05 * airless_km; off += 2.0) {
    const double slope = log_y(off + 10.0) - log_y(off - 10.0);
    if (slope > steepest) {
      steepest = slope;
      edge = off;
    }
  }
  return edge;
}

} // namespace vesper::test
