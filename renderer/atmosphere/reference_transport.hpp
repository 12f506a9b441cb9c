// The slow, trustworthy answer: light in the spherical atmosphere by a spectral Monte Carlo of all orders.
#pragma once

#include "vesper/atmosphere/medium.hpp"
#include "vesper/atmosphere/sky_query.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace vesper {

/// A mean with the standard error of the mean.
struct Estimate {
  double mean = 0.0;
  double standard_error = 0.0;
};

/// A linear functional of the spectrum that is estimated, error included, beside the spectrum: weights at the
/// transport's wavelengths (spectral_weights.hpp makes those of X, Y, Z and S).
using SpectralFunctional = std::vector<double>;

/// Above an irradiance of 1 at every wavelength.
struct TransportResult {
  std::vector<Estimate> spectrum;    ///< at the transport's wavelengths: radiance in 1/sr, or irradiance
  std::vector<Estimate> functionals; ///< as many as were asked for
  std::uint64_t paths = 0;
};

/// When to stop, and which random numbers to take.
struct PathBudget {
  /// Standard error over mean that each watched quantity is to reach: the functionals, or without any the spectrum.
  double relative_error = 0.01;
  std::uint64_t least_paths = 4096;
  std::uint64_t most_paths = 1U << 24U;
  int orders = std::numeric_limits<int>::max(); ///< 1: light scattered or reflected once
  std::uint64_t seed = 0;
  std::uint64_t stream = 0; ///< of queries under the same seed, each its own
  unsigned threads = 0;     ///< 0 for one per core; results do not depend on it
};

class TransportGuide;

/// Backward paths, each at all wavelengths at once, with next-event estimation to the light at every vertex.
///
/// Straight rays, no polarization, a spherical ground that reflects after Lambert. (Paths are drawn after a coarse
/// deterministic solution of the same medium, so that they go toward lit air: it decides how soon an answer converges,
/// never the answer.) Optical depths come from quadrature (SampledAir), within 1e-5 of themselves or 5e-7.
class ReferenceTransport {
public:
  /// Takes seconds: the guide is solved here, for all lights and observers.
  /// \param wavelengths_nm ascending, at least one; the medium is valid at each of them
  /// Throws Error(argument) naming component, value and range.
  ReferenceTransport(const Medium& medium, std::vector<double> wavelengths_nm, unsigned threads = 0);
  ~ReferenceTransport();
  ReferenceTransport(ReferenceTransport&&) noexcept;
  ReferenceTransport& operator=(ReferenceTransport&&) noexcept;

  [[nodiscard]] const std::vector<double>& wavelengths_nm() const;

  /// Radiance of the scattered and reflected light that arrives from the view direction; the light's own disc is not
  /// in it. Throws Error(argument) for a query out of its range.
  [[nodiscard]] TransportResult radiance(const SkyQuery& query, const std::vector<SpectralFunctional>& functionals,
                                         const PathBudget& budget) const;

  /// The same light over the upper hemisphere on a level surface.
  [[nodiscard]] TransportResult diffuse_irradiance(const SkyQuery& query,
                                                   const std::vector<SpectralFunctional>& functionals,
                                                   const PathBudget& budget) const;

  /// What of the light itself arrives on a level surface, without error of chance: by quadrature over its disc.
  [[nodiscard]] std::vector<double> direct_irradiance(const SkyQuery& query) const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace vesper
