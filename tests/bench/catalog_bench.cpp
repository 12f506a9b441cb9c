// How long the conversion of a catalogue takes, from the bytes of the source to the file on the disk.
//
// The real catalogue, where VESPER_BSC5 names it; else records of its size, written from the embedded star buffer.

#include "vesper/assets/default_stars.hpp"
#include "vesper/assets/star_glb.hpp"
#include "vesper/base/files.hpp"
#include "vesper/base/sha256.hpp"
#include "vesper/base/units.hpp"
#include "vesper/catalog_tools/bright_star_catalogue.hpp"
#include "vesper/catalog_tools/star_products.hpp"

#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <string>
#include <unistd.h>

namespace {

using namespace vesper;

/// A record with the star's numbers at the columns of the Bright Star Catalogue. Colours and motions are made up: only
/// their digits matter here.
std::string record(const StarRecord& star, const StarIdentity& identity) {
  const auto component = [&](std::size_t axis) { return static_cast<double>(star.position[axis]); };
  const double ra_s = std::fmod((std::atan2(component(1), component(0)) * rad).to(deg) + 360.0, 360.0) * 240.0;
  const double dec_arcsec = (std::asin(component(2)) * rad).to(arcsec);
  const int ra_tenths = std::min(static_cast<int>(ra_s * 10.0), 863999);
  const int dec = static_cast<int>(std::abs(dec_arcsec));
  std::string line(197, ' ');
  const auto put = [&](std::size_t column, const std::string& text) { line.replace(column - 1, text.size(), text); };
  put(1, fmt::format("{:4}", identity.hr));
  put(26, fmt::format("{:6}", identity.hd));
  put(76, fmt::format("{:02}{:02}{:04.1f}", ra_tenths / 36000, ra_tenths / 600 % 60, ra_tenths % 600 / 10.0));
  put(84, fmt::format("{}{:02}{:02}{:02}", dec_arcsec < 0 ? '-' : '+', dec / 3600, dec / 60 % 60, dec % 60));
  put(103, fmt::format("{:5.2f}", identity.magnitude));
  put(110, fmt::format("{:+5.2f}", static_cast<double>(identity.hr % 200) / 100.0 - 0.3));
  put(128, "K0III");
  put(149, "-0.012-0.018");
  put(162, "+.014-006");
  return line + "\n";
}

Bytes source() {
  if (const char* path = std::getenv("VESPER_BSC5")) {
    return read_file(path);
  }
  const StarCatalogue& catalogue = default_star_catalogue();
  std::string text;
  for (std::size_t i = 0; i < catalogue.stars.size(); ++i) {
    text += record(catalogue.stars[i], catalogue.identities[i]);
  }
  Bytes bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

void convert_catalogue(benchmark::State& state) {
  const Bytes content = source();
  const auto folder = std::filesystem::temp_directory_path();
  const auto path = folder / fmt::format("vesper_catalog_bench_{}.glb", ::getpid());
  std::size_t stars = 0;
  for ([[maybe_unused]] auto _ : state) {
    StarProduct product = make_star_product(read_bright_star_catalogue(content, "bsc5.dat"), {});
    product.catalogue.provenance.source_sha256 = sha256_hex(content);
    write_star_glb(path, product.catalogue);
    stars = product.report.kept;
  }
  std::filesystem::remove(path);
  state.counters["stars"] = static_cast<double>(stars);
  state.SetLabel("target: under 200 ms");
}

void decode_default_stars(benchmark::State& state) {
  const Bytes bytes = encode_star_glb(default_star_catalogue());
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(decode_star_glb(bytes, "bench.glb"));
  }
}

} // namespace

BENCHMARK(convert_catalogue)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(decode_default_stars)->Unit(benchmark::kMillisecond)->UseRealTime();
