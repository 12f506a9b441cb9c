#include "vesper/catalog_tools/fits_picture.hpp"

#include "vesper/base/error.hpp"
#include "vesper/catalog_tools/gzip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <erfa.h>
#include <fitsio.h>
#include <fmt/format.h>
#include <fstream>
#include <limits>

namespace vesper {
namespace {

namespace fs = std::filesystem;

constexpr int most_pixels_a_side = 1 << 20;
constexpr double modified_zero = 2400000.5; // Julian date
constexpr const char* fetch_remedy = "Fetch the file again and compare its size and checksum with the publisher's";

/// CFITSIO's last words, all of them taken off its stack.
std::string fits_message(int status) {
  std::array<char, FLEN_ERRMSG> text{};
  fits_get_errstatus(status, text.data());
  std::string message = text.data();
  std::array<char, FLEN_ERRMSG> line{};
  for (bool first = true; fits_read_errmsg(line.data()) != 0; first = false) {
    if (first) {
      message += fmt::format(" ({})", line.data());
    }
  }
  return message;
}

} // namespace

class FitsPicture::File {
public:
  File(const fs::path& path, int hdu) : name_(path.string()), place_(fmt::format("HDU {}", std::max(hdu, 1))) {
    std::array<char, 6> start{};
    std::ifstream stream(path, std::ios::binary);
    if (!stream || fs::is_directory(path)) {
      throw Error(ErrorKind::file, "cannot be opened", {name_, "", "Check the path and its permissions"});
    }
    stream.read(start.data(), start.size());
    fs::path opened = path;
    if (is_gzip(std::as_bytes(std::span(start)))) {
      unpacked_ = std::make_unique<UnpackedFile>(path);
      opened = unpacked_->path();
      stream = std::ifstream(opened, std::ios::binary);
      stream.read(start.data(), start.size());
    }
    if (std::string_view(start.data(), start.size()) != "SIMPLE") {
      throw Error(ErrorKind::input, "not a FITS file: it does not begin with the keyword SIMPLE",
                  {name_, "byte 0", "Give a FITS file, or a picture with --frame and --origin"});
    }
    int status = 0;
    fits_open_diskfile(&fits_, opened.c_str(), READONLY, &status);
    require(status, "", "the header cannot be read");
    file_size_ = static_cast<LONGLONG>(fs::file_size(opened));
    try {
      choose(hdu);
    } catch (...) {
      fits_close_file(fits_, &status);
      throw;
    }
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    int status = 0;
    fits_close_file(fits_, &status);
  }

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& place() const { return place_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int planes() const { return planes_; }

  [[noreturn]] void fail(const std::string& keyword, const std::string& message, const std::string& remedy) const {
    throw Error(ErrorKind::input, message, {name_, keyword.empty() ? place_ : place_ + ", " + keyword, remedy});
  }
  void require(int status, const std::string& keyword, const std::string& what) const {
    if (status != 0) {
      fail(keyword, what + ": " + fits_message(status), fetch_remedy);
    }
  }

  [[nodiscard]] std::string cards() const {
    int status = 0;
    char* text = nullptr;
    int count = 0;
    fits_convert_hdr2str(fits_, 0, nullptr, 0, &text, &count, &status);
    std::string result = text == nullptr ? "" : text;
    int free_status = 0;
    fits_free_memory(text, &free_status);
    require(status, "", "the header cannot be read");
    return result;
  }

  template <class T> [[nodiscard]] std::optional<T> key(const char* keyword) const {
    int status = 0;
    if constexpr (std::is_same_v<T, std::string>) {
      std::array<char, FLEN_VALUE> value{};
      fits_read_key(fits_, TSTRING, keyword, value.data(), nullptr, &status);
      fits_clear_errmsg();
      return status == 0 ? std::optional<T>(value.data()) : std::nullopt;
    } else {
      double value = 0.0;
      fits_read_key(fits_, TDOUBLE, keyword, &value, nullptr, &status);
      fits_clear_errmsg();
      return status == 0 && std::isfinite(value) ? std::optional<T>(value) : std::nullopt;
    }
  }

  void read(int plane, int first_row, std::span<float> values) {
    std::array<LONGLONG, 3> first{1, first_row + 1, plane};
    float missing = std::numeric_limits<float>::quiet_NaN();
    int any_missing = 0;
    int status = 0;
    fits_read_pixll(fits_, TFLOAT, first.data(), static_cast<LONGLONG>(values.size()), &missing, values.data(),
                    &any_missing, &status);
    // Values out of the range of a float are as good as missing.
    if (status == NUM_OVERFLOW) {
      fits_clear_errmsg();
      status = 0;
    }
    if (status != 0) {
      fail("", fmt::format("the data of rows {} on cannot be read: {}", first_row + 1, fits_message(status)),
           fetch_remedy);
    }
  }

private:
  /// Goes to the picture and reads its size.
  void choose(int hdu) {
    int count = 0;
    int status = 0;
    fits_get_num_hdus(fits_, &count, &status);
    if (status != 0 || hdu > count) {
      fits_clear_errmsg();
      fail("", fmt::format("there is no HDU {}: the file has {}", hdu, count), "Choose another --hdu");
    }
    for (int i = hdu == 0 ? 1 : hdu; i <= (hdu == 0 ? count : hdu); ++i) {
      int type = 0;
      int axes = 0;
      int bits = 0;
      std::array<LONGLONG, 9> sizes{};
      fits_movabs_hdu(fits_, i, &type, &status);
      if (type == IMAGE_HDU) {
        fits_get_img_paramll(fits_, static_cast<int>(sizes.size()), &bits, &axes, sizes.data(), &status);
      }
      place_ = fmt::format("HDU {}", i);
      require(status, "", "the header cannot be read");
      if (axes >= 2 && sizes[0] > 0 && sizes[1] > 0) {
        take_size(axes, sizes);
        require_all_data(bits, axes, sizes);
        return;
      }
    }
    fail("NAXIS", hdu == 0 ? "no HDU holds a picture of two axes or more" : "this HDU holds no picture of two axes",
         "Choose another --hdu or file");
  }

  void take_size(int axes, const std::array<LONGLONG, 9>& sizes) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::min(axes, 9)); ++i) {
      const LONGLONG most = i < 3 ? most_pixels_a_side : 1;
      if (sizes[i] < 1 || sizes[i] > most) {
        fail(fmt::format("NAXIS{}", i + 1), fmt::format("an axis of {} elements, 1 to {} allowed", sizes[i], most),
             "Give a picture of two axes, or three with the channels last");
      }
    }
    width_ = static_cast<int>(sizes[0]);
    height_ = static_cast<int>(sizes[1]);
    planes_ = axes > 2 ? static_cast<int>(sizes[2]) : 1;
  }

  void require_all_data(int bits, int axes, const std::array<LONGLONG, 9>& sizes) {
    int status = 0;
    LONGLONG header = 0;
    LONGLONG data = 0;
    LONGLONG end = 0;
    fits_get_hduaddrll(fits_, &header, &data, &end, &status);
    double needed = 0.0;
    if (fits_is_compressed_image(fits_, &status) != 0) {
      needed = key<double>("NAXIS1").value_or(0.0) * key<double>("NAXIS2").value_or(0.0) +
               key<double>("PCOUNT").value_or(0.0);
    } else {
      needed = std::abs(bits) / 8.0;
      for (int i = 0; i < axes; ++i) {
        needed *= static_cast<double>(sizes[static_cast<std::size_t>(i)]);
      }
    }
    require(status, "", "the header cannot be read");
    if (static_cast<double>(data) + needed > static_cast<double>(file_size_)) {
      fail("NAXIS, BITPIX",
           fmt::format(
               "the data are cut short: the header promises {:.0f} bytes from byte {} on, the file ends at byte {}",
               needed, data, file_size_),
           fetch_remedy);
    }
  }

  std::string name_;
  std::string place_;
  std::unique_ptr<UnpackedFile> unpacked_;
  fitsfile* fits_ = nullptr;
  LONGLONG file_size_ = 0;
  int width_ = 0, height_ = 0, planes_ = 0;
};

FitsPicture::FitsPicture(const std::vector<fs::path>& files, int hdu, const std::vector<int>& planes) {
  for (const fs::path& path : files) {
    File& file = *files_.emplace_back(std::make_unique<File>(path, hdu));
    if (planes.empty()) {
      for (int plane = 1; plane <= file.planes(); ++plane) {
        channels_.push_back({&file, plane});
      }
    }
    for (const int plane : planes) {
      if (plane < 1 || plane > file.planes()) {
        file.fail("NAXIS3", fmt::format("there is no plane {} but {}", plane, file.planes()), "Choose other --planes");
      }
      channels_.push_back({&file, plane});
    }
    if (file.width() != files_[0]->width() || file.height() != files_[0]->height()) {
      file.fail("NAXIS1, NAXIS2",
                fmt::format("{} x {} pixels, but {} has {} x {}", file.width(), file.height(), files_[0]->name(),
                            files_[0]->width(), files_[0]->height()),
                "Give channels of one size");
    }
  }
  if (channels_.size() != 1 && channels_.size() != 3) {
    files_.back()->fail("NAXIS3", fmt::format("{} channels, but one or three are needed", channels_.size()),
                        "Choose planes with --planes, or give three files");
  }
  width_ = files_[0]->width();
  height_ = files_[0]->height();
}

FitsPicture::~FitsPicture() = default;

void FitsPicture::read(int channel, int first_row, std::span<float> values) {
  const Channel& from = channels_[static_cast<std::size_t>(channel)];
  from.file->read(from.plane, first_row, values);
}

std::string FitsPicture::cards(std::size_t file) const { return files_[file]->cards(); }
const std::string& FitsPicture::name(std::size_t file) const { return files_[file]->name(); }
const std::string& FitsPicture::place(std::size_t file) const { return files_[file]->place(); }

FitsRemarks FitsPicture::remarks() const {
  const File& file = *files_[0];
  FitsRemarks remarks{file.key<double>("SATURATE"), std::nullopt, file.key<std::string>("BUNIT").value_or("")};
  for (const char* keyword : {"MJD-AVG", "MJD-OBS"}) {
    if (const auto day = file.key<double>(keyword); day && !remarks.epoch_jyear) {
      remarks.epoch_jyear = eraEpj(modified_zero, *day);
    }
  }
  for (const char* keyword : {"DATE-AVG", "DATE-OBS"}) {
    auto text = file.key<std::string>(keyword);
    int year = 0;
    int month = 0;
    int day = 0;
    int status = 0;
    if (text && !remarks.epoch_jyear && fits_str2date(text->data(), &year, &month, &day, &status) == 0 && year > 0) {
      double zero = 0.0;
      double day_number = 0.0;
      if (eraCal2jd(year, month, day, &zero, &day_number) == 0) {
        remarks.epoch_jyear = eraEpj(zero, day_number);
      }
    }
    fits_clear_errmsg();
  }
  return remarks;
}

} // namespace vesper
