// What an eclipse of the Sun leaves of a frame's sky, over the columns and rows of its map.
#pragma once

#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/plan/frame_plan.hpp"

namespace vesper::gpu {

/// Dims a map of the sky (sky_map.hpp). Views are followed on the processor, on a net four times coarser
/// than the map for observers on the ground (20 ms on one core), as fine as the map for those high above it (0.3 s).
class EclipseMap {
public:
  /// The library must outlive it.
  explicit EclipseMap(const ShaderLibrary& library) : programs_(library, {"sky_eclipse.comp"}) {}

  struct MapSize {
    int columns; ///< the last is the first again
    int rows_below, rows_above;
  };
  /// Where the map's rows begin and end, as they are seen and along straight rays.
  struct MapRows {
    f32::SkyMapFrame frame;
    double seen_horizon_rad, seen_end_rad;
    double straight_horizon_rad, straight_end_rad; ///< altitudes of the horizon and of the zenith or the limb's end
  };

  /// \param plan whose eclipse has a sky
  void dim(const Texture& map, const MapSize& size, const MapRows& rows, const FramePlan& plan);

private:
  ProgramVariants programs_;
};

} // namespace vesper::gpu
