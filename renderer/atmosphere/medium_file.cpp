#include "vesper/atmosphere/medium_file.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/standard_profiles.hpp"
#include "vesper/atmosphere/toml_table.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"
#include "vesper/light/spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace vesper {
namespace {

constexpr Range fraction{0.0, 1.0};
constexpr Range ground_radii_km{1.0, 1.0e6};
constexpr Range top_heights_km{0.001, 1.0e4};
constexpr Range scales_km{0.001, 1.0e3};
constexpr Range coefficients_per_km{0.0, 1.0e6};
constexpr Range relative_densities{0.0, 1.0e30}; // also molecules per m3: see the aerosol's and ozone's columns
constexpr Range depolarizations{0.0, 6.0 / 7.0};
constexpr Range asymmetries{-0.99, 0.99};

/// Everything that is read under one file's roof.
class MediumReader {
public:
  MediumReader(std::string_view text, const std::string& name) : file_(TomlTable::parse(text, name)) {}

  Medium read() {
    file_.has("base") ? read_base() : read_radii();
    if (file_.has("ground_albedo")) {
      medium_.ground_albedo = numbers_law(file_, "ground_albedo", fraction);
    }
    const std::vector<TomlTable> components = file_.tables("component");
    if (components.empty() && medium_.components.empty()) {
      file_.fail("component", "the medium has no component", "Add at least one [[component]], or a base");
    }
    for (const TomlTable& component : components) {
      medium_.components.push_back(read_component(component));
    }
    read_wavelengths();
    return std::move(medium_);
  }

private:
  struct ClearKnob {
    const char* key;
    double ClearAir::*value;
  };

  void read_base() {
    const std::string base = file_.text("base");
    const auto preset = medium_by_name(base);
    if (!preset) {
      file_.fail("base", fmt::format("'{}' is no medium of its own", base),
                 fmt::format("Give one of {}", fmt::join(medium_names(), ", ")));
    }
    if (base == "clear") {
      file_.allow_only({"base", "turbidity", "aerosol_optical_depth", "stratospheric_optical_depth",
                        "angstrom_exponent", "ozone", "ground_albedo", "wavelengths", "component"});
      medium_ = clear_medium(read_clear_air());
    } else {
      file_.allow_only({"base", "ground_albedo", "wavelengths", "component"});
      medium_ = *preset;
    }
    narrow(medium_.wavelengths_nm.front(), medium_.wavelengths_nm.back());
  }

  ClearAir read_clear_air() {
    ClearAir air;
    const auto held = [&](const char* key) {
      try {
        validate(air);
      } catch (const Error& e) {
        file_.fail(key, e.message(), e.context().remedy);
      }
    };
    for (const ClearKnob& knob : {ClearKnob{"aerosol_optical_depth", &ClearAir::aerosol_optical_depth},
                                  ClearKnob{"stratospheric_optical_depth", &ClearAir::stratospheric_optical_depth},
                                  ClearKnob{"angstrom_exponent", &ClearAir::angstrom_exponent}}) {
      if (file_.has(knob.key)) {
        air.*knob.value = file_.number(knob.key, any_number);
        held(knob.key);
      }
    }
    if (file_.has("ozone")) {
      air.ozone_dobson = file_.quantity("ozone", QuantityKind::ozone_column, any_number);
      held("ozone");
    }
    if (file_.has("turbidity")) {
      if (file_.has("aerosol_optical_depth")) {
        file_.fail("turbidity", "stands beside aerosol_optical_depth", "Give one of the two");
      }
      air.aerosol_optical_depth = aerosol_depth_from_turbidity(file_.number("turbidity", {1.0, 100.0}));
    }
    return air;
  }

  void read_radii() {
    file_.allow_only({"base", "ground_radius", "top_height", "ground_albedo", "wavelengths", "component"});
    medium_.ground_radius = file_.quantity("ground_radius", QuantityKind::height, ground_radii_km) * kilometre;
    medium_.top_radius =
        medium_.ground_radius + file_.quantity("top_height", QuantityKind::height, top_heights_km) * kilometre;
    if (!file_.has("ground_albedo")) {
      file_.fail("ground_albedo", "the key is missing",
                 "Give a number from 0 to 1, or one for each of some wavelengths");
    }
  }

  void read_wavelengths() {
    if (!file_.has("wavelengths")) {
      if (!file_.has("base") || covered_.lowest > medium_.wavelengths_nm.front() ||
          covered_.highest < medium_.wavelengths_nm.back()) {
        medium_.wavelengths_nm = transport_wavelengths_nm();
        std::erase_if(medium_.wavelengths_nm, [&](double nm) { return nm < covered_.lowest || nm > covered_.highest; });
      }
      return;
    }
    std::vector<double> wavelengths = file_.quantities("wavelengths", QuantityKind::wavelength, covered_);
    hold_visible(file_, wavelengths);
    medium_.wavelengths_nm = std::move(wavelengths);
  }

  /// Ascending wavelengths that span the visible.
  static void hold_visible(const TomlTable& table, const std::vector<double>& wavelengths_nm) {
    const auto falls = std::adjacent_find(wavelengths_nm.begin(), wavelengths_nm.end(), std::not_fn(std::less<>()));
    if (falls != wavelengths_nm.end()) {
      table.fail("wavelengths", fmt::format("{:g} nm is followed by {:g} nm", *falls, *(falls + 1)),
                 "Sort the wavelengths and remove repetitions");
    }
    if (wavelengths_nm.front() > visible_from_nm || wavelengths_nm.back() < visible_to_nm) {
      table.fail("wavelengths",
                 fmt::format("{:g} to {:g} nm do not cover the visible", wavelengths_nm.front(), wavelengths_nm.back()),
                 fmt::format("Begin at {:g} nm or below and end at {:g} nm or above", visible_from_nm, visible_to_nm));
    }
  }

  void narrow(double from_nm, double to_nm) {
    covered_ = {std::max(covered_.lowest, from_nm), std::min(covered_.highest, to_nm)};
  }

  /// A table of wavelengths and values, linear between them; beyond them the outermost values hold.
  WavelengthLaw sampled(const TomlTable& table, std::vector<double> values) {
    std::vector<double> wavelengths = table.quantities("wavelengths", QuantityKind::wavelength, {1.0, 1.0e5});
    hold_visible(table, wavelengths);
    if (values.size() != wavelengths.size()) {
      table.fail("values", fmt::format("holds {} values for {} wavelengths", values.size(), wavelengths.size()),
                 "Give one value for each wavelength");
    }
    narrow(wavelengths.front(), wavelengths.back());
    return [from = wavelengths.front(), to = wavelengths.back(), spectrum = Spectrum(wavelengths, std::move(values))](
               double nm) { return spectrum(std::clamp(nm, from, to)); };
  }

  /// A number for all wavelengths, or a table of them.
  WavelengthLaw numbers_law(const TomlTable& table, std::string_view key, Range range) {
    if (!table.has_table(key)) {
      return constant_law(table.number(key, range));
    }
    const TomlTable samples = table.table(key);
    samples.allow_only({"wavelengths", "values"});
    return sampled(samples, samples.numbers("values", range));
  }

  WavelengthLaw coefficient_law(const TomlTable& table, std::string_view key) {
    if (!table.has(key)) {
      return constant_law(0.0);
    }
    if (!table.has_table(key)) {
      return constant_law(table.quantity(key, QuantityKind::coefficient, coefficients_per_km));
    }
    const TomlTable samples = table.table(key);
    samples.allow_only({"wavelengths", "values"});
    return sampled(samples, samples.quantities("values", QuantityKind::coefficient, coefficients_per_km));
  }

  /// Heights that must lie in the air.
  [[nodiscard]] std::vector<double> heights(const TomlTable& table, std::string_view key) const {
    const double top_km = (medium_.top_radius - medium_.ground_radius).to(kilometre);
    std::vector<double> heights_km = table.quantities(key, QuantityKind::height, any_number);
    for (const double km : heights_km) {
      // A top that was written in km must not lose its last bit to the radii.
      if (!(km >= 0.0 && km <= top_km * (1.0 + 1.0e-9))) {
        table.fail(key, fmt::format("{:g} km lies outside the air", km),
                   fmt::format("The air reaches from the ground, 0 km, to {:g} km (top_height)", top_km));
      }
    }
    return heights_km;
  }

  [[nodiscard]] double height(const TomlTable& table, std::string_view key) const {
    const std::vector<double> one = heights(table, key);
    if (one.size() != 1) {
      table.fail(key, fmt::format("holds {} heights", one.size()), "Give one");
    }
    return one.front();
  }

  [[nodiscard]] HeightProfile table_profile(const TomlTable& table) const {
    std::vector<double> heights_km = heights(table, "heights");
    std::vector<double> densities = table.numbers("densities", relative_densities);
    const std::string between = table.has("between") ? table.text("between") : "linear";
    if (between != "linear" && between != "logarithmic") {
      table.fail("between", fmt::format("'{}' is unknown", between), "Give linear or logarithmic");
    }
    try {
      return HeightProfile::table(std::move(heights_km), std::move(densities),
                                  between == "linear" ? HeightProfile::Between::linear
                                                      : HeightProfile::Between::logarithmic);
    } catch (const Error& e) {
      table.fail("", e.message(), e.context().remedy);
    }
  }

  /// \param otherwise where the component has none
  HeightProfile profile_of(const TomlTable& component, HeightProfile (*otherwise)()) const {
    if (!component.has("profile") && otherwise != nullptr) {
      return otherwise();
    }
    const TomlTable table = component.table("profile");
    const std::string kind = table.text("kind");
    if (kind == "exponential") {
      table.allow_only({"kind", "scale"});
      return HeightProfile::exponential(table.quantity("scale", QuantityKind::height, scales_km));
    }
    if (kind == "tent") {
      table.allow_only({"kind", "lowest", "peak", "highest"});
      const std::array<double, 3> km{height(table, "lowest"), height(table, "peak"), height(table, "highest")};
      if (!std::is_sorted(km.begin(), km.end())) {
        table.fail("peak", fmt::format("{:g} km does not lie between {:g} and {:g} km", km[1], km[0], km[2]),
                   "Give lowest, peak and highest from below upwards");
      }
      return HeightProfile::tent(km[0], km[1], km[2]);
    }
    if (kind == "table") {
      table.allow_only({"kind", "heights", "densities", "between"});
      return table_profile(table);
    }
    if (kind == "standard-air" || kind == "standard-ozone") {
      table.allow_only({"kind"});
      return kind == "standard-air" ? standard_air_profile() : standard_ozone_profile();
    }
    table.fail("kind", fmt::format("'{}' is unknown", kind),
               "Give exponential, tent, table, standard-air or standard-ozone");
  }

  PhaseFunction phase_of(const TomlTable& component) {
    const TomlTable table = component.table("phase");
    const std::string kind = table.text("kind");
    if (kind == "rayleigh") {
      table.allow_only({"kind", "depolarization"});
      return {PhaseKind::rayleigh, table.has("depolarization") ? numbers_law(table, "depolarization", depolarizations)
                                                               : WavelengthLaw(air_depolarization)};
    }
    constexpr std::array<std::pair<std::string_view, PhaseKind>, 3> lobes{
        {{"henyey-greenstein", PhaseKind::henyey_greenstein},
         {"cornette-shanks", PhaseKind::cornette_shanks},
         {"schlick", PhaseKind::schlick}}};
    const auto* const lobe = std::find_if(lobes.begin(), lobes.end(), [&](const auto& l) { return l.first == kind; });
    if (lobe == lobes.end()) {
      table.fail("kind", fmt::format("'{}' is unknown", kind),
                 "Give rayleigh, henyey-greenstein, cornette-shanks or schlick");
    }
    table.allow_only({"kind", "asymmetry"});
    return {lobe->second, numbers_law(table, "asymmetry", asymmetries)};
  }

  /// The zenith column that an optical depth or an amount of ozone is spread over.
  [[nodiscard]] double column_km(const TomlTable& component, std::string_view key, const HeightProfile& profile) const {
    const double km = zenith_column_km(profile, medium_.ground_radius, medium_.top_radius);
    if (!(km > 0.0)) {
      component.fail(key, "has to be spread over a profile that holds nothing", "Give the profile some thickness");
    }
    return km;
  }

  MediumComponent molecules(const TomlTable& component, std::string name) {
    component.allow_only({"name", "profile", "molecules", "phase"});
    const TomlTable table = component.table("molecules");
    table.allow_only({"pressure", "temperature"});
    constexpr double standard_hpa = 1013.25;
    constexpr double standard_k = 288.15;
    constexpr double zero_celsius_k = 273.15;
    const double hpa =
        table.has("pressure") ? table.quantity("pressure", QuantityKind::pressure, {0.0, 1.0e5}) : standard_hpa;
    const double kelvin =
        table.has("temperature")
            ? table.quantity("temperature", QuantityKind::temperature, {-200.0, 2000.0}) + zero_celsius_k
            : standard_k;
    const double density = hpa / standard_hpa * (standard_k / kelvin);
    return {std::move(name), profile_of(component, standard_air_profile),
            [density](double nm) { return density * rayleigh_per_km(nm); }, constant_law(0.0),
            component.has("phase") ? phase_of(component) : PhaseFunction{PhaseKind::rayleigh, air_depolarization}};
  }

  MediumComponent aerosol(const TomlTable& component, std::string name) {
    component.allow_only({"name", "profile", "aerosol", "phase"});
    const TomlTable table = component.table("aerosol");
    table.allow_only({"optical_depth", "at", "angstrom_exponent", "single_scattering_albedo"});
    HeightProfile profile = profile_of(component, nullptr);
    const double depth = table.number("optical_depth", {0.0, 1000.0});
    const double at_nm = table.quantity("at", QuantityKind::wavelength, {100.0, 1.0e5});
    const double exponent = table.number("angstrom_exponent", {-4.0, 4.0});
    WavelengthLaw albedo = numbers_law(table, "single_scattering_albedo", fraction);
    const WavelengthLaw per_km = [at_nm, exponent, here = depth / column_km(component, "aerosol", profile)](double nm) {
      return here * std::pow(nm / at_nm, -exponent);
    };
    return {std::move(name), std::move(profile), [per_km, albedo](double nm) { return albedo(nm) * per_km(nm); },
            [per_km, albedo](double nm) { return (1.0 - albedo(nm)) * per_km(nm); }, phase_of(component)};
  }

  MediumComponent ozone(const TomlTable& component, std::string name) {
    component.allow_only({"name", "profile", "ozone"});
    const TomlTable table = component.table("ozone");
    table.allow_only({"column"});
    const double dobson = table.quantity("column", QuantityKind::ozone_column, {0.0, 1.0e5});
    HeightProfile profile = profile_of(component, standard_ozone_profile);
    const double km = column_km(component, "ozone", profile);
    return {std::move(name),
            std::move(profile),
            constant_law(0.0),
            ozone_absorption_per_km(dobson, km),
            {PhaseKind::rayleigh, air_depolarization}};
  }

  MediumComponent by_coefficients(const TomlTable& component, std::string name) {
    component.allow_only({"name", "profile", "scattering", "absorption", "molecules", "aerosol", "ozone", "phase"});
    const bool scatters = component.has("scattering");
    if (!scatters && !component.has("absorption")) {
      component.fail("", "the component holds nothing",
                     "Give scattering, absorption or both; or molecules, aerosol or ozone");
    }
    HeightProfile profile = profile_of(component, nullptr);
    WavelengthLaw scattering = coefficient_law(component, "scattering");
    WavelengthLaw absorption = coefficient_law(component, "absorption");
    return {std::move(name), std::move(profile), std::move(scattering), std::move(absorption),
            scatters || component.has("phase") ? phase_of(component)
                                               : PhaseFunction{PhaseKind::rayleigh, constant_law(0.0)}};
  }

  MediumComponent read_component(const TomlTable& component) {
    std::string name = component.text("name");
    MediumComponent part = component.has("molecules") ? molecules(component, std::move(name))
                           : component.has("aerosol") ? aerosol(component, std::move(name))
                           : component.has("ozone")   ? ozone(component, std::move(name))
                                                      : by_coefficients(component, std::move(name));
    // Values that were in range may still multiply to more than a double holds.
    for (const double nm : transport_wavelengths_nm()) {
      if (!std::isfinite(part.extinction_per_km(nm))) {
        component.fail("", fmt::format("the extinction at {:g} nm is beyond all numbers", nm),
                       "Give densities nearer to 1");
      }
    }
    return part;
  }

  TomlTable file_;
  Medium medium_;
  /// What all tables by wavelength span, within what the response functions do.
  Range covered_{transport_wavelengths_nm().front(), transport_wavelengths_nm().back()};
};

} // namespace

Medium parse_medium(std::string_view text, const std::string& name) { return MediumReader(text, name).read(); }

Medium read_medium_file(const std::filesystem::path& path) {
  const Bytes bytes = read_file(path);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): text is bytes
  return parse_medium({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path.string());
}

} // namespace vesper
