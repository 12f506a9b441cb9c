// The measured part of docs/SKY_TABLES.md, as Markdown: how few wavelengths and texels the tables of the sky need, and
// what other ways of laying them out would give. Errors are those against the light field that all are filled from.
#include "baselines/mapped_sky.hpp"
#include "baselines/sky_mapping.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/atmosphere/spectral_rule.hpp"
#include "vesper/light/sunlight.hpp"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace vesper {
namespace {

using baseline::Between;
using baseline::MappedSky;
using baseline::SkyMapping;
using baseline::SkyPlace;
using std::numbers::pi;
using vec4 = f32::vec4;

constexpr Angle light_radius = 0.2666 * deg;

/// Of all threads together: what else runs on the machine does not count.
double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

vec4 to_vec4(const Xyzs& light) {
  return {static_cast<float>(light.x), static_cast<float>(light.y), static_cast<float>(light.z),
          static_cast<float>(light.s)};
}

/// Relative errors of X, Y, Z and S.
class Errors {
public:
  void add(const vec4& found, const vec4& exact) {
    for (int i = 0; i < 4; ++i) {
      const double error = static_cast<double>(found[i]) / static_cast<double>(exact[i]) - 1.0;
      squares_ += error * error;
      worst_ = std::max(worst_, std::abs(error));
      ++count_;
    }
  }
  [[nodiscard]] double rms_percent() const { return 100.0 * std::sqrt(squares_ / count_); }
  [[nodiscard]] double worst_percent() const { return 100.0 * worst_; }

private:
  double squares_ = 0.0;
  double worst_ = 0.0;
  int count_ = 0;
};

constexpr std::array<double, 5> span_ends_deg{90.0, 0.0, -6.0, -12.0, -18.0};
constexpr std::size_t spans = span_ends_deg.size() - 1;
/// Of the observer: near the ground, in an aircraft, where meteors burn.
constexpr std::size_t regions = 3;
constexpr std::array<double, 4> heights_km{0.0, 2.4, 11.0, 60.0};
constexpr std::array<std::size_t, 4> region_of_height{0, 0, 1, 2};

struct Query {
  SkyPlace place;
  std::size_t span;
  std::size_t region;
  vec4 exact;
};

/// The light field of a medium, and questions with their answers.
class Judge {
public:
  explicit Judge(const Medium& medium)
      : rule_(spectral_rule(medium, solar_irradiance_1au(), 8)), air_(medium), optics_(medium, rule_.wavelengths_nm),
        field_(air_, optics_), phase_(make_phase()) {
    lux_ = rule_.weights(std::vector<double>(optics_.size(), 1.0)).y;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (std::size_t span = 0; span < spans; ++span) {
      for (std::size_t height = 0; height < heights_km.size(); ++height) {
        for (int i = 0; i < 400; ++i) {
          const double dip = std::acos(air_.ground_km() / (air_.ground_km() + heights_km[height]));
          const bool below = region_of_height[height] > 0 && i % 2 == 0;
          // Half of the views lie within a fourth of the way from the horizon to zenith or nadir.
          const double share = std::pow(uniform(random), 2.0);
          const double view = below ? -dip - share * (0.5 * pi - dip) : -dip + share * (0.5 * pi + dip);
          const double light = std::lerp(span_ends_deg[span + 1], span_ends_deg[span], uniform(random)) * pi / 180.0;
          const SkyPlace place{heights_km[height], view, below, light, std::cos(pi * uniform(random))};
          const LightField::RayLight exact =
              field_.light(baseline::view_ray(field_, air_, place), std::sin(light), place.cos_azimuth, light_radius);
          queries_.push_back(
              {place, span, region_of_height[height], responses(exact.single_aerosol) + responses(exact.other)});
        }
      }
    }
  }

  [[nodiscard]] vec4 responses(const LightField::Spectrum& light) const {
    Xyzs sum;
    for (std::size_t l = 0; l < optics_.size(); ++l) {
      const double value = static_cast<double>(light[l]) / lux_;
      sum = {sum.x + rule_.weights.x[l] * value, sum.y + rule_.weights.y[l] * value, sum.z + rule_.weights.z[l] * value,
             sum.s + rule_.weights.s[l] * value};
    }
    return to_vec4(sum);
  }
  [[nodiscard]] const std::vector<Query>& queries() const { return queries_; }
  [[nodiscard]] MappedSky table(const SkyMapping& mapping) const {
    return {mapping, field_, air_, [this](const auto& light) { return responses(light); },
            [this](double cos_angle) { return phase_(cos_angle); }};
  }
  [[nodiscard]] const SampledAir& air() const { return air_; }

private:
  [[nodiscard]] std::function<double(double)> make_phase() const {
    for (std::size_t c = 0; c < air_.component_count(); ++c) {
      if (optics_.phase_kind(c) != PhaseKind::rayleigh) {
        return [this, c](double cos_angle) { return optics_.phase(c, optics_.size() / 2, cos_angle); };
      }
    }
    return [](double) { return 0.25 / pi; };
  }

  SpectralRule rule_;
  SampledAir air_;
  SpectralAir optics_;
  LightField field_;
  std::function<double(double)> phase_;
  double lux_ = 1.0;
  std::vector<Query> queries_;
};

/// The row of a table of errors: RMS by span of the light's altitude and region.
template <class Lookup> void print_row(const Judge& judge, const std::string& name, const Lookup& lookup) {
  std::array<std::array<Errors, regions>, spans> errors;
  for (const Query& query : judge.queries()) {
    errors[query.span][query.region].add(lookup(query.place), query.exact);
  }
  std::printf("| %s |", name.c_str());
  for (const auto& span : errors) {
    std::printf(" %.3g, %.3g, %.3g |", span[0].rms_percent(), span[1].rms_percent(), span[2].rms_percent());
  }
  std::printf("\n");
  std::fflush(stdout);
}

void print_head(const char* what) {
  std::printf("| %s | above 0 degrees | 0 to -6 | -6 to -12 | -12 to -18 |\n|---|---|---|---|---|\n", what);
}

/// Our tables without the ground: with the library's interpolation, or linear in all of the places.
template <class Log2> vec4 looked_up(const SkyTables& tables, const SkyPlace& place, const Log2& log2) {
  const f32::SkyTableFrame& frame = tables.frame;
  const auto height = static_cast<float>(place.height_km);
  const auto altitude = static_cast<float>(place.view_rad);
  const f32::SkyViewPlace view = f32::sky_view_place(altitude, f32::sky_dip(height, frame), place.meets_ground, frame);
  const double cos_angle = std::sin(place.view_rad) * std::sin(place.light_rad) +
                           std::cos(place.view_rad) * std::cos(place.light_rad) * place.cos_azimuth;
  const float phase = f32::sky_aerosol_phase(line_sampler(tables.phase), static_cast<float>(cos_angle),
                                             static_cast<int>(tables.phase.size()));
  return f32::sky_path_share(height, altitude, place.meets_ground, frame) *
         (glm::exp2(log2(tables.other, view)) + phase * glm::exp2(log2(tables.aerosol, view)));
}

vec4 cubic(const SkyTables& tables, const SkyPlace& place) {
  return looked_up(tables, place, [&](const auto& texels, const f32::SkyViewPlace& view) {
    return f32::sky_table_log2(sampler(tables, texels), static_cast<float>(place.height_km), view,
                               static_cast<float>(place.light_rad), static_cast<float>(place.cos_azimuth),
                               tables.frame);
  });
}

vec4 linear(const SkyTables& tables, const SkyPlace& place) {
  return looked_up(tables, place, [&](const auto& texels, const f32::SkyViewPlace& view) {
    const f32::SkyTableFrame& frame = tables.frame;
    const f32::sampler3D table = sampler(tables, texels);
    const std::array<float, 4> at{f32::sky_height_place(static_cast<float>(place.height_km), frame), view.place,
                                  f32::sky_light_place(static_cast<float>(place.light_rad), frame),
                                  static_cast<float>(std::acos(place.cos_azimuth) / pi * (f32::sky_azimuths - 1))};
    const std::array<int, 4> counts{frame.heights, view.rows, frame.lights, f32::sky_azimuths};
    vec4 sum(0.0F);
    for (unsigned corner = 0; corner < 16; ++corner) {
      float weight = 1.0F;
      std::array<int, 4> node{};
      for (std::size_t axis = 0; axis < 4; ++axis) {
        const int low = std::min(static_cast<int>(at[axis]), counts[axis] - 2);
        const float fraction = at[axis] - static_cast<float>(low);
        const bool up = ((corner >> axis) & 1U) != 0;
        node[axis] = up ? low + 1 : low;
        weight *= up ? fraction : 1.0F - fraction;
      }
      sum += weight *
             f32::texelFetch(table, {node[3] + f32::sky_azimuths * node[2], view.first_row + node[1], node[0]}, 0);
    }
    return sum;
  });
}

template <class Round> SkyTables rounded(SkyTables tables, const Round& round) {
  for (auto* texels : {&tables.aerosol, &tables.other}) {
    for (vec4& texel : *texels) {
      texel = {round(texel.x), round(texel.y), round(texel.z), round(texel.w)};
    }
  }
  return tables;
}

std::string size_name(const SkyTables& tables) {
  char text[80];
  const f32::SkyTableFrame& frame = tables.frame;
  std::snprintf(text, sizeof text, "%d x (%d + %d) x %d x %d, %.0f MiB", frame.heights, frame.views_below,
                frame.views_above, frame.lights, f32::sky_azimuths,
                static_cast<double>(2 * tables.other.size() * sizeof(vec4)) / (1024.0 * 1024.0));
  return text;
}

void compare_wavelengths(const Medium& medium) {
  const SampledAir air(medium);
  const SpectralAir optics(medium, medium.wavelengths_nm);
  const LightField field(air, optics, {16, 12, 6, 10, 5, 0.25, 0.5, 0.02, 8});
  std::vector<std::pair<std::size_t, std::vector<double>>> spectra;
  for (std::size_t span = 0; span < spans; ++span) {
    for (int i = 0; i < 6; ++i) {
      const double light = std::lerp(span_ends_deg[span + 1], span_ends_deg[span], (i + 0.5) / 6.0) * pi / 180.0;
      for (const double height_km : heights_km) {
        for (const double view_deg : {90.0, 30.0, 8.0, 1.0}) {
          for (const double azimuth_deg : {0.0, 90.0, 180.0}) {
            const double view = view_deg * pi / 180.0;
            const double azimuth = azimuth_deg * pi / 180.0;
            spectra.emplace_back(span, field.radiance({height_km * kilometre,
                                                       {std::cos(light), 0.0, std::sin(light)},
                                                       light_radius,
                                                       {std::cos(view) * std::cos(azimuth),
                                                        std::cos(view) * std::sin(azimuth), std::sin(view)}}));
          }
        }
      }
    }
  }
  const Spectrum& sun = solar_irradiance_1au();
  const SpectralWeights exact = spectral_weights(sun, medium.wavelengths_nm);
  const auto print = [&](const std::string& name, const std::vector<double>& nm, const SpectralWeights& weights) {
    std::array<Errors, spans> errors;
    for (const auto& [span, spectrum] : spectra) {
      const Spectrum fine(medium.wavelengths_nm, spectrum);
      std::vector<double> few;
      std::transform(nm.begin(), nm.end(), std::back_inserter(few), fine);
      errors[span].add(to_vec4(weights(few)), to_vec4(exact(spectrum)));
    }
    std::printf("| %zu %s |", nm.size(), name.c_str());
    for (const Errors& span : errors) {
      std::printf(" %.2g, %.2g |", span.rms_percent(), span.worst_percent());
    }
    std::printf("\n");
  };
  print_head("wavelengths");
  for (const std::size_t count : {4U, 8U, 12U, 16U}) {
    std::vector<double> even;
    for (std::size_t i = 0; i < count; ++i) {
      even.push_back(400.0 + 300.0 * static_cast<double>(i) / static_cast<double>(count - 1));
    }
    print("even, 400 to 700 nm, linear between", even, spectral_weights(sun, even));
    const SpectralRule rule = spectral_rule(medium, sun, count);
    print("chosen and fitted", rule.wavelengths_nm, rule.weights);
  }
}

void compare_mappings(const Judge& judge) {
  const double ground = judge.air().ground_km();
  const double top = judge.air().top_km();
  std::vector<std::unique_ptr<SkyMapping>> mappings;
  mappings.push_back(baseline::bruneton_mapping(ground, top, {16, 96, 32, 8}, false));
  mappings.push_back(baseline::bruneton_mapping(ground, top, {16, 96, 32, 8}, true));
  mappings.push_back(baseline::power_mapping(ground, top, {16, 48, 64, 8}, 1.0));
  mappings.push_back(baseline::power_mapping(ground, top, {16, 48, 64, 8}, 2.0));
  mappings.push_back(baseline::weighted_power_mapping(ground, top, {16, 48, 64, 8}));
  for (const auto& mapping : mappings) {
    const MappedSky sky = judge.table(*mapping);
    print_row(judge, mapping->name() + ", values", [&](const SkyPlace& p) { return sky.light(p, Between::values); });
    print_row(judge, mapping->name() + ", logarithms",
              [&](const SkyPlace& p) { return sky.light(p, Between::logarithms); });
  }
}

struct Cost {
  double fill_s;
  double look_up_us;
};

Cost compare_sizes(const Judge& judge, const Medium& medium) {
  Cost cost{};
  const double start = processor_s();
  const SkyTables tables = make_sky_tables(medium);
  cost.fill_s = processor_s() - start;
  const double begin = processor_s();
  const auto ours = [&](const SkyPlace& place) { return cubic(tables, place); };
  print_row(judge, size_name(tables) + ", **ours**", ours);
  cost.look_up_us = 1.0e6 * (processor_s() - begin) / static_cast<double>(judge.queries().size());
  print_row(judge, "the same, linear between nodes", [&](const SkyPlace& place) { return linear(tables, place); });
  // Logarithms from -64 to 64.
  const SkyTables fixed = rounded(tables, [](float x) { return std::max(std::round(x * 512.0F) / 512.0F, -64.0F); });
  print_row(judge, "the same, in 16 bits, fixed point", [&](const SkyPlace& place) { return cubic(fixed, place); });
  const SkyTables half = rounded(tables, [](float x) { return glm::unpackHalf1x16(glm::packHalf1x16(x)); });
  print_row(judge, "the same, in half floats", [&](const SkyPlace& place) { return cubic(half, place); });
  for (const SkyTableSize& size : {SkyTableSize{16, 12, 20, 48}, SkyTableSize{24, 24, 40, 64}}) {
    const SkyTables other = make_sky_tables(medium, size);
    print_row(judge, size_name(other), [&](const SkyPlace& place) { return cubic(other, place); });
  }
  return cost;
}

void print_page() {
  const Medium medium = clear_medium();
  std::puts("## Wavelengths\nX, Y, Z and S of the sky at a few wavelengths against all 48 of `clear`, RMS and worst in "
            "%, by altitude of the\nlight, from heights of 0 to 60 km. The tables are made with eight.\n");
  compare_wavelengths(medium);
  const Judge judge(medium);
  std::puts("\n## Mappings at equal memory\nRMS in % of X, Y, Z and S from the ground (0 and 2.4 km), 11 km, 60 km; "
            "half of the views near the horizon, 393216\ntexels. Bruneton's mapping and those of Atmosphere Plus hold "
            "light over the phase function of what scattered it,\nlinear between nodes in the value as published, or "
            "in its logarithm.\n");
  print_head("mapping");
  compare_mappings(judge);
  std::puts("\n## Sizes and formats\nThe same errors of our tables; heights x (views below + above the horizon) x "
            "altitudes of the light x azimuths.\n");
  print_head("table");
  const Cost cost = compare_sizes(judge, medium);
  std::printf(
      "\nFrom nothing the tables of `clear` take %.1f s of one core's time; a look-up on the CPU, from any height "
      "into\nany direction, %.1f microseconds.\n",
      cost.fill_s, cost.look_up_us);
}

} // namespace
} // namespace vesper

int main() {
  try {
    vesper::print_page();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_sky_tables: %s\n", error.what());
    return 1;
  }
}
