#include "vesper/light/sunlight.hpp"

#include "vesper/base/embedded.hpp"
#include "vesper/light/embedded_spectrum.hpp"

namespace vesper {

extern const EmbeddedTable embedded_light_tables;

const Spectrum& solar_irradiance_1au() {
  static const Spectrum table = embedded_spectrum(embedded_light_tables, "solar_e490.csv", "irradiance_w_m2_nm");
  return table;
}

} // namespace vesper
