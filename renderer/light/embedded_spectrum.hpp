// Spectra from the tables that are compiled into the libraries.
#pragma once

#include "vesper/base/embedded.hpp"
#include "vesper/light/spectrum.hpp"

#include <string_view>

namespace vesper {

/// A column of an embedded table of comma-separated values against its first column, the wavelength in nm.
/// Throws Error(file) when the table is not embedded, Error(input) when it has no such column.
[[nodiscard]] Spectrum embedded_spectrum(const EmbeddedTable& tables, std::string_view name, std::string_view column);

} // namespace vesper
