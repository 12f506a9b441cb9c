#include "vesper/atmosphere/single_scattering.hpp"

#include "vesper/atmosphere/quadrature.hpp"
#include "vesper/atmosphere/ray_column.hpp"
#include "vesper/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace vesper {
namespace {

void hold(double relative_error) {
  if (!(relative_error >= 1.0e-8 && relative_error <= 0.1)) {
    throw Error(ErrorKind::argument, "a relative error of " + std::to_string(relative_error),
                {"", "", "Give 1e-8 to 0.1"});
  }
}

/// Columns of the components with their errors.
struct Columns {
  std::vector<double> km;
  std::vector<double> error_km;
};

/// What depends on the wavelength, per km at unit density: by component, then wavelength.
struct Coefficients {
  std::vector<std::vector<double>> extinction;
  std::vector<std::vector<double>> into_view; ///< scattering times the phase function
};

Coefficients coefficients(const Medium& medium, double cos_angle, const std::vector<double>& wavelengths_nm) {
  Coefficients result;
  for (const MediumComponent& part : medium.components) {
    std::vector<double>& extinction = result.extinction.emplace_back();
    std::vector<double>& into_view = result.into_view.emplace_back();
    for (const double nm : wavelengths_nm) {
      extinction.push_back(part.extinction_per_km(nm));
      into_view.push_back(part.scattering_per_km(nm) * part.phase(cos_angle, nm));
    }
  }
  return result;
}

/// A part of the view ray, all of it in the light, with its integrals by wavelength.
struct Piece {
  double begin_km = 0.0;
  double end_km = 0.0;
  Columns before; ///< from the observer to its begin
  Columns halfway;
  std::vector<double> value;
  std::vector<double> rule_error; ///< what halving can lessen
  std::vector<double> column_error;
};

class ViewRay {
public:
  ViewRay(const Medium& medium, const SkyQuery& query, const std::vector<double>& wavelengths_nm);
  [[nodiscard]] SingleScattering integrate(double relative_error) const;

private:
  [[nodiscard]] std::vector<double> cuts() const;
  void append_shadow_edges(std::vector<double>& cuts) const;
  [[nodiscard]] bool in_light(double s_km) const;
  void add_columns(Columns& sum, const RaySpan& span) const;
  [[nodiscard]] Columns towards_light(const Vec3& place_km) const;
  [[nodiscard]] double transmittance(const Columns& view, const Columns& light, std::size_t wavelength,
                                     double& relative_error) const;
  [[nodiscard]] Piece piece(double begin_km, double end_km, Columns before) const;
  [[nodiscard]] std::vector<Piece> refined(std::vector<Piece> pieces, double relative_error) const;
  void add_ground(const Columns& view, SingleScattering& sum) const;
  [[nodiscard]] Vec3 place_km(double s_km) const { return perigee_ + s_km * view_; }

  const Medium& medium_;
  const std::vector<double>& wavelengths_nm_;
  Coefficients coefficients_;
  double ground_km_;
  double top_km_;
  Vec3 view_;
  Vec3 light_;
  Vec3 perigee_;
  RaySpan span_; ///< what of the ray lies in the air; begin = end where nothing does
  bool meets_ground_ = false;
};

ViewRay::ViewRay(const Medium& medium, const SkyQuery& query, const std::vector<double>& wavelengths_nm)
    : medium_(medium), wavelengths_nm_(wavelengths_nm),
      // Light that travels along -light is turned into -view.
      coefficients_(coefficients(medium, glm::dot(query.light_direction, query.view_direction), wavelengths_nm)),
      ground_km_(medium.ground_radius.to(kilometre)), top_km_(medium.top_radius.to(kilometre)),
      view_(query.view_direction), light_(query.light_direction) {
  const Vec3 from_km(0.0, 0.0, ground_km_ + query.height.to(kilometre));
  const double along = glm::dot(from_km, view_);
  perigee_ = from_km - along * view_;
  const double perigee_km = glm::length(glm::cross(from_km, view_));
  const double reach = crossing_km(perigee_km, top_km_);
  meets_ground_ = along < 0.0 && perigee_km < ground_km_;
  const double end = meets_ground_ ? -crossing_km(perigee_km, ground_km_) : reach;
  span_ = {perigee_km, std::min(std::max(along, -reach), end), end};
}

/// The planet's shadow is a half cylinder around the axis of the light.
bool ViewRay::in_light(double s_km) const {
  const Vec3 place = place_km(s_km);
  return glm::dot(place, light_) >= 0.0 || glm::length(glm::cross(place, light_)) >= ground_km_;
}

void ViewRay::append_shadow_edges(std::vector<double>& cuts) const {
  // Across the axis the ray is a line whose distance from it is quadratic in s.
  const Vec3 offset = perigee_ - glm::dot(perigee_, light_) * light_;
  const Vec3 slope = view_ - glm::dot(view_, light_) * light_;
  const double a = glm::dot(slope, slope);
  const double b = glm::dot(offset, slope);
  const double distance = glm::length(offset);
  const double c = (distance - ground_km_) * (distance + ground_km_);
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0.0)) {
    return;
  }
  // The form without cancellation; its divisors vanish only where the ray runs along the axis.
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  for (const double edge : {q / a, c / q}) {
    if (edge > span_.begin_km && edge < span_.end_km) {
      cuts.push_back(edge);
    }
  }
}

/// Where the integrand breaks or changes its pace, from the observer on.
std::vector<double> ViewRay::cuts() const {
  std::vector<double> cuts{span_.begin_km, span_.end_km};
  std::vector<double> extinction(wavelengths_nm_.size(), 0.0);
  const double begin_height_km = std::max(std::hypot(span_.perigee_km, span_.begin_km) - ground_km_, 0.0);
  for (std::size_t i = 0; i < medium_.components.size(); ++i) {
    const HeightProfile& profile = medium_.components[i].profile;
    append_cuts(cuts, profile, span_, ground_km_);
    const double density = profile.at(begin_height_km);
    for (std::size_t k = 0; k < extinction.size(); ++k) {
      extinction[k] += density * coefficients_.extinction[i][k];
    }
  }
  append_shadow_edges(cuts);
  // Dense air shows no more than its first free paths, which long pieces would pass over.
  const double densest = *std::max_element(extinction.begin(), extinction.end());
  const double length_km = span_.end_km - span_.begin_km;
  if (densest * length_km > 1.0) {
    double path_km = 1.0 / densest;
    while (path_km < length_km) {
      cuts.push_back(span_.begin_km + path_km);
      path_km *= 2.0;
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

void ViewRay::add_columns(Columns& sum, const RaySpan& span) const {
  for (std::size_t i = 0; i < medium_.components.size(); ++i) {
    const Integral part = column(medium_.components[i].profile, span, ground_km_);
    sum.km[i] += part.value;
    sum.error_km[i] += part.error;
  }
}

/// Of a place that is in the light: what the light has passed, also where rounding puts the ground in its way.
Columns ViewRay::towards_light(const Vec3& place_km) const {
  Columns sum{std::vector<double>(medium_.components.size(), 0.0), std::vector<double>(medium_.components.size(), 0.0)};
  const double begin_km = glm::dot(place_km, light_);
  const double perigee_km = glm::length(glm::cross(place_km, light_));
  add_columns(sum, {perigee_km, begin_km, std::max(begin_km, crossing_km(perigee_km, top_km_))});
  return sum;
}

double ViewRay::transmittance(const Columns& view, const Columns& light, std::size_t wavelength,
                              double& relative_error) const {
  double depth = 0.0;
  relative_error = 0.0;
  for (std::size_t i = 0; i < medium_.components.size(); ++i) {
    const double extinction = coefficients_.extinction[i][wavelength];
    depth += extinction * (view.km[i] + light.km[i]);
    relative_error += extinction * (view.error_km[i] + light.error_km[i]);
  }
  return std::exp(-depth);
}

Piece ViewRay::piece(double begin_km, double end_km, Columns before) const {
  const std::size_t count = wavelengths_nm_.size();
  Piece result;
  result.begin_km = begin_km;
  result.end_km = end_km;
  result.before = std::move(before);
  result.value.assign(count, 0.0);
  result.column_error.assign(count, 0.0);
  std::vector<double> coarse(count, 0.0);
  Columns view = result.before;
  double reached_km = result.begin_km;
  int node = 0;
  visit_kronrod_nodes(begin_km, end_km, [&](double s_km, double kronrod, double gauss) {
    add_columns(view, {span_.perigee_km, reached_km, s_km});
    reached_km = s_km;
    if (++node == 8) {
      result.halfway = view;
    }
    const Vec3 place = place_km(s_km);
    const Columns light = towards_light(place);
    const double height_km = std::max(glm::length(place) - ground_km_, 0.0);
    std::vector<double> density;
    for (const MediumComponent& part : medium_.components) {
      density.push_back(part.profile.at(height_km));
    }
    for (std::size_t k = 0; k < count; ++k) {
      double source = 0.0;
      for (std::size_t i = 0; i < density.size(); ++i) {
        source += coefficients_.into_view[i][k] * density[i];
      }
      double relative_error = 0.0;
      const double radiance = source * transmittance(view, light, k, relative_error);
      result.value[k] += kronrod * radiance;
      coarse[k] += gauss * radiance;
      result.column_error[k] += kronrod * radiance * relative_error;
    }
  });
  result.rule_error.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    result.rule_error[k] = std::abs(result.value[k] - coarse[k]);
  }
  return result;
}

/// Halves, in rounds, the pieces with more than their share of the error.
std::vector<Piece> ViewRay::refined(std::vector<Piece> pieces, double relative_error) const {
  constexpr int most_rounds = 60;
  const std::size_t count = wavelengths_nm_.size();
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<double> allowed(count, 0.0);
    for (const Piece& whole : pieces) {
      for (std::size_t k = 0; k < count; ++k) {
        allowed[k] += relative_error * whole.value[k];
      }
    }
    const double share = 1.0 / static_cast<double>(pieces.size());
    std::vector<Piece> next;
    for (Piece& whole : pieces) {
      bool fine = true;
      for (std::size_t k = 0; k < count && fine; ++k) {
        // Below the smallest normal number nothing can be lessened.
        fine = whole.rule_error[k] <= std::max(share * allowed[k], std::numeric_limits<double>::min());
      }
      if (fine) {
        next.push_back(std::move(whole));
        continue;
      }
      const double middle_km = 0.5 * (whole.begin_km + whole.end_km);
      next.push_back(piece(whole.begin_km, middle_km, std::move(whole.before)));
      next.push_back(piece(middle_km, whole.end_km, std::move(whole.halfway)));
    }
    const bool settled = next.size() == pieces.size();
    pieces = std::move(next);
    if (settled) {
      break;
    }
  }
  return pieces;
}

/// Lambert: the reflected radiance is the irradiance times albedo over pi.
void ViewRay::add_ground(const Columns& view, SingleScattering& sum) const {
  const Vec3 place = place_km(span_.end_km);
  const double cos_light = glm::dot(place, light_) / glm::length(place);
  if (!(cos_light > 0.0)) {
    return;
  }
  const Columns light = towards_light(place);
  for (std::size_t k = 0; k < wavelengths_nm_.size(); ++k) {
    double relative_error = 0.0;
    const double radiance = medium_.ground_albedo(wavelengths_nm_[k]) * std::numbers::inv_pi * cos_light *
                            transmittance(view, light, k, relative_error);
    sum.radiance[k] += radiance;
    sum.error[k] += radiance * relative_error;
  }
}

SingleScattering ViewRay::integrate(double relative_error) const {
  const std::size_t count = wavelengths_nm_.size();
  Columns view{std::vector<double>(medium_.components.size(), 0.0),
               std::vector<double>(medium_.components.size(), 0.0)};
  std::vector<Piece> pieces;
  const std::vector<double> places = cuts();
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (in_light(0.5 * (places[i - 1] + places[i]))) {
      pieces.push_back(piece(places[i - 1], places[i], view));
    }
    add_columns(view, {span_.perigee_km, places[i - 1], places[i]});
  }
  SingleScattering sum{std::vector<double>(count, 0.0), std::vector<double>(count, 0.0)};
  for (const Piece& part : refined(std::move(pieces), relative_error)) {
    for (std::size_t k = 0; k < count; ++k) {
      sum.radiance[k] += part.value[k];
      sum.error[k] += part.rule_error[k] + part.column_error[k];
    }
  }
  if (meets_ground_) {
    add_ground(view, sum);
  }
  return sum;
}

} // namespace

SingleScattering single_scattering(const Medium& medium, const SkyQuery& query,
                                   const std::vector<double>& wavelengths_nm, double relative_error) {
  validate(query);
  hold(relative_error);
  if (wavelengths_nm.empty()) {
    throw Error(ErrorKind::argument, "no wavelength", {"", "", "Give at least one"});
  }
  for (const double nm : wavelengths_nm) {
    validate(medium, nm);
  }
  return ViewRay(medium, query, wavelengths_nm).integrate(relative_error);
}

} // namespace vesper
