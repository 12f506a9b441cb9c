#include "baselines/published_sky.hpp"

#include "vesper/base/shader_math.hpp"
#include "vesper/base/worker_pool.hpp"

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace vesper::baseline {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr int transmittance_steps = 500;
constexpr int scattering_steps = 50;
constexpr int zenith_angles = 16; ///< of a sphere for the scattering density, of a hemisphere for irradiance
constexpr int density_azimuths = 32;
constexpr int irradiance_azimuths = 64;
constexpr float sun_radius_rad = 0.00935F / 2.0F;
/// The published solar irradiance, W/m2/nm: it scales what half floats must hold and is divided out at look-up.
const Rgb solar_irradiance(1.474F, 1.8504F, 1.91198F);

Shell shell_of(const Medium& medium, SunMapping sun) {
  Shell shell{static_cast<float>(medium.ground_radius.to(kilometre)),
              static_cast<float>(medium.top_radius.to(kilometre)), 0.0F};
  shell.sun_span = sun == SunMapping::of_2017 ? sun_span_2017(shell, std::cos(102.0F / 180.0F * pi))
                                              : sun_span_revised(shell, std::cos(120.0F / 180.0F * pi));
  return shell;
}

Rgb sample(const WavelengthLaw& law) { return {law(680.0), law(550.0), law(440.0)}; }
float rayleigh(float nu) { return f32::rayleigh_phase(nu, 0.0F); }

/// Runs work(i) for each row of a table on all cores.
template <class Work> void each(int count, Work&& work) {
  parallel_for(static_cast<std::size_t>(count), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      work(static_cast<int>(i));
    }
  });
}

/// Runs work(r, mu, mu_s, nu) for each texel of a table of scattering on all cores.
template <class Work> void each_texel(const TableSizes& sizes, Work&& work) {
  each(sizes.scattering_r * sizes.scattering_mu, [&](int row) {
    for (int mu_s = 0; mu_s < sizes.scattering_mu_s; ++mu_s) {
      for (int nu = 0; nu < sizes.scattering_nu; ++nu) {
        work(row / sizes.scattering_mu, row % sizes.scattering_mu, mu_s, nu);
      }
    }
  });
}

/// Calls visit(distance, step) at the ends of equal steps, by the trapezoidal rule.
template <class Visit> void trapezoids(float length, int steps, Visit&& visit) {
  const float step = length / static_cast<float>(steps);
  for (int i = 0; i <= steps; ++i) {
    visit(static_cast<float>(i) * step, i == 0 || i == steps ? 0.5F * step : step);
  }
}

/// Where a ray is after a distance.
ScatteringPlace after(const ScatteringPlace& from, float distance, const Shell& shell) {
  const float r = std::clamp(std::sqrt(distance * distance + 2.0F * from.r * from.mu * distance + from.r * from.r),
                             shell.ground_km, shell.top_km);
  return {r, std::clamp((from.r * from.mu + distance) / r, -1.0F, 1.0F),
          std::clamp((from.r * from.mu_s + distance * from.nu) / r, -1.0F, 1.0F), from.nu, from.meets_ground};
}

/// The Sun's direction over a view that lies in the plane of x and z.
glm::vec3 sun_direction(const ScatteringPlace& place) {
  const float across = std::sqrt(std::max(1.0F - place.mu * place.mu, 0.0F));
  const float x = across > 0.0F ? (place.nu - place.mu * place.mu_s) / across : 0.0F;
  return {x, std::sqrt(std::max(1.0F - x * x - place.mu_s * place.mu_s, 0.0F)), place.mu_s};
}

} // namespace

PublishedSky::PublishedSky(const Medium& medium, const PublishedOptions& options)
    : sizes_(options.sizes), shell_(shell_of(medium, options.sun)),
      molecules_per_km_(sample(medium.components.at(0).scattering_per_km)),
      aerosol_per_km_(sample(medium.components.at(1).scattering_per_km)),
      asymmetry_(static_cast<float>(medium.components.at(1).phase.parameter(550.0))),
      albedo_(sample(medium.ground_albedo)), molecules_(sizes_, options.storage), aerosol_(sizes_, options.storage) {
  for (const MediumComponent& part : medium.components) {
    profiles_.push_back(part.profile);
    extinction_per_km_.push_back(sample(part.scattering_per_km) + sample(part.absorption_per_km));
  }
  fill_transmittance();
  single_scattering(molecules_, aerosol_);
  PlaneTable ground = direct_irradiance();
  ScatteringTable previous = molecules_;
  for (int order = 2; order <= options.orders; ++order) {
    const Order source{&previous, order == 2 ? &aerosol_ : nullptr, &ground};
    ScatteringTable density(sizes_, options.storage);
    scattering_density(source, density);
    PlaneTable next_ground = indirect_irradiance(source);
    multiple_scattering(density, previous);
    ground = std::move(next_ground);
    each_texel(sizes_, [&](int r, int mu, int mu_s, int nu) {
      const std::size_t i = molecules_.index(r, mu, mu_s, nu);
      molecules_.store(i, molecules_[i] + previous[i] / rayleigh(place(r, mu, mu_s, nu).nu));
    });
  }
}

ScatteringPlace PublishedSky::place(int r, int mu, int mu_s, int nu) const {
  return scattering_place(
      shell_, sizes_,
      {static_cast<float>(r), static_cast<float>(mu), static_cast<float>(mu_s), static_cast<float>(nu)});
}

Rgb PublishedSky::extinction(float r) const {
  Rgb sum(0.0F);
  for (std::size_t i = 0; i < profiles_.size(); ++i) {
    sum += static_cast<float>(profiles_[i].at(std::max(r - shell_.ground_km, 0.0F))) * extinction_per_km_[i];
  }
  return sum;
}

void PublishedSky::fill_transmittance() {
  transmittance_ = PlaneTable(sizes_.transmittance_mu, sizes_.transmittance_r);
  each(sizes_.transmittance_r, [&](int row) {
    for (int column = 0; column < sizes_.transmittance_mu; ++column) {
      const RayPlace ray = transmittance_ray(shell_, sizes_, {static_cast<float>(column), static_cast<float>(row)});
      Rgb depth(0.0F);
      trapezoids(shell_.to_top_km(ray.r, ray.mu), transmittance_steps, [&](float distance, float step) {
        depth += step * extinction(after({ray.r, ray.mu, 0.0F, 0.0F, false}, distance, shell_).r);
      });
      transmittance_(column, row) = glm::exp(-depth);
    }
  });
}

Rgb PublishedSky::transmittance_to_top(float r, float mu) const {
  const TransmittanceTexel texel = transmittance_texel(shell_, sizes_, {r, mu});
  return transmittance_.at(texel.mu, texel.r);
}

/// Over a distance, as a quotient of two transmittances to the top.
Rgb PublishedSky::transmittance(float r, float mu, float distance, bool meets_ground) const {
  const ScatteringPlace there = after({r, mu, 0.0F, 0.0F, meets_ground}, distance, shell_);
  return glm::min(meets_ground ? transmittance_to_top(there.r, -there.mu) / transmittance_to_top(r, -mu)
                               : transmittance_to_top(r, mu) / transmittance_to_top(there.r, there.mu),
                  Rgb(1.0F));
}

/// What of the Sun comes through the air, its disc fading over the horizon.
Rgb PublishedSky::sunlight(float r, float mu_s) const {
  const float sin_horizon = shell_.ground_km / r;
  const float cos_horizon = -std::sqrt(std::max(1.0F - sin_horizon * sin_horizon, 0.0F));
  const float width = sin_horizon * sun_radius_rad;
  const float x = std::clamp((mu_s - cos_horizon + width) / (2.0F * width), 0.0F, 1.0F);
  return x * x * (3.0F - 2.0F * x) * transmittance_to_top(r, mu_s);
}

Rgb PublishedSky::irradiance(const PlaneTable& table, float r, float mu_s) const {
  const IrradianceTexel texel = irradiance_texel(shell_, sizes_, r, mu_s);
  return table.at(texel.mu_s, texel.r);
}

PlaneTable PublishedSky::direct_irradiance() const {
  PlaneTable table(sizes_.irradiance_mu_s, sizes_.irradiance_r);
  for (int row = 0; row < sizes_.irradiance_r; ++row) {
    for (int column = 0; column < sizes_.irradiance_mu_s; ++column) {
      const SunPlace sun = irradiance_sun(shell_, sizes_, {static_cast<float>(column), static_cast<float>(row)});
      // The mean cosine over the part of the disc above the level.
      const float above = sun.mu_s + sun_radius_rad;
      const float mean_cosine = sun.mu_s < -sun_radius_rad  ? 0.0F
                                : sun.mu_s > sun_radius_rad ? sun.mu_s
                                                            : above * above / (4.0F * sun_radius_rad);
      table(column, row) = mean_cosine * solar_irradiance * transmittance_to_top(sun.r, sun.mu_s);
    }
  }
  return table;
}

void PublishedSky::single_scattering(ScatteringTable& molecules, ScatteringTable& aerosol) const {
  each_texel(sizes_, [&](int r, int mu, int mu_s, int nu) {
    const ScatteringPlace from = place(r, mu, mu_s, nu);
    Rgb by_molecules(0.0F);
    Rgb by_aerosol(0.0F);
    trapezoids(shell_.to_edge_km(from.r, from.mu, from.meets_ground), scattering_steps,
               [&](float distance, float step) {
                 const ScatteringPlace there = after(from, distance, shell_);
                 const Rgb arriving =
                     step * transmittance(from.r, from.mu, distance, from.meets_ground) * sunlight(there.r, there.mu_s);
                 const double height_km = there.r - shell_.ground_km;
                 by_molecules += static_cast<float>(profiles_[0].at(height_km)) * arriving;
                 by_aerosol += static_cast<float>(profiles_[1].at(height_km)) * arriving;
               });
    const std::size_t i = molecules.index(r, mu, mu_s, nu);
    molecules.store(i, by_molecules * solar_irradiance * molecules_per_km_);
    aerosol.store(i, by_aerosol * solar_irradiance * aerosol_per_km_);
  });
}

/// Light of one order from a direction, its phase function in it.
Rgb PublishedSky::incident(const Order& order, const ScatteringPlace& place) const {
  const ScatteringTexel texel = scattering_texel(shell_, sizes_, place);
  const ScatteringTable::Corners corners = order.molecules->corners(texel);
  const Rgb light = order.molecules->at(corners, texel.nu);
  return order.aerosol == nullptr ? light
                                  : light * rayleigh(place.nu) + order.aerosol->at(corners, texel.nu) *
                                                                     f32::cornette_shanks_phase(place.nu, asymmetry_);
}

PlaneTable PublishedSky::indirect_irradiance(const Order& order) const {
  PlaneTable table(sizes_.irradiance_mu_s, sizes_.irradiance_r);
  each(sizes_.irradiance_r, [&](int row) {
    for (int column = 0; column < sizes_.irradiance_mu_s; ++column) {
      const SunPlace sun = irradiance_sun(shell_, sizes_, {static_cast<float>(column), static_cast<float>(row)});
      const glm::vec3 to_sun(std::sqrt(1.0F - sun.mu_s * sun.mu_s), 0.0F, sun.mu_s);
      Rgb sum(0.0F);
      constexpr float angle = 0.5F * pi / zenith_angles;
      for (int j = 0; j < zenith_angles; ++j) {
        const float theta = (static_cast<float>(j) + 0.5F) * angle;
        for (int i = 0; i < irradiance_azimuths; ++i) {
          const float phi = (static_cast<float>(i) + 0.5F) * 2.0F * pi / irradiance_azimuths;
          const glm::vec3 from(std::cos(phi) * std::sin(theta), std::sin(phi) * std::sin(theta), std::cos(theta));
          const float solid_angle = angle * 2.0F * pi / irradiance_azimuths * std::sin(theta);
          sum += incident(order, {sun.r, from.z, sun.mu_s, glm::dot(from, to_sun), false}) * from.z * solid_angle;
        }
      }
      table(column, row) = sum;
    }
  });
  return table;
}

void PublishedSky::scattering_density(const Order& order, ScatteringTable& density) const {
  each(sizes_.scattering_r * sizes_.scattering_mu_s, [&](int row) {
    const int r = row / sizes_.scattering_mu_s;
    const int mu_s = row % sizes_.scattering_mu_s;
    const ScatteringPlace here = place(r, 0, mu_s, 0);
    const double height_km = here.r - shell_.ground_km;
    const Rgb molecules = static_cast<float>(profiles_[0].at(height_km)) * molecules_per_km_;
    const Rgb aerosol = static_cast<float>(profiles_[1].at(height_km)) * aerosol_per_km_;

    // What does not depend on the texel's view: by the angle at which light comes in.
    struct Cone {
      float cos_theta;
      float sin_theta;
      bool meets_ground;
      float distance_km;
      Rgb reflected;              ///< to here, for an irradiance of 1 at the ground
      std::vector<Rgb> molecules; ///< by nu
      std::vector<Rgb> aerosol;
    };
    std::array<Cone, zenith_angles> cones{};
    for (int l = 0; l < zenith_angles; ++l) {
      const float theta = (static_cast<float>(l) + 0.5F) * pi / zenith_angles;
      Cone& cone = cones[static_cast<std::size_t>(l)];
      cone.cos_theta = std::cos(theta);
      cone.sin_theta = std::sin(theta);
      cone.meets_ground = shell_.meets_ground(here.r, cone.cos_theta);
      if (cone.meets_ground) {
        cone.distance_km = shell_.to_ground_km(here.r, cone.cos_theta);
        cone.reflected = transmittance(here.r, cone.cos_theta, cone.distance_km, true) * albedo_ / pi;
      }
      const ScatteringTable::Corners corners = order.molecules->corners(
          scattering_texel(shell_, sizes_, {here.r, cone.cos_theta, here.mu_s, 0.0F, cone.meets_ground}));
      cone.molecules = order.molecules->over_nu(corners);
      if (order.aerosol != nullptr) {
        cone.aerosol = order.aerosol->over_nu(corners);
      }
    }
    std::array<glm::vec2, density_azimuths> azimuths{};
    for (int m = 0; m < density_azimuths; ++m) {
      const float phi = (static_cast<float>(m) + 0.5F) * 2.0F * pi / density_azimuths;
      azimuths[static_cast<std::size_t>(m)] = {std::cos(phi), std::sin(phi)};
    }
    constexpr float angle = pi / zenith_angles;
    constexpr float azimuth_step = 2.0F * pi / density_azimuths;
    const auto last_nu = static_cast<float>(sizes_.scattering_nu - 1);
    for (int mu = 0; mu < sizes_.scattering_mu; ++mu) {
      for (int nu = 0; nu < sizes_.scattering_nu; ++nu) {
        const ScatteringPlace texel = place(r, mu, mu_s, nu);
        const glm::vec3 view(std::sqrt(std::max(1.0F - texel.mu * texel.mu, 0.0F)), 0.0F, texel.mu);
        const glm::vec3 to_sun = sun_direction(texel);
        Rgb sum(0.0F);
        for (const Cone& cone : cones) {
          const float solid_angle = angle * azimuth_step * cone.sin_theta;
          for (const glm::vec2& azimuth : azimuths) {
            const glm::vec3 from(azimuth.x * cone.sin_theta, azimuth.y * cone.sin_theta, cone.cos_theta);
            const float nu1 = glm::dot(from, to_sun);
            const float nu_texel = (0.5F * nu1 + 0.5F) * last_nu;
            Rgb light = linear(cone.molecules.data(), sizes_.scattering_nu, nu_texel);
            if (order.aerosol != nullptr) {
              light = light * rayleigh(nu1) + linear(cone.aerosol.data(), sizes_.scattering_nu, nu_texel) *
                                                  f32::cornette_shanks_phase(nu1, asymmetry_);
            }
            if (cone.meets_ground) {
              const glm::vec3 normal = glm::normalize(glm::vec3(0.0F, 0.0F, here.r) + cone.distance_km * from);
              light +=
                  cone.reflected * irradiance(*order.ground_irradiance, shell_.ground_km, glm::dot(normal, to_sun));
            }
            const float nu2 = glm::dot(view, from);
            sum += light * solid_angle *
                   (molecules * rayleigh(nu2) + aerosol * f32::cornette_shanks_phase(nu2, asymmetry_));
          }
        }
        density.store(density.index(r, mu, mu_s, nu), sum);
      }
    }
  });
}

void PublishedSky::multiple_scattering(const ScatteringTable& density, ScatteringTable& light) const {
  each_texel(sizes_, [&](int r, int mu, int mu_s, int nu) {
    const ScatteringPlace from = place(r, mu, mu_s, nu);
    Rgb sum(0.0F);
    trapezoids(shell_.to_edge_km(from.r, from.mu, from.meets_ground), scattering_steps,
               [&](float distance, float step) {
                 const ScatteringTexel texel = scattering_texel(shell_, sizes_, after(from, distance, shell_));
                 sum += step * transmittance(from.r, from.mu, distance, from.meets_ground) *
                        density.at(density.corners(texel), texel.nu);
               });
    light.store(light.index(r, mu, mu_s, nu), sum);
  });
}

Rgb PublishedSky::radiance(float height_km, const glm::vec3& light, const glm::vec3& view) const {
  const float r = shell_.ground_km + height_km;
  const ScatteringPlace place{r, view.z, light.z, glm::dot(light, view), shell_.meets_ground(r, view.z)};
  return incident({&molecules_, &aerosol_, nullptr}, place) / solar_irradiance;
}

} // namespace vesper::baseline
