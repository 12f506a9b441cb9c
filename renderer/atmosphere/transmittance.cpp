#include "vesper/atmosphere/transmittance.hpp"

#include "vesper/base/error.hpp"
#include "vesper/light/response_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace vesper {
namespace {

/// Places on a straight ray are its distances from the point nearest to the planet's centre.
struct Ray {
  double perigee_km; ///< distance of that point from the centre
  double begin_km;
  double end_km;
};

struct Estimate {
  double value = 0.0;
  double error = 0.0;
};

/// The rule of Gauss with 7 nodes inside that of Kronrod with 15 (Piessens et al. 1983, QUADPACK).
constexpr std::array<double, 8> nodes{0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
                                      0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
                                      0.586087235467691130294144045693360, 0.405845151377397166906606412076961,
                                      0.207784955007898467600689403773245, 0.0};
constexpr std::array<double, 8> kronrod{0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
                                        0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
                                        0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
                                        0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
constexpr std::array<double, 4> gauss{0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
                                      0.381830050505118944950369775488975, 0.417959183673469387755102040816327};

/// Halves the piece until the two rules agree to 1e-9 of it, or to what no sky shows.
template <class Function> Estimate integrate(const Function& f, double begin, double end, int halvings = 40) {
  const double middle = 0.5 * (begin + end);
  const double half = 0.5 * (end - begin);
  double fine = kronrod[7] * f(middle);
  double coarse = gauss[3] * f(middle);
  for (std::size_t i = 0; i < 7; ++i) {
    const double pair = f(middle - half * nodes[i]) + f(middle + half * nodes[i]);
    fine += kronrod[i] * pair;
    if (i % 2 == 1) {
      coarse += gauss[i / 2] * pair;
    }
  }
  const double error = std::abs(half * (fine - coarse));
  constexpr double relative = 1.0e-9;
  constexpr double negligible_km = 1.0e-12;
  if (halvings == 0 || error <= std::max(relative * std::abs(half * fine), negligible_km)) {
    return {half * fine, error};
  }
  const Estimate left = integrate(f, begin, middle, halvings - 1);
  const Estimate right = integrate(f, middle, end, halvings - 1);
  return {left.value + right.value, left.error + right.error};
}

/// Distance from the perigee at which the ray crosses a sphere; 0 where it passes above.
double crossing_km(double perigee_km, double radius_km) {
  return radius_km > perigee_km ? std::sqrt((radius_km - perigee_km) * (radius_km + perigee_km)) : 0.0;
}

Estimate column(const HeightProfile& profile, const Ray& ray, double ground_km) {
  std::vector<double> cuts{ray.begin_km, ray.end_km, 0.0};
  for (const double height_km : profile.breaks_km()) {
    const double cut = crossing_km(ray.perigee_km, ground_km + height_km);
    cuts.push_back(cut);
    cuts.push_back(-cut);
  }
  for (double& cut : cuts) {
    cut = std::clamp(cut, ray.begin_km, ray.end_km);
  }
  std::sort(cuts.begin(), cuts.end());
  const auto density = [&](double s) { return profile.at(std::max(std::hypot(ray.perigee_km, s) - ground_km, 0.0)); };
  Estimate sum;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (cuts[i] > cuts[i - 1]) {
      const Estimate piece = integrate(density, cuts[i - 1], cuts[i]);
      sum.value += piece.value;
      sum.error += piece.error;
    }
  }
  return sum;
}

AirColumns columns(const Medium& medium, const Vec3& from_km, const Vec3& direction, double length_km) {
  validate_radii(medium);
  const double ground_km = medium.ground_radius.to(kilometre);
  const double top_km = medium.top_radius.to(kilometre);
  AirColumns result;
  result.km.assign(medium.components.size(), 0.0);
  result.error_km = result.km;

  const double along = glm::dot(from_km, direction);
  const double perigee_km = glm::length(glm::cross(from_km, direction));
  const double reach = crossing_km(perigee_km, top_km);
  const Ray ray{perigee_km, std::max(along, -reach), std::min(along + length_km, reach)};
  if (!(ray.end_km > ray.begin_km)) {
    return result;
  }
  const double nearest = std::clamp(0.0, ray.begin_km, ray.end_km);
  constexpr double rounding = 1.0e-12;
  if (std::hypot(perigee_km, nearest) < ground_km * (1.0 - rounding)) {
    result.blocked = true;
    return result;
  }
  for (std::size_t i = 0; i < medium.components.size(); ++i) {
    const Estimate sum = column(medium.components[i].profile, ray, ground_km);
    result.km[i] = sum.value;
    result.error_km[i] = sum.error;
  }
  return result;
}

} // namespace

AirColumns columns_between(const Medium& medium, const Vec3& from_km, const Vec3& to_km) {
  const double length_km = glm::length(to_km - from_km);
  if (!std::isfinite(length_km) || !std::isfinite(glm::length(from_km))) {
    throw Error(ErrorKind::argument, "a path whose end is not finite", {"", "", "Give finite points"});
  }
  const Vec3 direction = length_km > 0.0 ? (to_km - from_km) / length_km : Vec3(0.0, 0.0, 1.0);
  return columns(medium, from_km, direction, length_km);
}

AirColumns columns_to_space(const Medium& medium, const Vec3& from_km, const Vec3& direction) {
  constexpr double tolerance = 1.0e-9;
  if (!(std::abs(glm::length(direction) - 1.0) <= tolerance) || !std::isfinite(glm::length(from_km))) {
    throw Error(ErrorKind::argument, "a path without a place or a direction",
                {"", "", "Give a finite point and a vector of unit length"});
  }
  return columns(medium, from_km, direction, std::numeric_limits<double>::infinity());
}

double zenith_column_km(const HeightProfile& profile, Length ground_radius, Length top_radius) {
  const Medium alone{ground_radius, top_radius, {}, {{"", profile, {}, {}, {}}}, {}};
  const Vec3 zenith(0.0, 0.0, 1.0);
  return columns_to_space(alone, ground_radius.to(kilometre) * zenith, zenith).km.front();
}

double OpticalDepth::transmittance() const { return std::exp(-value); }

OpticalDepth optical_depth(const Medium& medium, const AirColumns& columns, double wavelength_nm) {
  if (columns.blocked) {
    return {std::numeric_limits<double>::infinity(), 0.0};
  }
  OpticalDepth depth;
  for (std::size_t i = 0; i < medium.components.size(); ++i) {
    const double extinction = medium.components[i].extinction_per_km(wavelength_nm);
    depth.value += extinction * columns.km[i];
    depth.error += extinction * columns.error_km[i];
  }
  return depth;
}

double zenith_extinction_v_mag(const Medium& medium, Length height, const Spectrum& light) {
  const Vec3 zenith(0.0, 0.0, 1.0);
  const AirColumns air = columns_to_space(medium, (medium.ground_radius + height).to(kilometre) * zenith, zenith);
  // Every nanometre of the band, as integrate_v_band takes it.
  std::vector<double> wavelengths;
  std::vector<double> above;
  std::vector<double> below;
  const std::vector<double>& band = v_band().wavelengths_nm();
  const auto steps = static_cast<int>(band.back() - band.front());
  for (int i = 0; i <= steps; ++i) {
    const double nm = band.front() + i;
    wavelengths.push_back(nm);
    above.push_back(light(nm));
    below.push_back(light(nm) * optical_depth(medium, air, nm).transmittance());
  }
  const double outside = integrate_v_band({wavelengths, above});
  if (!(outside > 0.0)) {
    throw Error(ErrorKind::argument, "light without any in V", {"", "", "Give a spectrum that covers 470 to 700 nm"});
  }
  return -2.5 * std::log10(integrate_v_band({wavelengths, below}) / outside);
}

} // namespace vesper
