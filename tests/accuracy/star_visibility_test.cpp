// Which stars are seen: thresholds against laboratory and published figures, limits of nights, moonlight and day, and
// the order in which stars come out at dusk.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/light/night_light.hpp"
#include "vesper/sky/sky_background.hpp"
#include "vesper/sky/star_visibility.hpp"

#include "support/known_tables.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace vesper {
namespace {

double magnitude_at_the_eye(double threshold_lux) { return -2.5 * std::log10(threshold_lux / f64::zero_magnitude_lux); }

/// Background of a surface brightness as Crumey 2014 turns it into luminance (section 1.2).
double crumey_cd_m2(double mag_per_arcsec2) { return std::pow(10.0, 0.4 * (12.58 - mag_per_arcsec2)); }

TEST(ThresholdOfAPoint, FollowsTouseyAndKoomenFromNightToDay) {
  // Tousey and Koomen 1953 (JOSA 43, 177), table I: decimal logarithms of candles per square foot and of foot-candles,
  // for a field factor of 2.
  struct Row {
    double background, threshold;
  };
  constexpr std::array rows{Row{2.5, -5.21},  Row{1.5, -6.07},  Row{0.5, -6.88},  Row{-0.5, -7.63},
                            Row{-1.5, -8.22}, Row{-2.5, -8.58}, Row{-3.5, -8.65}, Row{-4.5, -9.01}};
  constexpr double per_square_foot = 10.763910417;
  test::ErrorSum errors;
  for (const Row& row : rows) {
    const double found =
        f64::threshold_illuminance_lux(per_square_foot * std::pow(10.0, row.background), 2.0) / per_square_foot;
    errors.add(2.5 * (std::log10(found) - row.threshold));
  }
  errors.hold("threshold of a point against Tousey and Koomen 1953, 3e-4 to 3e3 cd/m2", 0.1, "mag");
}

TEST(ThresholdOfAPoint, IsWhatCrumeyQuotes) {
  test::ErrorSum errors;
  const auto limit = [](double cd_m2, double factor) {
    return magnitude_at_the_eye(f64::threshold_illuminance_lux(cd_m2, factor));
  };
  errors.add(limit(crumey_cd_m2(21.83), 1.0) - 6.93); // section 3.1
  errors.add(limit(crumey_cd_m2(21.83), 2.0) - 6.18);
  errors.add(magnitude_at_the_eye(f64::threshold_illuminance_lux(0.0, 1.0)) - magnitude_at_the_eye(1.150e-9)); // eq. 71
  for (const double mu : {20.0, 20.5, 21.0, 21.5, 22.0}) {
    errors.add(limit(crumey_cd_m2(mu), 1.7) - (0.3834 * mu - 1.44 - 2.5 * std::log10(1.7))); // eq. 54
  }
  errors.hold("limiting magnitude against Crumey's own figures and his equation 54", 0.04, "mag");
}

TEST(MesopicShare, IsThatOfTheWorkedExamples) {
  // CIE TN 007:2017, section 5.1: 0.3 cd/m2 of S/P 1.8 and 2.5.
  test::ErrorSum shares;
  test::ErrorSum luminances;
  for (const auto& [ratio, share, luminance] : {std::array{1.8, 0.614, 0.348}, std::array{2.5, 0.629, 0.386}}) {
    const double found = f64::mesopic_cone_share(0.3, 0.3 * ratio);
    shares.add(found - share);
    luminances.add(f64::mesopic_luminance(0.3, 0.3 * ratio, found) - luminance);
  }
  shares.hold("cones' share of mesopic vision against CIE TN 007", 0.0007, "");
  luminances.hold("mesopic luminance against CIE TN 007", 0.0007, "cd/m2");
}

/// A sky over a place at sea level whose Sun and Moon can be put where they are wanted.
class Skies {
public:
  explicit Skies(const Medium& medium)
      : medium_(medium), tables_(std::make_shared<const SkyTables>(test::known_tables(medium))),
        air_(medium, Length(), std::nullopt),
        // Near new Moon, the galaxy's pole high.
        sky_(sky_state(parse_instant("2026-04-17T20:00:00Z"), {40.0 * deg, 0.0 * deg, 0.0 * metre})) {
    put_moon(-90.0 * deg);
    put_sun(-60.0 * deg);
  }

  void put_sun(Angle altitude) {
    sky_.sun.altitude = altitude;
    sky_.sun.direction_horizon = test::direction(Angle(), altitude); // in the east
  }
  void put_moon(Angle altitude) { sky_.moon.place.direction_horizon = test::direction(Angle(), altitude); }
  void make_moon_full() {
    sky_ = sky_state(parse_instant("2026-01-03T10:03:00Z"), {40.0 * deg, 180.0 * deg, 0.0 * metre});
    put_sun(-60.0 * deg);
  }
  void make_sun_quiet() { dark_.solar_flux_sfu = 80.0; }

  /// \param azimuth from the Sun's or the Moon's
  [[nodiscard]] Vec4 background(Angle altitude, Angle azimuth) const {
    return sky_backgrounds(sky_, medium_, tables_, dark_, {{90.0 * deg + azimuth, altitude}})[0].sum();
  }
  [[nodiscard]] double limit(Angle altitude, Angle azimuth, double field_factor = f64::default_field_factor) const {
    return limiting_magnitude(background(altitude, azimuth),
                              usual_star(air_.starlight_share(std::sin(altitude.to(rad)))), field_factor);
  }
  [[nodiscard]] double zenith_limit() const { return limit(90.0 * deg, Angle()); }
  [[nodiscard]] double zenith_brightness() const {
    return v_per_arcsec2(background(90.0 * deg, Angle()).y * candela_per_m2);
  }

  /// Depression of the Sun in degrees at which a star is first seen, within 0.01.
  [[nodiscard]] double first_seen(double magnitude, Angle altitude, Angle azimuth) {
    double day = -40.0;
    double night = 18.0;
    for (int i = 0; i < 13; ++i) {
      const double middle = 0.5 * (day + night);
      put_sun(-middle * deg);
      (limit(altitude, azimuth) >= magnitude ? night : day) = middle;
    }
    return 0.5 * (day + night);
  }

  /// The least that a star above the Sun and the Sun below stand apart in altitude when it is first seen.
  [[nodiscard]] double arcus_visionis(double magnitude) {
    double least = 90.0;
    for (const double altitude : {1.5, 2.0, 3.0, 4.5}) {
      least = std::min(least, altitude + first_seen(magnitude, altitude * deg, Angle()));
    }
    return least;
  }

private:
  Medium medium_;
  std::shared_ptr<const SkyTables> tables_;
  DarkSkyAir air_;
  DarkSkyOptions dark_;
  SkyState sky_;
};

/// How far a value lies outside a range.
double outside(double value, double low, double high) { return std::max({0.0, low - value, value - high}); }

TEST(LimitingMagnitude, OfNightMoonlightAndNoon) {
  test::ErrorSum errors;
  const auto hold = [&](const char* what, double limit, double low, double high) {
    std::printf("  %s: %.2f (%.1f to %.1f)\n", what, limit, low, high);
    errors.add(outside(limit, low, high));
  };
  for (const auto& [name, medium] : {std::pair("clear", clear_medium()), std::pair("published", published_medium())}) {
    std::puts(name);
    Skies skies(medium);
    skies.make_sun_quiet();
    EXPECT_NEAR(skies.zenith_brightness(), 21.8, 0.2);
    hold("dark zenith", skies.zenith_limit(), 6.0, 6.6);
    skies.put_sun(62.0 * deg);
    const double noon = skies.zenith_limit();
    skies.make_moon_full();
    skies.put_moon(45.0 * deg);
    const double moonlit = skies.zenith_limit();
    if (std::string(name) == "clear") {
      hold("zenith at noon, Sun 62 degrees high", noon, -4.5, -3.5);
      hold("zenith, full Moon 45 degrees high", moonlit, 3.9, 4.8);
    } else {
      // Half the extinction and hardly any haze: a darker day, and stars that come through.
      std::printf("  noon %.2f, full Moon %.2f\n", noon, moonlit);
      EXPECT_NEAR(noon, -3.5, 0.6);
      EXPECT_NEAR(moonlit, 4.8, 0.2);
    }
  }
  errors.hold("limiting magnitude outside the ranges of night, full Moon and noon", 0.0, "mag");
}

TEST(OrderOfAppearance, AtDusk) {
  Skies skies(clear_medium());
  std::puts("depression of the Sun, degrees, at which stars come out (altitude: Venus, Jupiter, Sirius, Vega, second "
            "magnitude)");
  double highest_sirius = 0.0;
  test::ErrorSum second;
  for (const double altitude : {90.0, 60.0, 30.0}) {
    std::array<double, 5> depressions{};
    for (std::size_t i = 0; i < depressions.size(); ++i) {
      constexpr std::array magnitudes{-4.4, -2.5, -1.46, 0.03, 2.0};
      depressions.at(i) = skies.first_seen(magnitudes.at(i), altitude * deg, 90.0 * deg);
    }
    std::printf("  %.0f: %.1f, %.1f, %.1f, %.1f, %.1f\n", altitude, depressions[0], depressions[1], depressions[2],
                depressions[3], depressions[4]);
    EXPECT_TRUE(std::is_sorted(depressions.begin(), depressions.end()));
    EXPECT_LT(depressions[0], -10.0) << "Venus is seen by day";
    EXPECT_LT(depressions[1], 0.83) << "Jupiter is seen at sunset (Tousey and Koomen 1953)";
    highest_sirius = altitude == 90.0 ? depressions[2] : highest_sirius;
    // Three stars of middling brightness: seen with effort at 4.8 degrees by good eyes, at 3.8 by who knows where
    // (Levi, The Times of the Day in Halacha).
    second.add(outside(depressions[4], 3.8, 4.8));
  }
  // High in the sky of Canberra, by an eye that knew where to look: not half an hour before sunset, the Sun 5.3 degrees
  // up, but 3 minutes before, 0.2 degrees below.
  test::ErrorSum sirius;
  sirius.add(outside(highest_sirius, -5.3, 0.2));
  sirius.hold("Sirius at sunset, depression of the Sun against what was seen in Canberra", 1.0, "deg");
  second.hold("second magnitude, depression of the Sun against Levi's 3.8 to 4.8 degrees", 1.0, "deg");
  // In most of the sky the first magnitude at the end of civil twilight, the fourth at that of nautical (Tousey and
  // Koomen 1953): by then at the latest, from 20 degrees upward.
  for (const auto& [depression, magnitude] : {std::pair(6.0, 1.0), std::pair(12.0, 4.0)}) {
    skies.put_sun(-depression * deg);
    for (const double azimuth : {0.0, 90.0, 180.0}) {
      EXPECT_GT(skies.limit(20.0 * deg, azimuth * deg), magnitude) << depression << " " << azimuth;
    }
  }
}

TEST(OrderOfAppearance, AtTheHorizon) {
  // Arcus visionis as almanacs had it (Pierer's Universal-Lexikon, 5, Altenburg 1858: Venus 5, stars of the first
  // magnitude 12 degrees) from observations under the dry skies of the south, in air that takes 0.15 mag at the zenith.
  Skies skies(published_medium());
  const double venus = skies.arcus_visionis(-3.9);
  const double sirius = skies.arcus_visionis(-1.46);
  const double vega = skies.arcus_visionis(0.03);
  const double second = skies.arcus_visionis(2.0);
  std::printf("arcus visionis, degrees: Venus %.1f, Sirius %.1f, Vega %.1f, second magnitude %.1f\n", venus, sirius,
              vega, second);
  EXPECT_LT(venus, sirius);
  EXPECT_LT(sirius, vega);
  EXPECT_LT(vega, second);
  test::ErrorSum errors;
  errors.add(venus - 5.0);
  errors.add(vega - 12.0);
  errors.hold("arcus visionis of Venus and Vega against the almanacs' 5 and 12 degrees", 1.0, "deg");
}

TEST(OrderOfAppearance, SiriusByDayTakesAKeenEyeThatKnowsWhere) {
  // Koennen, Tinbergen and Stammes 2015 (Applied Optics 54, B1): seen along a telescope's finder with the Sun 73
  // degrees high, Sirius 37. The field factor that this takes is less than that of any watcher of the night: they knew
  // the place to minutes of arc.
  Skies skies(published_medium()); // a mountain's air
  skies.put_sun(73.0 * deg);
  const double limit = skies.limit(37.0 * deg, Angle(), 1.0);
  const double field_factor = std::pow(10.0, 0.4 * (limit + 1.46));
  std::printf("Sirius by day: a field factor of %.2f\n", field_factor);
  EXPECT_GT(field_factor, 0.2);
  EXPECT_LT(field_factor, 1.0);
}

} // namespace
} // namespace vesper
