// The light field solved by compute shaders against the same on the processor.
#include "render/render_fixture.hpp"

#include "vesper/atmosphere/light_field.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/gpu/light_gatherer.hpp"

#include "support/truth.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace vesper::test {
namespace {

using LightFieldGpu = RenderTest;

constexpr LightFieldSize small{8, 10, 4, 8, 3, 0.3, 1.0, 0.1, 4};

void compare(const gpu::ShaderLibrary& shaders, const Medium& medium, const std::vector<double>& wavelengths_nm,
             const std::string& name) {
  const SampledAir air(medium);
  const SpectralAir optics(medium, wavelengths_nm);
  const LightFieldModel model(air, optics, small, 0);
  ThreadedLightGatherer threads(model, 0);
  gpu::GpuLightGatherer shader(shaders, model);
  const LightFieldSolution expected = solve_light_field(model, threads, 0);
  const LightFieldSolution solution = solve_light_field(model, shader, 0);
  EXPECT_EQ(solution.orders, expected.orders);

  // Where there is light to speak of: a Sun below -18 degrees leaves 1e-10 in the zenith.
  constexpr float least_log2 = -36.0F;
  ErrorSum radiance;
  ErrorSum shape;
  const std::size_t blocks = model.blocks();
  for (std::size_t k = 0; k < expected.tables.field.size(); ++k) {
    const std::size_t moment = k / blocks % f32::field_moments;
    const std::size_t mean = k - moment * blocks;
    for (std::size_t i = 0; i < Lanes::size && k % blocks * Lanes::size + i < optics.size(); ++i) {
      if (expected.tables.field[mean][i] > least_log2) {
        const auto difference = static_cast<double>(solution.tables.field[k][i] - expected.tables.field[k][i]);
        moment == 0 ? radiance.add(std::exp2(difference) - 1.0) : shape.add(difference);
      }
    }
  }
  ErrorSum sources;
  for (std::size_t k = 0; k < expected.tables.sources.size(); ++k) {
    for (std::size_t i = 0; i < Lanes::size && k % blocks * Lanes::size + i < optics.size(); ++i) {
      if (expected.tables.sources[k][i] > least_log2) {
        sources.add(std::exp2(static_cast<double>(solution.tables.sources[k][i] - expected.tables.sources[k][i])) -
                    1.0);
      }
    }
  }
  radiance.hold(name + ": mean radiance at the nodes, relative", 1.0e-4, "");
  shape.hold(name + ": its second moments", 1.0e-4, "");
  if (model.source_heights() > 0) {
    sources.hold(name + ": aerosol's sources, relative", 1.0e-4, "");
  }

  const LightField one(model, expected);
  const LightField other(model, solution);
  ErrorSum sky;
  for (const double sun : {60.0, 5.0, -1.0, -6.0, -12.0}) {
    for (const double altitude : {90.0, 20.0, 2.0, -10.0}) {
      const SkyQuery query{0.5 * kilometre, direction(0.0 * deg, sun * deg), 0.2666 * deg,
                           direction(50.0 * deg, altitude * deg)};
      const std::vector<double> a = one.radiance(query);
      const std::vector<double> b = other.radiance(query);
      for (std::size_t l = 0; l < a.size(); ++l) {
        ASSERT_GT(a[l], 0.0);
        sky.add(b[l] / a[l] - 1.0);
      }
    }
  }
  sky.hold(name + ": radiance of the sky, relative", 1.0e-4, "");
}

TEST_F(LightFieldGpu, AgreesWithTheProcessor) {
  // Two blocks of wavelengths, the second not full.
  compare(shaders, clear_medium(), {420.0, 470.0, 530.0, 600.0, 680.0}, "clear");
  compare(shaders, published_medium(), {440.0, 550.0, 680.0}, "published");
}

TEST_F(LightFieldGpu, AirWithoutAerosol) {
  Medium medium = published_medium();
  medium.components.erase(medium.components.begin() + 1);
  compare(shaders, medium, {440.0}, "molecules alone");
}

TEST_F(LightFieldGpu, TablesOfTheSky) {
  const SkyTableSize size{3, 2, 4, 12, small};
  const SkyTables expected = make_sky_tables(published_medium(), size);
  const SkyTables tables = make_sky_tables(published_medium(), size, 0, {}, [this](const LightFieldModel& model) {
    gpu::GpuLightGatherer gatherer(shaders, model);
    return solve_light_field(model, gatherer, 0);
  });
  ErrorSum errors;
  for (std::size_t k = 0; k < expected.other.size(); ++k) {
    for (int i = 0; i < 4; ++i) {
      // Logarithms to base 2 of luminance; below, twilight is over.
      if (expected.other[k][i] > -30.0F) {
        errors.add(std::exp2(static_cast<double>(tables.other[k][i] - expected.other[k][i])) - 1.0);
      }
    }
  }
  errors.hold("tables of the sky from the GPU's light field, relative", 1.0e-4, "");
}

} // namespace
} // namespace vesper::test
