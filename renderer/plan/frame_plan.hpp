// What one frame has to draw.
#pragma once

#include "vesper/assets/star_catalogue.hpp"
#include "vesper/atmosphere/eclipsed_sky.hpp"
#include "vesper/atmosphere/medium.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/atmosphere/star_extinction_table.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/plan/dark_sky_plan.hpp"
#include "vesper/plan/layers.hpp"
#include "vesper/plan/planned_disc.hpp"
#include "vesper/plan/view.hpp"
#include "vesper/sky/sky_state.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vesper {

/// How much of the air between the observer and the stars is modelled.
struct AirOptions {
  bool refraction = true;
  bool extinction = true;
  std::shared_ptr<const Medium> medium; ///< what dims the stars; clear_medium() where there is none
  /// The light of that medium, for the layer `sky` (none is drawn without) and for what the air scatters of the dark
  /// sky's own light. Plans share them: they are copied to the GPU
  /// once.
  std::shared_ptr<const SkyTables> sky_tables;
  bool scintillation = true;
  /// Seconds over which scintillation is averaged: the eye's integration time by default; 0 for an instant.
  double exposure_s = 0.1;
  /// Entrance pupil in metres: the dark-adapted eye's by default.
  double pupil_m = 0.007;
};

/// What a caller wants of a frame, beyond the sky and the view.
struct FrameOptions {
  LayerSet layers = all_layers();
  AirOptions air;
  DarkSkyOptions dark_sky;
  DiscOptions discs;
  std::uint32_t seed = 0;
  std::uint32_t frame_number = 0; ///< counts the frames of a sequence; the cheap scintillation's only clock
  double control_magnitude = 4.0; ///< of the cheap tier (Mueller et al. 2012, m_a)
  double faintest_lux = 0.0;      ///< the catalogue is cut behind the last star as bright above the atmosphere
};

/// The most billboards that one star needs: the faces that meet at a cube's corner.
inline constexpr int most_star_copies = 3;

/// A table of extinction, and what it was made for.
struct PlannedExtinction {
  std::shared_ptr<const Medium> medium;
  Length height;
  std::optional<RefractionConditions> bending;
  StarExtinction table;
};

/// The sky of a solar eclipse, and the medium of its air.
struct PlannedEclipse {
  std::shared_ptr<const Medium> medium;
  std::shared_ptr<const EclipsedAir> air; ///< serves all instants
  std::shared_ptr<const EclipsedSky> sky; ///< none while the Moon's shadow is far away
};

/// A light of the air, ready to be looked up in tables made for sunlight.
struct PlannedLight {
  Vec3 direction;          ///< without refraction, horizon frame
  Vec3 apparent_direction; ///< where its disc is seen
  Angle angular_radius;
  Mat4 xyzs_from_sunlight; ///< what it makes in X, Y, Z and S of what 1 lux of sunlight makes
};

/// The decisions for one frame, ready for the passes.
struct FramePlan {
  FrameOptions options;
  bool cheap_stars = false;   ///< Mueller's point-spread function, fades and scintillation
  std::size_t star_count = 0; ///< a prefix of the catalogue
  int star_copies = 1;        ///< billboards per star: 2 where the picture wraps round, 3 for the faces of a cube
  Vec4 optical_depth{};       ///< of one zenith column, for the cheap tier: star_optical_depth_xyzs
  std::shared_ptr<const PlannedExtinction> extinction;          ///< for the others; none where the air takes nothing
  std::shared_ptr<const PlannedExtinction> sunlight_extinction; ///< the same for Moon and Sun
  std::optional<PlannedMoon> moon;                              ///< none where it does not show
  std::optional<PlannedSun> sun;
  std::vector<PlannedLight> lights; ///< of the layer `sky`; none where it is not drawn
  PlannedEclipse eclipse;           ///< what dims the sky, whose lights are those outside the Moon's shadow then
  std::shared_ptr<const PlannedDarkSky> dark_sky; ///< none where none of its layers is drawn
  Refraction refraction;                          ///< with its table
  Length observer_height;
  double horizon_sin_altitude = 0.0; ///< of the sea's horizon as it is seen, dipped by the observer's height
};

/// Decides what the frame must draw. `stars` are sorted by magnitude.
/// \param before the plan of an earlier frame, whose tables of extinction serve again (and need not be made, in 3 ms
///        each) where medium, height and the air that bends the light are the same; likewise what is known of the air
///        in an eclipse of the Sun (0.2 s) and of that before the dark sky (30 ms)
[[nodiscard]] FramePlan plan_frame(const SkyState& sky, const View& view, std::span<const StarRecord> stars,
                                   const FrameOptions& options = {}, const FramePlan* before = nullptr);

} // namespace vesper
