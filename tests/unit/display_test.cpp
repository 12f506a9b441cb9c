// The display's model against published figures, analytic answers and a dome of patches that light each other.
#include "vesper/plan/display.hpp"

#include "support/expect_error.hpp"
#include "support/truth.hpp"

#include <cstdio>
#include <random>
#include <vector>

namespace vesper {
namespace {

constexpr std::array all_primaries{Primaries::srgb, Primaries::display_p3, Primaries::rec2020};
constexpr std::array all_transfers{Transfer::srgb, Transfer::gamma, Transfer::pq};
const Vec3 d65_white(0.3127 / 0.3290, 1.0, 0.3583 / 0.3290);

Mat3 published_matrix(Primaries primaries) {
  // Rows of X, Y and Z: IEC 61966-2-1; SMPTE EG 432-1 with D65; ITU-R BT.2020 gives Y, BT.2087 all.
  switch (primaries) {
  case Primaries::srgb:
    return glm::transpose(Mat3(0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505));
  case Primaries::display_p3:
    return glm::transpose(Mat3(0.4866, 0.2657, 0.1982, 0.2290, 0.6917, 0.0793, 0.0000, 0.0451, 1.0439));
  case Primaries::rec2020:
    break;
  }
  return glm::transpose(Mat3(0.6370, 0.1446, 0.1689, 0.2627, 0.6780, 0.0593, 0.0000, 0.0281, 1.0610));
}

Mat3 matrix_of(Primaries primaries) { return f64::xyz_from_rgb(f64::chromaticities_of(static_cast<int>(primaries))); }

TEST(Display, MatricesAreThePublishedOnes) {
  test::ErrorSum errors;
  for (const Primaries primaries : all_primaries) {
    const Mat3 difference = matrix_of(primaries) - published_matrix(primaries);
    for (int i = 0; i < 9; ++i) {
      errors.add(difference[i / 3][i % 3]);
    }
    EXPECT_LT(glm::distance(matrix_of(primaries) * Vec3(1.0), d65_white), 1.0e-12);
  }
  errors.hold("linear RGB to XYZ against the standards' four digits", 1.0e-4, "of the white's Y");
}

TEST(Display, TransfersAreThePublishedOnes) {
  // SMPTE ST 2084, by the figures of ITU-R BT.2408-7 (203 cd/m2: 58 %; 1000: 75 %) and of colour-science 0.4 (100).
  EXPECT_NEAR(f64::pq_encode(100.0), 0.508078421517399, 1.0e-12);
  EXPECT_NEAR(f64::pq_encode(203.0), 0.58, 0.005);
  EXPECT_NEAR(f64::pq_encode(1000.0), 0.75, 0.005);
  EXPECT_NEAR(f64::pq_encode(10000.0), 1.0, 1.0e-12);
  EXPECT_LT(f64::pq_encode(0.0), 1.0e-6);
  EXPECT_DOUBLE_EQ(f64::pq_c1, f64::pq_c3 - f64::pq_c2 + 1.0) << "as the standard has it";
  // IEC 61966-2-1: the middle of the codes is 21.4 % of the light; the line meets the power within a part in 1e5.
  EXPECT_NEAR(f64::srgb_decode(0.5), 0.21404114, 1.0e-7);
  EXPECT_NEAR(f64::srgb_encode(0.0031308), 12.92 * 0.0031308, 1.0e-12);
  EXPECT_NEAR(f64::srgb_encode(0.0031308 + 1.0e-9), 12.92 * 0.0031308, 1.0e-6);
}

TEST(Display, TheQuickTransferIsTheStandards) {
  test::ErrorSum of_double;
  test::ErrorSum of_single;
  for (int i = 0; i <= 65535; ++i) {
    const double linear = f64::srgb_decode(i / 65535.0);
    of_double.add(65535.0 * f64::quick_srgb_encode(linear) - i);
    of_single.add(65535.0 * static_cast<double>(f32::quick_srgb_encode(static_cast<float>(linear))) - i);
  }
  of_double.hold("sRGB's transfer without a power", 0.1, "steps of 16 bits");
  of_single.hold("the same in single precision", 0.12, "steps of 16 bits");
  EXPECT_EQ(f32::quick_srgb_encode(0.0F), 0.0F);
  EXPECT_NEAR(f64::quick_srgb_encode(1.0), 1.0, 1.0e-9);
}

TEST(Display, CodesAndLightAreEachOthersInverse) {
  test::ErrorSum light_errors;
  test::ErrorSum code_errors;
  for (const Primaries primaries : all_primaries) {
    for (const Transfer transfer : all_transfers) {
      Display display;
      display.primaries = primaries;
      display.transfer = transfer;
      display.gamma = 2.4;
      display.dome_gain = 0.6;
      display.dome_reflectance = 0.45;
      const f64::DisplayModel model = display_model(display);
      for (int i = 0; i < 1000; ++i) {
        const Vec3 codes = Vec3(i % 10, i / 10 % 10, i / 100) / 9.0 * f64::transfer_encode(1.0, model);
        const Vec3 light = f64::display_light(codes, model, 30.0);
        const Vec3 again = f64::display_codes(light, model, 30.0);
        const Vec3 difference = f64::display_light(again, model, 30.0) - light;
        light_errors.add(glm::length(difference) / light.y);
        // Beside 0 codes of the power and of PQ are steep: a rounding error of light is many codes there.
        for (int channel = 0; channel < 3; ++channel) {
          code_errors.add(codes[channel] > 0.0 ? again[channel] - codes[channel] : 0.0);
        }
      }
    }
  }
  light_errors.hold("light to codes to light", 1.0e-9, "of the light");
  code_errors.hold("codes to light to codes", 1.0e-7, "of full scale");
}

TEST(Display, ShowsItsFloorWhereNothingIsSentAndItsCeilingWhereAllIs) {
  Display display;
  display.peak = 100.0 * candela_per_m2;
  display.black = 0.1 * candela_per_m2;
  display.ambient = 0.4 * candela_per_m2;
  const f64::DisplayModel model = display_model(display);
  EXPECT_LT(glm::distance(f64::display_light(Vec3(0.0), model, 7.0), 0.5 * d65_white), 1.0e-12);
  EXPECT_LT(glm::distance(f64::display_light(Vec3(1.0), model, 7.0), 100.4 * d65_white), 1.0e-10);
  EXPECT_EQ(f64::display_codes(0.5 * d65_white, model, 7.0), Vec3(0.0));
  EXPECT_EQ(f64::display_codes(0.2 * d65_white, model, 7.0), Vec3(0.0));
  EXPECT_LT(glm::distance(f64::display_codes(100.4 * d65_white, model, 7.0), Vec3(1.0)), 1.0e-12);
  EXPECT_LT(glm::distance(f64::display_codes(1.0e9 * d65_white, model, 7.0), Vec3(1.0)), 1.0e-12);
  // A grey between, by hand: (20 - 0.5) / 99.9 of the range.
  const Vec3 grey = f64::display_codes(20.0 * d65_white, model, 7.0);
  EXPECT_NEAR(grey.y, 1.055 * std::pow(19.5 / 99.9, 1.0 / 2.4) - 0.055, 1.0e-12);
  EXPECT_NEAR(grey.x, grey.y, 1.0e-12);
  EXPECT_NEAR(grey.z, grey.y, 1.0e-12);
  // PQ is absolute, over what the display adds.
  display.transfer = Transfer::pq;
  EXPECT_NEAR(f64::display_codes(20.0 * d65_white, display_model(display), 7.0).y, f64::pq_encode(19.5), 1.0e-12);
}

TEST(Display, ColoursOutsideTheGamutKeepLuminanceAndHue) {
  Display display;
  display.black = display.ambient = Luminance();
  test::ErrorSum luminance_errors;
  test::ErrorSum hue_errors;
  std::size_t outside = 0;
  for (const Primaries primaries : all_primaries) {
    display.primaries = primaries;
    const f64::DisplayModel model = display_model(display);
    // Over the whole triangle of x and y and far beyond, negative components included.
    for (const double y : {1.0e-3, 1.0, 20.0, 100.0, 180.0, 199.9}) {
      for (int i = 0; i < 900; ++i) {
        const Vec2 chromaticity(0.01 + 0.05 * (i % 30) - 0.3, 0.02 + 0.03 * std::floor(i / 30.0));
        const Vec3 xyz = y * f64::xyz_of_chromaticity(chromaticity);
        const Vec3 signal = f64::display_signal(xyz, model, 0.0);
        for (int channel = 0; channel < 3; ++channel) {
          ASSERT_GE(signal[channel], 0.0);
          ASSERT_LE(signal[channel], 1.0);
        }
        const Vec3 shown = matrix_of(primaries) * signal * model.range_cd_m2;
        luminance_errors.add(shown.y / y - 1.0);
        const Vec3 wanted_hue = xyz - y * d65_white;
        const Vec3 hue = shown - shown.y * d65_white;
        if (glm::distance(shown, xyz) > 1.0e-9 * y) {
          ++outside;
          hue_errors.add(glm::length(glm::cross(hue, glm::normalize(wanted_hue))) / y);
          EXPECT_GE(glm::dot(hue, wanted_hue), -1.0e-9 * y * y);
          // As much of the colour as fits: it lies on the gamut's border.
          EXPECT_LT(std::min({signal.x, signal.y, signal.z, 1.0 - signal.x, 1.0 - signal.y, 1.0 - signal.z}), 1.0e-9);
        }
      }
    }
  }
  EXPECT_GT(outside, 5000U);
  luminance_errors.hold("luminance of colours brought into the gamut", 1.0e-9, "of it");
  hue_errors.hold("their distance from the line to grey", 1.0e-9, "of the luminance");
}

/// A hemisphere of patches of equal size and its own light, which they reflect to each other: the luminance that each
/// gets from the others, by the radiosity of every pair.
std::vector<double> light_of_the_others(const std::vector<double>& own, double reflectance) {
  const std::size_t count = own.size();
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < count; ++i) {
    // Fibonacci's lattice.
    const double z = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double angle = 2.399963229728653 * static_cast<double>(i);
    places.emplace_back(std::sqrt(1.0 - z * z) * std::cos(angle), std::sqrt(1.0 - z * z) * std::sin(angle), z);
  }
  const double area = 2.0 * std::numbers::pi / static_cast<double>(count);
  std::vector<double> added(count, 0.0);
  for (int bounce = 0; bounce < 60; ++bounce) {
    std::vector<double> next(count, 0.0);
    for (std::size_t to = 0; to < count; ++to) {
      for (std::size_t from = 0; from < count; ++from) {
        if (to != from) {
          const Vec3 way = places[from] - places[to];
          const double square = glm::dot(way, way);
          // The normals point to the centre.
          const double cosines = glm::dot(way, -places[to]) * glm::dot(way, places[from]) / square;
          next[to] += reflectance / std::numbers::pi * (own[from] + added[from]) * cosines / square * area;
        }
      }
    }
    added = next;
  }
  return added;
}

TEST(Display, ADomeLightsItselfAsItsPatchesDo) {
  // A night sky with a bright quarter.
  std::vector<double> own(600, 0.01);
  for (std::size_t i = 0; i < 150; ++i) {
    own[i] = 3.0;
  }
  test::ErrorSum errors;
  for (const double reflectance : {0.2, 0.45, 0.7}) {
    const std::vector<double> added = light_of_the_others(own, reflectance);
    double mean = 0.0;
    for (std::size_t i = 0; i < own.size(); ++i) {
      mean += (own[i] + added[i]) / static_cast<double>(own.size());
    }
    Display dome;
    dome.black = dome.ambient = Luminance();
    dome.dome_reflectance = reflectance;
    const double veil = f64::display_floor_cd_m2(display_model(dome), mean);
    for (const double light : added) {
      errors.add(veil / light - 1.0);
    }
  }
  errors.hold("veil of a dome against 600 patches", 0.01, "of it");
}

TEST(Display, ADomesPictureTakesItsVeilOff) {
  Display dome;
  dome.peak = 5.0 * candela_per_m2;
  dome.black = 0.001 * candela_per_m2;
  dome.ambient = Luminance();
  dome.dome_gain = 0.5;
  dome.dome_reflectance = 0.5;
  const f64::DisplayModel model = display_model(dome);
  // Half the gain, half the white: 2.5 cd/m2; half the sphere, half of it reflected: a quarter of the mean.
  EXPECT_NEAR(f64::display_floor_cd_m2(model, 0.4), 0.0005 + 0.1, 1.0e-12);
  EXPECT_NEAR(f64::display_ceiling_cd_m2(model, 0.4), 2.5 + 0.1, 1.0e-12);
  EXPECT_EQ(f64::display_codes(0.1 * d65_white, model, 0.4), Vec3(0.0));
  EXPECT_GT(f64::display_codes(0.1 * d65_white, model, 0.0).y, 0.1);
}

TEST(Display, TheViewersPixelsAreThoseOfADesk) {
  // 24 inches of 16 to 9 in 1920 pixels from 60 cm: 0.2768 mm and, by the tangent of a degree, 37.8 a degree.
  EXPECT_NEAR(Display().pixels_per_degree,
              600.0 * std::tan((1.0 * deg).to(rad)) / (609.6 * 16.0 / std::hypot(16.0, 9.0) / 1920.0), 0.02);
  EXPECT_NEAR(display_model(Display()).pixel_sr, std::pow((1.0 * deg).to(rad) / 37.84, 2.0), 1.0e-9);
}

TEST(Display, APictureFillsAMonitorOrADome) {
  View view;
  view.width = 2560;
  view.height = 1440;
  // As wide an angle as 1080 rows of the default monitor take.
  EXPECT_NEAR(1440.0 / usual_pixels_per_degree({}, view), 1080.0 / Display().pixels_per_degree, 1.0e-9);
  Display dome;
  dome.dome_reflectance = 0.4;
  EXPECT_NEAR(usual_pixels_per_degree(dome, view), 1440.0 / 180.0, 1.0e-9);
  view.width = view.height = 1;
  EXPECT_EQ(usual_pixels_per_degree({}, view), pixels_per_degree_range.lowest);
}

TEST(Display, NamesAreThereAndBack) {
  for (const Primaries primaries : all_primaries) {
    EXPECT_EQ(primaries_from_name(primaries_names()[static_cast<std::size_t>(primaries)]), primaries);
  }
  for (const Transfer transfer : all_transfers) {
    EXPECT_EQ(transfer_from_name(transfer_names()[static_cast<std::size_t>(transfer)]), transfer);
  }
  EXPECT_EQ(primaries_from_name("adobe"), std::nullopt);
  EXPECT_EQ(transfer_from_name(""), std::nullopt);
}

} // namespace
} // namespace vesper
