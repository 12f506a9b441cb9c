#include "vesper/assets/star_catalogue_check.hpp"

#include "vesper/base/shader_math.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numeric>
#include <string>

namespace vesper {
namespace {

// A unit vector rounded to floats is off by less than 1e-7; a proper motion by that much of its length.
constexpr double unit_vector_tolerance = 1e-6;
// Illuminance of V = 0: that of an A0 star, times the lux ratio of any colour between deep blue and a carbon star.
constexpr double least_v0_lux = 0.9 * f64::zero_magnitude_lux;
constexpr double most_v0_lux = 1.5 * f64::zero_magnitude_lux;

double dot(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return static_cast<double>(a[0]) * static_cast<double>(b[0]) + static_cast<double>(a[1]) * static_cast<double>(b[1]) +
         static_cast<double>(a[2]) * static_cast<double>(b[2]);
}

/// The first rule that a star breaks, or nullptr.
const char* fault_of(const StarRecord& star, const StarIdentity& identity) {
  std::array<float, sizeof(StarRecord) / sizeof(float)> numbers{};
  std::memcpy(numbers.data(), &star, sizeof(star));
  if (!std::all_of(numbers.begin(), numbers.end(), [](float v) { return std::isfinite(v); }) ||
      !std::isfinite(identity.magnitude)) {
    return "a number is not finite";
  }
  if (std::abs(std::sqrt(dot(star.position, star.position)) - 1.0) > unit_vector_tolerance) {
    return "the position is not a unit vector";
  }
  const double motion = std::sqrt(dot(star.proper_motion, star.proper_motion));
  if (std::abs(dot(star.position, star.proper_motion)) > unit_vector_tolerance * motion) {
    return "the proper motion is not tangent to the sphere";
  }
  if (star.parallax < 0.0F) {
    return "the parallax is negative";
  }
  if (!(star.illuminance > 0.0F)) {
    return "the illuminance is not positive";
  }
  if (!std::all_of(star.color.begin(), star.color.end(), [](float v) { return v > 0.0F; }) ||
      std::abs(static_cast<double>(star.color[1]) - 1.0) > 1e-6) {
    return "the colour is not positive with Y = 1";
  }
  if (star.variability < 0.0F) {
    return "the amplitude of variability is negative";
  }
  const double v0_lux =
      static_cast<double>(star.illuminance) * std::pow(10.0, 0.4 * static_cast<double>(identity.magnitude));
  if (v0_lux < least_v0_lux || v0_lux > most_v0_lux) {
    return "the illuminance does not belong to the magnitude";
  }
  return nullptr;
}

} // namespace

double total_illuminance_lux(const StarCatalogue& catalogue) {
  return std::accumulate(catalogue.stars.begin(), catalogue.stars.end(), 0.0, [](double sum, const StarRecord& star) {
    return sum + static_cast<double>(star.illuminance);
  });
}

void check_star_catalogue(const StarCatalogue& catalogue, ErrorKind kind, const std::string& file) {
  const auto& [stars, identities, provenance] = catalogue;
  const auto fail = [&](const std::string& place, const std::string& message) {
    throw Error(kind, message, {file, place, star_file_remedy});
  };
  if (stars.empty()) {
    fail("", "the catalogue holds no star");
  }
  if (identities.size() != stars.size()) {
    fail("", std::to_string(identities.size()) + " identities for " + std::to_string(stars.size()) + " stars");
  }
  for (std::size_t i = 0; i < stars.size(); ++i) {
    if (const char* fault = fault_of(stars[i], identities[i])) {
      fail("star " + std::to_string(i), fault);
    }
    if (i > 0 && identities[i].magnitude < identities[i - 1].magnitude) {
      fail("star " + std::to_string(i), "is brighter than the star before it: not sorted by magnitude");
    }
  }
  if (provenance.kept != stars.size()) {
    fail("provenance",
         "says " + std::to_string(provenance.kept) + " stars, the buffer holds " + std::to_string(stars.size()));
  }
  if (provenance.read < provenance.kept) {
    fail("provenance",
         "says " + std::to_string(provenance.read) + " entries read but " + std::to_string(provenance.kept) + " kept");
  }
  if (!std::isfinite(provenance.epoch_jyear)) {
    fail("provenance", "the epoch is not finite");
  }
  const double total = total_illuminance_lux(catalogue);
  if (!(std::abs(total - provenance.illuminance_lux) <= star_flux_tolerance * std::abs(total))) {
    fail("provenance", "the stars give " + std::to_string(total * 1e6) + " microlux together, not the " +
                           std::to_string(provenance.illuminance_lux * 1e6) + " that is stated");
  }
}

} // namespace vesper
