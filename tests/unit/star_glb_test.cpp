#include "vesper/assets/default_stars.hpp"
#include "vesper/assets/star_catalogue_check.hpp"
#include "vesper/assets/star_glb.hpp"
#include "vesper/base/error.hpp"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace vesper {
namespace {

using Json = nlohmann::ordered_json;

StarRecord star(std::array<float, 3> position, float illuminance) {
  return {.position = position,
          .proper_motion = {0, 0, 0},
          .parallax = 1e-6F,
          .radial_velocity = -7.5F,
          .illuminance = illuminance,
          .color = {1.0F, 1.0F, 1.2F, 2.5F},
          .variability = 0.25F};
}

StarCatalogue three_stars() {
  StarCatalogue c;
  c.stars = {star({1, 0, 0}, 2.54e-6F), star({0, 0.6F, -0.8F}, 2.54e-7F), star({0, 0, 1}, 2.54e-8F)};
  c.stars[0].proper_motion = {0, 3e-6F, -1e-6F};
  c.identities = {{7001, 172167, 0.0F, "Alp Lyr"}, {2, 0, 2.5F, ""}, {3, 33, 5.0F, "33 Psc"}};
  c.provenance = {.source = "a \"source\"",
                  .source_file = "stars.dat",
                  .source_sha256 = "00ff",
                  .tool = "test 1",
                  .options = "--limit-magnitude 5",
                  .licence = "public domain",
                  .epoch_jyear = 2000.0,
                  .read = 4,
                  .kept = 3,
                  .illuminance_lux = total_illuminance_lux(c)};
  return c;
}

std::uint32_t word(const Bytes& bytes, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, 4);
  return value;
}

void set_word(Bytes& bytes, std::size_t offset, std::uint32_t value) { std::memcpy(bytes.data() + offset, &value, 4); }

Json json_of(const Bytes& bytes) {
  return Json::parse(std::string(reinterpret_cast<const char*>(bytes.data()) + 20, word(bytes, 12)));
}

/// A file with the document changed and everything around it as it should be.
Bytes with_json(const Bytes& bytes, const std::string& json) {
  std::string padded = json;
  padded.resize((padded.size() + 3) / 4 * 4, ' ');
  const std::size_t old_end = 20 + word(bytes, 12);
  Bytes result(20 + padded.size() + bytes.size() - old_end);
  std::memcpy(result.data(), bytes.data(), 20);
  std::memcpy(result.data() + 20, padded.data(), padded.size());
  std::memcpy(result.data() + 20 + padded.size(), bytes.data() + old_end, bytes.size() - old_end);
  set_word(result, 8, static_cast<std::uint32_t>(result.size()));
  set_word(result, 12, static_cast<std::uint32_t>(padded.size()));
  return result;
}

Bytes edited(const std::function<void(Json&)>& edit) {
  const Bytes bytes = encode_star_glb(three_stars());
  Json json = json_of(bytes);
  edit(json);
  return with_json(bytes, json.dump());
}

/// The same, with a change in the buffer of the stars.
Bytes edited_star(std::size_t index, const std::function<void(StarRecord&)>& edit) {
  Bytes bytes = encode_star_glb(three_stars());
  const std::size_t offset = 20 + word(bytes, 12) + 8 + index * sizeof(StarRecord);
  StarRecord record{};
  std::memcpy(&record, bytes.data() + offset, sizeof(record));
  edit(record);
  std::memcpy(bytes.data() + offset, &record, sizeof(record));
  return bytes;
}

/// Decodes what must fail. Returns the whole message.
std::string failure(const Bytes& bytes) {
  try {
    static_cast<void>(decode_star_glb(bytes, "forged.glb"));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.context().file, "forged.glb");
    EXPECT_FALSE(error.context().remedy.empty());
    return error.what();
  }
  ADD_FAILURE() << "was accepted";
  return "";
}

void expect_failure(const Bytes& bytes, const std::string& part) {
  const std::string text = failure(bytes);
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(StarGlb, ComesBackAsItWas) {
  const StarCatalogue before = three_stars();
  const StarCatalogue after = decode_star_glb(encode_star_glb(before), "x.glb");
  ASSERT_EQ(after.stars.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(after.stars[i].position, before.stars[i].position);
    EXPECT_EQ(after.stars[i].proper_motion, before.stars[i].proper_motion);
    EXPECT_EQ(after.stars[i].parallax, before.stars[i].parallax);
    EXPECT_EQ(after.stars[i].radial_velocity, before.stars[i].radial_velocity);
    EXPECT_EQ(after.stars[i].illuminance, before.stars[i].illuminance);
    EXPECT_EQ(after.stars[i].color, before.stars[i].color);
    EXPECT_EQ(after.stars[i].variability, before.stars[i].variability);
    EXPECT_EQ(after.identities[i].hr, before.identities[i].hr);
    EXPECT_EQ(after.identities[i].hd, before.identities[i].hd);
    EXPECT_EQ(after.identities[i].magnitude, before.identities[i].magnitude);
    EXPECT_EQ(after.identities[i].name, before.identities[i].name);
  }
  EXPECT_EQ(after.provenance.source, before.provenance.source);
  EXPECT_EQ(after.provenance.source_file, before.provenance.source_file);
  EXPECT_EQ(after.provenance.source_sha256, before.provenance.source_sha256);
  EXPECT_EQ(after.provenance.tool, before.provenance.tool);
  EXPECT_EQ(after.provenance.options, before.provenance.options);
  EXPECT_EQ(after.provenance.licence, before.provenance.licence);
  EXPECT_EQ(after.provenance.epoch_jyear, before.provenance.epoch_jyear);
  EXPECT_EQ(after.provenance.read, before.provenance.read);
  EXPECT_EQ(after.provenance.kept, before.provenance.kept);
  EXPECT_EQ(after.provenance.illuminance_lux, before.provenance.illuminance_lux);
}

TEST(StarGlb, IsDeterministic) { EXPECT_EQ(encode_star_glb(three_stars()), encode_star_glb(three_stars())); }

// What the glTF 2.0 specification demands of any file of this kind.
TEST(StarGlb, IsValidGltf) {
  const Bytes bytes = encode_star_glb(three_stars());
  EXPECT_EQ(word(bytes, 0), 0x46546C67U);
  EXPECT_EQ(word(bytes, 4), 2U);
  EXPECT_EQ(word(bytes, 8), bytes.size());
  EXPECT_EQ(word(bytes, 12) % 4, 0U);
  EXPECT_EQ(word(bytes, 16), 0x4E4F534AU);
  const std::size_t bin = 20 + word(bytes, 12);
  EXPECT_EQ(word(bytes, bin), 3 * 56U);
  EXPECT_EQ(word(bytes, bin + 4), 0x004E4942U);
  EXPECT_EQ(bytes.size(), bin + 8 + 3 * sizeof(StarRecord));

  const Json json = json_of(bytes);
  EXPECT_EQ(json["asset"]["version"], "2.0");
  EXPECT_EQ(json["asset"]["generator"], "test 1");
  EXPECT_EQ(json["scenes"][json["scene"].get<std::size_t>()]["nodes"][0], 0);
  EXPECT_EQ(json["nodes"][0]["mesh"], 0);
  EXPECT_EQ(json["buffers"][0]["byteLength"], 168);
  EXPECT_FALSE(json["buffers"][0].contains("uri"));
  EXPECT_EQ(json["bufferViews"][0]["byteLength"], 168);
  EXPECT_EQ(json["bufferViews"][0]["byteStride"], 56);
  EXPECT_EQ(json["bufferViews"][0]["target"], 34962);
  const Json& primitive = json["meshes"][0]["primitives"][0];
  EXPECT_EQ(primitive["mode"], 0);
  ASSERT_EQ(primitive["attributes"].size(), 7U);
  for (const auto& [name, index] : primitive["attributes"].items()) {
    // Names that glTF does not define begin with an underscore.
    EXPECT_TRUE(name == "POSITION" || name[0] == '_') << name;
    const Json& accessor = json["accessors"][index.get<std::size_t>()];
    EXPECT_EQ(accessor["componentType"], 5126);
    EXPECT_EQ(accessor["count"], 3);
    const std::string type = accessor["type"];
    const std::size_t size = type == "SCALAR" ? 4 : type == "VEC3" ? 12 : 16;
    EXPECT_LE(accessor["byteOffset"].get<std::size_t>() + size, 56U);
    EXPECT_EQ(accessor["byteOffset"].get<std::size_t>() % 4, 0U);
  }
  const Json& position = json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
  EXPECT_EQ(position["min"].dump(), Json({0.0, 0.0, static_cast<double>(-0.8F)}).dump());
  EXPECT_EQ(position["max"].dump(), Json({1.0, static_cast<double>(0.6F), 1.0}).dump());
  EXPECT_EQ(json["meshes"][0]["extras"]["hr"], Json({7001, 2, 3}));
}

TEST(StarGlb, EveryTruncationIsRefused) {
  const Bytes whole = encode_star_glb(three_stars());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THROW(static_cast<void>(decode_star_glb(part, "part.glb")), Error) << size;
    if (size >= 12) {
      Bytes relabelled = part;
      set_word(relabelled, 8, static_cast<std::uint32_t>(size));
      EXPECT_THROW(static_cast<void>(decode_star_glb(relabelled, "part.glb")), Error) << size;
    }
  }
}

TEST(StarGlb, WrongHeadersAreRefused) {
  const Bytes good = encode_star_glb(three_stars());
  const auto forged = [&](std::size_t offset, std::uint32_t value) {
    Bytes bytes = good;
    set_word(bytes, offset, value);
    return bytes;
  };
  const std::size_t bin = 20 + word(good, 12);
  expect_failure({}, "the file is empty");
  expect_failure(forged(0, 0x21212121), "byte 0: not a binary glTF file");
  expect_failure(forged(4, 1), "byte 4: binary glTF version 1");
  expect_failure(forged(8, 999999), "byte 8: the header says 999999 bytes");
  expect_failure(forged(12, 0xFFFFFFFC), "byte 12: the JSON chunk claims 4294967292 bytes");
  expect_failure(forged(16, 0x004E4942), "byte 16: expected the JSON chunk");
  expect_failure(forged(12, word(good, 12) - 1), "no multiple of 4");
  expect_failure(forged(bin, 168 * 1000), "the BIN chunk claims 168000 bytes");
  expect_failure(forged(bin, 112), "unexpected bytes after the BIN chunk");
  expect_failure(forged(bin + 4, 0), "expected the BIN chunk");
  Bytes longer = good;
  longer.resize(longer.size() + 4);
  expect_failure(longer, "byte 8: the header says");
}

TEST(StarGlb, BrokenJsonIsRefused) {
  const Bytes good = encode_star_glb(three_stars());
  expect_failure(with_json(good, "{\"asset\":"), "the JSON chunk is broken");
  expect_failure(with_json(good, "[]"), "is not an object");
  expect_failure(with_json(good, "{}"), "asset: is missing");
  expect_failure(with_json(good, "{\"asset\":1e999}"), "out of range");
  expect_failure(with_json(good, std::string(100000, '[')), "the JSON chunk is broken");
}

TEST(StarGlb, ForgedLayoutsAreRefused) {
  const auto accessor = [](Json& j, std::size_t i) -> Json& { return j["accessors"][i]; };
  expect_failure(edited([&](Json& j) { accessor(j, 0)["count"] = 4000000000U; }),
                 "accessor 0.count: claims 4000000000");
  expect_failure(edited([&](Json& j) { accessor(j, 4)["count"] = 2; }), "accessor 4.count");
  expect_failure(edited([&](Json& j) { accessor(j, 5)["type"] = "VEC3"; }),
                 "accessor 5.type: _COLOR is VEC3, not VEC4");
  expect_failure(edited([&](Json& j) { accessor(j, 2)["componentType"] = 5123; }), "accessor 2.componentType");
  expect_failure(edited([&](Json& j) { accessor(j, 3)["byteOffset"] = 1000; }), "accessor 3.byteOffset");
  expect_failure(edited([&](Json& j) { accessor(j, 1)["bufferView"] = 7; }), "accessor 1.bufferView");
  expect_failure(edited([&](Json& j) { accessor(j, 1)["count"] = -3; }), "accessor 1.count: is not a whole number");
  expect_failure(edited([&](Json& j) { accessor(j, 0)["max"][0] = 0.5; }), "accessor of POSITION.max");
  expect_failure(edited([&](Json& j) { accessor(j, 0).erase("min"); }), "accessor of POSITION.min: is missing");
  expect_failure(edited([](Json& j) { j["bufferViews"][0]["byteStride"] = 60; }), "bufferViews[0].byteStride");
  expect_failure(edited([](Json& j) { j["bufferViews"][0]["byteLength"] = 1U << 31U; }), "bufferViews[0].byteLength");
  expect_failure(edited([](Json& j) { j["bufferViews"][0]["buffer"] = 1; }), "bufferViews[0].buffer: is 1");
  expect_failure(edited([](Json& j) { j["buffers"][0]["byteLength"] = 56000; }), "buffers[0].byteLength: is 56000");
  expect_failure(edited([](Json& j) { j["meshes"][0]["primitives"][0]["mode"] = 4; }), "primitives[0].mode: is 4");
  expect_failure(edited([](Json& j) { j["meshes"][0]["primitives"][0]["attributes"]["_COLOR"] = 99; }),
                 "_COLOR: names accessor 99");
  expect_failure(edited([](Json& j) { j["meshes"][0]["primitives"][0]["attributes"].erase("_PARALLAX"); }),
                 "_PARALLAX: is missing");
  expect_failure(edited([](Json& j) { j["meshes"] = Json::array(); }), "meshes: is not a list of one object");
  expect_failure(edited([](Json& j) { j["accessors"] = 5; }), "which is not there");
  expect_failure(edited([](Json& j) { j["asset"]["version"] = "1.0"; }), "asset.version: glTF version 1.0, not 2.0");
}

TEST(StarGlb, ForgedIdentitiesAndProvenanceAreRefused) {
  const auto extras = [](Json& j) -> Json& { return j["meshes"][0]["extras"]; };
  const auto provenance = [](Json& j) -> Json& { return j["asset"]["extras"]["provenance"]; };
  expect_failure(edited([&](Json& j) { extras(j)["hr"].push_back(4); }), "extras.hr: is not a list of 3");
  expect_failure(edited([&](Json& j) { extras(j).erase("name"); }), "extras.name: is missing");
  expect_failure(edited([&](Json& j) { extras(j)["name"][1] = 5; }), "star 1: its name");
  expect_failure(edited([&](Json& j) { extras(j)["hd"][2] = 1e10; }), "star 2: its hd");
  expect_failure(edited([&](Json& j) { extras(j)["hr"][2] = 5000000000U; }), "star 2: its hr");
  expect_failure(edited([&](Json& j) { extras(j)["magnitude"][0] = 1e300; }), "star 0: its magnitude");
  expect_failure(edited([&](Json& j) { extras(j)["magnitude"][2] = 1.0; }), "star 2: the illuminance does not belong");
  expect_failure(edited([&](Json& j) { provenance(j)["kept"] = 2; }), "says 2 stars, the buffer holds 3");
  expect_failure(edited([&](Json& j) { provenance(j)["read"] = 2; }), "says 2 entries read but 3 kept");
  expect_failure(edited([&](Json& j) { provenance(j)["read"] = "many"; }), "provenance.read: is not a whole number");
  expect_failure(edited([&](Json& j) { provenance(j)["licence"] = nullptr; }), "provenance.licence: is not a text");
  expect_failure(
      edited([&](Json& j) { provenance(j)["illuminance_lux"] = total_illuminance_lux(three_stars()) * 1.000002; }),
      "the stars give");
}

TEST(StarGlb, ForgedStarsAreRefused) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  expect_failure(edited_star(1, [](StarRecord& s) { s.radial_velocity = nan; }), "star 1: a number is not finite");
  expect_failure(edited_star(2, [](StarRecord& s) { s.proper_motion[0] = infinity; }),
                 "star 2: a number is not finite");
  expect_failure(edited_star(0, [](StarRecord& s) { s.position[0] = 1.00001F; }), "star 0: the position is not a unit");
  expect_failure(edited_star(0, [](StarRecord& s) { s.proper_motion[0] = 1e-6F; }), "star 0: the proper motion");
  expect_failure(edited_star(1, [](StarRecord& s) { s.parallax = -1e-9F; }), "star 1: the parallax is negative");
  expect_failure(edited_star(1, [](StarRecord& s) { s.illuminance = 0.0F; }),
                 "star 1: the illuminance is not positive");
  expect_failure(edited_star(1, [](StarRecord& s) { s.illuminance *= 2.0F; }),
                 "star 1: the illuminance does not belong");
  expect_failure(edited_star(1, [](StarRecord& s) { s.color[1] = 0.9F; }), "star 1: the colour");
  expect_failure(edited_star(1, [](StarRecord& s) { s.color[3] = -1.0F; }), "star 1: the colour");
  expect_failure(edited_star(1, [](StarRecord& s) { s.variability = -1.0F; }), "star 1: the amplitude");
}

TEST(StarGlb, UnsortedStarsAreRefused) {
  StarCatalogue c = three_stars();
  std::swap(c.stars[1], c.stars[2]);
  std::swap(c.identities[1], c.identities[2]);
  try {
    static_cast<void>(encode_star_glb(c));
    ADD_FAILURE() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::argument);
    EXPECT_NE(std::string(error.what()).find("star 2: is brighter than the star before"), std::string::npos);
  }
}

TEST(StarGlb, EmptyCataloguesAndMissingIdentitiesAreRefused) {
  EXPECT_THROW(static_cast<void>(encode_star_glb({})), Error);
  StarCatalogue c = three_stars();
  c.identities.pop_back();
  EXPECT_THROW(static_cast<void>(encode_star_glb(c)), Error);
}

TEST(StarGlb, EachFaultHasItsOwnMessage) {
  std::set<std::string> messages;
  const std::vector<Bytes> faults{
      edited([](Json& j) { j["accessors"][0]["count"] = 9; }),
      edited([](Json& j) { j["accessors"][0]["type"] = "VEC4"; }),
      edited([](Json& j) { j["bufferViews"][0]["byteStride"] = 0; }),
      edited([](Json& j) { j["meshes"][0]["extras"]["hr"] = 3; }),
      edited([](Json& j) { j["asset"]["extras"]["provenance"]["kept"] = 9; }),
      edited_star(0, [](StarRecord& s) { s.position[1] = 1.0F; }),
      edited_star(0, [](StarRecord& s) { s.illuminance = -1.0F; }),
  };
  for (const Bytes& bytes : faults) {
    messages.insert(failure(bytes));
  }
  EXPECT_EQ(messages.size(), faults.size());
}

TEST(StarGlb, GoesThroughAFile) {
  const auto path = std::filesystem::path(testing::TempDir()) / "star_glb_test.glb";
  write_star_glb(path, three_stars());
  EXPECT_EQ(read_file(path), encode_star_glb(three_stars()));
  EXPECT_EQ(read_star_glb(path).stars.size(), 3U);
  std::filesystem::remove(path);
}

TEST(DefaultStars, HoldTheWholeCatalogue) {
  const StarCatalogue& c = default_star_catalogue();
  EXPECT_EQ(c.stars.size(), 9096U);
  EXPECT_EQ(c.provenance.read, 9110U);
  EXPECT_EQ(c.identities.front().hr, 2491U);
  EXPECT_EQ(c.identities.front().name, "Alp CMa");
  EXPECT_EQ(c.identities.front().hd, 48915U);
  EXPECT_FLOAT_EQ(c.identities.front().magnitude, -1.46F);
  EXPECT_EQ(&c, &default_star_catalogue());
  // The buffer was encoded by this very code: it must come out the same.
  EXPECT_EQ(encode_star_glb(c), read_file(VESPER_SOURCE_DIR "/data/bright_stars.glb"));
}

} // namespace
} // namespace vesper
