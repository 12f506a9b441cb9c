// The chain from a frame's light to a display's code values, on the GPU.
#include "render/mapped_light.hpp"

#include "support/truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>

namespace vesper::test {
namespace {

class DisplayChains : public RenderTest {
protected:
  gpu::DisplayChain chain{shaders};
};

/// Without glare and acuity, which have tests of their own.
gpu::DisplaySettings deep(ToneOperator tone = ToneOperator::visibility, const Display& display = {}) {
  gpu::DisplaySettings settings;
  settings.tone.tone = tone;
  settings.display = display;
  settings.format = gpu::PixelFormat::rgba16;
  settings.optics.glare = settings.optics.acuity = false;
  return settings;
}

const std::vector<ToneOperator> all_operators{ToneOperator::visibility, ToneOperator::reinhard, ToneOperator::hable,
                                              ToneOperator::photographic, ToneOperator::false_color};

/// A sky by direction, so that its light does not depend on the pixels: brighter towards one side, with a dark ground
/// and a Sun in the corner, whose edge is shared out over the pixels that it crosses.
PictureLight test_sky(const View& view, double luminance) {
  PictureLight light{view, {}, {}};
  const f64::PixelFrame frame = pixel_frame(view);
  const Vec3 sun = glm::normalize(Vec3(0.36, 0.34, 1.0));
  const auto from_sun = [&](const Vec2& pixel) {
    Vec3 direction;
    return f64::unproject(pixel, frame, direction) ? std::acos(std::min(glm::dot(direction, sun), 1.0))
                                                   : std::numbers::pi;
  };
  const auto sun_share = [&](const Vec2& pixel) {
    constexpr double near = 4.0; // pixels
    const double radius = (0.27 * deg).to(rad);
    if (from_sun(pixel) > radius + near / frame.focal) {
      return 0.0;
    }
    constexpr int steps = 16;
    int inside = 0;
    for (int i = 0; i < steps * steps; ++i) {
      const int line = i / steps;
      const Vec2 part((i % steps + 0.5) / steps - 0.5, (line + 0.5) / steps - 0.5);
      inside += from_sun(pixel + part) < radius ? 1 : 0;
    }
    return static_cast<double>(inside) / (steps * steps);
  };
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const Vec2 pixel(column + 0.5, row + 0.5);
      Vec3 direction;
      const bool inside = f64::unproject(pixel, frame, direction);
      const double sky = std::exp(2.0 * direction.x) * (direction.y < -0.3 ? 0.1 : 1.0);
      const auto value = static_cast<float>(inside ? luminance * (sky + 3.0e5 * sun_share(pixel)) : 0.0);
      light.frame.insert(light.frame.end(), {0.9F * value, value, 1.2F * value, 2.0F * value});
    }
  }
  return light;
}

/// The same by the processor: every sample of every cell, in double precision.
LightHistogram histogram_of(const PictureLight& light, const MeteringGrid& grid) {
  LightHistogram histogram;
  const View& view = light.view;
  const f64::PixelFrame frame = pixel_frame(view);
  struct Cell {
    double y, s, weight;
  };
  std::vector<Cell> cells;
  double all = 0.0;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      Cell cell{};
      for (int i = 0; i < grid.samples * grid.samples; ++i) {
        const double x = (column + (i % grid.samples + 0.5) / grid.samples) / grid.columns * view.width;
        const int sample_row = i / grid.samples;
        const double y = (row + (sample_row + 0.5) / grid.samples) / grid.rows * view.height;
        const double per_steradian = f64::pixels_per_steradian({x, y}, frame);
        if (per_steradian > 0.0) {
          const std::size_t at =
              4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(x));
          cell.y += static_cast<double>(light.frame[at + 1]) / per_steradian;
          cell.s += static_cast<double>(light.frame[at + 3]) / per_steradian;
          cell.weight += 1.0 / per_steradian;
        }
      }
      if (cell.weight > 0.0) {
        cells.push_back(cell);
        all += cell.weight;
      }
    }
  }
  for (const Cell& cell : cells) {
    const double y = cell.y / cell.weight;
    const double s = cell.s / cell.weight;
    add_to(histogram.seen, f64::mesopic_luminance(y, s, f64::local_cone_share(y, s)), cell.weight / all);
    add_to(histogram.scotopic, s, cell.weight / all);
  }
  return histogram;
}

TEST_F(DisplayChains, MeterAsTheProcessorDoes) {
  ErrorSum error;
  for (const Projection projection : {Projection::fisheye, Projection::perspective, Projection::equirectangular}) {
    View view = square_view(200, 100.0 * deg);
    view.projection = projection;
    for (const double luminance : {3.0e-4, 0.5, 3.0e3}) {
      const PictureLight light = test_sky(view, luminance);
      chain.use(deep());
      static_cast<void>(codes_of(chain, light));
      const LightHistogram expected = histogram_of(light, metering_grid(view));
      for (std::size_t bin = 0; bin < expected.seen.size(); ++bin) {
        error.add(chain.histogram().seen.at(bin) - expected.seen.at(bin));
        error.add(chain.histogram().scotopic.at(bin) - expected.scotopic.at(bin));
      }
    }
  }
  error.hold("metering on the GPU, share of a bin", 1.0e-3, "");
}

double mean_shown(const std::vector<std::uint16_t>& codes, const View& view) {
  const f64::DisplayModel display = display_model({});
  double sum = 0.0;
  for (int row = 0; row < view.height; row += 2) {
    for (int column = 0; column < view.width; column += 2) {
      sum += light_at(codes, view.width, column, row, display, 0.0).y;
    }
  }
  return sum / (0.25 * view.width * view.height);
}

TEST_F(DisplayChains, MapAPictureOfMorePixelsToTheSameMean) {
  ErrorSum error;
  for (const double luminance : {3.0e-4, 3.0e3}) {
    const PictureLight coarse = test_sky(square_view(512), luminance);
    const PictureLight fine = test_sky(square_view(2048), luminance);
    for (const bool optics : {false, true}) {
      gpu::DisplaySettings settings = deep();
      settings.optics.glare = settings.optics.acuity = optics;
      chain.use(settings);
      const double of_coarse = mean_shown(codes_of(chain, coarse), coarse.view);
      const double of_fine = mean_shown(codes_of(chain, fine), fine.view);
      std::printf("sky of %g cd/m2%s: mean on the display %.5g cd/m2 in 512 pixels, %.5g in 2048\n", luminance,
                  optics ? ", glare and acuity" : "", of_coarse, of_fine);
      error.add(100.0 * (of_fine / of_coarse - 1.0));
    }
  }
  error.hold("mean luminance on the display, 2048 pixels over 512", 1.0, "%");
}

TEST_F(DisplayChains, ASequenceIsAdaptedFirstAndThenDrawnInAnyOrder) {
  // Lights go out, and on again.
  constexpr std::size_t frames = 5;
  constexpr std::array<double, frames> luminances{300.0, 300.0, 1.0e-3, 1.0e-3, 300.0};
  constexpr std::array<double, frames> seconds{0.0, 10.0, 20.0, 200.0, 200.2};
  std::vector<PictureLight> pictures;
  std::vector<MeteredInstant> instants;
  const View view = square_view(96);
  for (std::size_t i = 0; i < frames; ++i) {
    pictures.push_back(even_light(view, luminances.at(i)));
    chain.use(deep());
    static_cast<void>(codes_of(chain, pictures.back()));
    instants.push_back({seconds.at(i), adapted_to(chain.histogram())});
  }
  const std::vector<AdaptationState> states = adapt(instants);
  const auto draw = [&](std::size_t frame) {
    gpu::DisplaySettings settings = deep();
    settings.optics = {};
    settings.noise = true;
    settings.adaptation = states[frame];
    settings.seconds = seconds.at(frame);
    settings.seed = static_cast<std::uint32_t>(frame);
    chain.use(settings);
    return codes_of(chain, pictures[frame]);
  };
  std::vector<std::vector<std::uint16_t>> in_order;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    in_order.push_back(draw(frame));
  }
  for (const std::size_t frame : std::array<std::size_t, frames>{3, 0, 4, 2, 1}) {
    EXPECT_EQ(draw(frame), in_order[frame]) << frame;
  }
  // The eye is still blind when it gets dark, and dazzled when light is back.
  const double black = f64::display_floor_cd_m2(display_model({}), 0.0);
  const auto shown = [&](std::size_t frame) { return mean_shown(in_order[frame], view) - black; };
  for (std::size_t frame = 0; frame < frames; ++frame) {
    std::printf("%5.1f s, sky of %5g cd/m2, cones adapted to %8.3g, rods to %8.3g: %.3g cd/m2 over black\n",
                seconds.at(frame), luminances.at(frame), states[frame].cones.to(candela_per_m2),
                states[frame].rods.to(candela_per_m2), shown(frame));
  }
  EXPECT_LT(shown(2), 0.5 * shown(3));
  EXPECT_GT(shown(4), 1.02 * shown(1));
}

/// Every luminance from 1e-6 to 2e9 cd/m2, a column each.
PictureLight all_luminances(const View& view) {
  PictureLight light{view, {}, {}};
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const auto y = static_cast<float>(1.0e-6 * std::pow(2.0e15, column / (view.width - 1.0)));
      light.frame.insert(light.frame.end(), {0.95047F * y, y, 1.08883F * y, 2.3F * y});
    }
  }
  return light;
}

TEST_F(DisplayChains, KeepTheOrderOfLuminance) {
  const View view = square_view(192);
  const f64::DisplayModel display = display_model({});
  for (const ToneOperator tone : all_operators) {
    if (tone == ToneOperator::false_color) {
      continue; // its colours tell, not their luminance
    }
    chain.use(deep(tone));
    const std::vector<std::uint16_t> codes = codes_of(chain, all_luminances(view));
    double last = 0.0;
    for (int column = 0; column < view.width; ++column) {
      // The mean of many, for what the dither adds.
      constexpr int rows = 32;
      double now = 0.0;
      for (int row = 0; row < rows; ++row) {
        now += light_at(codes, view.width, column, row, display, 0.0).y / rows;
      }
      ASSERT_GE(now, last - 1.0e-4 * std::max(last, 1.0)) << static_cast<int>(tone) << " column " << column;
      last = std::max(now, last);
    }
    EXPECT_GT(last, 0.5 * display.range_cd_m2);
  }
}

TEST_F(DisplayChains, AGreyOfDaylightStaysGrey) {
  ErrorSum error;
  const f64::DisplayModel display = display_model({});
  const View view = square_view(64);
  for (const ToneOperator tone : all_operators) {
    for (const double luminance : {10.0, 100.0, 1.0e3, 1.0e4}) {
      if (tone == ToneOperator::false_color) {
        continue;
      }
      chain.use(deep(tone));
      const std::vector<std::uint16_t> codes = codes_of(chain, even_light(view, luminance));
      const f64::vec3 xyz = light_at(codes, view.width, 30, 30, display, 0.0);
      const double sum = xyz.x + xyz.y + xyz.z;
      error.add(xyz.x / sum - 0.3127);
      error.add(xyz.y / sum - 0.3290);
    }
  }
  error.hold("grey of daylight on the display, x and y", 0.003, "");
}

TEST_F(DisplayChains, ColourFadesByNight) {
  const f64::DisplayModel display = display_model({});
  const View view = square_view(64);
  const auto blueness = [&](double luminance) {
    chain.use(deep());
    PictureLight light = even_light(view, luminance);
    for (std::size_t i = 0; i < light.frame.size(); i += 4) {
      light.frame[i] *= 1.3F; // reddish
      light.frame[i + 2] *= 0.5F;
    }
    const f64::vec3 xyz = light_at(codes_of(chain, light), view.width, 30, 30, display, 0.0);
    const f64::vec3 added = xyz - chain.curve().floor_cd_m2 * f64::vec3(0.95047, 1.0, 1.08883);
    return added.z / added.y;
  };
  EXPECT_NEAR(blueness(100.0), 0.544, 0.01);
  EXPECT_GT(blueness(1.0e-3), 1.1); // bluish, whatever it was
}

TEST_F(DisplayChains, StandWhatNoSkyShows) {
  const View view = square_view(64);
  const std::size_t values = std::size_t{4} * 64 * 64;
  PictureLight black{view, std::vector<float>(values, 0.0F), {}};
  PictureLight pixel = black;
  PictureLight half = black;
  PictureLight odd = black;
  constexpr std::size_t bright = 8000;
  for (std::size_t i = 0; i < 4; ++i) {
    pixel.frame[bright + i] = 2.0e9F;
  }
  std::fill(half.frame.begin(), half.frame.begin() + static_cast<std::ptrdiff_t>(values / 2), 1.0e4F);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> exponent(-8.0F, 9.3F);
  for (float& value : odd.frame) { // colours far outside any gamut, negative ones among them
    value = std::pow(10.0F, exponent(random)) * (random() % 7 == 0 ? -1.0F : 1.0F);
  }
  for (const ToneOperator tone : all_operators) {
    gpu::DisplaySettings settings = deep(tone);
    if (tone == ToneOperator::hable) {
      settings.light = 0.2 * Vec3(0.9879, 1.0, 0.8249); // moonlight
    }
    chain.use(settings);
    for (const PictureLight* light : {&black, &pixel, &half, &odd, &black, &half}) { // one after another, too
      const std::vector<std::uint16_t> codes = codes_of(chain, *light);
      ASSERT_TRUE(std::isfinite(chain.curve().mean_cd_m2));
      for (std::size_t i = 3; i < codes.size(); i += 4) {
        ASSERT_EQ(codes[i], 65535);
      }
      if (tone == ToneOperator::false_color) {
        continue;
      }
      if (light == &odd) {
        // What is bright has some colour, however impossible its own: a number that is none would be black.
        for (std::size_t i = 0; i < codes.size(); i += 4) {
          if (odd.frame[i + 1] > 1.0e8F) {
            ASSERT_GT(std::max({codes[i], codes[i + 1], codes[i + 2]}), 20000) << static_cast<int>(tone) << " " << i;
          }
        }
        continue;
      }
      ASSERT_EQ(codes[std::size_t{4} * 60 * 64], 0) << "black";
      if (light == &pixel) {
        ASSERT_GT(codes[bright + 1], 30000);
      }
      if (light == &half) {
        ASSERT_GT(codes[4 * 100 + 1], 20000);
      }
    }
  }
}

TEST_F(DisplayChains, KeepsNothingOfAFrameBeforeInAnotherField) {
  gpu::DisplaySettings settings = deep();
  settings.optics = {};
  View whole = square_view(160, 180.0 * deg);
  whole.projection = Projection::fisheye;
  const PictureLight sky = test_sky(whole, 3.0e3);
  const PictureLight narrow = test_sky(square_view(96, 0.5 * deg), 3.0e-4);
  chain.use(settings);
  const auto first = codes_of(chain, sky);
  const auto second = codes_of(chain, narrow);
  EXPECT_EQ(codes_of(chain, sky), first);
  gpu::DisplayChain fresh(shaders);
  fresh.use(settings);
  EXPECT_EQ(codes_of(fresh, narrow), second);
}

TEST_F(DisplayChains, FalseColoursTellLuminanceAndCarryALegend) {
  const View view = square_view(240);
  const f64::DisplayModel display = display_model({});
  chain.use(deep(ToneOperator::false_color));
  const std::vector<std::uint16_t> codes = codes_of(chain, even_light(view, 50.0));
  const f64::vec3 expected = f64::false_color(50.0);
  const std::size_t at = std::size_t{4} * (100 * 240 + 100);
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(codes[at + static_cast<std::size_t>(channel)] / 65535.0, f64::srgb_encode(expected[channel]), 2.0e-4);
  }
  EXPECT_GT(light_at(codes, 240, 240 - 20, 238, display, 0.0).y, 100.0); // the bar's bright end
  EXPECT_LT(light_at(codes, 240, 20, 238, display, 0.0).y, 5.0);         // and its dark one
}

TEST_F(DisplayChains, PointsAreKeptApartAndHiddenByWhatCoversThem) {
  const View view = square_view(96, 20.0 * deg);
  const std::vector<StarRecord> stars{white_star(direction_at(view, {48.3, 47.6}), 2.54e-6)};
  renderer.load(catalogue_of(stars));
  const SkyState sky = still_sky();
  const FramePlan plan = plan_frame(sky, view, stars, bare_stars());
  chain.use(deep());
  const gpu::Frame alone = renderer.render(sky, view, plan);
  const gpu::Frame mapped = renderer.render(sky, view, plan, {.xyzs = true, .mapping = &chain});
  EXPECT_EQ(alone.xyzs, mapped.xyzs);
  // Nothing but points: what the meter sees is black.
  for (const double bin : chain.histogram().seen) {
    ASSERT_EQ(bin, 0.0);
  }
  EXPECT_GT(*std::max_element(mapped.rgba16.begin(), mapped.rgba16.end() - 1), 10000);
}

/// A sky's luminance at the zenith by the Sun's altitude, cd/m2, of a clear sky: Koomen et al. 1952 (J. Opt. Soc. Am.
/// 42, 353) in twilight, with the dark sky behind it.
struct Dusk {
  double sun_altitude_deg, luminance;
};
constexpr std::array<Dusk, 8> dusks{{{30.0, 2.6e3},
                                     {10.0, 1.0e3},
                                     {0.0, 2.0e2},
                                     {-4.0, 9.0},
                                     {-6.0, 1.1},
                                     {-9.0, 0.03},
                                     {-12.0, 2.5e-3},
                                     {-18.0, 2.7e-4}}};

TEST_F(DisplayChains, TheFaintestStarOnTheDisplayIsTheFaintestInTheSky) {
  ErrorSum error;
  constexpr int side = 192;
  constexpr int across = 5;
  constexpr int apart = side / across;
  const View view = square_view(side, 40.0 * deg);
  for (const double peak : {50.0, 200.0, 1000.0}) {
    const Display screen{.peak = peak * candela_per_m2, .black = 0.001 * peak * candela_per_m2};
    const f64::DisplayModel display = display_model(screen);
    for (const Dusk& dusk : dusks) {
      // Of star and sky alike, so that thresholds count their photopic light.
      constexpr double sp_ratio = f64::usual_star_sp_ratio;
      const double predicted =
          f64::magnitude_of(f64::threshold_illuminance_lux(dusk.luminance, f64::default_field_factor));
      // Magnitudes about the limit, at places of their own within their pixels.
      std::vector<StarRecord> stars;
      std::vector<Vec2> places;
      for (int i = 0; i < across * across; ++i) {
        const double magnitude = predicted - 1.2 + 0.1 * i;
        const int line = i / across;
        const Vec2 at(apart * (i % across) + 19.1 + 0.13 * i, apart * line + 18.7 + 0.07 * i);
        stars.push_back(white_star(direction_at(view, at), f64::zero_magnitude_lux * std::pow(10.0, -0.4 * magnitude)));
        stars.back().color = {0.99F, 1.0F, 0.8F, static_cast<float>(sp_ratio)};
        places.push_back(at);
      }
      renderer.load(catalogue_of(stars));
      const gpu::Frame drawn = renderer.render(still_sky(), view, plan_frame(still_sky(), view, stars, bare_stars()));
      PictureLight light = even_light(view, dusk.luminance, sp_ratio);
      light.points = drawn.xyzs;
      std::transform(light.frame.begin(), light.frame.end(), drawn.xyzs.begin(), light.frame.begin(), std::plus<>());
      gpu::DisplaySettings settings = deep(ToneOperator::visibility, screen);
      settings.optics.glare = settings.optics.acuity = peak == 200.0; // which must not hide what the eye sees
      chain.use(settings);
      const std::vector<std::uint16_t> codes = codes_of(chain, light);
      // The faintest of those that are seen without a gap.
      double measured = predicted - 1.3;
      for (const Vec2& place : places) {
        const SeenExcess excess = excess_at(codes, view, static_cast<int>(place.x), static_cast<int>(place.y), 10,
                                            display, chain.curve().mean_cd_m2);
        if (excess.lux < f64::threshold_illuminance_lux(excess.background_cd_m2, f64::default_field_factor)) {
          break;
        }
        measured += 0.1;
      }
      std::printf("display of %4.0f cd/m2, Sun at %3.0f deg: limit %.2f predicted, %.2f measured\n", peak,
                  dusk.sun_altitude_deg, predicted, measured);
      error.add(measured - predicted);
    }
  }
  error.hold("limiting magnitude on the mapped frame against the sky's", 0.5, "mag");
}

} // namespace
} // namespace vesper::test
