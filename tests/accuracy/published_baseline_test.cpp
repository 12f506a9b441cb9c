// The published precomputation at a reduced size: that it is what was published, errors included.
#include "baselines/published_sky.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/single_scattering.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace vesper {
namespace {

using baseline::PublishedSky;
using baseline::Rgb;
using baseline::Storage;

constexpr float observer_km = 0.01F;
const std::array<double, 3> wavelengths_nm{680.0, 550.0, 440.0};

/// A 64th of the published texels of scattering.
PublishedSky reduced_sky(Storage storage = Storage::single, int orders = 4) {
  baseline::PublishedOptions options;
  options.sizes.scattering_r = 8;
  options.sizes.scattering_mu = 32;
  options.sizes.scattering_mu_s = 16;
  options.sizes.scattering_nu = 4;
  options.storage = storage;
  options.orders = orders;
  return PublishedSky(published_medium(), options);
}

Rgb zenith(const PublishedSky& sky, double sun_deg) {
  const Vec3 light = test::direction(0.0 * deg, sun_deg * deg);
  return sky.radiance(observer_km, light, {0.0F, 0.0F, 1.0F});
}

TEST(PublishedMapping, TexelsComeBack) {
  const baseline::TableSizes sizes;
  baseline::Shell shell{6360.0F, 6460.0F, 0.0F};
  shell.sun_span = baseline::sun_span_revised(shell, -0.5F);
  test::ErrorSum transmittance;
  test::ErrorSum irradiance;
  test::ErrorSum scattering;
  test::ErrorSum view;
  for (int r = 0; r < sizes.transmittance_r; ++r) {
    for (int mu = 0; mu < sizes.transmittance_mu; ++mu) {
      const baseline::TransmittanceTexel texel{static_cast<float>(mu), static_cast<float>(r)};
      const auto back = transmittance_texel(shell, sizes, transmittance_ray(shell, sizes, texel));
      transmittance.add(std::hypot(back.mu - texel.mu, back.r - texel.r));
    }
  }
  for (int r = 0; r < sizes.irradiance_r; ++r) {
    for (int mu_s = 0; mu_s < sizes.irradiance_mu_s; ++mu_s) {
      const baseline::IrradianceTexel texel{static_cast<float>(mu_s), static_cast<float>(r)};
      const auto sun = irradiance_sun(shell, sizes, texel);
      const auto back = irradiance_texel(shell, sizes, sun.r, sun.mu_s);
      irradiance.add(std::hypot(back.mu_s - texel.mu_s, back.r - texel.r));
    }
  }
  for (int r = 0; r < sizes.scattering_r; ++r) {
    for (int mu = 0; mu < sizes.scattering_mu; ++mu) {
      for (int mu_s = 0; mu_s < sizes.scattering_mu_s; ++mu_s) {
        const baseline::ScatteringTexel texel{static_cast<float>(r), static_cast<float>(mu), static_cast<float>(mu_s),
                                              3.0F};
        const auto place = scattering_place(shell, sizes, texel);
        EXPECT_EQ(place.meets_ground, mu < sizes.scattering_mu / 2);
        const auto back = scattering_texel(shell, sizes, place);
        EXPECT_GE(place.mu_s, -0.5F - 1.0e-5F);
        scattering.add(std::hypot(back.r - texel.r, back.mu_s - texel.mu_s));
        // On the ground all rays that meet it do so at once, at the top those that do not leave at once.
        if (r > 0 && r < sizes.scattering_r - 1) {
          view.add(back.mu - texel.mu);
        }
      }
    }
  }
  transmittance.hold("published mapping of transmittance, there and back in floats", 0.05, "texels");
  irradiance.hold("published mapping of irradiance, there and back in floats", 0.05, "texels");
  scattering.hold("published mapping of scattering, there and back in floats", 0.05, "texels");
  // Near the horizon the distance to the edge is a difference of squares of thousands of kilometres: with floats a flaw
  // of the method.
  view.hold("published mapping of the view's direction, there and back in floats", 2.5, "texels");
  EXPECT_LT(view.rms(), 0.1);
}

TEST(PublishedBaseline, ZenithByDay) {
  const PublishedSky sky = reduced_sky();
  const std::string path = std::string(VESPER_TEST_DATA) + "/atmosphere/sky_zenith_radiance.csv";
  const CsvTable table(read_file(path), path);
  test::ErrorSum high;
  test::ErrorSum low;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const test::TruthRow row(table, i);
    const double sun_deg = row.number("sun_elevation_deg");
    for (std::size_t k = 0; k < 3; ++k) {
      if (row.number("channel_nm") == wavelengths_nm[k] && sun_deg >= 0.0) {
        const double ratio = static_cast<double>(zenith(sky, sun_deg)[static_cast<int>(k)]) / row.number("total");
        (sun_deg >= 10.0 ? high : low).add(100.0 * (ratio - 1.0));
      }
    }
  }
  high.hold("zenith of the published tables at a 64th of their size, Sun above 10 degrees", 10.0, "%");
  low.hold("zenith of the published tables at a 64th of their size, Sun at 0 to 5 degrees", 20.0, "%");
}

TEST(PublishedBaseline, OneOrderIsSingleScattering) {
  const Medium air = published_medium();
  const PublishedSky sky = reduced_sky(Storage::single, 1);
  test::ErrorSum error;
  for (const double sun_deg : {60.0, 30.0, 10.0, 2.0}) {
    const SkyQuery query{static_cast<double>(observer_km) * kilometre, test::direction(0.0 * deg, sun_deg * deg),
                         0.0 * deg, Vec3(0.0, 0.0, 1.0)};
    const SingleScattering exact = single_scattering(air, query, {680.0, 550.0, 440.0});
    for (std::size_t k = 0; k < 3; ++k) {
      error.add(100.0 * (static_cast<double>(zenith(sky, sun_deg)[static_cast<int>(k)]) / exact.radiance[k] - 1.0));
    }
  }
  error.hold("first order of the published tables at a 64th of their size", 10.0, "%");
}

TEST(PublishedBaseline, OrdersDecrease) {
  std::vector<PublishedSky> skies;
  for (int orders = 1; orders <= 4; ++orders) {
    skies.push_back(reduced_sky(Storage::single, orders));
  }
  for (const double sun_deg : {60.0, 10.0, 0.0}) {
    for (int k = 0; k < 3; ++k) {
      float previous = zenith(skies[0], sun_deg)[k];
      for (std::size_t order = 1; order < skies.size(); ++order) {
        const float added = zenith(skies[order], sun_deg)[k] - zenith(skies[order - 1], sun_deg)[k];
        EXPECT_GT(added, 0.0F) << sun_deg << " " << k << " order " << order + 1;
        EXPECT_LT(added, previous) << sun_deg << " " << k << " order " << order + 1;
        previous = added;
      }
    }
  }
}

TEST(PublishedBaseline, HalfFloatsEndInTwilight) {
  const PublishedSky sky = reduced_sky(Storage::half);
  EXPECT_GT(zenith(sky, 0.0).y, 0.0F);
  EXPECT_EQ(zenith(sky, -15.0), Rgb(0.0F));
}

} // namespace
} // namespace vesper
