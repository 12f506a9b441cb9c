// A picture of the sky through the tool, against what it was made from.

#include "support/sky_picture.hpp"
#include "support/truth.hpp"

#include "vesper/assets/cube_texels.hpp"
#include "vesper/assets/default_stars.hpp"
#include "vesper/base/files.hpp"
#include "vesper/catalog_tools/celestial_axes.hpp"
#include "vesper/catalog_tools/pixel_corners.hpp"

#include <gtest/gtest.h>

#include <erfa.h>
#include <numbers>
#include <random>

namespace vesper {
namespace {

using test::ErrorSum;
using test::header_in;
using test::MadePicture;
using test::plain_options;
using test::SkyHeader;

constexpr double sphere_sr = 4.0 * std::numbers::pi;
const std::vector<std::string> projections{"CAR", "AIT", "MOL", "TAN", "ZEA", "HPX"};

/// The cards of the real Mellinger panorama's header, 3600 x 1800.
std::string real_cards() {
  const Bytes bytes = read_file(VESPER_TEST_DATA "/panorama/mwpan2_RGB_3600.hdr");
  std::string cards;
  std::string line;
  for (const std::byte byte : bytes) {
    if (static_cast<char>(byte) == '\n') {
      line.resize(80, ' ');
      cards += line;
      line.clear();
    } else {
      line += static_cast<char>(byte);
    }
  }
  return cards;
}

/// Whether a direction lies in a picture and not at its end.
bool lies_inside(const SkyHeader& header, PictureWcs& wcs, const Vec3& direction, double margin_px) {
  const auto place = wcs.place(direction);
  // ZEA pulls the antipode out to a circle.
  constexpr double near_antipode = 1.95;
  const Vec2 middle = 0.5 * Vec2(header.width, header.height);
  return place && place->x > margin_px && place->y > margin_px && place->x < header.width - margin_px &&
         place->y < header.height - margin_px &&
         (header.projection != "ZEA" || distance(direction, wcs.direction(middle)) < near_antipode);
}

/// A smooth sky: constant, dipole and a term of the second order. Its integral is that of the constant.
double smooth_sky(const Vec3& d) { return 2.0 + 0.7 * d.x - 0.5 * d.z + 0.9 * d.x * d.y; }

TEST(PanoramaAccuracy, TotalLightInEveryProjection) {
  for (const std::string& projection : projections) {
    const SkyHeader header = header_in(projection);
    MadePicture picture = header.picture();
    picture.paint(0, header.wcs(), smooth_sky);
    const PanoramaReport report =
        make_panorama(picture, header.wcs(), "made.fits", "HDU 1", plain_options(1, 128)).report;
    double expected = 2.0 * sphere_sr;
    if (projection == "TAN") {
      // The picture's square on the plane at distance 1, by the midpoint rule.
      const double half = 0.5 * header.width * (header.scale_deg * deg).to(rad);
      PictureWcs wcs = header.wcs();
      expected = 0.0;
      constexpr int steps = 400;
      for (int i = 0; i < steps * steps; ++i) {
        const int row = i / steps;
        const Vec2 place((i % steps + 0.5) / steps, (row + 0.5) / steps);
        const Vec2 plane = half * (2.0 * place - 1.0);
        const double solid_angle =
            std::pow(2.0 * half / steps, 2.0) / std::pow(1.0 + plane.x * plane.x + plane.y * plane.y, 1.5);
        expected += solid_angle * smooth_sky(wcs.direction(place * static_cast<double>(header.width)));
      }
      EXPECT_GT(report.dark_sr, 0.5 * sphere_sr);
    } else {
      EXPECT_EQ(report.dark_sr, 0.0) << projection;
    }
    ErrorSum error;
    error.add(100.0 * (report.out.light[0] / expected - 1.0));
    error.hold("Total light of a picture, " + projection, 0.1, "%");
    // By construction, up to the rounding of sums of floats.
    EXPECT_NEAR(report.in.light[0] - report.overlapped.light[0] + report.filled.light[0], report.out.light[0],
                2e-6 * report.out.light[0])
        << projection;
  }
}

TEST(PanoramaAccuracy, AConstantSkyStaysConstant) {
  for (const std::string& projection : projections) {
    for (const int face_size : {16, 129}) {
      const SkyHeader header = header_in(projection);
      PictureWcs wcs = header.wcs();
      MadePicture picture = header.picture();
      picture.paint(0, wcs, [](const Vec3&) { return 3.0; });
      const Panorama map = make_panorama(picture, header.wcs(), "made.fits", "HDU 1", plain_options(1, face_size)).map;
      ErrorSum error;
      for (std::size_t i = 0; i < map.cube().sums.size(); ++i) {
        // TAN is a part of the sky, whose end is not filled.
        if (projection != "TAN" ||
            lies_inside(header, wcs, cube_texel(face_size, i).direction, 2.0 + 400.0 / face_size)) {
          error.add(100.0 * (static_cast<double>(map.texel(i)[1]) / 3.0 - 1.0));
        }
      }
      error.hold(fmt::format("A constant sky, {} onto faces of {}", projection, face_size), 0.1, "%");
    }
  }
}

TEST(PanoramaAccuracy, RecoversASmoothSky) {
  for (const std::string& projection : projections) {
    const SkyHeader header = header_in(projection);
    MadePicture picture = header.picture();
    PictureWcs wcs = header.wcs();
    picture.paint(0, wcs, smooth_sky);
    const Panorama map = make_panorama(picture, wcs, "made.fits", "HDU 1", plain_options(1, 64)).map;
    ErrorSum error;
    for (std::size_t i = 0; i < map.cube().sums.size(); ++i) {
      const CubeTexel texel = cube_texel(map.face_size(), i);
      if (lies_inside(header, wcs, texel.direction, 8.0)) {
        error.add(100.0 * (static_cast<double>(map.texel(i)[1]) - smooth_sky(texel.direction)) / 2.0);
      }
    }
    EXPECT_GT(error.count(), projection == "TAN" ? 3000U : 20000U);
    error.hold("A gradient, " + projection, 0.5, "% of the mean");
  }
}

TEST(PanoramaAccuracy, PointSourcesStayInPlace) {
  for (const std::string& projection : projections) {
    const SkyHeader header = header_in(projection);
    PictureWcs wcs = header.wcs();
    // Stars as a telescope shows them, one standard deviation a pixel, far from one another.
    const double sigma = (header.scale_deg * deg).to(rad);
    std::mt19937 random(7); // NOLINT(cert-msc32-c,cert-msc51-cpp): the same places every time
    std::normal_distribution<double> normal;
    std::vector<Vec3> stars;
    while (stars.size() < 12) {
      const Vec3 star = normalize(Vec3(normal(random), normal(random), normal(random)));
      const bool far = std::all_of(stars.begin(), stars.end(),
                                   [&](const Vec3& other) { return distance(star, other) > 20.0 * sigma; });
      // Maps of the whole sky go on at the other side.
      const bool whole = projection != "TAN" && projection != "ZEA";
      const bool drawn = whole || lies_inside(header, wcs, star, 10.0);
      if (far && drawn) {
        stars.push_back(star);
      }
    }
    MadePicture picture = header.picture();
    picture.paint(0, wcs, [&](const Vec3& direction) {
      double light = 0.0;
      for (const Vec3& star : stars) {
        const double apart = distance(direction, star) / sigma;
        light += apart < 7.0 ? std::exp(-0.5 * apart * apart) : 0.0;
      }
      return light;
    });
    const Panorama map = make_panorama(picture, wcs, "made.fits", "HDU 1", plain_options(1, 256)).map;
    std::vector<Vec3> moments(stars.size());
    std::vector<double> light(stars.size());
    for (std::size_t i = 0; i < map.cube().sums.size(); ++i) {
      const double value = static_cast<double>(map.texel(i)[1]);
      const CubeTexel texel = cube_texel(map.face_size(), i);
      for (std::size_t s = 0; s < stars.size() && value != 0.0; ++s) {
        if (distance(texel.direction, stars[s]) < 9.0 * sigma) {
          moments[s] += value * texel.solid_angle_sr * texel.direction;
          light[s] += value * texel.solid_angle_sr;
        }
      }
    }
    ErrorSum places;
    ErrorSum totals;
    for (std::size_t s = 0; s < stars.size(); ++s) {
      places.add(distance(normalize(moments[s]), stars[s]) / sigma);
      totals.add(100.0 * (light[s] / (2.0 * std::numbers::pi * sigma * sigma) - 1.0));
    }
    places.hold("Place of a point source, " + projection, 0.1, "pixels");
    totals.print(("Light of a point source, " + projection).c_str(), "%");
  }
}

TEST(PanoramaAccuracy, RealGeometry) {
  // 3600 x 1800, CD matrix alone, no CRVAL, no LONPOLE: column 1800.950026799 is galactic longitude 0, row
  // 900.950013387949 latitude 0, 0.099999998509884 degrees a pixel.
  PictureWcs wcs(real_cards(), "mwpan2_RGB_3600.hdr", "HDU 1");
  wcs.require_on_sphere(3600, 1800);
  const auto galactic = [](double column, double row) {
    return test::direction((1800.950026799 - column) * 0.099999998509884 * deg,
                           (row - 900.950013387949) * 0.099999998509884 * deg);
  };
  // The galactic axes in ICRS (ESA 1997, Hipparcos catalogue, volume 1, equation 1.5.11).
  const Mat3 galactic_from_icrs(Vec3(-0.0548755604, 0.4941094279, -0.8676661490),
                                Vec3(-0.8734370902, -0.4448296300, -0.1980763734),
                                Vec3(-0.4838350155, 0.7469822445, 0.4559837762));
  ErrorSum placed;
  for (int row = 2; row < 1800; row += 97) {
    for (int column = 1; column < 3600; column += 89) {
      const Vec3 direction = galactic_from_icrs * wcs.direction({column - 0.5, row - 0.5});
      placed.add(test::separation(direction, galactic(column, row)).to(arcsec));
    }
  }
  placed.hold("Pixels of the real header", 0.01, "arcsec");

  // Constant, band and points, a channel each.
  const auto band = [&](const Vec3& icrs) {
    const Vec3 g = galactic_from_icrs * icrs;
    return std::exp(-30.0 * g.z * g.z) * (1.5 + g.x);
  };
  MadePicture picture(3600, 1800, 3);
  picture.paint(0, wcs, [](const Vec3&) { return 5.0; });
  picture.paint(1, wcs, band);
  picture.at(2, 1234, 1300) = 1.0e4F;
  const PanoramaProduct product = make_panorama(picture, wcs, "made.fits", "HDU 1", plain_options(3, 512));
  ErrorSum constant;
  ErrorSum gradient;
  for (std::size_t i = 0; i < product.map.cube().sums.size(); ++i) {
    const auto light = product.map.texel(i);
    constant.add(100.0 * (static_cast<double>(light[0]) / 5.0 - 1.0));
    gradient.add(100.0 * (static_cast<double>(light[1]) - band(cube_texel(512, i).direction)) / 2.5);
  }
  constant.hold("A constant sky in the real geometry", 0.1, "%");
  gradient.hold("A band in the real geometry", 0.1, "% of its peak");
  // Integral of exp(-30 z^2)(1.5 + x): the second term vanishes, the first is 2 pi 1.5 sqrt(pi / 30) erf(sqrt(30)).
  const double expected = 3.0 * std::numbers::pi * std::sqrt(std::numbers::pi / 30.0) * std::erf(std::sqrt(30.0));
  ErrorSum flux;
  flux.add(100.0 * (product.report.out.light[1] / expected - 1.0));
  flux.hold("Total light of a band in the real geometry", 0.1, "%");
  Vec3 sum(0.0);
  for (std::size_t i = 0; i < product.map.cube().sums.size(); ++i) {
    sum +=
        static_cast<double>(product.map.texel(i)[2]) * cube_texel(512, i).solid_angle_sr * cube_texel(512, i).direction;
  }
  ErrorSum point;
  point.add(test::separation(galactic_from_icrs * sum, galactic(1235, 1301)).to(deg) / 0.1);
  point.hold("A point source in the real geometry", 0.1, "pixels");
}

TEST(PanoramaAccuracy, InterpolatedCorners) {
  for (const std::string& projection : projections) {
    for (const int finer : {1, 10}) {
      const SkyHeader header = header_in(projection, finer);
      PictureWcs wcs = header.wcs();
      ErrorSum error;
      for (int y = 0; y + 64 <= header.height; y += 64 * finer) {
        for (int x = 0; x + 64 <= header.width; x += 64 * finer) {
          const PixelBox box{x, y, 64, 64};
          const PixelCorners corners(wcs, box);
          for (int i = 0; i < 65 * 65; i += 7) {
            const Vec2 place(x + i % 65, y + i / 65);
            const Vec3 exact = wcs.direction(place);
            const Vec3 beside = wcs.direction(place + Vec2(0.0, 1.0));
            if (exact != Vec3(0.0) && beside != Vec3(0.0)) {
              error.add(distance(corners.all()[static_cast<std::size_t>(i)], exact) / distance(exact, beside));
            }
          }
        }
      }
      error.hold(fmt::format("Interpolated corners, {} with {} pixels a degree", projection, finer), 0.1, "pixels");
    }
  }
}

/// The embedded stars on a background that rises to the plane of the Milky Way, in a map of the real size: each a
/// Gaussian of one pixel on the sky. A unit is `unit` cd/m2.
struct StarrySky {
  static constexpr double unit = 3.0e-6;
  SkyHeader header{"CAR", "GLON", "GLAT", 3600, 1800, 0.1, 0.0, 0.0, ""};
  double sigma = (0.1 * deg).to(rad);

  static double background(const Vec3& icrs) {
    const double sine = dot(icrs, direction_of(sky_fields()[0]));
    return 40.0 + 160.0 * std::exp(-20.0 * sine * sine);
  }
  void paint(MadePicture& made) const {
    PictureWcs wcs = header.wcs();
    made.paint(0, wcs, background);
    const StarCatalogue& catalogue = default_star_catalogue();
    for (const StarRecord& star : catalogue.stars) {
      const Vec3 direction(star.position[0], star.position[1], star.position[2]);
      const Vec2 place = *wcs.place(direction);
      const double peak = static_cast<double>(star.illuminance) / (2.0 * std::numbers::pi * sigma * sigma) / unit;
      const double stretch = 1.0 / std::max(std::cos((place.y - 900.0) * 0.1 * deg.to(rad)), 1e-3);
      const int reach_x = std::min(static_cast<int>(std::ceil(7.0 * stretch)), 1799);
      for (int y = std::max(static_cast<int>(place.y) - 7, 0); y <= std::min(static_cast<int>(place.y) + 7, 1799);
           ++y) {
        for (int step = -reach_x; step <= reach_x; ++step) {
          const int x = (static_cast<int>(place.x) + step + 3600) % 3600;
          const double apart = distance(wcs.direction({x + 0.5, y + 0.5}), normalize(direction)) / sigma;
          if (apart < 7.0) {
            made.at(0, x, y) += static_cast<float>(peak * std::exp(-0.5 * apart * apart));
          }
        }
      }
    }
  }
};

TEST(PanoramaAccuracy, StarsGiveTheZeroPointAndGo) {
  const StarrySky sky;
  MadePicture made = sky.header.picture();
  sky.paint(made);
  const StarCatalogue& catalogue = default_star_catalogue();
  PictureWcs wcs = sky.header.wcs();
  PanoramaStars stars(catalogue, "embedded stars", wcs, 3600, 1800, {});
  PictureStrip strip{0, 1800, 3600, 1, std::vector<float>(3600UL * 1800UL)};
  made.read(0, 0, strip.values);
  stars.process(strip, 1801);

  const ZeroPointFit fit = fit_zero_point(stars.measured(), channel_transform("mono", 1), {}, "made.fits");
  ErrorSum zero_point;
  zero_point.add(-2.5 * std::log10(fit.cd_m2_per_unit / StarrySky::unit));
  zero_point.hold("Zero point by stars", 0.02, "mag");
  ErrorSum residual;
  residual.add(fit.residual_mag);
  residual.hold("Residual of a star in the fit", 0.05, "mag");
  EXPECT_GT(fit.stars, 1000U);

  // Around every star of V < 6 without a neighbour: the light that is left, and the ring of 3 to 6 pixels.
  ErrorSum left;
  ErrorSum ring;
  for (std::size_t i = 0; i < catalogue.stars.size() && catalogue.identities[i].magnitude < 6.0F; ++i) {
    const StarRecord& star = catalogue.stars[i];
    const Vec3 direction = normalize(Vec3(star.position[0], star.position[1], star.position[2]));
    const bool alone = std::none_of(catalogue.stars.begin(), catalogue.stars.end(), [&](const StarRecord& other) {
      const double apart = distance(Vec3(other.position[0], other.position[1], other.position[2]), direction);
      return apart < 14.0 * sky.sigma && &other != &star;
    });
    if (!alone) {
      continue;
    }
    const Vec2 place = *wcs.place(direction);
    if (std::abs(place.y - 900.0) > 700.0) {
      continue; // where a pixel's width is a third of its height
    }
    double light = 0.0;
    double ring_change = 0.0;
    double ring_light = 0.0;
    for (int y = std::max(static_cast<int>(place.y) - 8, 0); y <= std::min(static_cast<int>(place.y) + 8, 1799); ++y) {
      for (int step = -30; step <= 30; ++step) {
        const int x = (static_cast<int>(place.x) + step + 3600) % 3600;
        const Vec3 there = wcs.direction({x + 0.5, y + 0.5});
        const double apart = distance(there, direction) / sky.sigma;
        const double above = static_cast<double>(strip.row(0, y)[x]) - StarrySky::background(there);
        const double pixel = std::cos((y + 0.5 - 900.0) * 0.1 * deg.to(rad)) * sky.sigma * sky.sigma;
        light += apart < 6.0 ? above * pixel : 0.0;
        if (apart >= 3.0 && apart < 6.0) {
          ring_change += above;
          ring_light += StarrySky::background(there);
        }
      }
    }
    left.add(100.0 * light * StarrySky::unit / static_cast<double>(star.illuminance));
    ring.add(100.0 * ring_change / ring_light);
  }
  EXPECT_GT(left.count(), 500U);
  left.hold("Light left of a removed star, V < 6", 3.0, "%");
  ring.hold("Background around a removed star", 2.0, "%");
}

TEST(PanoramaAccuracy, FramesAgree) {
  // One place, Vega's at J2000, written in five frames: galactic and ecliptic as catalogues print it, B1950 by ERFA for
  // a star without motion (with the E-terms of aberration, up to 0.34").
  double ra_1950 = 0.0;
  double dec_1950 = 0.0;
  double unused = 0.0;
  eraFk54z((279.2347348 * deg).to(rad), (38.7836889 * deg).to(rad), 1950.0, &ra_1950, &dec_1950, &unused, &unused);
  const Vec3 vega = test::direction(279.2347348 * deg, 38.7836889 * deg);
  struct Case {
    const char *longitude, *latitude;
    double lon, lat;
    std::string more;
    double tolerance_arcsec;
  };
  const std::vector<Case> cases{
      {"RA--", "DEC-", 279.2347348, 38.7836889, test::card("RADESYS", "ICRS"), 0.001},
      {"RA--", "DEC-", 279.2347348, 38.7836889, test::card("RADESYS", "FK5") + test::card("EQUINOX", 2000.0), 0.05},
      {"RA--", "DEC-", (ra_1950 * rad).to(deg), (dec_1950 * rad).to(deg),
       test::card("RADESYS", "FK4") + test::card("EQUINOX", 1950.0), 0.4},
      {"GLON", "GLAT", 67.4482, 19.2373, "", 0.4},
      {"ELON", "ELAT", 285.3171, 61.7326, "", 2.0},
  };
  for (const Case& c : cases) {
    SkyHeader header{"TAN", c.longitude, c.latitude, 100, 100, 0.01, c.lon, c.lat, c.more};
    const Vec3 direction = header.wcs().direction({50.0, 50.0});
    ErrorSum error;
    error.add(test::separation(direction, vega).to(arcsec));
    error.hold(fmt::format("Axes {} {}", c.longitude, header.wcs().description()), c.tolerance_arcsec, "arcsec");
  }
}

} // namespace
} // namespace vesper
