// Pictures in FITS files, through CFITSIO.
#pragma once

#include "vesper/catalog_tools/picture_source.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vesper {

/// A picture of one plane or three, on the third axis of one file or in one file each: integers or floats, scaled by
/// BSCALE and BZERO, blank where BLANK or NaN; tiles compressed by gzip, Rice, PLIO or H-compress, or the whole file
/// by gzip (then it is unpacked into a temporary file).
class FitsPicture : public PictureSource {
public:
  /// \param files  one, or one for each channel
  /// \param hdu    counted from 1, the primary one; 0 for the first that holds a picture
  /// \param planes of the third axis, counted from 1, in the order of the channels; empty for all
  /// Throws Error(file) or Error(input) that name file, HDU and keyword: not FITS, cut short, no picture, other than
  /// one or three channels, channels of different size.
  FitsPicture(const std::vector<std::filesystem::path>& files, int hdu, const std::vector<int>& planes);
  ~FitsPicture() override;

  [[nodiscard]] int width() const override { return width_; }
  [[nodiscard]] int height() const override { return height_; }
  [[nodiscard]] int channels() const override { return static_cast<int>(channels_.size()); }
  void read(int channel, int first_row, std::span<float> values) override;

  /// The header's cards of a file, 80 characters each, as of an uncompressed picture.
  [[nodiscard]] std::string cards(std::size_t file = 0) const;
  [[nodiscard]] std::size_t file_count() const { return files_.size(); }
  [[nodiscard]] const std::string& name(std::size_t file = 0) const;
  /// "HDU 2", for messages.
  [[nodiscard]] const std::string& place(std::size_t file = 0) const;
  [[nodiscard]] FitsRemarks remarks() const;

private:
  class File;
  struct Channel {
    File* file;
    int plane;
  };
  std::vector<std::unique_ptr<File>> files_;
  std::vector<Channel> channels_;
  int width_ = 0, height_ = 0;
};

} // namespace vesper
