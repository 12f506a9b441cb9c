// The sky of one frame over azimuth and view, computed from tables.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/gpu/eclipse_map.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/gpu/sky_textures.hpp"
#include "vesper/plan/frame_plan.hpp"

#include <vector>

namespace vesper::gpu {

/// What shaders/sky.frag reads: the map's layers and the phase function of the aerosol.
class SkyMap {
public:
  /// Steps over azimuth, a multiple of 4, and texels over the views that meet the ground and the others.
  /// shaders/sky.frag states the error.
  static constexpr int columns = 160;
  static constexpr int rows_below = 48;
  static constexpr int rows_above = 136;

  /// The library must outlive the map.
  explicit SkyMap(const ShaderLibrary& library);

  /// Computes the map of a frame whose plan has lights.
  /// \param height of the observer, anywhere
  /// \param share 1 to overwrite what the map held; less to blend these tables with those of the call before
  void fill(const SkyTextures& tables, const FramePlan& plan, Length height, double share = 1.0);

  /// Dims what fill() made by the plan's eclipse, if there is one. Once a frame, after the last call of fill().
  void eclipse(const SkyTables& tables, const FramePlan& plan, Length height);

  /// Binds the map to texture unit 0, the phase function to unit 1 and the block of shaders/sky_block.glsl.
  void bind() const;

private:
  void fill_slices(const SkyTextures& tables, const FramePlan& plan);
  void fill_ground(const SkyTextures& tables);
  void fill_phase(const std::shared_ptr<const SkyTables>& tables, float share);

  ProgramVariants slice_programs_;
  ProgramHandle ground_program_;
  ProgramVariants map_programs_;
  EclipseMap eclipse_map_;
  Texture slices_; ///< side by side: of both tables for the first light, then for the second
  int slice_rows_ = 0;
  Texture map_;
  Texture ground_; ///< its illuminance under each light
  Texture phase_texture_;
  std::vector<float> phase_;
  std::shared_ptr<const SkyTables> phase_of_; ///< null while it is a blend
  Buffer uniforms_;
};

} // namespace vesper::gpu
