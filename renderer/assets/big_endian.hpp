// Bytes as ICC profiles and PNG hold numbers.
#pragma once

#include "vesper/base/files.hpp"
#include "vesper/base/vector.hpp"

#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>

namespace vesper {

/// Big-endian numbers and texts, one behind the other.
class BigEndian {
public:
  BigEndian& u8(unsigned value) { return append(value, 1); }
  BigEndian& u16(unsigned value) { return append(value, 2); }
  BigEndian& u32(std::uint32_t value) { return append(value, 4); }
  /// s15Fixed16Number.
  BigEndian& fixed(double value) {
    return u32(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(65536.0 * value))));
  }
  BigEndian& vector(const Vec3& v) { return fixed(v.x).fixed(v.y).fixed(v.z); }
  BigEndian& text(std::string_view text) {
    for (const char c : text) {
      u8(static_cast<unsigned char>(c));
    }
    return *this;
  }
  BigEndian& zeros(std::size_t count) {
    bytes_.resize(bytes_.size() + count);
    return *this;
  }
  BigEndian& all(std::span<const std::byte> bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return *this;
  }
  [[nodiscard]] const Bytes& bytes() const { return bytes_; }

private:
  BigEndian& append(std::uint32_t value, unsigned count) {
    for (unsigned i = count; i-- > 0;) {
      bytes_.push_back(static_cast<std::byte>(value >> (8U * i)));
    }
    return *this;
  }
  Bytes bytes_;
};

} // namespace vesper
