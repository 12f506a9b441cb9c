// What of the rings around a centre is seen past a disc before them.
#pragma once

#include <array>
#include <cstddef>

namespace vesper {

/// Rings from an inner to an outer radius: those nearer than `inside_until` and further than `outside_from` are seen
/// whole. Of those between, which the disc's edge crosses, light integrates to the sum of its density (light per unit
/// of radius) at the nodes times their weights.
struct SeenRings {
  struct Node {
    double radius;
    double weight; ///< width times the share of the ring that is seen
  };
  double inside_until;
  double outside_from;
  std::array<Node, 48> crossed;
};

/// All lengths in one unit.
/// \param radius of the disc, >= 0
/// \param distance of its centre from that of the rings, >= 0
/// \param inner, outer radii of the rings, 0 <= inner <= outer
[[nodiscard]] SeenRings rings_past_disc(double radius, double distance, double inner, double outer);

} // namespace vesper
