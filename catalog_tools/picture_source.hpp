// The pixels of a picture of the sky, row by row, wherever they come from.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vesper {

/// A picture of one or three channels that is read in strips. Row 0 is the one that row 0 of its coordinates means.
class PictureSource {
public:
  PictureSource() = default;
  PictureSource(const PictureSource&) = delete;
  PictureSource& operator=(const PictureSource&) = delete;
  virtual ~PictureSource() = default;

  [[nodiscard]] virtual int width() const = 0;
  [[nodiscard]] virtual int height() const = 0;
  [[nodiscard]] virtual int channels() const = 0;
  /// Reads whole rows of one channel, `values.size()` a multiple of the width. What is missing is NaN. Strips are read
  /// from first to last row; going back may cost a new start. Throws Error(file) or Error(input).
  virtual void read(int channel, int first_row, std::span<float> values) = 0;
};

/// What a FITS header says beside the coordinates.
struct FitsRemarks {
  std::optional<double> saturation;  ///< SATURATE: values from here on are cut off
  std::optional<double> epoch_jyear; ///< of MJD-AVG, MJD-OBS, DATE-AVG or DATE-OBS: when the stars stood there
  std::string unit;                  ///< BUNIT, empty if missing
};

} // namespace vesper
