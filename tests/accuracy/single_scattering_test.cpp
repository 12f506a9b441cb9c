// Light scattered or reflected once against a quadrature made elsewhere and against what is known in closed form.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/single_scattering.hpp"
#include "vesper/atmosphere/transmittance.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace vesper {
namespace {

Vec3 toward(double altitude_deg, double azimuth_deg = 0.0) {
  return test::direction(azimuth_deg * deg, altitude_deg * deg);
}

TEST(SingleScattering, ZenithOfThePublishedMedium) {
  const std::string path = std::string(VESPER_TEST_DATA) + "/atmosphere/sky_zenith_radiance.csv";
  const CsvTable table(read_file(path), path);
  const Medium air = published_medium();
  test::ErrorSum error;
  test::ErrorSum bound;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const test::TruthRow row(table, i);
    const double azimuth = row.number("view_azimuth_from_sun_deg");
    const SkyQuery query{row.number("height_km") * kilometre, toward(row.number("sun_elevation_deg")), 0.0 * deg,
                         toward(row.number("view_elevation_deg"), azimuth)};
    const SingleScattering ours = single_scattering(air, query, {row.number("channel_nm")});
    const double theirs = row.number("order1");
    if (theirs == 0.0) {
      EXPECT_EQ(ours.radiance[0], 0.0) << "line " << table.line(i);
      EXPECT_EQ(ours.error[0], 0.0);
    } else {
      error.add(ours.radiance[0] / theirs - 1.0);
      bound.add(ours.error[0] / ours.radiance[0]);
    }
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%.3f s\n", seconds.count());
  error.hold("single scattering at the zenith, relative", 1.0e-4, "");
  bound.hold("own bound of single scattering at the zenith, relative", 2.0e-6, "");
}

} // namespace
} // namespace vesper
