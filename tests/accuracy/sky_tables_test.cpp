// The tables of the sky against the reference transport at all of the medium's wavelengths: for the Sun as they are,
// for the Moon through the matrix that turns one light's responses into another's.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/light/moonlight.hpp"
#include "vesper/light/response_matrix.hpp"
#include "vesper/light/spectral_weights.hpp"
#include "vesper/light/sunlight.hpp"

#include "support/thorough.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace vesper {
namespace {

constexpr Angle light_radius = 0.2666 * deg;

struct SkySpan {
  std::string name;
  std::vector<double> lights_deg;
  double reference_error;
  double luminance_limit;   ///< RMS over the sky, %
  double illuminance_limit; ///< %
  bool colour;              ///< whether chromaticity is held
};

/// The limits are what the tables are for; the reference's own errors count as theirs.
const std::vector<SkySpan> sky_spans{{"above 0 degrees", {62.0, 17.0, 4.0, 0.6}, 0.008, 2.0, 2.0, true},
                                     {"0 to -6 degrees", {-0.4, -2.3, -4.1, -5.9}, 0.012, 5.0, 5.0, true},
                                     {"-6 to -12 degrees", {-7.2, -9.4, -11.8}, 0.025, 10.0, 15.0, false},
                                     {"-12 to -18 degrees", {-14.3, -17.6}, 0.06, 25.0, 25.0, false}};

/// A light's weights at the transport's wavelengths, for 1 lux of it outside the air.
struct Light {
  explicit Light(const Spectrum& irradiance, const std::vector<double>& wavelengths_nm)
      : weights(spectral_weights(irradiance, wavelengths_nm)),
        lux(weights(std::vector<double>(wavelengths_nm.size(), 1.0)).y),
        from_sun(response_matrix(solar_irradiance_1au(), irradiance)) {}
  SpectralWeights weights;
  double lux;
  Mat4 from_sun;
};

Xyzs responses(const TransportResult& result, std::size_t first, double lux) {
  const auto mean = [&](std::size_t i) { return result.functionals[first + i].mean / lux; };
  return {mean(0), mean(1), mean(2), mean(3)};
}

/// What is compared for one light.
struct Sums {
  double squares = 0.0;
  int count = 0;
  test::ErrorSum colour;

  void add(const Xyzs& found, const Xyzs& exact) {
    const double error = found.y / exact.y - 1.0;
    squares += error * error;
    ++count;
    const Chromaticity a = chromaticity(found);
    const Chromaticity b = chromaticity(exact);
    colour.add(a.x - b.x);
    colour.add(a.y - b.y);
  }
  void hold(const std::string& what, const SkySpan& span) const {
    test::ErrorSum luminance;
    luminance.add(100.0 * std::sqrt(squares / count));
    luminance.hold(what + ": RMS of the luminance over the sky", span.luminance_limit, "%");
    if (span.colour) {
      colour.hold(what + ": chromaticity x, y", 0.01, "");
    }
  }
};

/// A medium's tables beside the reference.
class TablesComparison {
public:
  TablesComparison(const Medium& medium, std::string name)
      : name_(std::move(name)), tables_(make_sky_tables(medium)), reference_(medium, medium.wavelengths_nm),
        sun_(solar_irradiance_1au(), medium.wavelengths_nm),
        moon_(moon_irradiance(2.0 * deg, moon_mean_distance, 149597870.7 * kilometre), medium.wavelengths_nm) {
    for (const Light* light : {&sun_, &moon_}) {
      functionals_.insert(functionals_.end(), {light->weights.x, light->weights.y, light->weights.z, light->weights.s});
    }
  }

  void sky() {
    for (const SkySpan& span : sky_spans) {
      Sums sun;
      Sums moon;
      for (const double light : span.lights_deg) {
        for (const double height_km : {0.0, 2.4, 11.0}) {
          for (int i = 0; i < (test::thorough() ? 16 : 3); ++i) {
            const Vec2 place = draw();
            add(query(light, height_km, 1.0 + 89.0 * std::pow(place.x, 1.5), 360.0 * place.y), span.reference_error,
                sun, moon);
          }
        }
      }
      sun.hold(name_ + ", Sun " + span.name, span);
      moon.hold(name_ + ", full Moon " + span.name, span);
    }
  }

  void ground_from_above() {
    for (const SkySpan& span : sky_spans) {
      Sums sun;
      Sums moon;
      for (const double light : span.lights_deg) {
        for (int i = 0; i < (test::thorough() ? 16 : 3); ++i) {
          const Vec2 place = draw();
          // From the horizon, 3.4 degrees down, to the nadir.
          add(query(light, 11.0, -3.6 - 86.0 * place.x, 360.0 * place.y), span.reference_error, sun, moon);
        }
      }
      sun.hold(name_ + ", ground from 11 km, Sun " + span.name, span);
      moon.hold(name_ + ", ground from 11 km, full Moon " + span.name, span);
    }
  }

  void illuminance() {
    for (const SkySpan& span : sky_spans) {
      test::ErrorSum errors;
      for (const double light : span.lights_deg) {
        const SkyQuery level = query(light, 0.0, 90.0, 0.0);
        const TransportResult diffuse =
            reference_.diffuse_irradiance(level, functionals_, budget(span.reference_error));
        const double exact =
            (diffuse.functionals[1].mean + sun_.weights(reference_.direct_irradiance(level)).y) / sun_.lux;
        const f32::vec4 found = f32::sky_ground_illuminance(
            line_sampler(tables_.ground), transmittance_sampler(tables_), tables_.light,
            static_cast<float>((light * deg).to(rad)), static_cast<float>(light_radius.to(rad)),
            tables_.transmittance_frame, tables_.frame);
        errors.add(100.0 * (static_cast<double>(found.y) / exact - 1.0));
      }
      errors.hold(name_ + ", Sun " + span.name + ": illuminance of level ground", span.illuminance_limit, "%");
    }
  }

private:
  /// Places that fill the unit square evenly (Roberts 2018's sequence after the plastic number).
  Vec2 draw() {
    ++draws_;
    return {std::fmod(0.5 + 0.7548776662 * draws_, 1.0), std::fmod(0.5 + 0.5698402910 * draws_, 1.0)};
  }

  static SkyQuery query(double light_deg, double height_km, double altitude_deg, double azimuth_deg) {
    return {height_km * kilometre, test::direction(0.0 * deg, light_deg * deg), light_radius,
            test::direction(azimuth_deg * deg, altitude_deg * deg)};
  }

  PathBudget budget(double relative_error) {
    PathBudget result;
    result.relative_error = relative_error;
    result.least_paths = 2048;
    result.stream = ++stream_;
    return result;
  }

  void add(const SkyQuery& query, double reference_error, Sums& sun, Sums& moon) {
    const TransportResult exact = reference_.radiance(query, functionals_, budget(reference_error));
    const Xyzs found = sky_luminance(tables_, query);
    sun.add(found, responses(exact, 0, sun_.lux));
    const Vec4 by_moon = moon_.from_sun * vector_of(found);
    moon.add({by_moon.x, by_moon.y, by_moon.z, by_moon.w}, responses(exact, 4, moon_.lux));
  }

  std::string name_;
  SkyTables tables_;
  ReferenceTransport reference_;
  Light sun_;
  Light moon_;
  std::vector<SpectralFunctional> functionals_;
  std::uint64_t stream_ = 0;
  int draws_ = 0;
};

TEST(SkyTables, ClearAirAgainstTheReference) {
  TablesComparison clear(clear_medium(), "clear");
  clear.sky();
  clear.ground_from_above();
  clear.illuminance();
}

TEST(SkyTables, PublishedMediumAgainstTheReference) {
  TablesComparison published(published_medium(), "published");
  published.sky();
  published.ground_from_above();
  published.illuminance();
}

} // namespace
} // namespace vesper
