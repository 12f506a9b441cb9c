// Tone operators, metering and adaptation without a GPU.
#include "vesper/plan/display.hpp"
#include "vesper/plan/light_metering.hpp"
#include "vesper/plan/tone_curve.hpp"

#include "support/expect_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace vesper::test {
namespace {

/// Luminances and their shares of the field; S is photopic luminance times `sp_ratio`.
LightHistogram field_of(const std::vector<std::pair<double, double>>& cells, double sp_ratio = 2.3) {
  LightHistogram histogram;
  for (const auto& [luminance, share] : cells) {
    add_to(histogram.seen, luminance, share);
    add_to(histogram.scotopic, sp_ratio * luminance, share);
  }
  return histogram;
}

/// What a picture of even light and a brighter rim holds.
LightHistogram sky_of(double luminance) {
  return field_of({{0.7 * luminance, 0.3}, {luminance, 0.4}, {2.0 * luminance, 0.2}, {5.0 * luminance, 0.1}});
}

ToneCurve curve_for(const LightHistogram& histogram, ToneOperator tone = ToneOperator::visibility,
                    const Display& display = {}) {
  ToneSettings settings;
  settings.tone = tone;
  return make_tone_curve(settings, histogram, adapted_to(histogram), display_model(display));
}

/// Luminance above the display's floor by the curve as the GPU reads it.
double shown(const ToneCurve& curve, double luminance) {
  return f64::tone_curve(luminance, {curve.nodes.data(), static_cast<int>(curve.nodes.size())}).x;
}

const std::vector<ToneOperator> all_operators{ToneOperator::visibility, ToneOperator::reinhard, ToneOperator::hable,
                                              ToneOperator::photographic};

const std::vector<LightHistogram>& trying_fields() {
  static const std::vector<LightHistogram> fields{LightHistogram{},                        // all black
                                                  field_of({{2.0e9, 1.0}}),                // nothing but the Sun
                                                  field_of({{2.0e9, 1.0e-6}}),             // one bright pixel on black
                                                  field_of({{1.0e4, 0.5}}),                // half black, half sunlit
                                                  field_of({{1.0e-6, 0.5}, {1.0e4, 0.5}}), // likewise, not quite black
                                                  field_of({{3.0e-4, 0.999}, {3.0e3, 0.001}}), // the Moon by night
                                                  field_of({{3.0e3, 0.6}, {2.0e-2, 0.4}}),     // the Moon alone
                                                  sky_of(1.0e-6),
                                                  sky_of(3.0e-4),
                                                  sky_of(0.02),
                                                  sky_of(1.0),
                                                  sky_of(5.0e3),
                                                  sky_of(1.0e8)};
  return fields;
}

TEST(ToneOperators, HaveTheirPublishedValues) {
  // Reinhard et al. 2002: what is at the white becomes 1, far below it the simple form L/(1+L) holds.
  EXPECT_NEAR(f64::reinhard_extended(4.0, 4.0), 1.0, 1.0e-12);
  EXPECT_NEAR(f64::reinhard_extended(0.18, 1.0e6), 0.18 / 1.18, 1.0e-9);
  // Hable: black at 0 and 1 at half the white of 11.2, by the bias of 2; the toe falls below a straight line.
  EXPECT_NEAR(f64::hable_curve(0.0), 0.0, 1.0e-15);
  EXPECT_NEAR(f64::hable_curve(5.6), 1.0, 1.0e-12);
  // (0.04144 / 0.25944 - 1/15) / 0.725129, by hand
  EXPECT_NEAR(f64::hable_curve(0.18), 0.12834, 1.0e-5);
  // Sunny 16: EV 15 at ISO 100. A sunlit white, 100 klx / pi = 32 kcd/m2, is within a stop of saturation.
  EXPECT_NEAR(std::log2(f64::photographic_white_cd_m2(15.0) / (1.0e5 / 3.14159)), 0.3, 0.1);
  EXPECT_NEAR(f64::metered_exposure_value(4096.0), 15.0, 1.0e-9);
  // Krawczyk et al. 2005, figure 4: about 0.03 in the dark and 0.68 at 5000 cd/m2.
  EXPECT_NEAR(f64::automatic_key(0.0), 0.03, 1.0e-12);
  EXPECT_NEAR(f64::automatic_key(5000.0), 0.68, 0.005);
}

TEST(ToneOperators, AdaptLocallyAsTheIterationDoes) {
  double worst = 0.0;
  for (double octave = -12.0; octave < 5.0; octave += 0.1) {
    for (const double sp_ratio : {0.5, 1.0, 1.5, 2.0, 2.5}) {
      const double luminance = std::exp2(octave);
      worst = std::max(worst, std::abs(f64::local_cone_share(luminance, sp_ratio * luminance) -
                                       f64::mesopic_cone_share(luminance, sp_ratio * luminance)));
    }
  }
  std::printf("local share of the cones: within %.3f of CIE 191's solution\n", worst);
  EXPECT_LT(worst, 0.08);
}

TEST(ToneCurves, KeepTheOrderOfLuminanceWithinTheDisplay) {
  for (const double peak : {50.0, 200.0, 1000.0}) {
    const Display display{.peak = peak * candela_per_m2, .black = 0.001 * peak * candela_per_m2};
    const double range = display_model(display).range_cd_m2;
    for (const ToneOperator tone : all_operators) {
      for (const LightHistogram& field : trying_fields()) {
        const ToneCurve curve = curve_for(field, tone, display);
        double last = 0.0;
        for (double octave = -20.0; octave <= 31.0; octave += 0.05) { // 1e-6 to 2e9 cd/m2
          const double now = shown(curve, std::exp2(octave));
          ASSERT_GE(now, last * (1.0 - 1.0e-9)) << "operator " << static_cast<int>(tone) << " at 2^" << octave;
          ASSERT_LE(now, range * 1.000001);
          last = now;
        }
        ASSERT_TRUE(std::isfinite(curve.mean_cd_m2));
        for (const f64::vec4& node : curve.nodes) {
          ASSERT_TRUE(std::isfinite(node.x) && std::isfinite(node.y) && std::isfinite(node.z) && std::isfinite(node.w));
        }
      }
    }
  }
}

TEST(ToneCurves, MatchWhatCanJustBeToldApart) {
  // At the adaptation luminance a step that can just be seen in the scene (Ferwerda et al. 1996) is one on the display.
  // At nodes of the table: its chords lie up to 1.3 % higher where the curve is steepest.
  for (const double octave : {-12.0, -11.625, -8.0, -5.0, -2.0, 1.0, 4.0, 8.0, 11.5}) {
    const double luminance = std::exp2(octave);
    const LightHistogram field = field_of({{luminance, 1.0}});
    const AdaptationState state = adapted_to(field);
    EXPECT_NEAR(state.cones.to(candela_per_m2), luminance, 0.001 * luminance);
    const ToneCurve curve = curve_for(field);
    const double scene_step = std::min(f64::cone_threshold_cd_m2(luminance), f64::rod_threshold_cd_m2(2.3 * luminance));
    const Display display;
    const double viewer = 0.3 * (curve.floor_cd_m2 + (display.peak - display.black).to(candela_per_m2));
    // By day brightness goes on to grow, where steps, by Weber's law, are matched at any.
    const double by_day = std::pow(std::max(luminance / 80.0, 1.0), 0.06);
    const double expected = by_day * f64::cone_threshold_cd_m2(viewer) / scene_step;
    EXPECT_NEAR(shown(curve, luminance) / luminance, expected, 0.01 * expected) << luminance;
  }
}

TEST(ToneCurves, DarkenFromNoonToMidnight) {
  const double white = Display{}.peak.to(candela_per_m2);
  double last = 1.0;
  // Noon, sunset, civil and nautical dusk, full Moon, dark.
  for (const double luminance : {5.0e3, 500.0, 5.0, 0.3, 0.004, 3.0e-4}) {
    const double share = curve_for(sky_of(luminance)).mean_cd_m2 / white;
    std::printf("sky of %g cd/m2: the display shows %.4f of its white in the mean\n", luminance, share);
    EXPECT_LT(share, last);
    last = share;
  }
  EXPECT_GT(curve_for(sky_of(5.0e3)).mean_cd_m2, 0.15 * white);
  EXPECT_LT(last, 0.02);
}

/// Contrast of all that leaves the display between two luminances of the scene.
double contrast_shown(const ToneCurve& curve, double bright, double dark) {
  return (curve.floor_cd_m2 + shown(curve, bright)) / (curve.floor_cd_m2 + shown(curve, dark));
}

TEST(ToneCurves, TheMilkyWayKeepsItsContrast) {
  // A sky of 21.7 mag/arcsec2 with the clouds of Sagittarius, 20.58 in all, on a twentieth of it.
  const double sky = 2.3e-4;
  const double clouds = sky * std::pow(10.0, 0.4 * (21.7 - 20.58));
  const LightHistogram field = field_of({{sky, 0.8}, {1.3 * sky, 0.15}, {clouds, 0.05}});
  for (const double peak : {50.0, 200.0, 1000.0}) {
    const Display display{.peak = peak * candela_per_m2, .black = 0.001 * peak * candela_per_m2};
    const double contrast = contrast_shown(curve_for(field, ToneOperator::visibility, display), clouds, sky);
    std::printf("clouds of Sagittarius, %.2f times the sky, are %.2f times as bright on a display of %.0f cd/m2\n",
                clouds / sky, contrast, peak);
    EXPECT_GT(contrast, clouds / sky);
    EXPECT_LT(contrast, std::pow(clouds / sky, 2.0));
  }
}

TEST(ToneCurves, ABrightRoomTearsNoNightApart) {
  const Display display{.ambient = 30.0 * candela_per_m2};
  const ToneCurve curve = curve_for(sky_of(3.0e-4), ToneOperator::visibility, display);
  for (double octave = -14.0; octave < 4.0; octave += 0.125) {
    const double at = std::exp2(octave);
    EXPECT_LT(shown(curve, 1.1 * at) / shown(curve, at), std::pow(1.1, 4.3)) << octave;
  }
}

TEST(ToneCurves, DaylightGetsNoMoreContrastThanItHas) {
  for (const double luminance : {10.0, 300.0, 5.0e3}) {
    const ToneCurve curve = curve_for(sky_of(luminance));
    for (double octave = -2.0; octave < 4.0; octave += 0.125) {
      const double at = luminance * std::exp2(octave);
      EXPECT_LT(contrast_shown(curve, 1.1 * at, at), 1.1 * 1.002) << luminance << " " << octave;
    }
  }
}

TEST(Points, GrowBrighterThanTheirThresholdAsks) {
  EXPECT_LT(f64::point_boost(0.25), 1.15); // the brightest pixel of a point at its threshold
  double last = 0.0;
  for (double over = 1.0e-3; over < 1.0e5; over *= 1.1) {
    EXPECT_GT(over * f64::point_boost(over), last);
    last = over * f64::point_boost(over);
  }
  // A power of 1.5 of the light, far above.
  EXPECT_NEAR(f64::point_boost(4.0e4) / f64::point_boost(1.0e4), 2.0, 0.01);
}

TEST(BrightColours, GiveUpLuminanceAndKeepTheirShare) {
  for (const double highest : {1.0, 1.3, 2.0, 4.7}) { // of unit luminance
    double last = 0.0;
    for (double shown = 0.001; shown <= 1.0; shown += 0.001) {
      const double scale = f64::scale_with_color(shown, 1.0, highest, 0.0, f64::kept_color);
      EXPECT_GT(scale, last);
      last = scale;
      if (shown * highest <= 1.0) {
        EXPECT_DOUBLE_EQ(scale, shown);
      }
    }
    // At white, towards which it goes as far as the highest component fits.
    const double white = f64::scale_with_color(1.0, 1.0, highest, 0.0, f64::kept_color);
    EXPECT_NEAR(1.0 - white, f64::kept_color * white * (highest - 1.0), 1.0e-12);
    const double dazzling = f64::scale_with_color(1.0, 1.0, highest, 1.0e8, f64::kept_color);
    EXPECT_NEAR(dazzling, 1.0, 1.0e-6);
  }
}

TEST(ToneCurves, NeitherSunNorMoonThrowsTheSky) {
  // 0.2 square degrees in a field of 60 by 60 degrees.
  const double share = 0.2 / 3600.0;
  for (const auto& [sky, disc] : {std::pair(3.0e3, 1.6e9), std::pair(0.01, 3.0e3)}) {
    const LightHistogram without = field_of({{sky, 1.0}});
    const LightHistogram with = field_of({{sky, 1.0 - share}, {disc, share}});
    for (const ToneOperator tone : all_operators) {
      const double change = shown(curve_for(with, tone), sky) / shown(curve_for(without, tone), sky) - 1.0;
      std::printf("%s: a disc of %g cd/m2 changes the sky of %g cd/m2 on the display by %.2f %%\n",
                  tone_operator_names()[static_cast<std::size_t>(tone)].data(), disc, sky, 100.0 * change);
      EXPECT_LT(std::abs(change), 0.02);
    }
  }
}

TEST(ToneCurves, ShowTheMoonsSurfaceWhereItFillsThePicture) {
  const LightHistogram field = field_of({{1000.0, 0.1}, {2000.0, 0.2}, {3500.0, 0.2}, {5000.0, 0.1}, {0.02, 0.4}});
  const ToneCurve curve = curve_for(field);
  EXPECT_GT(shown(curve, 5000.0) / shown(curve, 1000.0), 1.5);
  EXPECT_GT(shown(curve, 5000.0), 0.5 * Display{}.peak.to(candela_per_m2));
  // As a camera has it: nothing is white.
  const ToneCurve camera = curve_for(field, ToneOperator::photographic);
  EXPECT_NEAR(shown(camera, 5000.0) / shown(camera, 1000.0), 5.0, 0.05);
  EXPECT_GT(shown(camera, 5000.0), 0.2 * Display{}.peak.to(candela_per_m2));
}

TEST(ToneCurves, ACamerasMeterReadsWhatItsSensorHolds) {
  // Even light comes out as ISO 2720 and 12232 have it together: 1 / (1.2 * 8) of white.
  const double range = display_model({}).range_cd_m2;
  for (const double luminance : {3.0e-4, 1.0, 3.0e3}) {
    EXPECT_NEAR(shown(curve_for(field_of({{luminance, 1.0}}), ToneOperator::photographic), luminance) / range,
                1.0 / 9.6, 0.002);
  }
  // A fifth of the field, far too bright: with the rest black it is exposed for, at 5/9.6 of white; of little use
  // beside it, a twentieth is white and counts as that: m = 0.95 + 0.05 * 9.6 m.
  const auto black = field_of({{4.0e3, 0.2}, {1.0e-3, 0.8}});
  EXPECT_NEAR(shown(curve_for(black, ToneOperator::photographic), 4.0e3) / range, 5.0 / 9.6, 0.01);
  const auto bright = field_of({{1.0e6, 0.05}, {1.0, 0.95}});
  EXPECT_NEAR(shown(curve_for(bright, ToneOperator::photographic), 1.0) / range, 0.52 / 0.95 / 9.6, 0.002);
}

TEST(ToneCurves, APointAtItsThresholdStaysAtIt) {
  // Half a node of a threshold in proportion to luminance is 4.4 %, 0.05 mag.
  for (const double peak : {50.0, 200.0, 1000.0}) {
    const Display display{.peak = peak * candela_per_m2, .black = 0.001 * peak * candela_per_m2};
    for (const double luminance : {3.0e-4, 0.02, 1.0, 300.0, 5.0e3}) {
      const ToneCurve curve = curve_for(field_of({{luminance, 1.0}}), ToneOperator::visibility, display);
      const f64::vec3 tone = f64::tone_curve(luminance, {curve.nodes.data(), static_cast<int>(curve.nodes.size())});
      const double on_display = f64::threshold_illuminance_lux(curve.floor_cd_m2 + tone.x, 1.7);
      EXPECT_NEAR(tone.y / tone.z / on_display, 1.0, 0.045) << peak << " " << luminance;
    }
  }
}

TEST(Metering, CellsDependOnFieldAndShapeAlone) {
  for (const Projection projection : {Projection::fisheye, Projection::perspective, Projection::cubemap}) {
    View small;
    small.projection = projection;
    small.fov = 60.0 * deg;
    small.width = 256;
    small.height = projection == Projection::cubemap ? 6 * small.width : 128;
    View large = small;
    large.width *= 7;
    large.height *= 7;
    const MeteringGrid a = metering_grid(small);
    const MeteringGrid b = metering_grid(large);
    EXPECT_EQ(a.columns, b.columns);
    EXPECT_EQ(a.rows, b.rows);
    EXPECT_EQ(a.samples, b.samples);
  }
}

TEST(Metering, APictureThatIsALineHasCellsToo) {
  View line;
  for (const auto& [width, height] : {std::pair(1, 500), std::pair(16384, 1), std::pair(2, 16384)}) {
    line.width = width;
    line.height = height;
    const MeteringGrid grid = metering_grid(line);
    EXPECT_GE(std::min(grid.columns, grid.rows), 1);
    EXPECT_LE(std::max(grid.columns, grid.rows), 4096);
  }
}

TEST(Metering, ACellCountsOnceHoweverItLies) {
  for (double octave = -30.0; octave < 40.0; octave += 0.037) {
    LightHistogram::Bins bins{};
    add_to(bins, std::exp2(octave), 0.25);
    double sum = 0.0;
    for (const double bin : bins) {
      sum += bin;
    }
    EXPECT_NEAR(sum, octave < -24.2 ? 0.0 : 0.25, octave < -23.8 && octave > -24.2 ? 0.25 : 1.0e-12) << octave;
  }
}

TEST(Adaptation, LightIsQuickAndDarknessSlow) {
  const AdaptationState day{1.0e3 * candela_per_m2, 2.3e3 * candela_per_m2};
  const AdaptationState night{1.0e-3 * candela_per_m2, 2.3e-3 * candela_per_m2};
  const std::vector<MeteredInstant> to_dark{{0.0, day}, {60.0, night}, {600.0, night}, {2400.0, night}};
  const std::vector<AdaptationState> dark = adapt(to_dark);
  // Cones are done in ten minutes, rods only in half an hour and more (Hecht et al. 1937).
  EXPECT_GT(dark[1].cones.to(candela_per_m2), 1.0);
  EXPECT_LT(dark[2].cones.to(candela_per_m2), 2.0e-3);
  EXPECT_GT(dark[2].rods.to(candela_per_m2), 0.02);
  EXPECT_LT(dark[3].rods.to(candela_per_m2), 5.0e-3);
  const std::vector<AdaptationState> light = adapt(std::vector<MeteredInstant>{{0.0, night}, {3.0, day}});
  EXPECT_NEAR(light[1].cones / day.cones, 1.0, 0.01);
  EXPECT_NEAR(light[1].rods / day.rods, 1.0, 0.01);
}

TEST(Adaptation, IsAFunctionOfTheSequenceAlone) {
  std::vector<MeteredInstant> sequence;
  for (int i = 0; i < 60; ++i) {
    const double luminance = std::pow(10.0, 2.0 * std::sin(0.2 * i));
    sequence.push_back({30.0 * i, {luminance * candela_per_m2, 2.0 * luminance * candela_per_m2}});
  }
  const std::vector<AdaptationState> whole = adapt(sequence);
  // A frame in the middle, found by itself and before others.
  for (const std::size_t frame : {std::size_t{41}, std::size_t{7}, std::size_t{59}}) {
    const std::vector<AdaptationState> part = adapt(std::span(sequence).first(frame + 1));
    EXPECT_EQ(part.back().cones.to(candela_per_m2), whole[frame].cones.to(candela_per_m2));
    EXPECT_EQ(part.back().rods.to(candela_per_m2), whole[frame].rods.to(candela_per_m2));
  }
  std::swap(sequence[3], sequence[4]);
  expect_error(ErrorKind::argument, {"before the one at"}, [&] { static_cast<void>(adapt(sequence)); });
}

TEST(Adaptation, AnEyeFromTheLightSeesLessByNight) {
  const LightHistogram night = sky_of(3.0e-4);
  const f64::DisplayModel display = display_model({});
  const AdaptationState from_light{0.05 * candela_per_m2, 5.0 * candela_per_m2};
  const ToneCurve dazzled = make_tone_curve({}, night, from_light, display);
  const ToneCurve adapted = make_tone_curve({}, night, adapted_to(night), display);
  EXPECT_LT(shown(dazzled, 3.0e-4), 0.1 * shown(adapted, 3.0e-4));
  const auto one_over_threshold = [](const ToneCurve& curve) {
    return f64::tone_curve(3.0e-4, {curve.nodes.data(), static_cast<int>(curve.nodes.size())}).z;
  };
  EXPECT_LT(one_over_threshold(dazzled), 0.25 * one_over_threshold(adapted));
}

} // namespace
} // namespace vesper::test
