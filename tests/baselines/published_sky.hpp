// The published way to a sky of all orders: Bruneton and Neyret's precomputed tables, a baseline to be measured.
#pragma once

#include "baselines/tables.hpp"

#include "vesper/atmosphere/medium.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace vesper::baseline {

/// How mu_s lies in the tables: down to 102 degrees from the zenith as in 2017, or 120 as later for float tables.
enum class SunMapping { of_2017, revised };

struct PublishedOptions {
  TableSizes sizes;
  Storage storage = Storage::single;
  SunMapping sun = SunMapping::of_2017;
  int orders = 4; ///< 1 or more
};

/// The algorithm as published, written from its description, with its numbers of steps: 500 for transmittance, 50 for
/// single and 50 for multiple scattering, 16 by 32 directions for the scattering density, 16 by 64 for the ground's
/// irradiance. Single scattering by aerosol stands in a table of its own, and both phase functions are applied where
/// the tables are read.
///
/// Its flaws are part of it and stay: the Sun's altitude has 32 values of which few lie in twilight, eight values of nu
/// smear the glow around the Sun, transmittance between two points is a quotient that loses its digits near the
/// horizon, the Sun's disc sets by a smoothstep, and orders above the fourth are left out. docs/BASELINES.md says how
/// wrong it is.
class PublishedSky {
public:
  /// \param medium of the shape of published_medium(): its first component scatters with Rayleigh's phase function, the
  ///        second with Cornette and Shanks's, the others absorb
  explicit PublishedSky(const Medium& medium, const PublishedOptions& options = {});

  /// Radiance of the scattered light in 1/sr above an irradiance of 1, for an observer in the air.
  /// \param light,view unit vectors, z to the zenith
  [[nodiscard]] Rgb radiance(float height_km, const glm::vec3& light, const glm::vec3& view) const;

private:
  /// The sources of the next order: one order's light.
  struct Order {
    const ScatteringTable* molecules; ///< or all of the light, its phase function in it
    const ScatteringTable* aerosol;   ///< null where there is one table only
    const PlaneTable* ground_irradiance;
  };

  [[nodiscard]] Rgb extinction(float r) const;
  [[nodiscard]] Rgb transmittance_to_top(float r, float mu) const;
  [[nodiscard]] Rgb transmittance(float r, float mu, float distance, bool meets_ground) const;
  [[nodiscard]] Rgb sunlight(float r, float mu_s) const;
  [[nodiscard]] Rgb irradiance(const PlaneTable& table, float r, float mu_s) const;
  [[nodiscard]] PlaneTable direct_irradiance() const;
  [[nodiscard]] PlaneTable indirect_irradiance(const Order& order) const;
  [[nodiscard]] Rgb incident(const Order& order, const ScatteringPlace& place) const;
  [[nodiscard]] ScatteringPlace place(int r, int mu, int mu_s, int nu) const;
  void fill_transmittance();
  void single_scattering(ScatteringTable& molecules, ScatteringTable& aerosol) const;
  void scattering_density(const Order& order, ScatteringTable& density) const;
  void multiple_scattering(const ScatteringTable& density, ScatteringTable& light) const;

  TableSizes sizes_;
  Shell shell_;
  std::vector<HeightProfile> profiles_;
  std::vector<Rgb> extinction_per_km_;
  Rgb molecules_per_km_;
  Rgb aerosol_per_km_;
  float asymmetry_;
  Rgb albedo_;
  PlaneTable transmittance_;
  ScatteringTable molecules_; ///< single scattering by molecules and, over Rayleigh's phase function, all other orders
  ScatteringTable aerosol_;   ///< single scattering by aerosol
};

} // namespace vesper::baseline
