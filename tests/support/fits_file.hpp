// FITS files that tests write.
#pragma once

#include <fitsio.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace vesper::test {

struct FitsContent {
  int width = 0, height = 0, planes = 1;
  int bits = FLOAT_IMG;      ///< BITPIX
  int compression = 0;       ///< of CFITSIO: RICE_1, GZIP_1, ...; 0 for none
  bool in_extension = false; ///< behind an empty primary HDU
  std::string cards;         ///< further cards, 80 characters each
  std::vector<float> values; ///< as they are stored, before BSCALE and BZERO
};

inline void write_fits(const std::string& path, const FitsContent& content) {
  fitsfile* file = nullptr;
  int status = 0;
  fits_create_diskfile(&file, path.c_str(), &status);
  if (content.compression != 0) {
    fits_set_compression_type(file, content.compression, &status);
    if (content.bits < 0) {
      fits_set_quantize_level(file, 0.0F, &status); // without loss
    }
  }
  if (content.in_extension) {
    fits_create_img(file, BYTE_IMG, 0, nullptr, &status);
  }
  std::array<long, 3> sizes{content.width, content.height, content.planes};
  fits_create_img(file, content.bits, content.planes > 1 ? 3 : 2, sizes.data(), &status);
  for (std::size_t at = 0; at < content.cards.size(); at += 80) {
    fits_write_record(file, content.cards.substr(at, 80).c_str(), &status);
  }
  fits_set_hdustruc(file, &status);
  fits_set_bscale(file, 1.0, 0.0, &status);
  if (content.bits > 0) {
    std::vector<int> values(content.values.begin(), content.values.end());
    fits_write_img(file, TINT, 1, static_cast<LONGLONG>(values.size()), values.data(), &status);
  } else {
    std::vector<float> values = content.values;
    fits_write_img(file, TFLOAT, 1, static_cast<LONGLONG>(values.size()), values.data(), &status);
  }
  fits_close_file(file, &status);
  if (status != 0) {
    std::array<char, FLEN_ERRMSG> text{};
    fits_get_errstatus(status, text.data());
    throw std::runtime_error(path + ": " + text.data());
  }
}

} // namespace vesper::test
