#include "vesper/light/response_matrix.hpp"

#include "vesper/base/error.hpp"
#include "vesper/light/response_functions.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>

namespace vesper {
namespace {

constexpr int lowest_power = -8;
constexpr std::size_t filters = 11;
constexpr std::size_t response_grid_size = response_last_nm - response_first_nm + 1;

/// By filter (wavelength / 550 nm)^power, whose powers are even, and nanometre: the responses to light behind it.
using FilteredResponses = std::array<std::array<Vec4, response_grid_size>, filters>;

const FilteredResponses& filtered_responses() {
  static const auto made = [] {
    auto responses = std::make_unique<FilteredResponses>();
    for (std::size_t i = 0; i < response_grid_size; ++i) {
      const double nm = response_first_nm + static_cast<double>(i);
      const double end = i == 0 || i + 1 == response_grid_size ? 0.5 : 1.0; // of the trapezoidal rule
      const Vec4 response = end * Vec4(photopic_efficacy_lm_w * Vec3(cie_x_bar()(nm), cie_y_bar()(nm), cie_z_bar()(nm)),
                                       scotopic_efficacy_lm_w * cie_scotopic()(nm));
      for (std::size_t f = 0; f < filters; ++f) {
        (*responses)[f][i] = std::pow(nm / 550.0, lowest_power + 2.0 * static_cast<double>(f)) * response;
      }
    }
    return responses;
  }();
  return *made;
}

/// The responses to 1 lux of a light behind each filter.
std::array<Vec4, filters> behind_filters(const Spectrum& light, double lux) {
  std::array<double, response_grid_size> values{};
  for (std::size_t i = 0; i < response_grid_size; ++i) {
    values[i] = light(response_first_nm + static_cast<double>(i)) / lux;
  }
  std::array<Vec4, filters> sums{};
  for (std::size_t f = 0; f < filters; ++f) {
    sums[f] = std::inner_product(values.begin(), values.end(), filtered_responses()[f].begin(), Vec4(0.0));
  }
  return sums;
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
  const auto sources = behind_filters(from, lux_of(from));
  const auto targets = behind_filters(to, lux_of(to));
  Mat4 rows(0.0);
  for (int response = 0; response < 4; ++response) {
    // Normal equations of errors in relation to what is right.
    Mat4 squares(0.0);
    Vec4 products(0.0);
    for (std::size_t f = 0; f < filters; ++f) {
      const Vec4 source = sources[f] / targets[f][response];
      squares += glm::outerProduct(source, source);
      products += source;
    }
    rows[response] = glm::inverse(squares) * products;
  }
  return glm::transpose(rows);
}

} // namespace vesper
