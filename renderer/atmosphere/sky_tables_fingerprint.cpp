#include "vesper/atmosphere/earth_shadow_file.hpp"
#include "vesper/atmosphere/sampled_air.hpp"
#include "vesper/atmosphere/sky_tables_file.hpp"
#include "vesper/base/sha256.hpp"
#include "vesper/light/sunlight.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

namespace vesper {

// Of their sources, made by the build.
extern const std::string_view sky_solver_digest;
extern const std::string_view shadow_solver_digest;

namespace {

class Description {
public:
  void add(std::string_view text) { (text_ += text) += '\n'; }
  /// The bits of a float: what is nearer to each other than 6e-8 of itself counts as the same.
  void add(double value) {
    fmt::format_to(std::back_inserter(text_), "{:x} ", std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  }
  void add(const std::vector<double>& values) {
    add(static_cast<double>(values.size()));
    for (const double value : values) {
      add(value);
    }
  }
  [[nodiscard]] std::string digest() const { return sha256_hex(std::as_bytes(std::span(text_))); }

private:
  std::string text_;
};

/// Where what depends on the wavelength is looked at: the medium's own wavelengths, and those that a solver may choose.
std::vector<double> wavelengths_of(const Medium& medium) {
  std::vector<double> wavelengths = medium.wavelengths_nm;
  for (int nm = 360; nm <= 830; nm += 5) {
    wavelengths.push_back(nm);
  }
  return wavelengths;
}

void describe(const MediumComponent& component, const std::vector<double>& wavelengths, double height_km,
              Description& description) {
  description.add(static_cast<double>(component.phase.kind));
  for (const double nm : wavelengths) {
    description.add(component.scattering_per_km(nm));
    description.add(component.absorption_per_km(nm));
    description.add(component.phase.parameter(nm));
  }
  description.add(component.profile.breaks_km());
  const double step_km = SampledAir::step_km;
  for (int i = 0; i * step_km < height_km + step_km; ++i) {
    description.add(component.profile.at(i * step_km));
  }
}

/// All of it that light meets, under sunlight.
void describe(const Medium& medium, Description& description) {
  description.add(solar_irradiance_1au().wavelengths_nm());
  description.add(solar_irradiance_1au().values());
  const double ground_km = medium.ground_radius.to(kilometre);
  const double top_km = medium.top_radius.to(kilometre);
  description.add(ground_km);
  description.add(top_km);
  description.add(medium.wavelengths_nm);
  const std::vector<double> wavelengths = wavelengths_of(medium);
  for (const double nm : wavelengths) {
    description.add(medium.ground_albedo(nm));
  }
  for (const MediumComponent& component : medium.components) {
    describe(component, wavelengths, top_km - ground_km, description);
  }
}

} // namespace

std::string sky_tables_fingerprint(const Medium& medium, const SkyTableSize& size) {
  validate_radii(medium);
  Description description;
  description.add(sky_solver_digest);
  for (const int nodes : {size.heights, size.views_below, size.views_above, size.lights}) {
    description.add(nodes);
  }
  const LightFieldSize& field = size.field;
  for (const std::size_t count :
       {field.heights, field.zeniths, field.azimuths, field.later_zeniths, field.later_azimuths}) {
    description.add(static_cast<double>(count));
  }
  for (const double value :
       {field.step_growth, field.least_step_km, field.rest, static_cast<double>(field.most_orders)}) {
    description.add(value);
  }
  describe(medium, description);
  return description.digest();
}

std::string earth_shadow_fingerprint(const Medium& medium) {
  validate_radii(medium);
  Description description;
  description.add(shadow_solver_digest);
  describe(medium, description);
  return description.digest();
}

} // namespace vesper
