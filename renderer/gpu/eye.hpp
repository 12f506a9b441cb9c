// What the observer's eye does to the light of a frame before it is seen: it scatters light (glare) and, as light falls,
// pools it over wider areas (acuity).
#pragma once

#include "vesper/base/vector.hpp"
#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/shader_library.hpp"
#include "vesper/plan/view.hpp"

#include <memory>
#include <vector>

namespace vesper::gpu {

/// A source that the picture does not show and whose veil it does, such as a Sun just beyond the edge.
struct UnseenSource {
  Vec3 direction;  ///< unit vector, horizon frame
  Vec4 light_lux;  ///< illuminance at the eye: X, Y, Z in lux and S
};

struct EyeGlareSettings {
  bool on = true;             ///< off for a camera
  double age_years = 30.0;    ///< 0 to 100
  double pigmentation = 0.5;  ///< of the iris: 0 very dark, 0.5 brown, 1 blue-green, 1.2 light blue; 0 to 1.5
  std::vector<UnseenSource> unseen;
};

struct EyeAcuitySettings {
  bool on = true; ///< off for a camera
};

struct EyeSettings {
  EyeGlareSettings glare;
  EyeAcuitySettings acuity;
  /// Angles as the viewer sees them over angles in the scene: 1 for the naked eye, more for a picture (or a telescope)
  /// that shows the scene larger. > 0.
  double magnification = 1.0;
};

/// Takes a frame in strips, then holds what the eye adds and keeps:
///
///     extended light seen = shares().x * extended light + added()
///     point light seen    = shares().y * point light
///
/// both textures of a quarter of the picture's size, to be read between texels (linearly) at the picture's place
/// (0 to 1 over the whole texture; texture_scale() says how much of it the picture takes).
class Eye {
public:
  explicit Eye(const ShaderLibrary& library);
  Eye(const Eye&) = delete;
  Eye& operator=(const Eye&) = delete;
  ~Eye();

  /// Begins a picture. Throws Error(argument) for settings out of range and for a cube map, whose six faces another
  /// program sees from within: glare belongs to the picture that it makes of them.
  void start(const View& view, const EyeSettings& settings);
  /// Takes in rows of the picture; the first row of a strip is a multiple of four.
  /// \param frame  rgba32f: all light, X, Y, Z in cd/m2 and S
  /// \param points rgba32f: the part of it that is point sources' light; null for none
  void add(const Texture& frame, const Texture* points, const Strip& strip);
  /// After the last strip.
  void finish();

  /// What extended light gains: X, Y, Z in cd/m2 and S.
  [[nodiscard]] const Texture& added() const;
  /// x: share of a pixel's extended light that stays sharp, y: of its point light.
  [[nodiscard]] const Texture& shares() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace vesper::gpu
