// What a light field is solved with: the air by wavelengths, the field's nodes, and rays in steps.
#pragma once

#include "vesper/atmosphere/sampled_air.hpp"
#include "vesper/atmosphere/spectral_air.hpp"
#include "vesper/base/shader_math.hpp"

#include <cstddef>
#include <vector>

namespace vesper {

/// How finely a light field is solved.
struct LightFieldSize {
  std::size_t heights = 24;       ///< 2 or more, as 3 zenith angles
  std::size_t zeniths = 40;       ///< directions of the first order at a node, above and below the horizon together
  std::size_t azimuths = 12;      ///< over half a turn
  std::size_t later_zeniths = 20; ///< the same of the later orders, which are smoother
  std::size_t later_azimuths = 8;
  double step_growth = 0.15; ///< a step's rise over its height
  double least_step_km = 0.3;
  /// Orders are followed until those left out are known within this share of all light at every node, 5e-4 or more. In
  /// twilight they come out ten times better.
  double rest = 0.01;
  int most_orders = 30; ///< the end, also where they are not; 1 or more
};

/// A ray toward an observer in steps, with what one unit of source in each sends there. Lights are by number and then
/// by block of four wavelengths.
struct LightRay {
  double cos_zenith = 1.0;
  double sin_zenith = 0.0;
  std::vector<f32::LightStep> steps;
  std::vector<Lanes> weights; ///< by step, scatterer, block
  bool meets_ground = false;
  f32::LightStep ground{};
  std::vector<Lanes> ground_weights; ///< transmittance times albedo over pi, by block
};

/// Directions from which the solver gathers light at each node.
struct LightRule {
  std::size_t zeniths = 0;
  std::size_t azimuths = 0;
  std::vector<LightRay> rays;                  ///< by height, zenith
  std::vector<f32::LightDirection> directions; ///< by height, zenith, azimuth
  /// What the light of each direction weighs in aerosol's sources, by height below source_heights, toward, direction,
  /// block.
  std::vector<Lanes> phase_matrix;

  [[nodiscard]] std::size_t size() const { return zeniths * azimuths; }
};

/// The medium prepared for the kernels of shaders/lib/light_field.glsl. Wavelengths are handled in blocks of four; what
/// stands behind the last wavelength has no meaning.
class LightFieldModel {
public:
  static constexpr std::size_t most_wavelengths = 64;
  static constexpr std::size_t most_blocks = most_wavelengths / Lanes::size;
  static constexpr float light_radius_rad = 0.00465305F; ///< of Sun and Moon, 16 arcmin, where the field is solved
  static constexpr std::size_t source_directions =
      static_cast<std::size_t>(f32::source_zeniths) * static_cast<std::size_t>(f32::source_azimuths);

  /// `air` and `optics` are of one medium and outlive this object.
  /// \param threads 0 for one per core
  /// Throws Error(argument) for more wavelengths than that and for a size out of its range.
  LightFieldModel(const SampledAir& air, const SpectralAir& optics, const LightFieldSize& size, unsigned threads);

  [[nodiscard]] const SampledAir& air() const { return air_; }
  [[nodiscard]] const SpectralAir& optics() const { return optics_; }
  [[nodiscard]] const LightFieldSize& size() const { return size_; }
  [[nodiscard]] std::size_t blocks() const { return blocks_; }
  [[nodiscard]] const f32::LightShell& shell() const { return shell_; }
  [[nodiscard]] std::size_t angles() const { return angle_cos_.size(); }
  [[nodiscard]] std::size_t nodes() const { return size_.heights * angles(); }
  [[nodiscard]] double angle_cos(std::size_t angle) const { return angle_cos_[angle]; }
  /// Of the nodes' heights, those from the ground up where aerosol counts.
  [[nodiscard]] std::size_t source_heights() const { return source_heights_; }
  /// 1 for the molecules, and as many as there are other phase functions.
  [[nodiscard]] std::size_t scatterers() const { return scatterers_.size(); }
  [[nodiscard]] const std::vector<Lanes>& second_moment() const { return second_moment_; }
  [[nodiscard]] const std::vector<Lanes>& depths() const { return depths_; }
  [[nodiscard]] const std::vector<float>& angle_places() const { return angle_places_; }

  [[nodiscard]] PhaseKind phase_kind(std::size_t scatterer) const;
  /// Of a scatterer by wavelength, in Lanes of `blocks`.
  void phase_parameter(std::size_t scatterer, Lanes* parameters) const;
  void phase(std::size_t scatterer, double cos_angle, Lanes* per_sr) const;

  /// \param radius_km of the ray's origin from the planet's centre
  /// \param growth,least_km a step's rise over its height, and its least
  [[nodiscard]] LightRay ray(double radius_km, double cos_zenith, double growth, double least_km) const;
  /// Place of a height in the table of optical depths.
  [[nodiscard]] double depth_place(double height_km) const;
  /// Directions for the first order, and for those after it.
  [[nodiscard]] LightRule first_rule(unsigned threads) const;
  [[nodiscard]] LightRule later_rule(unsigned threads) const;

private:
  [[nodiscard]] LightRule rule(std::size_t zeniths, std::size_t azimuths, double growth, double least_km,
                               unsigned threads) const;

  /// Components with one phase function.
  using Scatterer = std::vector<std::size_t>;

  // Zenith nodes of aerosol's sources below the horizon and above it; one stands at it.
  static constexpr int source_nodes_below = 5;
  static constexpr int source_nodes_above = f32::source_zeniths - 1 - source_nodes_below;

  void find_scatterers();
  void place_angles();
  void tabulate_depths(unsigned threads);
  void find_source_heights();
  [[nodiscard]] double node_height_km(std::size_t i) const;
  [[nodiscard]] double height_place(double height_km) const;
  [[nodiscard]] double dip(double radius_km) const;
  [[nodiscard]] static double source_altitude(std::size_t zenith_node, double dip_rad);
  [[nodiscard]] static double zenith_place(double altitude_rad, double dip_rad);
  [[nodiscard]] f32::LightStep step(const AirRay& ray, double place_km, double cos_zenith, double sin_zenith) const;
  [[nodiscard]] double scattering_per_km(const Scatterer& scatterer, const SampledAir::PerComponent& density,
                                         std::size_t wavelength) const;
  void add_phase_matrix(std::size_t height, LightRule& rule) const;

  const SampledAir& air_;
  const SpectralAir& optics_;
  LightFieldSize size_;
  std::size_t blocks_;
  f32::LightShell shell_{};
  std::vector<Scatterer> scatterers_; ///< the molecules first
  std::vector<Lanes> second_moment_;  ///< Legendre's of molecules, by block
  std::vector<double> angle_cos_;     ///< of the nodes, falling
  std::vector<float> angle_places_;
  std::vector<Lanes> depths_; ///< by height, angle, block
  std::size_t source_heights_ = 0;
};

} // namespace vesper
