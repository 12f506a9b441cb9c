// Light that comes from all over the sky, and what the air scatters of it.
#pragma once

#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace vesper {

/// A light without edges, as much of it as scattering tells apart: rings of equal altitude, in each the mean and the
/// first two harmonics over the azimuth.
struct SpreadLight {
  struct Ring {
    Angle altitude;
    double even = 0.0; ///< illuminance of a surface that faces the ring, lux
    Vec2 first{};      ///< north and east parts of what varies once around the sky
    Vec2 second{};     ///< cosine and sine parts of what varies twice
  };
  std::vector<Ring> rings;
};

/// Where in the sky light may come from to reach the air about an observer: altitudes above this.
[[nodiscard]] Angle lowest_spread_light(const SkyTables& tables, Length height);

/// How far apart the light is looked at: a finer sky is to be averaged over it.
inline constexpr Angle spread_light_width = 15.0 * deg;

/// \param luminance cd/m2 toward a unit vector (x = East, y = North, z = zenith) of `lowest` altitude or more
[[nodiscard]] SpreadLight spread_light(Angle lowest, const std::function<double(const Vec3&)>& luminance);

/// Tables of the sky added up over such lights, for some views of one observer. Takes 60 looks at the tables a view.
class SpreadLightViews {
public:
  /// \param views altitudes, without refraction; also below the horizon, where the air before the ground and the lit
  /// ground show
  SpreadLightViews(std::shared_ptr<const SkyTables> tables, Length height, const std::vector<Angle>& views);

  [[nodiscard]] Angle lowest() const { return lowest_; }

  /// Scattered light in a view, of all orders: X, Y, Z, S for a light of the Sun's colour. For another colour it is
  /// multiplied by a response_matrix from sunlight.
  /// \param light made with lowest() \param azimuth north through east
  [[nodiscard]] Vec4 luminance(std::size_t view, Angle azimuth, const SpreadLight& light) const;

  /// Of a level surface by scattered light, the same way.
  [[nodiscard]] Vec4 illuminance(const SpreadLight& light) const;

private:
  /// By view and ring: the mean and two harmonics of the tables' light over its azimuth from the view's.
  struct Harmonics {
    Vec4 even, first, second;
  };
  std::shared_ptr<const SkyTables> tables_;
  Length height_;
  Angle lowest_;
  std::size_t rings_;
  std::vector<Harmonics> harmonics_;
  std::vector<Vec4> illuminance_; ///< by ring
};

} // namespace vesper
