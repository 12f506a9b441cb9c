// The map of the light in the Earth's shadow as a file.
#include "vesper/atmosphere/earth_shadow_file.hpp"
#include "vesper/base/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace vesper {
namespace {

std::string message_of(const Bytes& bytes) {
  try {
    static_cast<void>(decode_earth_shadow_light(bytes, "shadow.bin"));
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

Bytes embedded() { return encode_earth_shadow_light(default_earth_shadow_light()); }

TEST(EarthShadowFile, ComesBackAsItWas) {
  const EarthShadowLight& light = default_earth_shadow_light();
  const EarthShadowLight back = decode_earth_shadow_light(embedded(), "shadow.bin");
  EXPECT_EQ(back.wavelengths_nm, light.wavelengths_nm);
  EXPECT_EQ(back.log_shares, light.log_shares);
  EXPECT_EQ(back.frame.inner, light.frame.inner);
  EXPECT_EQ(back.frame.width_km, light.frame.width_km);
  EXPECT_EQ(encode_earth_shadow_light(back), embedded());
}

TEST(EarthShadowFile, IsWrittenAndRead) {
  const auto path = std::filesystem::temp_directory_path() / "vesper_earth_shadow_test.bin";
  write_earth_shadow_light(path, default_earth_shadow_light());
  EXPECT_EQ(read_earth_shadow_light(path).log_shares, default_earth_shadow_light().log_shares);
  std::filesystem::remove(path);
  EXPECT_THROW(static_cast<void>(read_earth_shadow_light(path)), Error);
}

TEST(EarthShadowFile, TellsWhatIsWrong) {
  EXPECT_NE(message_of({}).find("no map"), std::string::npos);
  EXPECT_NE(message_of(Bytes(500, std::byte{7})).find("no map"), std::string::npos);
  Bytes bytes = embedded();
  bytes.resize(40);
  EXPECT_NE(message_of(bytes).find("ends before"), std::string::npos);
  bytes = embedded();
  bytes.pop_back();
  EXPECT_NE(message_of(bytes).find("bytes where"), std::string::npos);
  bytes = embedded();
  bytes.push_back(std::byte{0});
  EXPECT_NE(message_of(bytes).find("bytes where"), std::string::npos);
  bytes = embedded();
  bytes[8] = std::byte{77};
  EXPECT_NE(message_of(bytes).find("version 77"), std::string::npos);
  bytes = embedded();
  std::fill_n(bytes.begin() + 12, 4, std::byte{0xff});
  EXPECT_NE(message_of(bytes).find("sizes"), std::string::npos);
  bytes = embedded();
  std::fill_n(bytes.begin() + 88, 8, std::byte{0xff});
  EXPECT_NE(message_of(bytes).find("do not rise"), std::string::npos);
  EarthShadowLight cut = default_earth_shadow_light();
  cut.log_shares.pop_back();
  EXPECT_THROW(static_cast<void>(encode_earth_shadow_light(cut)), Error);
}

} // namespace
} // namespace vesper
