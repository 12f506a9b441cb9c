#include "vesper/atmosphere/star_extinction_table.hpp"

#include "vesper/atmosphere/refracted_columns.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/star_color.hpp"
#include "vesper/light/sunlight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

namespace vesper {
namespace {

constexpr std::size_t rows = 224;
constexpr std::size_t colors = 32;
constexpr std::size_t responses = 4;

/// Every nanometre, as integrate_xyzs takes it.
constexpr std::size_t wavelengths = std::size_t{response_last_nm - response_first_nm} + 1;
double wavelength_nm(std::size_t i) { return response_first_nm + static_cast<double>(i); }

/// From bluer than earthlight to redder than what an eclipse leaves the Moon.
constexpr double least_sunlight_power = -4.0;
constexpr double most_sunlight_power = 20.0;

/// Less light than that is none; its logarithm is a number that floats can hold and interpolate.
constexpr double least_share = 1.0e-300;

/// Spectra of a parameter with which they redden.
struct Reddening {
  double bluest;
  double reddest;
  std::function<double(double parameter)> hue;                         ///< ln(Z/Y), which falls with the parameter
  std::function<double(double parameter, double wavelength_nm)> light; ///< relative to nothing: only ratios are taken

  /// The parameter of a hue.
  [[nodiscard]] double of_hue(double wanted) const {
    double low = bluest;
    double high = reddest;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (hue(middle) > wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
};

/// Black bodies by the B-V of star_color.
Reddening black_bodies() {
  return {min_star_b_v, max_star_b_v,
          [](double b_v) {
            const Xyzs color = star_color(b_v);
            return std::log(color.z / color.y);
          },
          [](double b_v, double nm) { return planck_w_m2_sr_nm(nm, star_temperature_k(b_v)); }};
}

/// Sunlight times a power of the wavelength.
Reddening reddened_sunlight() {
  struct Sunlight {
    std::array<double, wavelengths> logarithm, y, z;
  };
  Sunlight sun{};
  for (std::size_t i = 0; i < wavelengths; ++i) {
    const double nm = wavelength_nm(i);
    sun.logarithm[i] = std::log(nm / 550.0);
    sun.y[i] = cie_y_bar()(nm) * solar_irradiance_1au()(nm);
    sun.z[i] = cie_z_bar()(nm) * solar_irradiance_1au()(nm);
  }
  const auto hue = [sun](double power) {
    double y = 0.0;
    double z = 0.0;
    for (std::size_t i = 0; i < wavelengths; ++i) {
      const double share = std::exp(power * sun.logarithm[i]);
      y += sun.y[i] * share;
      z += sun.z[i] * share;
    }
    return std::log(z / y);
  };
  return {least_sunlight_power, most_sunlight_power, hue,
          [](double power, double nm) { return solar_irradiance_1au()(nm) * std::pow(nm / 550.0, power); }};
}

/// The lights of the table's columns, at equal steps of ln(Z/Y) from the reddest.
struct Colors {
  double reddest;
  double steps_per_hue;
  std::array<std::array<double, colors>, wavelengths> light;
  std::array<std::array<double, wavelengths>, responses> response;
  std::array<std::array<double, colors>, responses> above; ///< the sums without air
};

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

Colors make_colors(const Reddening& family) {
  Colors table{};
  table.reddest = family.hue(family.reddest);
  table.steps_per_hue = static_cast<double>(colors - 1) / (family.hue(family.bluest) - table.reddest);
  for (std::size_t c = 0; c < colors; ++c) {
    const double parameter = family.of_hue(table.reddest + static_cast<double>(c) / table.steps_per_hue);
    for (std::size_t i = 0; i < wavelengths; ++i) {
      table.light[i][c] = family.light(parameter, wavelength_nm(i));
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
  static const Colors table = make_colors(black_bodies());
  return table;
}

const Colors& sunlight_colors() {
  static const Colors table = make_colors(reddened_sunlight());
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

StarExtinction make_extinction(const Medium& medium, Length height, const std::optional<RefractionConditions>& bending,
                               const Colors& lights) {
  const RefractedColumns air(medium, height, bending);
  const std::vector<std::array<double, wavelengths>> coefficients = coefficients_of(medium);

  StarExtinction table;
  f64::StarExtinctionFrame& frame = table.frame;
  frame.rows = rows;
  frame.columns = colors;
  frame.sin_horizon = air.sin_horizon();
  frame.width = width_at(air);
  frame.rows_per_x = static_cast<double>(rows - 1) / f64::arc_sinh((1.0 - frame.sin_horizon) / frame.width);
  frame.reddest = lights.reddest;
  frame.columns_per_hue = lights.steps_per_hue;

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
    const ResponseSums sums = sums_behind(share, lights);
    for (std::size_t c = 0; c < colors; ++c) {
      Vec4 logarithm{};
      for (std::size_t r = 0; r < responses; ++r) {
        logarithm[static_cast<int>(r)] = std::log(std::max(sums.at(r)[c] / lights.above.at(r)[c], least_share));
      }
      table.texels.push_back(logarithm);
    }
  }
  return table;
}

} // namespace

StarExtinction make_star_extinction(const Medium& medium, Length height,
                                    const std::optional<RefractionConditions>& bending) {
  return make_extinction(medium, height, bending, star_colors());
}

StarExtinction make_sunlight_extinction(const Medium& medium, Length height,
                                        const std::optional<RefractionConditions>& bending) {
  return make_extinction(medium, height, bending, sunlight_colors());
}

f64::sampler2D star_extinction_sampler(const StarExtinction& table) {
  return {table.texels.data(), table.frame.columns, table.frame.rows};
}

Vec4 star_extinction(const StarExtinction& table, double sin_altitude, const Vec4& light) {
  return f64::star_extinction(sin_altitude, light, table.frame, star_extinction_sampler(table));
}

} // namespace vesper
