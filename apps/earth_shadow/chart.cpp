#include "earth_shadow/chart.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/light/moonlight.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vesper {
namespace {

constexpr double width = 760.0;
constexpr double height = 360.0;
constexpr double left = 60.0;
constexpr double top = 20.0;
constexpr int farthest_km = 9000;
constexpr double decades = 7.0;
constexpr double strip = 22.0; // of one L's colours

double x_of(double km) { return left + width * km / farthest_km; }
double y_of(double share) { return top - height * std::log10(share) / decades; }

/// The colour of sunlit snow dimmed by these shares, as bright as a screen can show it: IEC 61966-2-1.
std::string color_of(const Vec4& shares) {
  const Mat3 linear_from_xyz = glm::transpose(Mat3(3.2406, -1.5372, -0.4986, //
                                                   -0.9689, 1.8758, 0.0415,  //
                                                   0.0557, -0.2040, 1.0570));
  const Vec3 white(0.9505, 1.0, 1.089);
  const Vec3 rgb = glm::max(linear_from_xyz * (Vec3(shares) * white), Vec3(0.0));
  const double most = std::max({rgb.x, rgb.y, rgb.z});
  const auto code = [&](double value) {
    const double share = value / most;
    const double encoded = share <= 0.0031308 ? 12.92 * share : 1.055 * std::pow(share, 1.0 / 2.4) - 0.055;
    return static_cast<int>(std::lround(255.0 * encoded));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", code(rgb.x), code(rgb.y), code(rgb.z));
}

} // namespace

std::string shadow_chart(const EarthShadowLight& light) {
  const double along_km = moon_mean_distance.to(kilometre);
  const f64::EarthShadow shadow{Vec3(0.0, 0.0, 1.0), astronomical_unit.to(kilometre), sun_radius.to(kilometre),
                                f64::earth_radius_km};
  const Spectrum moonlight = moon_irradiance(2.0 * deg, moon_mean_distance, astronomical_unit);
  std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
                                "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" "
                                "fill=\"#ffffff\"/>\n",
                                left + width + 20.0, top + height + 5.0 * strip + 70.0);
  const auto out = std::back_inserter(svg);
  for (int decade = 0; decade <= static_cast<int>(decades); ++decade) {
    const double y = y_of(std::pow(10.0, -decade));
    fmt::format_to(out,
                   "<path d=\"M{0} {1}H{2}\" stroke=\"#dddddd\"/><text x=\"{3}\" y=\"{4}\" text-anchor=\"end\">"
                   "1e-{5}</text>\n",
                   left, y, left + width, left - 6.0, y + 4.0, decade);
  }
  const f64::vec2 radii = f64::earth_shadow_radii_km(along_km, shadow);
  for (const auto& [km, name] : {std::pair{radii.x, "umbra"}, std::pair{radii.y, "penumbra"}}) {
    fmt::format_to(out,
                   "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#999999\" stroke-dasharray=\"4 3\"/><text x=\"{3:.1f}\" "
                   "y=\"{4}\">{5} without air</text>\n",
                   x_of(km), top, top + height, x_of(km) - 140.0, top + height - 8.0, name);
  }
  for (int danjon = 0; danjon <= 4; ++danjon) {
    const LunarEclipseTable table =
        lunar_eclipse_table(eclipse_spectra(light, along_km * kilometre, astronomical_unit, danjon), moonlight);
    const double strip_y = top + height + 34.0 + strip * danjon;
    std::string path;
    constexpr int step_km = 25;
    constexpr int stripe_km = 75;
    for (int km = 0; km <= farthest_km; km += step_km) {
      const Vec4 shares = f64::lunar_eclipse_shares(Vec3(km, 0.0, along_km), shadow, table.frame, table.sampler());
      fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x_of(km), y_of(shares.y));
      if (km % stripe_km == 0) {
        fmt::format_to(out, "<rect x=\"{:.1f}\" y=\"{:.0f}\" width=\"7\" height=\"19\" fill=\"{}\"/>\n", x_of(km),
                       strip_y, color_of(shares));
      }
    }
    constexpr double named_km = 3000.0;
    const Vec4 named = f64::lunar_eclipse_shares(Vec3(named_km, 0.0, along_km), shadow, table.frame, table.sampler());
    fmt::format_to(out,
                   "<path d=\"{}\" fill=\"none\" stroke=\"#204080\"/><text x=\"{}\" y=\"{:.1f}\">L = {}</text>"
                   "<text x=\"8\" y=\"{:.1f}\">L = {}</text>\n",
                   path, x_of(named_km), y_of(named.y) - 5.0, danjon, strip_y + 14.0, danjon);
  }
  for (int km = 0; km <= farthest_km; km += 1000) {
    fmt::format_to(out, "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", x_of(km), top + height + 18.0,
                   km);
  }
  return svg + fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">km from the axis</text>\n</svg>\n",
                           left + width, top + height + 5.0 * strip + 56.0);
}

} // namespace vesper
