// How the published tables lie over the atmosphere: Bruneton and Neyret 2008 (Computer Graphics Forum 27, 1079), with
// the mappings of the new implementation of 2017 (Bruneton, "Precomputed Atmospheric Scattering: a New
// Implementation").
//
// r: distance from the planet's centre in km. mu: cosine of the view's zenith angle. mu_s: of the Sun's. nu: cosine
// between view and Sun. Places in a table are texels: 0 is the centre of the first, n - 1 that of the last.
#pragma once

namespace vesper::baseline {

/// Texels; the defaults are those published.
struct TableSizes {
  int transmittance_r = 64;
  int transmittance_mu = 256;
  int irradiance_r = 16;
  int irradiance_mu_s = 64;
  int scattering_r = 32;
  int scattering_mu = 128; ///< even: one half for rays that meet the ground
  int scattering_mu_s = 32;
  int scattering_nu = 8;
};

/// The shell of air, in single precision as everything here: the published method runs on a GPU.
struct Shell {
  float ground_km;
  float top_km;
  float sun_span; ///< of the Sun's mapping: to how low a Sun tables reach

  /// Length of the level ray from the ground to the top.
  [[nodiscard]] float longest_level_km() const;
  /// Distance to the point nearest to the centre of a ray that grazes the ground.
  [[nodiscard]] float horizon_km(float r) const;
  [[nodiscard]] float to_top_km(float r, float mu) const;
  [[nodiscard]] float to_ground_km(float r, float mu) const;
  [[nodiscard]] bool meets_ground(float r, float mu) const;
  [[nodiscard]] float to_edge_km(float r, float mu, bool to_ground) const;
};

/// The mapping of mu_s in 2017: the Sun down to nearly lowest_mu_s.
[[nodiscard]] float sun_span_2017(const Shell& shell, float lowest_mu_s);
/// As revised later: down to lowest_mu_s.
[[nodiscard]] float sun_span_revised(const Shell& shell, float lowest_mu_s);

struct RayPlace {
  float r;
  float mu;
};

/// A place in the table of transmittance to the top, for rays that do not meet the ground.
struct TransmittanceTexel {
  float mu;
  float r;
};
[[nodiscard]] TransmittanceTexel transmittance_texel(const Shell& shell, const TableSizes& sizes, RayPlace ray);
[[nodiscard]] RayPlace transmittance_ray(const Shell& shell, const TableSizes& sizes, TransmittanceTexel texel);

struct IrradianceTexel {
  float mu_s;
  float r;
};
[[nodiscard]] IrradianceTexel irradiance_texel(const Shell& shell, const TableSizes& sizes, float r, float mu_s);
struct SunPlace {
  float r;
  float mu_s;
};
[[nodiscard]] SunPlace irradiance_sun(const Shell& shell, const TableSizes& sizes, IrradianceTexel texel);

/// A place in the tables of scattering.
struct ScatteringTexel {
  float r;
  float mu;
  float mu_s;
  float nu;
};
struct ScatteringPlace {
  float r;
  float mu;
  float mu_s;
  float nu;
  bool meets_ground;
};
[[nodiscard]] ScatteringTexel scattering_texel(const Shell& shell, const TableSizes& sizes,
                                               const ScatteringPlace& place);
/// The nu of a texel is kept within what its mu and mu_s allow.
[[nodiscard]] ScatteringPlace scattering_place(const Shell& shell, const TableSizes& sizes,
                                               const ScatteringTexel& texel);

} // namespace vesper::baseline
