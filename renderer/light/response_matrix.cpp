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
  const Xyzs sum = integrate_xyzs(light);
  if (!(sum.x > 0.0 && sum.y > 0.0 && sum.z > 0.0 && sum.s > 0.0)) {
    throw Error(ErrorKind::argument, "a light without any of X, Y, Z or S",
                {"", "", "Give a spectrum that is seen by day and by night"});
  }
  return sum.y;
}

} // namespace

Mat4 response_matrix(const Spectrum& from, const Spectrum& to) {
  const double from_lux = lux_of(from);
  const double to_lux = lux_of(to);
  Mat4 rows(0.0);
  for (int response = 0; response < 4; ++response) {
    // Normal equations of errors in relation to what is right.
    Mat4 squares(0.0);
    Vec4 products(0.0);
    for (int power = -8; power <= 12; power += 2) {
      const Vec4 target = behind_filter(to, to_lux, power);
      const Vec4 source = behind_filter(from, from_lux, power) / target[response];
      squares += glm::outerProduct(source, source);
      products += source;
    }
    rows[response] = glm::inverse(squares) * products;
  }
  return glm::transpose(rows);
}

} // namespace vesper
