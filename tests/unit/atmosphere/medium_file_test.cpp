// Media from files: what a good one says, and what a bad one is told.
#include "vesper/atmosphere/medium_file.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace vesper {
namespace {

const std::string media = VESPER_SOURCE_DIR "/data/media/";

std::string text_of(const std::string& path) {
  const Bytes bytes = read_file(path);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

double zenith_depth(const Medium& medium, double nm, double height_km = 0.0) {
  const Vec3 zenith(0.0, 0.0, 1.0);
  return optical_depth(medium,
                       columns_to_space(medium, (medium.ground_radius.to(kilometre) + height_km) * zenith, zenith), nm)
      .value;
}

/// A small medium, for tests to spoil.
constexpr std::string_view small = R"(ground_radius = "6360 km"
top_height = "100 km"
ground_albedo = 0.1
[[component]]
name = "dust"
profile = { kind = "exponential", scale = "2 km" }
scattering = "0.01 /km"
phase = { kind = "schlick", asymmetry = 0.5 }
)";

std::string with(std::string_view what, std::string_view instead, std::string_view text = small) {
  std::string changed(text);
  const std::size_t at = changed.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return changed.replace(at, what.size(), instead);
}

void expect_same(const Medium& ours, const Medium& theirs, double from_nm, double to_nm) {
  EXPECT_EQ(ours.ground_radius.to(metre), theirs.ground_radius.to(metre));
  EXPECT_EQ(ours.top_radius.to(metre), theirs.top_radius.to(metre));
  EXPECT_EQ(ours.wavelengths_nm, theirs.wavelengths_nm);
  ASSERT_EQ(ours.components.size(), theirs.components.size());
  for (double nm = from_nm; nm <= to_nm; nm += 1.0) {
    EXPECT_EQ(ours.ground_albedo(nm), theirs.ground_albedo(nm));
    for (std::size_t i = 0; i < ours.components.size(); ++i) {
      const MediumComponent& a = ours.components[i];
      const MediumComponent& b = theirs.components[i];
      EXPECT_EQ(a.name, b.name);
      EXPECT_EQ(a.phase.kind, b.phase.kind) << a.name;
      if (b.scattering_per_km(nm) > 0.0) {
        EXPECT_EQ(a.phase.parameter(nm), b.phase.parameter(nm)) << a.name;
      }
      for (const double km : {0.0, 0.7, 5.0, 13.0, 24.0, 60.0}) {
        const double density_a = a.profile.at(km);
        const double density_b = b.profile.at(km);
        const auto near = [](double x, double y) { EXPECT_NEAR(x, y, 1.0e-8 * y); };
        near(density_a * a.scattering_per_km(nm), density_b * b.scattering_per_km(nm));
        near(density_a * a.absorption_per_km(nm), density_b * b.absorption_per_km(nm));
      }
    }
  }
}

TEST(MediumFile, SpellsOutThePublishedMedium) {
  expect_same(read_medium_file(media + "published.toml"), published_medium(), 440.0, 680.0);
}

TEST(MediumFile, SpellsOutClearAir) {
  expect_same(read_medium_file(media + "clear.toml"), clear_medium(), 360.0, 830.0);
}

TEST(MediumFile, ABaseAloneIsThePreset) {
  expect_same(parse_medium("base = \"clear\"", "x"), clear_medium(), 360.0, 830.0);
  expect_same(parse_medium("base = \"published\"", "x"), published_medium(), 440.0, 680.0);
}

TEST(MediumFile, KnobsAreThoseOfClearAir) {
  const Medium file = parse_medium("base = \"clear\"\naerosol_optical_depth = 0.4\nstratospheric_optical_depth = 0.1\n"
                                   "angstrom_exponent = 0.9\nozone = \"250 DU\"\nground_albedo = 0.8\n",
                                   "x");
  expect_same(file, clear_medium({0.4, 0.1, 0.9, 250.0, 0.8}), 360.0, 830.0);
}

TEST(MediumFile, TurbidityIsTheRatioOfOpticalDepths) {
  const Medium pure = parse_medium("base = \"clear\"\nturbidity = 1\nozone = \"0 DU\"\n", "x");
  const Medium hazy = parse_medium("base = \"clear\"\nturbidity = 6.5\nozone = \"0 DU\"\n", "x");
  EXPECT_NEAR(zenith_depth(hazy, 550.0) / zenith_depth(pure, 550.0), 6.5, 1.0e-7);
}

TEST(MediumFile, ComponentsAddToTheBase) {
  const Medium hazy = read_medium_file(media + "hazy.toml");
  ASSERT_EQ(hazy.components.size(), 5U);
  EXPECT_EQ(hazy.components.back().name, "smoke");
  EXPECT_EQ(hazy.components.back().profile.at(2.9), 0.0);
  EXPECT_EQ(hazy.components.back().profile.at(4.0), 1.0);
  const double above = zenith_depth(hazy, 550.0, 5.0);
  const double below = zenith_depth(hazy, 550.0, 3.0);
  EXPECT_GT(below - above, 0.05); // the smoke, and the other parts of those two kilometres
  EXPECT_NEAR(hazy.components.back().extinction_per_km(550.0) * 1.5, 0.05, 1.0e-8);
  EXPECT_NEAR(hazy.ground_albedo(525.0), 0.07, 1.0e-12);
  EXPECT_EQ(hazy.wavelengths_nm.size(), 48U);
}

TEST(MediumFile, UnitsAreConverted) {
  const Medium a = parse_medium(small, "x");
  const std::string other =
      with("\"2 km\"", "\"2000 m\"",
           with("0.01 /km", "1e-5 1/m", with("6360 km", "6.36e6m", with("100 km", " +100000 m "))));
  expect_same(parse_medium(other, "x"), a, 360.0, 830.0);
  const Medium table =
      parse_medium(with("\"0.01 /km\"", R"({ wavelengths = "0.36 µm, 0.83 um", values = "20e-6 /m, 0.01 /km" })"), "x");
  EXPECT_NEAR(table.components[0].scattering_per_km(360.0), 0.02, 1.0e-15);
  EXPECT_NEAR(table.components[0].scattering_per_km(595.0), 0.015, 1.0e-15);
  const std::string molecules = R"([[component]]
name = "air"
molecules = { pressure = "50662.5 Pa", temperature = "576.3 K" }
)";
  const Medium thin = parse_medium(std::string(small) + molecules, "x");
  EXPECT_NEAR(thin.components[1].scattering_per_km(500.0) / rayleigh_per_km(500.0), 0.25, 1.0e-12);
}

TEST(MediumFile, OpticalDepthsFillTheirProfiles) {
  const std::string layers = R"([[component]]
name = "ash"
aerosol = { optical_depth = 0.3, at = "0.5 um", angstrom_exponent = 2, single_scattering_albedo = 0.5 }
profile = { kind = "table", heights = "10, 20, 60 km", densities = [1e25, 1e24, 1e22], between = "logarithmic" }
phase = { kind = "henyey-greenstein", asymmetry = -0.2 }
[[component]]
name = "ozone"
ozone = { column = "1000 DU" }
profile = { kind = "tent", lowest = "15 km", peak = "15 km", highest = "30 km" }
)";
  const Medium medium = parse_medium(std::string(small) + layers, "x");
  const Medium without = parse_medium(small, "x");
  // 1000 Dobson units of 2.6867e20 molecules per m2 with 5.085e-25 m2 at 600 nm.
  const double ozone = 1000.0 * 2.6867e20 * 5.085e-25;
  EXPECT_NEAR(zenith_depth(medium, 600.0) - zenith_depth(without, 600.0), 0.3 * std::pow(600.0 / 500.0, -2.0) + ozone,
              1.0e-3 * ozone);
  EXPECT_NEAR(medium.components[1].scattering_per_km(700.0), medium.components[1].absorption_per_km(700.0),
              1.0e-12 * medium.components[1].absorption_per_km(700.0));
}

TEST(MediumFile, WavelengthsOfTransportFollowTheTables) {
  EXPECT_EQ(parse_medium(small, "x").wavelengths_nm, transport_wavelengths_nm());
  const std::string narrow =
      with("\"0.01 /km\"", R"({ wavelengths = "435, 500, 695 nm", values = "0.02, 0.02, 0.01 /km" })");
  const Medium medium = parse_medium(narrow, "x");
  EXPECT_EQ(medium.wavelengths_nm.front(), 440.0);
  EXPECT_EQ(medium.wavelengths_nm.back(), 690.0);
  // What lies beyond a table is as at its end.
  EXPECT_EQ(medium.components[0].scattering_per_km(400.0), 0.02);
  EXPECT_EQ(medium.components[0].scattering_per_km(800.0), 0.01);
  EXPECT_EQ(parse_medium("wavelengths = \"440, 530, 680 nm\"\n" + narrow, "x").wavelengths_nm,
            (std::vector<double>{440.0, 530.0, 680.0}));
}

TEST(MediumFile, ThePageShowsAMediumThatIsOne) {
  // Every block of TOML on the page is a medium by itself.
  const std::string page = text_of(VESPER_SOURCE_DIR "/docs/MEDIUM.md");
  int blocks = 0;
  const std::string fence = "```toml\n";
  for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at)) {
    at += fence.size();
    const std::string block = page.substr(at, page.find("```", at) - at);
    EXPECT_NO_THROW((void)parse_medium(block, "docs/MEDIUM.md")) << block;
    ++blocks;
  }
  EXPECT_GE(blocks, 2);
}

struct BadMedium {
  std::string text;
  std::vector<std::string> words; ///< that the message has to say
};

void expect_refused(const BadMedium& bad) {
  try {
    (void)parse_medium(bad.text, "bad.toml");
    ADD_FAILURE() << "taken for good:\n" << bad.text;
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_EQ(e.context().file, "bad.toml");
    EXPECT_FALSE(e.context().remedy.empty());
    for (const std::string& word : bad.words) {
      EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what() << "\nshould say: " << word;
    }
  }
}

TEST(MediumBadFile, UnknownAndMissingKeys) {
  expect_refused(
      {with("ground_albedo", "ground_albido"), {"line 3, key 'ground_albido'", "Did you mean 'ground_albedo'?"}});
  expect_refused(
      {with("scattering", "scatering"), {"line 7, key 'component.scatering'", "Did you mean 'scattering'?"}});
  expect_refused({with("scale", "sclae"), {"line 6, key 'component.profile.sclae'", "'scale'"}});
  expect_refused({with("asymmetry", "g"), {"line 8, key 'component.phase.g'", "Keys here: kind, asymmetry"}});
  expect_refused({with("name = \"dust\"\n", ""), {"line 4, key 'component.name'", "missing"}});
  expect_refused({with("top_height = \"100 km\"\n", ""), {"key 'top_height'", "missing"}});
  expect_refused({with("phase = { kind = \"schlick\", asymmetry = 0.5 }\n", ""), {"key 'component.phase'", "missing"}});
  expect_refused({with("scattering = \"0.01 /km\"\n", ""), {"line 4, key 'component'", "holds nothing"}});
  expect_refused({"base = \"clear\"\naerosol = 0.1\n", {"line 2, key 'aerosol'", "aerosol_optical_depth"}});
  expect_refused({"base = \"clear\"\nground_radius = \"6000 km\"\n", {"line 2, key 'ground_radius'"}});
  expect_refused({"base = \"published\"\nturbidity = 3\n", {"line 2, key 'turbidity'"}});
  expect_refused({"base = \"foggy\"\n", {"line 1, key 'base'", "'foggy'", "clear, published"}});
  expect_refused({"", {"ground_radius", "missing"}});
}

TEST(MediumBadFile, MissingAndWrongUnits) {
  expect_refused({with("\"2 km\"", "\"2\""), {"line 6, key 'component.profile.scale'", "'2' has no unit", "km, m"}});
  expect_refused({with("\"2 km\"", "2"), {"line 6, key 'component.profile.scale'", "type integer", "km"}});
  expect_refused({with("\"2 km\"", "\"2 miles\""), {"line 6", "'miles'", "km, m"}});
  expect_refused({with("0.01 /km", "0.01 km"), {"line 7, key 'component.scattering'", "'km'", "/km, /m"}});
  expect_refused({with("\"0.01 /km\"", "0.01"), {"line 7, key 'component.scattering'", "/km"}});
  expect_refused({with("0.01 /km", "thin"), {"line 7", "'thin'", "finite number"}});
  expect_refused({with("0.01 /km", "1, 2 /km"), {"line 7", "2 values"}});
  expect_refused({with("0.01 /km", ", /km"), {"line 7"}});
  expect_refused({"base = \"clear\"\nozone = 300\n", {"line 2, key 'ozone'", "DU"}});
  expect_refused({"base = \"clear\"\nozone = \"300 nm\"\n", {"line 2, key 'ozone'", "'nm'", "DU"}});
}

TEST(MediumBadFile, ValuesOutOfRange) {
  expect_refused({with("0.01 /km", "-0.01 /km"), {"line 7, key 'component.scattering'", "-0.01 /km", "0 to"}});
  expect_refused({with("0.01 /km", "nan /km"), {"line 7", "finite"}});
  expect_refused({with("0.01 /km", "1e308 /m"), {"line 7", "out of range"}});
  expect_refused({with("0.01 /km", "1e999 /km"), {"line 7"}});
  expect_refused({with("= 0.5", "= 1.0"), {"line 8, key 'component.phase.asymmetry'", "-0.99 to 0.99"}});
  expect_refused({with("= 0.5", "= nan"), {"line 8, key 'component.phase.asymmetry'"}});
  expect_refused({with("= 0.5", "= inf"), {"line 8, key 'component.phase.asymmetry'"}});
  expect_refused({with("= 0.1", "= 1.1"), {"line 3, key 'ground_albedo'", "0 to 1"}});
  expect_refused({with("= 0.1", "= \"0.1\""), {"line 3, key 'ground_albedo'", "type string"}});
  expect_refused({with("\"schlick\"", "\"mie\""), {"line 8, key 'component.phase.kind'", "'mie'", "cornette-shanks"}});
  expect_refused({with("\"schlick\", asymmetry = 0.5", "\"rayleigh\", depolarization = 0.9"),
                  {"line 8, key 'component.phase.depolarization'"}});
  expect_refused({with("6360 km", "0 km"), {"line 1, key 'ground_radius'"}});
  expect_refused({with("100 km", "-1 km"), {"line 2, key 'top_height'"}});
  expect_refused({with("\"2 km\"", "\"0 m\""), {"line 6, key 'component.profile.scale'"}});
  expect_refused({"base = \"clear\"\naerosol_optical_depth = -0.1\n", {"line 2, key 'aerosol_optical_depth'", "-0.1"}});
  expect_refused({"base = \"clear\"\nangstrom_exponent = inf\n", {"line 2, key 'angstrom_exponent'", "finite number"}});
  expect_refused({"base = \"clear\"\nozone = \"-1 DU\"\n", {"line 2, key 'ozone'"}});
  expect_refused({"base = \"clear\"\nground_albedo = -0.5\n", {"line 2, key 'ground_albedo'"}});
  expect_refused({"base = \"clear\"\nturbidity = 0.9\n", {"line 2, key 'turbidity'", "1 to 100"}});
  expect_refused(
      {"base = \"clear\"\nturbidity = 2\naerosol_optical_depth = 0.1\n", {"key 'turbidity'", "one of the two"}});
}

TEST(MediumBadFile, Layers) {
  const auto profile = [](std::string_view text) { return with(R"({ kind = "exponential", scale = "2 km" })", text); };
  expect_refused({profile(R"({ kind = "tent", lowest = "10 km", peak = "20 km", highest = "101 km" })"),
                  {"line 6, key 'component.profile.highest'", "101 km lies outside the air", "100 km"}});
  expect_refused({profile(R"({ kind = "tent", lowest = "-1 km", peak = "20 km", highest = "30 km" })"),
                  {"line 6, key 'component.profile.lowest'", "-1 km lies outside the air"}});
  expect_refused({profile(R"({ kind = "tent", lowest = "25 km", peak = "20 km", highest = "30 km" })"),
                  {"line 6, key 'component.profile.peak'"}});
  expect_refused({profile(R"({ kind = "table", heights = "0, 120 km", densities = [1, 0] })"),
                  {"line 6, key 'component.profile.heights'", "120 km lies outside"}});
  expect_refused({profile(R"({ kind = "table", heights = "0, 20, 10 km", densities = [1, 1, 0] })"),
                  {"line 6, key 'component.profile'", "in order"}});
  expect_refused({profile(R"({ kind = "table", heights = "0, 20 km", densities = [1, -1] })"),
                  {"line 6, key 'component.profile.densities'", "number 2 of 2", "-1"}});
  expect_refused({profile(R"({ kind = "table", heights = "0, 20 km", densities = [1, 0], between = "logarithmic" })"),
                  {"line 6, key 'component.profile'", "logarithmic"}});
  expect_refused({profile(R"({ kind = "table", heights = "0, 20 km", densities = [1] })"),
                  {"line 6, key 'component.profile'", "one density for each"}});
  expect_refused({profile(R"({ kind = "table", heights = "0 km", densities = [1] })"), {"line 6", "two heights"}});
  expect_refused({profile(R"({ kind = "table", heights = "0, 20 km", densities = [1, "0"] })"),
                  {"line 6, key 'component.profile.densities'", "type string"}});
  expect_refused({profile("\"exponential\""), {"line 6, key 'component.profile'", "type string"}});
  expect_refused({profile(R"({ kind = "gaussian" })"), {"line 6, key 'component.profile.kind'", "exponential, tent"}});
  const std::string empty = R"([[component]]
name = "ash"
aerosol = { optical_depth = 0.3, at = "0.5 um", angstrom_exponent = 2, single_scattering_albedo = 0.5 }
profile = { kind = "tent", lowest = "10 km", peak = "10 km", highest = "10 km" }
phase = { kind = "schlick", asymmetry = 0 }
)";
  expect_refused({std::string(small) + empty, {"line 11, key 'component.aerosol'", "holds nothing"}});
}

TEST(MediumBadFile, WavelengthsThatDoNotCoverTheVisible) {
  const auto table = [](std::string_view text) { return with("\"0.01 /km\"", text); };
  expect_refused({table(R"({ wavelengths = "450, 700 nm", values = "1, 1 /km" })"),
                  {"line 7, key 'component.scattering.wavelengths'", "450 to 700 nm", "440 nm", "680 nm"}});
  expect_refused({table(R"({ wavelengths = "400, 650 nm", values = "1, 1 /km" })"), {"line 7", "400 to 650 nm"}});
  expect_refused({table(R"({ wavelengths = "550 nm", values = "1 /km" })"), {"line 7", "550 to 550 nm"}});
  expect_refused({table(R"({ wavelengths = "400, 700, 600 nm", values = "1, 1, 1 /km" })"),
                  {"line 7", "700 nm is followed by 600 nm", "Sort"}});
  expect_refused({table(R"({ wavelengths = "400, 700 nm", values = "1, 1, 1 /km" })"),
                  {"line 7, key 'component.scattering.values'", "3 values for 2 wavelengths"}});
  expect_refused({table(R"({ wavelengths = "400, 700", values = "1, 1 /km" })"), {"line 7", "no unit"}});
  expect_refused({"wavelengths = \"500, 600 nm\"\n" + std::string(small), {"line 1, key 'wavelengths'", "visible"}});
  expect_refused(
      {"wavelengths = \"340, 700 nm\"\n" + std::string(small), {"line 1, key 'wavelengths'", "360 to 830 nm"}});
  expect_refused(
      {"base = \"published\"\nwavelengths = \"400, 700 nm\"\n", {"line 2, key 'wavelengths'", "440 to 680"}});
}

TEST(MediumBadFile, MalformedAndTruncated) {
  expect_refused({with("= 0.1", "== 0.1"), {"line 3"}});
  expect_refused({"ground_radius = \"6360 km\"\nground_radius = \"6360 km\"\n", {"line 2"}});
  expect_refused({with("[[component]]", "[component]"), {"line 4, key 'component'", "[[component]]"}});
  expect_refused({std::string("base = \"cl\xff\"\n"), {"line 1"}});
  // Cut anywhere, it is an error: what is left lacks a key or ends within a value.
  for (std::size_t length = 0; length + 2 < small.size(); ++length) {
    expect_refused({std::string(small.substr(0, length)), {}});
  }
}

TEST(MediumBadFile, IsNotThere) {
  try {
    (void)read_medium_file("/no/such/medium.toml");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::file);
    EXPECT_EQ(e.context().file, "/no/such/medium.toml");
  }
}

} // namespace
} // namespace vesper
