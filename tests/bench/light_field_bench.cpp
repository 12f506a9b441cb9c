// What a sky of all orders costs: the published algorithm, and the light field with tables of as many texels filled
// from it. CSV, in processor time of one run.
#include "baselines/published_sky.hpp"

#include "vesper/atmosphere/light_field.hpp"
#include "vesper/atmosphere/medium_presets.hpp"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <numbers>
#include <string>
#include <vector>

namespace vesper {
namespace {

/// Of all threads together: what else runs on the machine does not count.
double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// One in `thinning` of a table's rays is filled, and its cost multiplied.
double fill_s(const LightField& field, const SampledAir& air, const baseline::TableSizes& sizes) {
  constexpr int thinning = 8;
  const double begin = processor_s();
  float sum = 0.0F;
  for (int i = 0; i < sizes.scattering_r; ++i) {
    const double share = static_cast<double>(i) / (sizes.scattering_r - 1);
    const double radius_km = air.ground_km() + (air.top_km() - air.ground_km()) * share * share;
    for (int j = i % thinning; j < sizes.scattering_mu; j += thinning) {
      const LightField::ViewRay ray =
          field.view_ray(radius_km, std::cos(std::numbers::pi * (j + 0.5) / sizes.scattering_mu));
      for (int k = 0; k < sizes.scattering_mu_s; ++k) {
        const double cos_light = std::cos(108.0 * std::numbers::pi / 180.0 * k / (sizes.scattering_mu_s - 1));
        for (int n = 0; n < sizes.scattering_nu; ++n) {
          const double cos_azimuth = std::cos(std::numbers::pi * n / (sizes.scattering_nu - 1));
          sum += field.light(ray, cos_light, cos_azimuth, 0.2666 * deg).other[0];
        }
      }
    }
  }
  // The sum keeps the work from being left out.
  return sum > 0.0F ? thinning * (processor_s() - begin) : 0.0;
}

void measure(const Medium& medium, const char* name, const std::vector<double>& wavelengths_nm) {
  const SampledAir air(medium);
  const SpectralAir optics(medium, wavelengths_nm);
  const double begin = processor_s();
  const LightField field(air, optics);
  const double solve_s = processor_s() - begin;
  const double rest_s = fill_s(field, air, baseline::TableSizes{});
  std::printf("light field,%s,%zu,%d,%.4f,%.2f,%.2f,%.2f\n", name, wavelengths_nm.size(), field.orders(), field.rest(),
              solve_s, rest_s, solve_s + rest_s);
}

void run() {
  std::puts("method,medium,wavelengths,orders,rest,solve_s,fill_s,total_s");
  const Medium published = published_medium();
  const double begin = processor_s();
  const baseline::PublishedSky sky(published);
  std::printf("published,published,3,%d,,,,%.2f\n", baseline::PublishedOptions{}.orders, processor_s() - begin);
  measure(published, "published", {440.0, 550.0, 680.0});
  const Medium clear = clear_medium();
  for (const std::size_t count : {4U, 8U, 12U, 16U}) {
    std::vector<double> wavelengths_nm(count);
    for (std::size_t i = 0; i < count; ++i) {
      wavelengths_nm[i] = 400.0 + 300.0 * static_cast<double>(i) / static_cast<double>(count - 1);
    }
    measure(clear, "clear", wavelengths_nm);
  }
}

} // namespace
} // namespace vesper

int main() {
  try {
    vesper::run();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_light_field: %s\n", error.what());
    return 1;
  }
}
