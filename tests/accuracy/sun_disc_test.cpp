// The Sun's disc and corona against published figures and integrals.
#include "support/sun_seen.hpp"
#include "support/truth.hpp"

#include "vesper/base/gauss_legendre.hpp"
#include "vesper/light/corona.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/corona_streamers.hpp"
#include "vesper/sky/eclipse_light.hpp"
#include "vesper/sky/sun_disc.hpp"

#include <numbers>

namespace vesper {
namespace {

using std::numbers::pi;
using test::ErrorSum;

constexpr std::array laws{LimbDarkening::neckel, LimbDarkening::hestroffer_magnan};

std::string name_of(LimbDarkening law) { return law == LimbDarkening::neckel ? "Neckel" : "Hestroffer and Magnan"; }

SunDisc sun_of(LimbDarkening law) {
  SunOptions options;
  options.law = law;
  return sun_disc(sky_state(parse_instant("2026-08-12T12:00:00Z"), {42.34 * deg, -3.70 * deg, 860.0 * metre}), options);
}

/// The shader's numbers for a disc that shines within 1 nm alone, of 1 lux.
f32::SunShading monochromatic(double nm, LimbDarkening law) {
  const std::array<Xyzs, limb_terms> terms = limb_xyzs({{nm - 1.0, nm, nm + 1.0}, {0.0, 1.0, 0.0}}, law);
  double whole = 0.0;
  for (std::size_t k = 0; k < limb_terms; ++k) {
    whole += terms.at(k).y * limb_powers(law).disc_mean(k);
  }
  f64::SunShading shading{};
  shading.lowest_power = limb_powers(law).lowest;
  shading.power_step = limb_powers(law).step;
  for (std::size_t k = 0; k < limb_terms; ++k) {
    shading.limb[k] = f64::vec4(terms.at(k).y / whole);
  }
  return in_single(shading);
}

/// Brightness over that at the centre, as the GPU finds it.
double shader_ratio(double nm, LimbDarkening law, double mu) {
  const f32::SunShading shading = monochromatic(nm, law);
  const auto r = static_cast<float>(std::sqrt(1.0 - mu * mu));
  return static_cast<double>(f32::sun_disc_luminance(r, shading).y) /
         static_cast<double>(f32::sun_disc_luminance(0.0F, shading).y);
}

constexpr std::array cosines{1.0, 0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1};

TEST(LimbDarkening, IsNeckels) {
  struct Row {
    double nm, power;
  };
  ErrorSum errors;
  for (const auto& [nm, power] : {Row{440.0, 0.652}, Row{550.0, 0.503}, Row{680.0, 0.397}}) {
    for (const double mu : cosines) {
      errors.add(100.0 * (shader_ratio(nm, LimbDarkening::neckel, mu) / std::pow(mu, power) - 1.0));
    }
    // 1 - u (1 - mu^a) has the mean 2 / (a + 2) for u = 1.
    EXPECT_NEAR(solar_disc_mean(nm, LimbDarkening::neckel), 2.0 / (power + 2.0), 1e-12);
  }
  errors.hold("limb darkening of the shader at 440, 550 and 680 nm, mu 0.1 to 1, against Neckel's law", 1.0, "%");
}

TEST(LimbDarkening, IsHestrofferAndMagnans) {
  // Coefficients for three colours as renderers print them, with the wavelengths they were measured at.
  struct Row {
    double nm;
    double a[6];
  };
  const Row rows[] = {{669.40, {0.34685, 1.37539, -2.04425, 2.70493, -1.94290, 0.55999}},
                      {541.76, {0.26073, 1.27428, -1.30352, 1.47085, -0.96618, 0.26384}},
                      {445.125, {0.15248, 1.38517, -1.49615, 1.99886, -1.48155, 0.44119}}};
  ErrorSum errors;
  for (const Row& row : rows) {
    for (const double mu : cosines) {
      double law = 0.0;
      for (int k = 5; k >= 0; --k) {
        law = row.a[k] + mu * law;
      }
      // 2 nm of the table's 12 and more beside the row are in the shader's light.
      errors.add(100.0 * (shader_ratio(row.nm, LimbDarkening::hestroffer_magnan, mu) / law - 1.0));
    }
  }
  errors.hold("limb darkening of the shader at 669, 542 and 445 nm, mu 0.1 to 1, against Hestroffer and Magnan's law",
              1.0, "%");
}

TEST(LimbDarkening, IsThatOfTheHandbook) {
  // At 550 nm 0.3 + 0.93 mu - 0.23 mu^2: Cox 2000, Allen's Astrophysical Quantities, 4th edition, sec. 14.7.
  // Power laws fall below it near the limb.
  for (const LimbDarkening law : laws) {
    const double last = law == LimbDarkening::neckel ? 0.3 : 0.1;
    ErrorSum errors;
    for (const double mu : cosines) {
      if (mu >= last) {
        errors.add(shader_ratio(550.0, law, mu) - (0.3 + 0.93 * mu - 0.23 * mu * mu));
      }
    }
    errors.hold("limb darkening at 550 nm after " + name_of(law) + " against a handbook's, mu " +
                    (last > 0.2 ? "0.3" : "0.1") + " to 1",
                0.015, "of the centre");
  }
}

TEST(LimbDarkening, HasTheMeasuredMeans) {
  // Neckel and Labs 1994 give the disc's mean too; that of 365.875 nm does not go with their polynomial.
  const std::string path = std::string(VESPER_SOURCE_DIR) + "/data/limb_darkening_neckel_labs_1994.csv";
  const CsvTable table(read_file(path), path);
  ErrorSum errors;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const double nm = table.number(row, table.column("wavelength_nm"));
    if (nm != 365.875) {
      errors.add(solar_disc_mean(nm) - table.number(row, table.column("disc_mean_over_centre")));
    }
  }
  errors.hold("the disc's mean over its centre against that of Neckel and Labs", 0.0005, "");
}

TEST(LimbDarkening, SeriesFollowsTheLaw) {
  for (const LimbDarkening law : laws) {
    ErrorSum errors;
    for (double nm = 360.0; nm <= 830.0; nm += 5.0) {
      const LimbSeries series = limb_series(nm, law);
      for (double mu = 0.0; mu <= 1.0; mu += 1.0 / 256.0) {
        double sum = 0.0;
        for (std::size_t k = 0; k < limb_terms; ++k) {
          sum += series.at(k) * std::pow(mu, limb_powers(law)[k]);
        }
        errors.add(sum - solar_limb_darkening(nm, mu, law) / solar_disc_mean(nm, law));
      }
    }
    errors.hold("series of powers against the law of " + name_of(law) + ", 360 to 830 nm", 1.0e-4, "of the mean");
  }
}

TEST(SunDisc, ShadesAsTheSpectrumDoes) {
  for (const LimbDarkening law : laws) {
    const SunDisc sun = sun_of(law);
    const double solid_angle = pi * sun.shading.sin_radius * sun.shading.sin_radius;
    const Xyzs whole = integrate_xyzs(sun.irradiance);
    const f64::vec4 mean = f64::vec4(whole.x, whole.y, whole.z, whole.s) / solid_angle;
    ErrorSum errors;
    for (double r = 0.0; r <= 1.0; r += 1.0 / 64.0) {
      std::vector<double> light = sun.irradiance.values();
      for (std::size_t i = 0; i < light.size(); ++i) {
        const double nm = sun.irradiance.wavelengths_nm()[i];
        light[i] *= solar_limb_darkening(nm, std::sqrt(1.0 - r * r), law) / solar_disc_mean(nm, law) / solid_angle;
      }
      const Xyzs reference = integrate_xyzs({sun.irradiance.wavelengths_nm(), std::move(light)});
      const f64::vec4 found = f64::sun_disc_luminance(r, sun.shading);
      errors.add((found.x - reference.x) / mean.x);
      errors.add((found.y - reference.y) / mean.y);
      errors.add((found.z - reference.z) / mean.z);
      errors.add((found.w - reference.s) / mean.w);
    }
    errors.hold("X, Y, Z, S of the disc against integrals over the spectrum, " + name_of(law), 1.0e-4, "of the mean");
  }
}

TEST(SunDisc, AddsUpToTheIrradiance) {
  const std::vector<QuadratureNode> rule = gauss_legendre(64);
  for (const LimbDarkening law : laws) {
    const SunDisc sun = sun_of(law);
    const Xyzs whole = integrate_xyzs(sun.irradiance);
    const f32::SunShading single = in_single(sun.shading);
    const double radius = sun.angular_radius.to(rad);
    f64::vec4 sum(0.0);
    f64::vec4 single_sum(0.0);
    double mean_y = 0.0;
    for (const QuadratureNode& node : rule) {
      // Directions on circles about the Sun, crowded at the limb; light on a plane that faces it.
      const double share = 1.0 - node.place * node.place;
      const double angle = radius * share;
      const Vec3 toward =
          std::cos(angle) * sun.direction + std::sin(angle) * (0.6 * sun.shading.aside + 0.8 * sun.shading.upward);
      const double width = 2.0 * node.place * node.weight * radius;
      const double area = 2.0 * pi * std::sin(angle) * std::cos(angle) * width;
      sum += area * test::sun_seen(toward, sun.shading);
      const auto r = static_cast<float>(std::sin(angle) / sun.shading.sin_radius);
      single_sum += area * f64::vec4(f32::sun_disc_luminance(r, single));
      mean_y += area;
    }
    ErrorSum errors;
    ErrorSum single_errors;
    const double reference[] = {whole.x, whole.y, whole.z, whole.s};
    for (int i = 0; i < 4; ++i) {
      errors.add(100.0 * (sum[i] / reference[i] - 1.0));
      single_errors.add(100.0 * (single_sum[i] / reference[i] - 1.0));
    }
    errors.hold("the disc's luminance added up against the irradiance, " + name_of(law), 0.001, "%");
    single_errors.hold("the same in single precision, " + name_of(law), 0.01, "%");
    ErrorSum luminance;
    luminance.add(100.0 * (sum.y / mean_y / 1.96e9 - 1.0));
    luminance.hold("mean luminance of the disc against 1.96e9 cd/m2", 2.0, "%");
  }
}

/// Light of the corona by the shader, over that of the disc (Y), from a distance on: by circles about the Sun.
double shaded_corona(const SunDisc& sun, double from) {
  const std::vector<QuadratureNode> rule = gauss_legendre(80);
  constexpr int azimuths = 90;
  double sum = 0.0;
  for (const QuadratureNode& node : rule) {
    // Equal steps in the logarithm.
    const double span = std::log(f64::corona_edge / from);
    const double r = from * std::exp(span * node.place);
    for (int k = 0; k < azimuths; ++k) {
      const double angle = 2.0 * pi * k / azimuths;
      const f64::vec2 place(r * std::cos(angle), r * std::sin(angle));
      sum += 2.0 * pi / azimuths * r * r * span * node.weight * f64::corona_luminance(place, sun.shading).y;
    }
  }
  return sum * sun.shading.sin_radius * sun.shading.sin_radius / integrate_xyzs(sun.irradiance).y;
}

TEST(Corona, HasThePublishedLight) {
  const SunDisc sun = sun_of(LimbDarkening::hestroffer_magnan);
  // Half as much as the full Moon, 0.31 lx (a figure of textbooks), or 1e-6 of the Sun, past a Moon 3 % larger than it.
  const double seen = shaded_corona(sun, 1.03);
  const double lux_at_1au = seen * integrate_xyzs(solar_irradiance_1au()).y;
  std::printf("corona beyond 1.03 radii: %.3g of the Sun, %.3f lx\n", seen, lux_at_1au);
  ErrorSum of_sun;
  of_sun.add(1.0e6 * seen - 1.0);
  of_sun.hold("light of the corona beyond 1.03 radii against 1e-6 of the Sun's", 0.2, "1e-6");
  ErrorSum of_moon;
  of_moon.add(lux_at_1au / 0.31 - 0.5);
  of_moon.hold("the same against half of the full Moon's", 0.1, "full Moons");
}

TEST(Corona, AddsUpToItsShareOfTheIrradiance) {
  const SunDisc sun = sun_of(LimbDarkening::hestroffer_magnan);
  // Dust in Y: its reddening, weighted by the disc's light.
  std::vector<double> reddened = sun.irradiance.values();
  for (std::size_t i = 0; i < reddened.size(); ++i) {
    reddened[i] *= dust_reddening(sun.irradiance.wavelengths_nm()[i]);
  }
  const double dust = integrate_xyzs({sun.irradiance.wavelengths_nm(), reddened}).y / integrate_xyzs(sun.irradiance).y;
  ErrorSum errors;
  for (const double moon : {1.0, 1.01, 1.03, 1.08}) {
    const CoronaLight share = corona_seen(1.0, moon, 0.0);
    const double expected = share.electrons + dust * share.dust;
    errors.add(100.0 * (shaded_corona(sun, moon) / expected - 1.0));
  }
  errors.hold("the corona's luminance added up, streamers and all, against its share of the irradiance", 0.01, "%");
}

TEST(Corona, StreamersLeaveEachCircleItsLight) {
  ErrorSum errors;
  double contrast = 0.0;
  for (const double activity : {0.0, 0.5, 1.0}) {
    for (const std::uint32_t seed : {0U, 1U, 4000000000U}) {
      f64::SunShading shading{};
      const auto streamers = corona_streamers(activity, seed);
      std::copy(streamers.begin(), streamers.end(), std::begin(shading.streamers));
      for (const double r : {1.0, 1.2, 1.7, 2.0, 5.0, 50.0}) {
        double sum = 0.0;
        double most = 0.0;
        double least = 1.0e9;
        constexpr int steps = 720;
        for (int i = 0; i < steps; ++i) {
          const double angle = 2.0 * pi * i / steps;
          const double here = f64::streamer_pattern(r * f64::vec2(std::cos(angle), std::sin(angle)), r, shading);
          sum += here / steps;
          most = std::max(most, here);
          least = std::min(least, here);
        }
        errors.add(sum - 1.0);
        EXPECT_GT(least, 0.0);
        if (r >= 2.0) {
          contrast = std::max(contrast, most / least);
        }
      }
    }
  }
  std::printf("streamers: brightest over darkest at most %.2f\n", contrast);
  EXPECT_GT(contrast, 1.5);
  errors.hold("mean of the streamers on circles about the Sun against 1", 1.0e-9, "");
}

/// X, Y, Z, S of disc and corona past the Moon, added up over directions by the shader.
f64::vec4 rendered(const f64::SunShading& sun, const std::vector<double>& edges) {
  constexpr int azimuths = 2880;
  const std::vector<QuadratureNode> rule = gauss_legendre(48);
  f64::vec4 sum(0.0);
  for (std::size_t piece = 0; piece + 1 < edges.size(); ++piece) {
    const double width = edges[piece + 1] - edges[piece];
    for (const QuadratureNode& node : rule) {
      // Crowded at both ends.
      const double r = edges[piece] + width * 0.5 * (1.0 - std::cos(pi * node.place));
      const double step = width * 0.5 * pi * std::sin(pi * node.place) * node.weight;
      const double sine = r * sun.sin_radius;
      const double cosine = std::sqrt(1.0 - sine * sine);
      for (int k = 0; k < azimuths; ++k) {
        const double angle = 2.0 * pi * (k + 0.5) / azimuths;
        const Vec3 toward =
            cosine * sun.direction + sine * (std::cos(angle) * sun.aside + std::sin(angle) * sun.upward);
        // Solid angle times the cosine: area in the orthographic picture.
        sum += 2.0 * pi / azimuths * r * step * sun.sin_radius * sun.sin_radius * test::sun_seen(toward, sun);
      }
    }
  }
  return sum;
}

TEST(SunInEclipse, RenderedLightIsTheIrradiance) {
  const Observer burgos{42.34 * deg, -3.70 * deg, 860.0 * metre};
  struct Scene {
    std::string time;
    Observer observer;
  };
  // Partial, deep, total and annular (2023-10-14 from Albuquerque).
  const Observer albuquerque{35.08 * deg, -106.65 * deg, 1600.0 * metre};
  for (const LimbDarkening law : laws) {
    ErrorSum partial;
    ErrorSum total;
    for (const Scene& scene : {Scene{"2026-08-12T17:50:00Z", burgos}, Scene{"2026-08-12T18:20:00Z", burgos},
                               Scene{"2026-08-12T18:29:30Z", burgos}, Scene{"2026-08-12T18:27:30Z", burgos},
                               Scene{"2023-10-14T16:36:00Z", albuquerque}}) {
      const SkyState sky = sky_state(parse_instant(scene.time), scene.observer);
      SunOptions options;
      options.law = law;
      const SunDisc sun = sun_disc(sky, options);
      const double moon = sky.solar_eclipse.moon_semidiameter / sky.solar_eclipse.sun_semidiameter;
      const double apart = sky.solar_eclipse.separation / sky.solar_eclipse.sun_semidiameter;
      std::vector<double> edges{0.0, 1.0, std::abs(apart - moon), apart + moon, 4.0, f64::corona_edge};
      std::sort(edges.begin(), edges.end());
      const f64::vec4 found = rendered(sun.shading, edges);
      const Xyzs expected = integrate_xyzs(filtered(sun.irradiance, sunlight_past_moon(sky.solar_eclipse, law)));
      const Xyzs whole = integrate_xyzs(sun.irradiance);
      const double pairs[4][3] = {{found.x, expected.x, whole.x},
                                  {found.y, expected.y, whole.y},
                                  {found.z, expected.z, whole.z},
                                  {found.w, expected.s, whole.s}};
      std::printf("%s: %.4g lx left of %.4g\n", scene.time.c_str(), expected.y, whole.y);
      for (const auto& [is, should, all] : pairs) {
        if (expected.y < 1.0e-4 * whole.y) {
          total.add(100.0 * (is / should - 1.0));
        } else {
          partial.add(100.0 * (is - should) / all);
        }
      }
    }
    partial.hold("rendered light of the partly eclipsed Sun against its irradiance, " + name_of(law), 0.02,
                 "% of the whole");
    total.hold("the same in totality, streamers and all, " + name_of(law), 0.1, "%");
  }
}

} // namespace
} // namespace vesper
