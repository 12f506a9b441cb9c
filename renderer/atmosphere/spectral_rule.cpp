#include "vesper/atmosphere/spectral_rule.hpp"

#include "vesper/atmosphere/sampled_air.hpp"
#include "vesper/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace vesper {
namespace {

using Values = std::vector<double>; // by wavelength of the medium

/// Spectra that air can make: what scatters, behind what takes away.
class Ensemble {
public:
  explicit Ensemble(const Medium& medium) : wavelengths_(medium.wavelengths_nm), count_(wavelengths_.size()) {
    add_matter(medium);
    const Values white(count_, 1.0);
    Values ground(count_);
    std::transform(wavelengths_.begin(), wavelengths_.end(), ground.begin(), medium.ground_albedo);
    // Scattered not at all, once, or again and again; by molecules, aerosol or the ground.
    const Values twice = times(molecules_.scattering, molecules_.scattering);
    for (const Values& source : {white, molecules_.scattering, other_.scattering, twice, times(twice, twice),
                                 times(molecules_.scattering, other_.scattering), times(molecules_.scattering, ground),
                                 times(other_.scattering, ground), ground}) {
      add_dimmed(source);
    }
  }

  /// Normalized to a mean of 1.
  [[nodiscard]] const std::vector<Values>& spectra() const { return spectra_; }

private:
  struct Matter {
    Values scattering, depth; // of a zenith column
  };

  void add_matter(const Medium& medium) {
    const SampledAir air(medium);
    const SampledAir::PerComponent columns =
        air.columns_to_space(air.ray(air.ground_km(), 1.0), [](const auto&) { return false; });
    for (Matter* matter : {&molecules_, &other_, &absorbers_}) {
      matter->scattering.assign(count_, 0.0);
      matter->depth.assign(count_, 0.0);
    }
    for (std::size_t c = 0; c < medium.components.size(); ++c) {
      const MediumComponent& part = medium.components[c];
      const bool scatters = std::any_of(wavelengths_.begin(), wavelengths_.end(),
                                        [&](double nm) { return part.scattering_per_km(nm) > 0.0; });
      Matter& matter = !scatters ? absorbers_ : part.phase.kind == PhaseKind::rayleigh ? molecules_ : other_;
      for (std::size_t l = 0; l < count_; ++l) {
        matter.scattering[l] += columns[c] * part.scattering_per_km(wavelengths_[l]);
        matter.depth[l] += columns[c] * part.extinction_per_km(wavelengths_[l]);
      }
    }
  }

  void add_dimmed(const Values& source) {
    for (const double through_molecules : {0.0, 1.0, 3.0, 8.0, 18.0, 40.0}) {
      for (const double through_other : {0.0, 1.0, 4.0, 12.0, 40.0}) {
        for (const double through_absorbers : {0.0, 2.0, 6.0, 15.0, 30.0}) {
          Values spectrum(count_);
          double sum = 0.0;
          for (std::size_t l = 0; l < count_; ++l) {
            spectrum[l] =
                source[l] * std::exp(-through_molecules * molecules_.depth[l] - through_other * other_.depth[l] -
                                     through_absorbers * absorbers_.depth[l]);
            sum += spectrum[l];
          }
          // Nothing is seen of what is dimmer.
          constexpr double darkest = 1.0e-7;
          if (sum > darkest * static_cast<double>(count_)) {
            for (double& value : spectrum) {
              value *= static_cast<double>(count_) / sum;
            }
            spectra_.push_back(std::move(spectrum));
          }
        }
      }
    }
  }

  [[nodiscard]] static Values times(Values a, const Values& b) {
    std::transform(a.begin(), a.end(), b.begin(), a.begin(), std::multiplies<>());
    return a;
  }

  const std::vector<double>& wavelengths_;
  std::size_t count_;
  Matter molecules_, other_, absorbers_;
  std::vector<Values> spectra_;
};

/// Least squares for one response: minimal over w >= 0 of w' squares w - 2 products' w + rest.
struct Fit {
  std::vector<Values> squares;
  Values products;
  double rest = 0.0;

  Fit(const std::vector<Values>& spectra, const Values& exact)
      : squares(exact.size(), Values(exact.size(), 0.0)), products(exact.size(), 0.0) {
    for (const Values& spectrum : spectra) {
      double target = 0.0;
      for (std::size_t l = 0; l < exact.size(); ++l) {
        target += exact[l] * spectrum[l];
      }
      if (!(target > 0.0)) {
        continue;
      }
      rest += 1.0;
      for (std::size_t a = 0; a < exact.size(); ++a) {
        const double value = spectrum[a] / target;
        products[a] += value;
        for (std::size_t b = 0; b <= a; ++b) {
          squares[a][b] += value * spectrum[b] / target;
        }
      }
    }
    for (std::size_t a = 0; a < exact.size(); ++a) {
      for (std::size_t b = a + 1; b < exact.size(); ++b) {
        squares[a][b] = squares[b][a];
      }
    }
  }
};

/// Solves a symmetric positive system by Cholesky's factors, in place.
Values solve(std::vector<Values> matrix, Values right) {
  const std::size_t n = right.size();
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = j; i < n; ++i) {
      double sum = matrix[i][j];
      for (std::size_t k = 0; k < j; ++k) {
        sum -= matrix[i][k] * matrix[j][k];
      }
      matrix[i][j] = i == j ? std::sqrt(std::max(sum, 1.0e-300)) : sum / matrix[j][j];
    }
    for (std::size_t k = 0; k < j; ++k) {
      right[j] -= matrix[j][k] * right[k];
    }
    right[j] /= matrix[j][j];
  }
  for (std::size_t j = n; j-- > 0;) {
    for (std::size_t k = j + 1; k < n; ++k) {
      right[j] -= matrix[k][j] * right[k];
    }
    right[j] /= matrix[j][j];
  }
  return right;
}

/// Weights of the chosen wavelengths, none negative: where the best would be, those are left out one by one.
struct Weights {
  Values values;
  double error; ///< sum of squared relative errors
};
Weights fitted(const Fit& fit, const std::vector<std::size_t>& chosen) {
  std::vector<std::size_t> kept(chosen.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    kept[i] = i;
  }
  Weights result{Values(chosen.size(), 0.0), fit.rest};
  while (!kept.empty()) {
    std::vector<Values> matrix(kept.size(), Values(kept.size()));
    Values right(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
      right[i] = fit.products[chosen[kept[i]]];
      for (std::size_t j = 0; j < kept.size(); ++j) {
        matrix[i][j] = fit.squares[chosen[kept[i]]][chosen[kept[j]]];
      }
      // Neighbours that are nearly alike shall not be played off against each other.
      matrix[i][i] *= 1.0 + 1.0e-9;
    }
    const Values best = solve(matrix, right);
    const auto least = std::min_element(best.begin(), best.end());
    if (*least < 0.0) {
      kept.erase(kept.begin() + (least - best.begin()));
      continue;
    }
    for (std::size_t i = 0; i < kept.size(); ++i) {
      result.values[kept[i]] = best[i];
      result.error -= best[i] * right[i];
    }
    break;
  }
  result.error = std::max(result.error, 0.0);
  return result;
}

using Choice = std::vector<std::size_t>; // of wavelengths

double error(const std::array<Fit, 4>& fits, const Choice& chosen) {
  double sum = 0.0;
  for (const Fit& fit : fits) {
    sum += fitted(fit, chosen).error;
  }
  return sum;
}

/// Lets each wavelength in turn go where it does best, until none moves any more. Returns the error.
double improve(Choice& chosen, const std::array<Fit, 4>& fits) {
  double least = error(fits, chosen);
  for (bool moved = true; moved;) {
    moved = false;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      for (std::size_t k = 0; k < fits[0].products.size(); ++k) {
        if (std::find(chosen.begin(), chosen.end(), k) != chosen.end()) {
          continue;
        }
        Choice other = chosen;
        other[i] = k;
        const double now = error(fits, other);
        if (now < least * (1.0 - 1.0e-6)) {
          least = now;
          chosen = other;
          moved = true;
        }
      }
    }
  }
  return least;
}

/// From a few even choices, each over a part of the spectrum that ends sooner in the red.
Choice best_choice(const std::array<Fit, 4>& fits, std::size_t wavelengths, std::size_t count) {
  Choice best;
  double least = std::numeric_limits<double>::infinity();
  for (const double part : {1.0, 0.925, 0.85, 0.775, 0.7, 0.625}) {
    Choice chosen;
    for (std::size_t i = 0; i < count; ++i) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      chosen.push_back(static_cast<std::size_t>(share * part * static_cast<double>(wavelengths)));
    }
    // Where they crowd more than the medium's own, one would stand twice.
    const bool crowded = std::adjacent_find(chosen.begin(), chosen.end()) != chosen.end();
    if (crowded && part < 1.0) {
      continue;
    }
    const double now = improve(chosen, fits);
    if (now < least || best.empty()) {
      least = now;
      best = chosen;
    }
  }
  std::sort(best.begin(), best.end());
  return best;
}

} // namespace

SpectralRule spectral_rule(const Medium& medium, const Spectrum& light, std::size_t most) {
  if (most == 0) {
    throw Error(ErrorKind::argument, "a spectral rule without wavelengths", {"", "", "Ask for at least 1"});
  }
  for (const double nm : medium.wavelengths_nm) {
    validate(medium, nm);
  }
  const std::vector<double>& all = medium.wavelengths_nm;
  const SpectralWeights exact = spectral_weights(light, all);
  if (all.size() <= most) {
    return {all, exact};
  }
  const Ensemble ensemble(medium);
  const std::array<Fit, 4> fits{Fit(ensemble.spectra(), exact.x), Fit(ensemble.spectra(), exact.y),
                                Fit(ensemble.spectra(), exact.z), Fit(ensemble.spectra(), exact.s)};
  const std::vector<std::size_t> chosen = best_choice(fits, all.size(), most);
  SpectralRule rule;
  for (const std::size_t k : chosen) {
    rule.wavelengths_nm.push_back(all[k]);
  }
  rule.weights = {fitted(fits[0], chosen).values, fitted(fits[1], chosen).values, fitted(fits[2], chosen).values,
                  fitted(fits[3], chosen).values};
  return rule;
}

} // namespace vesper
