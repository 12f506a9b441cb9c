#include "vesper/atmosphere/star_extinction_table.hpp"

#include "vesper/atmosphere/refracted_columns.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/star_color.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace vesper {
namespace {

constexpr std::size_t rows = 224;
constexpr std::size_t colors = 32;
constexpr std::size_t responses = 4;

/// Every nanometre, as integrate_xyzs takes it.
constexpr std::size_t wavelengths = std::size_t{response_last_nm - response_first_nm} + 1;
double wavelength_nm(std::size_t i) { return response_first_nm + static_cast<double>(i); }

/// Less light than that is none; its logarithm is a number that floats can hold and interpolate.
constexpr double least_share = 1.0e-300;

double hue(double b_v) {
  const Xyzs color = star_color(b_v);
  return std::log(color.z / color.y);
}

/// The black bodies of the table's columns, at equal steps of ln(Z/Y) from the reddest.
struct Colors {
  double reddest;
  double steps_per_hue;
  std::array<std::array<double, colors>, wavelengths> light; ///< relative to nothing: only ratios are taken
  std::array<std::array<double, wavelengths>, responses> response;
  std::array<std::array<double, colors>, responses> above; ///< the sums without air
};

/// B-V of the star that has a hue, which falls with B-V.
double b_v_of(double wanted) {
  double low = min_star_b_v;
  double high = max_star_b_v;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (hue(middle) > wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

using ResponseSums = std::array<std::array<double, colors>, responses>;

/// The responses to the light of all colours through a filter.
ResponseSums sums_behind(const std::array<double, wavelengths>& share, const Colors& table) {
  ResponseSums sums{};
  for (std::size_t r = 0; r < responses; ++r) {
    std::array<double, colors>& sum = sums.at(r);
    for (std::size_t i = 0; i < wavelengths; ++i) {
      const double weight = table.response.at(r)[i] * share[i];
      if (weight == 0.0) {
        continue;
      }
      for (std::size_t c = 0; c < colors; ++c) {
        sum[c] += weight * table.light[i][c];
      }
    }
  }
  return sums;
}

Colors make_colors() {
  Colors table{};
  table.reddest = hue(max_star_b_v);
  table.steps_per_hue = static_cast<double>(colors - 1) / (hue(min_star_b_v) - table.reddest);
  for (std::size_t c = 0; c < colors; ++c) {
    const double kelvin = star_temperature_k(b_v_of(table.reddest + static_cast<double>(c) / table.steps_per_hue));
    for (std::size_t i = 0; i < wavelengths; ++i) {
      table.light[i][c] = planck_w_m2_sr_nm(wavelength_nm(i), kelvin);
    }
  }
  const std::array<const Spectrum*, responses> functions{&cie_x_bar(), &cie_y_bar(), &cie_z_bar(), &cie_scotopic()};
  for (std::size_t i = 0; i < wavelengths; ++i) {
    for (std::size_t r = 0; r < responses; ++r) {
      table.response.at(r)[i] = (*functions.at(r))(wavelength_nm(i));
    }
  }
  std::array<double, wavelengths> all{};
  all.fill(1.0);
  table.above = sums_behind(all, table);
  return table;
}

const Colors& star_colors() {
  static const Colors table = make_colors();
  return table;
}

/// Extinction of each component per km of its column, wavelength by wavelength.
std::vector<std::array<double, wavelengths>> coefficients_of(const Medium& medium) {
  std::vector<std::array<double, wavelengths>> result(medium.components.size());
  for (std::size_t k = 0; k < result.size(); ++k) {
    for (std::size_t i = 0; i < wavelengths; ++i) {
      result[k].at(i) = medium.components[k].extinction_per_km(wavelength_nm(i));
    }
  }
  return result;
}

/// By how much the sine of the horizon's altitude would sink were the ground 1 km deeper: the scale on which the air's
/// lowest layers change with the altitude above the horizon.
double width_at(const RefractedColumns& air) {
  constexpr double depth_km = 1.0;
  const auto dip = [&](double ground_km) {
    const double cosine = std::min(ground_km / air.observer_radius_km(), 1.0);
    return std::sqrt((1.0 - cosine) * (1.0 + cosine));
  };
  return dip(air.lowest_radius_km() - depth_km) - dip(air.lowest_radius_km());
}

} // namespace

StarExtinction make_star_extinction(const Medium& medium, Length height,
                                    const std::optional<RefractionConditions>& bending) {
  const RefractedColumns air(medium, height, bending);
  const Colors& stars = star_colors();
  const std::vector<std::array<double, wavelengths>> coefficients = coefficients_of(medium);

  StarExtinction table;
  f64::StarExtinctionFrame& frame = table.frame;
  frame.rows = rows;
  frame.columns = colors;
  frame.sin_horizon = air.sin_horizon();
  frame.width = width_at(air);
  frame.rows_per_x = static_cast<double>(rows - 1) / f64::arc_sinh((1.0 - frame.sin_horizon) / frame.width);
  frame.reddest = stars.reddest;
  frame.columns_per_hue = stars.steps_per_hue;

  table.texels.reserve(rows * colors);
  std::array<double, wavelengths> share{};
  for (std::size_t row = 0; row < rows; ++row) {
    const double sine = frame.sin_horizon + frame.width * std::sinh(static_cast<double>(row) / frame.rows_per_x);
    const std::vector<double> km = air.columns_km(sine);
    share.fill(0.0);
    for (std::size_t k = 0; k < km.size(); ++k) {
      for (std::size_t i = 0; i < wavelengths; ++i) {
        share[i] -= coefficients[k][i] * km[k];
      }
    }
    for (double& value : share) {
      value = std::exp(value);
    }
    const ResponseSums sums = sums_behind(share, stars);
    for (std::size_t c = 0; c < colors; ++c) {
      Vec4 logarithm{};
      for (std::size_t r = 0; r < responses; ++r) {
        logarithm[static_cast<int>(r)] = std::log(std::max(sums.at(r)[c] / stars.above.at(r)[c], least_share));
      }
      table.texels.push_back(logarithm);
    }
  }
  return table;
}

f64::sampler2D star_extinction_sampler(const StarExtinction& table) {
  return {table.texels.data(), table.frame.columns, table.frame.rows};
}

Vec4 star_extinction(const StarExtinction& table, double sin_altitude, const Vec4& light) {
  return f64::star_extinction(sin_altitude, light, table.frame, star_extinction_sampler(table));
}

} // namespace vesper
