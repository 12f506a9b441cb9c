#include "vesper/atmosphere/reference_transport.hpp"

#include "vesper/atmosphere/path_tracer.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace vesper {
namespace {

/// Paths that one thread takes at a time; their sums are joined in order.
constexpr std::uint64_t batch_paths = 512;

/// Which wavelengths paths are drawn for: one for each response function, or all of a few.
std::vector<std::size_t> guide_wavelengths(const std::vector<double>& wavelengths_nm) {
  std::vector<std::size_t> chosen;
  if (wavelengths_nm.size() <= TransportGuide::most_wavelengths) {
    for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
      chosen.push_back(i);
    }
    return chosen;
  }
  for (const double wanted_nm : {440.0, 505.0, 565.0, 630.0}) {
    const auto nearest = std::min_element(wavelengths_nm.begin(), wavelengths_nm.end(), [&](double a, double b) {
      return std::abs(a - wanted_nm) < std::abs(b - wanted_nm);
    });
    const auto index = static_cast<std::size_t>(nearest - wavelengths_nm.begin());
    if (chosen.empty() || chosen.back() != index) {
      chosen.push_back(index);
    }
  }
  return chosen;
}

void validate(const PathBudget& budget) {
  if (!(budget.relative_error > 0.0) || budget.most_paths == 0 || budget.orders < 1) {
    throw Error(ErrorKind::argument, "a budget of no paths, no orders or no error",
                {"", "", "Give a positive error and at least one path and order"});
  }
}

struct Sums {
  std::vector<double> first;  ///< of the values of all paths: wavelengths, then functionals
  std::vector<double> second; ///< of their squares
};

Estimate estimate(double first, double second, std::uint64_t paths) {
  const auto n = static_cast<double>(paths);
  const double mean = first / n;
  return {mean, paths > 1 ? std::sqrt(std::max(0.0, second / n - mean * mean) / (n - 1.0)) : 0.0};
}

} // namespace

struct ReferenceTransport::Parts {
  Parts(Medium the_medium, std::vector<double> wavelengths_nm, unsigned threads)
      : medium(std::move(the_medium)), air(medium), optics(medium, std::move(wavelengths_nm)),
        guide(air, optics, guide_wavelengths(optics.wavelengths_nm()), threads) {}

  [[nodiscard]] Sums batch(const SkyQuery& query, PathTracer::Quantity quantity,
                           const std::vector<SpectralFunctional>& functionals, const PathBudget& budget,
                           std::uint64_t begin, std::uint64_t end) const;
  [[nodiscard]] TransportResult solve(const SkyQuery& query, PathTracer::Quantity quantity,
                                      const std::vector<SpectralFunctional>& functionals,
                                      const PathBudget& budget) const;

  Medium medium;
  SampledAir air;
  SpectralAir optics;
  TransportGuide guide;
};

Sums ReferenceTransport::Parts::batch(const SkyQuery& query, PathTracer::Quantity quantity,
                                      const std::vector<SpectralFunctional>& functionals, const PathBudget& budget,
                                      std::uint64_t begin, std::uint64_t end) const {
  PathTracer tracer(air, optics, guide, query, budget.orders);
  Sums sums;
  sums.first.assign(optics.size() + functionals.size(), 0.0);
  sums.second = sums.first;
  std::vector<double> values(optics.size());
  const auto add = [&](std::size_t i, double value) {
    sums.first[i] += value;
    sums.second[i] += value * value;
  };
  for (std::uint64_t path = begin; path < end; ++path) {
    RandomStream random(budget.seed, budget.stream, path);
    tracer.trace(quantity, static_cast<std::size_t>(path % guide.wavelengths().size()), random, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      add(i, values[i]);
    }
    for (std::size_t f = 0; f < functionals.size(); ++f) {
      double sum = 0.0;
      for (std::size_t i = 0; i < values.size(); ++i) {
        sum += functionals[f][i] * values[i];
      }
      add(values.size() + f, sum);
    }
  }
  return sums;
}

TransportResult ReferenceTransport::Parts::solve(const SkyQuery& query, PathTracer::Quantity quantity,
                                                 const std::vector<SpectralFunctional>& functionals,
                                                 const PathBudget& budget) const {
  validate(query);
  validate(budget);
  for (const SpectralFunctional& functional : functionals) {
    if (functional.size() != optics.size()) {
      throw Error(ErrorKind::argument,
                  "weights at " + std::to_string(functional.size()) + " wavelengths for a transport at " +
                      std::to_string(optics.size()),
                  {"", "", "Give one weight a wavelength"});
    }
  }
  const std::size_t count = optics.size() + functionals.size();
  const std::size_t watched = functionals.empty() ? 0 : optics.size();
  Sums total{std::vector<double>(count, 0.0), std::vector<double>(count, 0.0)};
  std::uint64_t paths = 0;
  // As many paths for each of the guide's wavelengths, as their weights expect.
  const auto evenly = [each = guide.wavelengths().size()](std::uint64_t some) {
    return (some + each - 1) / each * each;
  };
  std::uint64_t wanted = std::min(evenly(std::max<std::uint64_t>(budget.least_paths, 2)), budget.most_paths);
  while (paths < wanted) {
    const std::uint64_t batches = (wanted - paths + batch_paths - 1) / batch_paths;
    std::vector<Sums> parts(batches);
    parallel_for(
        batches, 1,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            const std::uint64_t first = paths + i * batch_paths;
            parts[i] = batch(query, quantity, functionals, budget, first, std::min(first + batch_paths, wanted));
          }
        },
        budget.threads);
    for (const Sums& part : parts) {
      for (std::size_t i = 0; i < count; ++i) {
        total.first[i] += part.first[i];
        total.second[i] += part.second[i];
      }
    }
    paths = wanted;
    double worst = 0.0;
    bool any = false;
    for (std::size_t i = watched; i < count; ++i) {
      const Estimate now = estimate(total.first[i], total.second[i], paths);
      if (now.mean > 0.0) {
        any = true;
        worst = std::max(worst, now.standard_error / now.mean);
      }
    }
    // Where no path has found light after many more than the least, none is looked for any further.
    constexpr std::uint64_t patience = 16;
    const double excess = worst / budget.relative_error;
    if (any ? excess <= 1.0 : paths >= patience * budget.least_paths) {
      break;
    }
    // The error falls with the root of the paths; it is itself not well known.
    const double factor = any ? std::clamp(1.1 * excess * excess, 1.25, 4.0) : 2.0;
    wanted =
        std::min(evenly(static_cast<std::uint64_t>(std::ceil(factor * static_cast<double>(paths)))), budget.most_paths);
  }
  TransportResult result;
  result.paths = paths;
  for (std::size_t i = 0; i < count; ++i) {
    (i < optics.size() ? result.spectrum : result.functionals)
        .push_back(estimate(total.first[i], total.second[i], paths));
  }
  return result;
}

ReferenceTransport::ReferenceTransport(const Medium& medium, std::vector<double> wavelengths_nm, unsigned threads)
    : parts_(std::make_unique<Parts>(medium, std::move(wavelengths_nm), threads)) {}
ReferenceTransport::~ReferenceTransport() = default;
ReferenceTransport::ReferenceTransport(ReferenceTransport&&) noexcept = default;
ReferenceTransport& ReferenceTransport::operator=(ReferenceTransport&&) noexcept = default;

const std::vector<double>& ReferenceTransport::wavelengths_nm() const { return parts_->optics.wavelengths_nm(); }

TransportResult ReferenceTransport::radiance(const SkyQuery& query, const std::vector<SpectralFunctional>& functionals,
                                             const PathBudget& budget) const {
  return parts_->solve(query, PathTracer::Quantity::radiance, functionals, budget);
}

TransportResult ReferenceTransport::diffuse_irradiance(const SkyQuery& query,
                                                       const std::vector<SpectralFunctional>& functionals,
                                                       const PathBudget& budget) const {
  return parts_->solve(query, PathTracer::Quantity::irradiance, functionals, budget);
}

std::vector<double> ReferenceTransport::direct_irradiance(const SkyQuery& query) const {
  validate(query);
  const Vec3 observer(0.0, 0.0, parts_->air.ground_km() + query.height.to(kilometre));
  const double altitude = std::asin(std::clamp(query.light_direction.z, -1.0, 1.0));
  std::vector<double> sums(parts_->optics.size(), 0.0);
  // Strips of equal altitude across the disc: Gauss and Chebyshev's rule of the second kind carries their lengths.
  constexpr int strips = 64;
  for (int i = 1; i <= strips; ++i) {
    const double angle = std::numbers::pi * i / (strips + 1.0);
    const double weight = 2.0 / (strips + 1.0) * std::sin(angle) * std::sin(angle);
    const double strip = altitude + query.light_angular_radius.to(rad) * std::cos(angle);
    if (std::sin(strip) <= 0.0) {
      continue;
    }
    const AirColumns columns = columns_to_space(parts_->medium, observer, Vec3(std::cos(strip), 0.0, std::sin(strip)));
    for (std::size_t j = 0; j < sums.size() && !columns.blocked; ++j) {
      sums[j] += weight * std::sin(strip) *
                 optical_depth(parts_->medium, columns, parts_->optics.wavelengths_nm()[j]).transmittance();
    }
  }
  if (query.light_share) {
    query.light_share({0.0, 0.0, 0.0}, sums);
  }
  return sums;
}

} // namespace vesper
