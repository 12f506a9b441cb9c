// What the observer's eye does to the light of a picture before it is seen: it scatters light (glare) and, as light
// falls, pools it over wider areas (acuity).
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/gpu/display_mapping.hpp"
#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/gpu/shader_library.hpp"
#include "vesper/plan/view.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace vesper::gpu {

/// A source that the picture does not show and whose veil it does, such as a Sun just beyond the edge.
struct UnseenSource {
  Vec3 direction; ///< unit vector, horizon frame
  Vec4 light_lux; ///< illuminance at the eye: X, Y, Z in lux and S
};

/// Glare and acuity of an eye. Cameras have neither: both off, or no EyeOptics at all.
struct EyeOpticsSettings {
  bool glare = true;
  bool acuity = true;
  double age_years = 30.0;   ///< 0 to 100
  double pigmentation = 0.5; ///< of the iris: 0 very dark, 0.5 brown, 1 blue-green, 1.2 light blue; 0 to 1.5
  /// Angles as the viewer sees them over angles in the scene: 1 for the naked eye, more for a picture (or a telescope)
  /// that shows the scene larger; > 0.
  double magnification = 1.0;
  std::vector<UnseenSource> unseen = {};
};

/// Reads a picture and holds what the eye makes of it:
///
///     extended light seen = shares().x * extended light + added()
///     point light seen    = shares().y * point light
///
/// Both textures have a texel for 4 x 4 pixels, cover the picture and some more, and are read between texels at
/// pixel / (4 * size of the texture), pixel centres at +0.5.
///
/// Glare is the CIE's total function (shaders/lib/eye_glare.glsl), divided by its integral over the sphere: what the
/// eye scatters is missing where it came from, and light scattered out of the picture is lost. Angles are those of the
/// scene. Near a source, within about a cell (1/24 of the picture), the veil is round in the picture: where a
/// projection stretches angles, it does so there too. Past the picture the sphere is taken to be as bright as the
/// picture's darkest cell. What is scattered by less than about eight pixels stays where it is.
/// Outside a fisheye's circle added() is not zero: there is no picture there.
class EyeOptics {
public:
  /// The library must outlive this.
  explicit EyeOptics(const ShaderLibrary& library);
  EyeOptics(const EyeOptics&) = delete;
  EyeOptics& operator=(const EyeOptics&) = delete;
  ~EyeOptics();

  /// Begins a picture.
  /// Throws Error(argument) for settings out of range, and for a cube map: its six faces are seen from within, through
  /// another program's view, whose eye this is not.
  void start(const View& view, const EyeOpticsSettings& settings);
  /// Takes in a strip, which starts at a multiple of 4 rows; strips come in any order.
  /// \param frame  rgba32f of the view's width, its row 0 the strip's first: all light, X, Y, Z in cd/m2 and S
  void add(const Texture& frame, const Strip& strip);
  /// Likewise, with points in it, whose light glare spreads and acuity does not. They send what reaches the naked eye,
  /// however much a picture magnifies.
  void add(const StripLight& light);
  /// Once all strips are in: makes what follows.
  void finish();
  /// The three in one, of a picture without points in one piece.
  void see(const Texture& frame, const View& view, const EyeOpticsSettings& settings);

  /// Whether the picture's left edge continues its right one, as that of an equirectangular one in whole blocks does.
  [[nodiscard]] bool wraps() const { return wraps_; }
  /// Extended light in blocks of 4 x 4 pixels as it came in: rgba32f, of the size of added(); nothing past the picture.
  [[nodiscard]] const Texture& blocks() const;
  /// What extended light gains: rgba32f, X, Y, Z in cd/m2 and S.
  [[nodiscard]] const Texture& added() const { return added_; }
  /// rg32f: the share of a pixel's extended light that stays sharp, and that of its point light.
  [[nodiscard]] const Texture& shares() const { return shares_; }

private:
  struct Pyramid;
  struct Observer {
    double age_years = -1.0;
    double pigmentation = 0.0;
    f64::EyeScatter scatter{}; ///< over its integral over the sphere
  };
  enum class Stage : std::uint8_t { blocks, points, halve, spread, cells, beyond, far, veil, seen };
  const ProgramHandle& program_of(Stage stage);
  void scatter();

  std::vector<ProgramVariants> stages_;
  std::vector<std::string> defines_; ///< that the picture's stages are built with
  Buffer uniforms_;
  Texture added_;
  Texture shares_;
  std::unique_ptr<Pyramid> pyramid_;
  Observer observer_; ///< of the last picture
  bool glare_ = false;
  bool wraps_ = false;
};

} // namespace vesper::gpu
