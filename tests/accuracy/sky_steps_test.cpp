// Dusk without steps: how the tables' sky changes while the light sinks by 0.05 degree at a time, against the slope of
// a smooth curve through the reference.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/light/spectral_weights.hpp"
#include "vesper/light/sunlight.hpp"

#include "support/thorough.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vesper {
namespace {

constexpr double highest_deg = 5.0;
constexpr double lowest_deg = -18.0;

struct View {
  double altitude_deg;
  double azimuth_deg; ///< from the light's
};

SkyQuery query(double light_deg, const View& view) {
  return {0.0 * kilometre, test::direction(0.0 * deg, light_deg * deg), 0.2666 * deg,
          test::direction(view.azimuth_deg * deg, view.altitude_deg * deg)};
}

/// Slope per degree of a cubic through values at equal steps, whose slope at each is that from one neighbour to the
/// other.
class SmoothCurve {
public:
  SmoothCurve(double first_deg, double step_deg, std::vector<double> values)
      : first_deg_(first_deg), step_deg_(step_deg), values_(std::move(values)) {}

  [[nodiscard]] double slope(double x_deg) const {
    const double place = (x_deg - first_deg_) / step_deg_;
    const auto i = static_cast<std::size_t>(place);
    const double t = place - static_cast<double>(i);
    const double* v = &values_[i - 1];
    return (0.5 * (v[2] - v[0]) + t * (2.0 * v[0] - 5.0 * v[1] + 4.0 * v[2] - v[3]) +
            1.5 * t * t * (3.0 * (v[1] - v[2]) + v[3] - v[0])) /
           step_deg_;
  }

private:
  double first_deg_;
  double step_deg_;
  std::vector<double> values_;
};

void expect_no_steps(const Medium& medium, const std::string& name, const std::vector<View>& views,
                     double reference_error) {
  const SkyTables tables = make_sky_tables(medium);
  const ReferenceTransport reference(medium, medium.wavelengths_nm);
  const std::vector<double> luminance = spectral_weights(solar_irradiance_1au(), medium.wavelengths_nm).y;
  constexpr double node_step_deg = 1.5;
  constexpr double first_node_deg = lowest_deg - 2.0 * node_step_deg;
  PathBudget budget;
  budget.least_paths = 2048;
  for (const View& view : views) {
    std::vector<double> logarithms;
    for (double light = first_node_deg; light < highest_deg + 2.0 * node_step_deg; light += node_step_deg) {
      ++budget.stream;
      // Where dusk falls fast a coarser curve will do.
      budget.relative_error = light > -1.0 ? reference_error : 3.0 * reference_error;
      logarithms.push_back(std::log(reference.radiance(query(light, view), {luminance}, budget).functionals[0].mean));
    }
    const SmoothCurve curve(first_node_deg, node_step_deg, logarithms);
    constexpr double step_deg = 0.05;
    // The largest step over what is allowed, as a share of it.
    test::ErrorSum steps;
    double last = std::log(sky_luminance(tables, query(lowest_deg, view)).y);
    for (int i = 1; lowest_deg + i * step_deg <= highest_deg; ++i) {
      const double light = lowest_deg + i * step_deg;
      const double now = std::log(sky_luminance(tables, query(light, view)).y);
      const double slope = std::max(std::abs(curve.slope(light)), std::abs(curve.slope(light - step_deg)));
      const double allowed = std::expm1(1.5 * slope * step_deg) + 0.001;
      steps.add(100.0 * std::expm1(std::abs(now - last)) / allowed);
      last = now;
    }
    steps.hold(name + ", view " + std::to_string(static_cast<int>(view.altitude_deg)) + " degrees high, " +
                   std::to_string(static_cast<int>(view.azimuth_deg)) +
                   " from the light: step of 0.05 degree, of 1.5 slopes and 0.1 %",
               100.0, "%");
  }
}

const std::vector<View> few{{90.0, 0.0}, {15.0, 0.0}, {10.0, 180.0}};
const std::vector<View> many{{90.0, 0.0},  {60.0, 60.0}, {15.0, 0.0},   {15.0, 30.0}, {3.0, 10.0},
                             {2.0, 170.0}, {10.0, 90.0}, {10.0, 180.0}, {40.0, 120.0}};

TEST(SkySteps, PublishedMedium) {
  expect_no_steps(published_medium(), "published", test::thorough() ? many : few, test::thorough() ? 0.004 : 0.008);
}

TEST(SkySteps, ClearAir) {
  expect_no_steps(clear_medium(), "clear", test::thorough() ? many : few, test::thorough() ? 0.005 : 0.01);
}

} // namespace
} // namespace vesper
