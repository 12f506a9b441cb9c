// The light in the Earth's shadow against conservation of energy, finer quadrature and published calculations.
#include "support/truth.hpp"
#include "support/umbra_edge.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/atmosphere/earth_shadow_light.hpp"
#include "vesper/atmosphere/earth_shadow_solver.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/base/gauss_legendre.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/spectral_weights.hpp"
#include "vesper/light/sunlight.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace vesper {
namespace {

using test::ErrorSum;

constexpr double moon_along_km = 384400.0;
constexpr std::array<double, 3> moons_km{358000.0, 384400.0, 406000.0};

f64::EarthShadow shadow_at(Length sun) {
  return {Vec3(0.0, 0.0, 1.0), sun.to(kilometre), sun_radius.to(kilometre), 1.01 * earth_equatorial_radius_km};
}

/// Radii of umbra and penumbra of a sphere without air, of the Earth's mean radius.
Vec2 airless_radii_km(double along_km) {
  return f64::earth_shadow_radii_km(along_km,
                                    f64::shadow_with_edge(shadow_at(astronomical_unit), f64::earth_radius_km));
}

constexpr EarthShadowLoad without_load{0.0, -100.0};

std::vector<double> every_nm(int step) {
  std::vector<double> nm;
  for (int at = 400; at <= 720; at += step) {
    nm.push_back(at);
  }
  return nm;
}

/// The table of a given L for moonlight of the Sun's colour.
LunarEclipseTable table_of(double danjon, double along_km = moon_along_km) {
  return lunar_eclipse_table(
      eclipse_spectra(default_earth_shadow_light(), along_km * kilometre, astronomical_unit, danjon),
      solar_irradiance_1au());
}

Vec4 shares(const LunarEclipseTable& table, double off_km, double along_km = moon_along_km) {
  return f64::lunar_eclipse_shares(Vec3(off_km, 0.0, along_km), shadow_at(astronomical_unit), table.frame,
                                   table.sampler());
}

TEST(EarthShadow, KeepsTheSunlightThatThePlanetDoesNotStop) {
  // Air that bends light but takes none: over a plane behind the Earth just that is missing which would have met the
  // ground, a disc as large as the rays that graze it are off the centre.
  Medium vacuum = clear_medium();
  vacuum.components.erase(vacuum.components.begin() + 1, vacuum.components.end());
  vacuum.components[0].scattering_per_km = constant_law(0.0);
  const EarthShadowSolver solver(vacuum, {550.0}, {without_load});
  const double ground_km = grazing_rays(vacuum).front().impact_km;
  ErrorSum error;
  for (const double along : moons_km) {
    const double end_km = airless_radii_km(along).y + 200.0;
    double missing = 0.0;
    for (const QuadratureNode& node : gauss_legendre(400)) {
      const double off = end_km * node.place;
      missing += end_km * node.weight * 2.0 * off * (1.0 - solver.shares({off, along}, astronomical_unit)[0]);
    }
    const double magnified = ground_km * (1.0 + along / astronomical_unit.to(kilometre));
    error.add(100.0 * (missing / (magnified * magnified) - 1.0));
  }
  error.hold("sunlight missing behind air that only bends light, against the Earth's disc", 0.1, "%");
}

TEST(EarthShadow, IsAsBrightOnTheAxisAsPublishedForMolecules) {
  // Vollmer and Gedzelman 2008 (Appl. Opt. 47, H52): 1/2400 of the light at the centre, molecules alone, no clouds.
  Medium molecules = clear_medium();
  molecules.components.erase(molecules.components.begin() + 1, molecules.components.end());
  const std::vector<double> nm = every_nm(10);
  const EarthShadowSolver solver(molecules, nm, {without_load});
  const std::vector<double> left = solver.shares({0.0, moon_along_km}, astronomical_unit);
  double share = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < nm.size(); ++i) {
    share += left[i] * solar_irradiance_1au()(nm[i]);
    all += solar_irradiance_1au()(nm[i]);
  }
  share /= all;
  std::printf("molecules alone leave 1/%.0f of the light on the axis\n", 1.0 / share);
  ErrorSum error;
  error.add(-2.5 * std::log10(share * 2400.0));
  error.hold("light on the shadow's axis behind molecules alone against a published 1/2400", 0.5, "mag");
}

TEST(EarthShadow, HasItsEdgeWhereObserversSeeIt) {
  // 1 to 2.5 % outside the airless one (1.2 to 2 % in two centuries of timings).
  for (const double danjon : {0.0, 1.0, 2.0, 3.0, 4.0}) {
    for (const double along : moons_km) {
      const LunarEclipseTable table = table_of(danjon, along);
      const double airless = airless_radii_km(along).x;
      const auto log_y = [&](double off) { return std::log10(shares(table, off, along).y); };
      const double edge = test::umbra_edge_km(airless, log_y);
      std::printf("L = %.0f, Moon at %.0f km: edge of the umbra %.2f %% outside the airless one\n", danjon, along,
                  100.0 * (edge / airless - 1.0));
      EXPECT_GT(edge, 1.010 * airless);
      EXPECT_LT(edge, 1.025 * airless);
    }
  }
}

TEST(EarthShadow, IsFullLightAtThePenumbrasEdge) {
  ErrorSum error;
  for (const double danjon : {0.0, 2.5, 4.0}) {
    for (const double along : moons_km) {
      const Vec4 left = shares(table_of(danjon, along), airless_radii_km(along).y, along);
      for (int i = 0; i < 4; ++i) {
        error.add(100.0 * (left[i] - 1.0));
      }
    }
  }
  error.hold("light at the airless penumbra's edge against full light", 0.5, "%");
}

TEST(EarthShadow, IsReddestInTheMiddleAndBlueAtItsRim) {
  // Not for L = 0: there the red light that the lower air bends meets clouds, and what is left has been scattered by
  // dust high up, without colour. Danjon calls such eclipses grey, where the Moon shows at all.
  for (const double danjon : {1.0, 2.0, 2.5, 3.0, 4.0}) {
    const LunarEclipseTable table = table_of(danjon);
    const auto blueness = [&](double off) { return shares(table, off).z / shares(table, off).x; };
    double rim = 0.0;
    for (double off = 4300.0; off < 4800.0; off += 5.0) {
      rim = std::max(rim, blueness(off));
    }
    std::printf("L = %.1f: Z/X of moonlight without eclipse times %.3f in the middle, %.3f at the rim\n", danjon,
                blueness(0.0), rim);
    EXPECT_LT(blueness(0.0), 0.85 * rim);
    // Dust hides the blue rim, as Danjon's scale has it; in clear air it is bluer than moonlight without an eclipse.
    if (danjon >= 2.5) {
      EXPECT_GT(rim, 1.0);
      EXPECT_GT(rim, blueness(5000.0));
    }
  }
  // It is ozone that makes it: most where ozone absorbs most, 600 nm.
  const EclipseSpectra spectra =
      eclipse_spectra(default_earth_shadow_light(), moon_along_km * kilometre, astronomical_unit, 3.0);
  std::vector<double> sums(spectra.wavelengths_nm.size(), 0.0);
  spectra.add({4600.0, moon_along_km}, shadow_at(astronomical_unit), 1.0, sums);
  const Spectrum rim = spectra.spectrum(sums);
  EXPECT_GT(rim(460.0), 1.3 * rim(600.0));
  EXPECT_GT(rim(700.0), 1.3 * rim(600.0));
}

TEST(EarthShadow, MapIsThatOfFinerQuadrature) {
  const std::vector<double> nm = every_nm(5);
  const std::vector<EarthShadowLoad> loads{earth_shadow_loads.begin(), earth_shadow_loads.end()};
  const EarthShadowSolver solver(clear_medium(), nm, loads);
  const SpectralWeights weights = spectral_weights(solar_irradiance_1au(), nm);
  const Xyzs full = weights(std::vector<double>(nm.size(), 1.0));
  ErrorSum umbra, penumbra;
  for (const double sun_au : {0.9833, 1.0, 1.0167}) {
    for (const double along : {357000.0, 368000.0, 391000.0, 406500.0}) {
      const Length sun = sun_au * astronomical_unit;
      std::vector<LunarEclipseTable> tables;
      for (std::size_t load = 0; load < loads.size(); ++load) {
        tables.push_back(lunar_eclipse_table(
            eclipse_spectra(default_earth_shadow_light(), along * kilometre, sun, static_cast<double>(load)),
            solar_irradiance_1au()));
      }
      for (int i = 0; i < 40; ++i) {
        const double off = 8300.0 * std::pow((i + 0.37) / 40.0, 1.5);
        const std::vector<double> fine = solver.shares({off, along}, sun);
        for (std::size_t load = 0; load < loads.size(); ++load) {
          const auto first = fine.begin() + static_cast<std::ptrdiff_t>(load * nm.size());
          const Xyzs left = weights({first, first + static_cast<std::ptrdiff_t>(nm.size())});
          const Vec4 found = f64::lunar_eclipse_shares(Vec3(0.0, off, along), shadow_at(sun), tables[load].frame,
                                                       tables[load].sampler());
          ErrorSum& sum = off < 4800.0 ? umbra : penumbra;
          sum.add(100.0 * std::log(found.x * full.x / left.x));
          sum.add(100.0 * std::log(found.y * full.y / left.y));
          sum.add(100.0 * std::log(found.z * full.z / left.z));
          sum.add(100.0 * std::log(found.w * full.s / left.s));
        }
      }
    }
  }
  umbra.hold("X, Y, Z, S of the map in the umbra against quadrature every 5 nm", 5.0, "%");
  penumbra.hold("X, Y, Z, S of the map in the penumbra against quadrature every 5 nm", 0.5, "%");
}

TEST(EarthShadow, TheEmbeddedMapIsThatOfTheDefaultMedium) {
  const EarthShadowLight made = make_earth_shadow_light(clear_medium());
  const EarthShadowLight& embedded = default_earth_shadow_light();
  ASSERT_EQ(made.log_shares.size(), embedded.log_shares.size());
  EXPECT_EQ(made.wavelengths_nm, embedded.wavelengths_nm);
  EXPECT_EQ(made.frame.edge_km, embedded.frame.edge_km);
  ErrorSum error;
  for (std::size_t i = 0; i < made.log_shares.size(); ++i) {
    error.add(100.0 * (made.log_shares[i] - embedded.log_shares[i]) / EarthShadowLight::logs_per_unit);
  }
  error.hold("the embedded map of the Earth's shadow against one made now", 0.06, "%");
}

} // namespace
} // namespace vesper
