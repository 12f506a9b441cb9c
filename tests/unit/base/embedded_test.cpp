#include "vesper/base/embedded.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

namespace vesper {

extern const EmbeddedTable unit_test_files; // made by vesper_embed() in tests/unit/CMakeLists.txt

namespace {

std::vector<unsigned char> bytes_on_disk(const std::string& name) {
  std::ifstream file(std::filesystem::path(VESPER_SOURCE_DIR) / "tests/unit/base" / name, std::ios::binary);
  std::vector<unsigned char> bytes;
  for (int byte = file.get(); byte != std::ifstream::traits_type::eof(); byte = file.get()) {
    bytes.push_back(static_cast<unsigned char>(byte));
  }
  return bytes;
}

TEST(Embedded, HoldsTheBytesOfEachFile) {
  ASSERT_EQ(unit_test_files.files.size(), 2U);
  for (const std::string name : {"embedded/bytes.bin", "embedded/empty.txt"}) {
    const EmbeddedFile* file = unit_test_files.find(name);
    ASSERT_NE(file, nullptr) << name;
    EXPECT_EQ(file->name, name);
    EXPECT_EQ(std::vector<unsigned char>(file->data.begin(), file->data.end()), bytes_on_disk(name)) << name;
  }
}

TEST(Embedded, SurvivesEveryByteValue) {
  const EmbeddedFile* file = unit_test_files.find("embedded/bytes.bin");
  ASSERT_NE(file, nullptr);
  ASSERT_EQ(file->data.size(), 256U);
  for (std::size_t i = 0; i < 256; ++i) {
    ASSERT_EQ(file->data[i], i);
  }
}

TEST(Embedded, DataIsAlignedForDoubles) {
  for (const EmbeddedFile& file : unit_test_files.files) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(file.data.data()) % 8, 0U) << file.name;
  }
}

TEST(Embedded, FindsByWholeNameOnly) {
  const std::array<EmbeddedFile, 2> files{{{"lib/a.glsl", {}}, {"a.glsl", {}}}};
  const EmbeddedTable table{files};
  EXPECT_EQ(table.find("a.glsl"), &files[1]);
  EXPECT_EQ(table.find("lib/a.glsl"), files.data());
  EXPECT_EQ(table.find("a"), nullptr);
  EXPECT_EQ(table.find(""), nullptr);
  EXPECT_EQ(EmbeddedTable{}.find("a.glsl"), nullptr);
}

} // namespace
} // namespace vesper
