#include "vesper/atmosphere/path_tracer.hpp"

#include "vesper/base/shader_math.hpp"
#include "vesper/base/sine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace vesper {
namespace {

using std::numbers::pi;

/// Share of directions that are drawn after the phase function, whatever the guide says.
constexpr double phase_share = 0.25;

/// A unit vector at an angle from another, toward any side.
Vec3 around(const Vec3& axis, double cos_angle, RandomStream& random) {
  const double azimuth_rad = 2.0 * pi * random();
  const Vec3 aside = std::abs(axis.z) < 0.9 ? Vec3(0.0, 0.0, 1.0) : Vec3(1.0, 0.0, 0.0);
  const Vec3 x = glm::normalize(glm::cross(aside, axis));
  const Vec3 y = glm::cross(axis, x);
  const double sin_angle = sine_of(cos_angle);
  return cos_angle * axis + sin_angle * (std::cos(azimuth_rad) * x + std::sin(azimuth_rad) * y);
}

/// What directions are drawn after for a phase function: the same for Henyey and Greenstein's, a neighbour that is
/// nowhere much smaller for the others.
double proposal_density(PhaseKind kind, double cos_angle, double parameter) {
  switch (kind) {
  case PhaseKind::rayleigh:
    return 0.25 / pi;
  case PhaseKind::cornette_shanks:
    return phase_function(PhaseKind::henyey_greenstein, cos_angle, parameter);
  default:
    return phase_function(kind, cos_angle, parameter);
  }
}

/// \param u uniform in [0, 1)
double proposed_cos_angle(PhaseKind kind, double parameter, double u) {
  const double linear = 2.0 * u - 1.0;
  if (kind == PhaseKind::rayleigh) {
    return linear;
  }
  if (kind == PhaseKind::schlick) {
    const double k = f64::schlick_asymmetry(parameter);
    return std::clamp((linear + k) / (1.0 + k * linear), -1.0, 1.0);
  }
  const double g = parameter;
  constexpr double even = 1.0e-6; // below it the quotient loses more digits than the lobe has
  if (std::abs(g) < even) {
    return linear;
  }
  const double ratio = (1.0 - g * g) / (1.0 + g * linear);
  return std::clamp((1.0 + g * g - ratio * ratio) / (2.0 * g), -1.0, 1.0);
}

} // namespace

PathTracer::PathTracer(const SampledAir& air, const SpectralAir& optics, const TransportGuide& guide,
                       const SkyQuery& query, int orders)
    : air_(air), optics_(optics), guide_(guide), query_(query), orders_(orders),
      light_cos_radius_(std::cos(query.light_angular_radius.to(rad))),
      observer_km_(0.0, 0.0, air.ground_km() + query.height.to(kilometre)),
      first_(air, optics, guide, query.light_direction), ray_(first_), throughput_(optics.size()),
      scattered_(optics.size()) {
  first_.lay(observer_km_, query.view_direction);
}

PathTracer::LocalFrame PathTracer::frame_at(const Vec3& place_km, double radius_km) const {
  LocalFrame frame;
  frame.z = place_km / radius_km;
  frame.cos_light_zenith = std::clamp(glm::dot(frame.z, query_.light_direction), -1.0, 1.0);
  const Vec3 level = query_.light_direction - frame.cos_light_zenith * frame.z;
  const double length = glm::length(level);
  constexpr double level_at_all = 1.0e-9;
  const Vec3 any = std::abs(frame.z.x) < 0.9 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
  frame.x = length > level_at_all ? level / length : glm::normalize(any - glm::dot(any, frame.z) * frame.z);
  frame.y = glm::cross(frame.z, frame.x);
  return frame;
}

/// Takes the density of what was drawn into the path's.
void PathTracer::drawn(const Values& density, std::size_t k) {
  const double own = density[k];
  for (double& value : throughput_) {
    value /= own;
  }
  for (std::size_t i = 0; i < guide_.wavelengths().size(); ++i) {
    likelihood_[i] *= density[i] / own;
  }
}

bool PathTracer::next_place(const GuidedRay& ray, std::size_t k, RandomStream& random, Vertex& vertex) {
  const std::optional<GuidedRay::Place> place = ray.draw(k, random());
  if (!place) {
    return false;
  }
  vertex = {place->place_km, place->radius_km, ray.direction(), place->on_ground, {}};
  if (!vertex.on_ground) {
    vertex.density = air_.density(vertex.radius_km);
  }
  optics_.attenuate(place->columns_km, throughput_);
  drawn(place->density, k);
  return true;
}

/// The share of light that a vertex throws from one direction into the ray's: per km and sr in the air, per sr on the
/// ground.
void PathTracer::scatter(const Vertex& vertex, const Vec3& toward, std::span<double> values) const {
  if (!vertex.on_ground) {
    optics_.scattering(vertex.density, glm::dot(vertex.direction, toward), values);
    return;
  }
  const double cos_zenith = std::max(0.0, glm::dot(vertex.place_km, toward) / vertex.radius_km);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = optics_.albedo(i) / pi * cos_zenith;
  }
}

Vec3 PathTracer::toward_light(RandomStream& random) const {
  if (light_cos_radius_ >= 1.0) {
    return query_.light_direction;
  }
  return around(query_.light_direction, 1.0 - random() * (1.0 - light_cos_radius_), random);
}

void PathTracer::add_light(const Vertex& vertex, RandomStream& random, std::span<double> result) {
  const Vec3 light = toward_light(random);
  const AirRay ray =
      air_.ray(vertex.radius_km, std::clamp(glm::dot(vertex.place_km, light) / vertex.radius_km, -1.0, 1.0));
  if (ray.meets_ground) {
    return;
  }
  const SampledAir::PerComponent columns =
      air_.columns_to_space(ray, [&](const auto& so_far) { return optics_.opaque(so_far); });
  scatter(vertex, light, scattered_);
  optics_.attenuate(columns, scattered_);
  if (query_.light_share) {
    query_.light_share(vertex.place_km - observer_km_, scattered_);
  }
  double likelihood = 0.0;
  for (const double value : likelihood_) {
    likelihood += value;
  }
  const double weight = static_cast<double>(guide_.wavelengths().size()) / likelihood;
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] += weight * throughput_[i] * scattered_[i];
  }
}

bool PathTracer::survives(const Vertex& vertex, std::size_t k, RandomStream& random) {
  const std::vector<std::size_t>& wavelengths = guide_.wavelengths();
  const double cos_light_zenith = glm::dot(vertex.place_km, query_.light_direction) / vertex.radius_km;
  Values chance{};
  const auto chance_of = [](double later, double all) {
    // A guide that sees no light is no reason to end a path.
    constexpr double least = 0.1;
    constexpr double most = 0.97;
    return all > 0.0 ? std::clamp(later / all, least, most) : 0.5;
  };
  if (vertex.on_ground) {
    const Values all = guide_.ground_irradiance(cos_light_zenith);
    const Values beam = guide_.light(vertex.radius_km, cos_light_zenith).beam;
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
      chance[i] = chance_of(all[i] - std::max(0.0, cos_light_zenith) * beam[i], all[i]);
    }
  } else {
    const TransportGuide::Light light = guide_.light(vertex.radius_km, cos_light_zenith);
    const double cos_angle = glm::dot(vertex.direction, query_.light_direction);
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
      double direct = 0.0;
      double later = 0.0;
      for (std::size_t c = 0; c < air_.component_count(); ++c) {
        const double scattering = vertex.density[c] * optics_.scattering_per_km(c, wavelengths[i]);
        direct += scattering * optics_.phase(c, wavelengths[i], cos_angle) * light.beam[i];
        later += scattering * light.scattered[i];
      }
      chance[i] = chance_of(later, direct + later);
    }
  }
  if (random() >= chance[k]) {
    return false;
  }
  drawn(chance, k);
  return true;
}

/// Without the guide: after the phase functions in the air, after the cosine on the ground.
Vec3 PathTracer::any_direction(const Vertex& vertex, const LocalFrame& frame, std::size_t k,
                               RandomStream& random) const {
  if (vertex.on_ground) {
    return around(frame.z, std::sqrt(random()), random);
  }
  const auto scattering = [&](std::size_t c) { return vertex.density[c] * optics_.mean_scattering_per_km(c); };
  double sum = 0.0;
  for (std::size_t c = 0; c < air_.component_count(); ++c) {
    sum += scattering(c);
  }
  double left = random() * sum;
  std::size_t chosen = 0;
  for (std::size_t c = 0; c < air_.component_count(); ++c) {
    if (scattering(c) > 0.0) {
      chosen = c;
      if (left < scattering(c)) {
        break;
      }
      left -= scattering(c);
    }
  }
  const double parameter = optics_.phase_parameter(chosen, guide_.wavelengths()[k]);
  return around(vertex.direction, proposed_cos_angle(optics_.phase_kind(chosen), parameter, random()), random);
}

bool PathTracer::next_direction(const Vertex& vertex, std::size_t k, RandomStream& random, Vec3& direction) {
  const std::vector<std::size_t>& wavelengths = guide_.wavelengths();
  const LocalFrame frame = frame_at(vertex.place_km, vertex.radius_km);
  const std::size_t cell = guide_.cell(vertex.radius_km, frame.cos_light_zenith);
  if (random() < (guide_.lit(cell, k) ? 1.0 - phase_share : 0.0)) {
    const TransportGuide::Direction local = guide_.sample(cell, k, random);
    const double sin_zenith = sine_of(local.cos_zenith);
    direction = local.cos_zenith * frame.z +
                sin_zenith * (std::cos(local.azimuth_rad) * frame.x + std::sin(local.azimuth_rad) * frame.y);
  } else {
    direction = any_direction(vertex, frame, k, random);
  }
  direction = glm::normalize(direction);

  const double cos_zenith = std::clamp(glm::dot(direction, frame.z), -1.0, 1.0);
  if (vertex.on_ground && cos_zenith <= 0.0) {
    return false;
  }
  const Values guided =
      guide_.density(cell, {cos_zenith, std::atan2(glm::dot(direction, frame.y), glm::dot(direction, frame.x))});
  const double cos_angle = std::clamp(glm::dot(direction, vertex.direction), -1.0, 1.0);
  Values density{};
  for (std::size_t i = 0; i < wavelengths.size(); ++i) {
    double plain = cos_zenith / pi;
    if (!vertex.on_ground) {
      double sum = 0.0;
      plain = 0.0;
      for (std::size_t c = 0; c < air_.component_count(); ++c) {
        const double scattering = vertex.density[c] * optics_.mean_scattering_per_km(c);
        sum += scattering;
        plain +=
            scattering * proposal_density(optics_.phase_kind(c), cos_angle, optics_.phase_parameter(c, wavelengths[i]));
      }
      plain /= sum;
    }
    density[i] = guide_.lit(cell, i) ? phase_share * plain + (1.0 - phase_share) * guided[i] : plain;
  }
  if (!(density[k] > 0.0)) {
    return false;
  }
  drawn(density, k);
  return true;
}

void PathTracer::trace(Quantity quantity, std::size_t k, RandomStream& random, std::span<double> result) {
  std::fill(result.begin(), result.end(), 0.0);
  std::fill(throughput_.begin(), throughput_.end(), 1.0);
  likelihood_.fill(0.0);
  std::fill_n(likelihood_.begin(), guide_.wavelengths().size(), 1.0);
  Vertex vertex{};
  Vec3 direction = query_.view_direction;
  const GuidedRay* ray = &first_;
  if (quantity == Quantity::irradiance) {
    const Vertex surface{observer_km_, glm::length(observer_km_), {}, true, {}};
    if (!next_direction(surface, k, random, direction)) {
      return;
    }
    for (double& value : throughput_) {
      value *= direction.z;
    }
    ray_.lay(observer_km_, direction);
    ray = &ray_;
  }
  for (int order = 1; next_place(*ray, k, random, vertex); ++order) {
    add_light(vertex, random, result);
    if (order >= orders_ || !survives(vertex, k, random) || !next_direction(vertex, k, random, direction)) {
      return;
    }
    scatter(vertex, direction, scattered_);
    for (std::size_t i = 0; i < throughput_.size(); ++i) {
      throughput_[i] *= scattered_[i];
    }
    ray_.lay(vertex.place_km, direction);
    ray = &ray_;
  }
}

} // namespace vesper
