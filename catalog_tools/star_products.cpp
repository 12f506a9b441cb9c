#include "vesper/catalog_tools/star_products.hpp"

#include "vesper/assets/star_catalogue_check.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/light/spectral_type.hpp"
#include "vesper/light/star_color.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace vesper {
namespace {

// A colour for the very few stars of which nothing is known: the Sun's.
constexpr double assumed_b_v = 0.65;

double color_index(const BrightStar& star, StarProductReport& report) {
  if (star.b_v) {
    return *star.b_v;
  }
  if (const auto inferred = b_v_of_spectral_type(star.spectral_type)) {
    ++report.inferred_colors;
    return *inferred;
  }
  ++report.assumed_colors;
  return assumed_b_v;
}

std::array<float, 3> to_floats(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// The star's record. Adds its illuminance, before rounding, and what it lacks to the report.
StarRecord make_record(const BrightStar& star, StarProductReport& report) {
  const double ra = (star.right_ascension_deg * deg).to(rad);
  const double dec = (star.declination_deg * deg).to(rad);
  const Vec3 position(std::cos(dec) * std::cos(ra), std::cos(dec) * std::sin(ra), std::sin(dec));
  const Vec3 east(-std::sin(ra), std::cos(ra), 0.0);
  const Vec3 north(-std::sin(dec) * std::cos(ra), -std::sin(dec) * std::sin(ra), std::cos(dec));
  const double pm_east = (star.pm_ra_arcsec_yr.value_or(0.0) * arcsec).to(rad);
  const double pm_north = (star.pm_dec_arcsec_yr.value_or(0.0) * arcsec).to(rad);
  const double parallax = std::max((star.parallax_arcsec.value_or(0.0) * arcsec).to(rad), 0.0);
  const double b_v = color_index(star, report);
  const double illuminance = illuminance_of_v(*star.v_magnitude, star_lux_ratio(b_v)).to(lux);
  const Xyzs color = star_color(b_v);

  report.illuminance_before_lux += illuminance;
  report.without_proper_motion += !star.pm_ra_arcsec_yr || !star.pm_dec_arcsec_yr ? 1U : 0U;
  report.without_parallax += !star.parallax_arcsec ? 1U : 0U;
  report.negative_parallaxes += star.parallax_arcsec.value_or(0.0) < 0.0 ? 1U : 0U;
  report.without_radial_velocity += !star.radial_velocity_km_s ? 1U : 0U;
  report.multiple += star.multiple ? 1U : 0U;
  report.variable += star.variable ? 1U : 0U;
  ++report.count_by_magnitude[static_cast<int>(std::floor(*star.v_magnitude + 0.5))];

  return {.position = to_floats(position),
          .proper_motion = to_floats(pm_east * east + pm_north * north),
          .parallax = static_cast<float>(parallax),
          .radial_velocity = static_cast<float>(star.radial_velocity_km_s.value_or(0.0)),
          .illuminance = static_cast<float>(illuminance),
          .color = {static_cast<float>(color.x), static_cast<float>(color.y), static_cast<float>(color.z),
                    static_cast<float>(color.s)},
          .variability = 0.0F};
}

/// The entries that belong into the product, in its order.
std::vector<const BrightStar*> select(std::span<const BrightStar> entries, double limit, StarProductReport& report) {
  std::vector<const BrightStar*> kept;
  for (const BrightStar& star : entries) {
    if (!star.has_position) {
      ++report.dropped_without_position;
    } else if (!star.v_magnitude) {
      ++report.dropped_without_magnitude;
    } else if (*star.v_magnitude > limit) {
      ++report.dropped_by_limit;
    } else {
      kept.push_back(&star);
    }
  }
  std::sort(kept.begin(), kept.end(), [](const BrightStar* a, const BrightStar* b) {
    return std::tie(*a->v_magnitude, a->hr) < std::tie(*b->v_magnitude, b->hr);
  });
  return kept;
}

} // namespace

StarProduct make_star_product(std::span<const BrightStar> entries, const StarProductOptions& options) {
  if (std::isnan(options.limit_magnitude)) {
    throw Error(ErrorKind::argument, "the limiting magnitude is not a number", {"", "", "Give a number"});
  }
  StarProduct product;
  auto& [catalogue, report] = product;
  const std::vector<const BrightStar*> kept = select(entries, options.limit_magnitude, report);
  if (kept.empty()) {
    throw Error(ErrorKind::input, "no star has a position and a magnitude within the limit",
                {"", "", "Choose a fainter limit or another catalogue"});
  }
  catalogue.stars.reserve(kept.size());
  catalogue.identities.reserve(kept.size());
  for (const BrightStar* star : kept) {
    catalogue.stars.push_back(make_record(*star, report));
    catalogue.identities.push_back({star->hr, star->hd, static_cast<float>(*star->v_magnitude), star->name});
  }
  report.read = entries.size();
  report.kept = kept.size();
  report.illuminance_after_lux = total_illuminance_lux(catalogue);
  catalogue.provenance.epoch_jyear = 2000.0;
  catalogue.provenance.read = report.read;
  catalogue.provenance.kept = report.kept;
  catalogue.provenance.illuminance_lux = report.illuminance_before_lux;
  return product;
}

} // namespace vesper
