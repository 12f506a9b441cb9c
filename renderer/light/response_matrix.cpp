#include "vesper/light/response_matrix.hpp"

#include "vesper/base/error.hpp"
#include "vesper/light/response_functions.hpp"

#include <cmath>
#include <vector>

namespace vesper {
namespace {

/// The responses to 1 lux of a light behind a filter (wavelength / 550 nm)^power.
Vec4 behind_filter(const Spectrum& light, double lux, double power) {
  std::vector<double> grid;
  std::vector<double> values;
  for (int nm = response_first_nm; nm <= response_last_nm; ++nm) {
    grid.push_back(nm);
    values.push_back(light(nm) * std::pow(nm / 550.0, power));
  }
  const Xyzs sum = integrate_xyzs({grid, values});
  return Vec4(sum.x, sum.y, sum.z, sum.s) / lux;
}

double lux_of(const Spectrum& light) {
  const double lux = integrate_xyzs(light).y;
  if (!(lux > 0.0)) {
    throw Error(ErrorKind::argument, "a light without any luminance", {"", "", "Give a spectrum that the eye sees"});
  }
  return lux;
}

} // namespace

Mat4 response_matrix(const Spectrum& from, const Spectrum& to) {
  const double from_lux = lux_of(from);
  const double to_lux = lux_of(to);
  // Normal equations, each filter weighted so that all are equally bright.
  Mat4 squares(0.0);
  Mat4 products(0.0);
  for (int power = -8; power <= 12; power += 2) {
    const Vec4 source = behind_filter(from, from_lux, power);
    const Vec4 target = behind_filter(to, to_lux, power);
    const double weight = 1.0 / (source.y * source.y);
    squares += weight * glm::outerProduct(source, source);
    products += weight * glm::outerProduct(target, source);
  }
  return products * glm::inverse(squares);
}

} // namespace vesper
