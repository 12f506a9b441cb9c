// The two readers on damaged input: every answer is a catalogue that holds all rules, or an Error. (The libFuzzer
// targets in tests/fuzz look deeper; this runs in every test run.)

#include "vesper/assets/star_catalogue_check.hpp"
#include "vesper/assets/star_glb.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"
#include "vesper/catalog_tools/bright_star_catalogue.hpp"
#include "vesper/catalog_tools/star_products.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <string>

namespace vesper {
namespace {

Bytes excerpt() { return read_file(VESPER_TEST_DATA "/catalogue/bsc5_excerpt.dat"); }

/// Bytes with a few of them changed, removed or repeated.
Bytes damaged(Bytes bytes, std::mt19937& random) {
  const auto pick = [&](std::size_t size) { return std::uniform_int_distribution<std::size_t>(0, size)(random); };
  for (std::size_t n = 1 + pick(3); n > 0 && !bytes.empty(); --n) {
    const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(pick(bytes.size() - 1));
    switch (pick(3)) {
    case 0:
      *at = static_cast<std::byte>(pick(255));
      break;
    case 1:
      *at ^= static_cast<std::byte>(1U << pick(7));
      break;
    case 2:
      bytes.erase(at);
      break;
    default:
      bytes.resize(static_cast<std::size_t>(at - bytes.begin()));
    }
  }
  return bytes;
}

/// Runs `work` on damaged copies. Only an Error may come out of it.
int refused(const Bytes& good, const std::function<void(const Bytes&)>& work) {
  std::mt19937 random(1991);
  int count = 0;
  for (int i = 0; i < 3000; ++i) {
    try {
      work(damaged(good, random));
    } catch (const Error& error) {
      EXPECT_FALSE(std::string(error.what()).empty());
      ++count;
    }
  }
  return count;
}

TEST(BrightStarStability, DamagedCataloguesAreReadOrRefused) {
  const int count = refused(excerpt(), [](const Bytes& bytes) {
    const auto entries = read_bright_star_catalogue(bytes, "damaged.dat");
    check_star_catalogue(make_star_product(entries, {}).catalogue, ErrorKind::argument, "");
  });
  std::printf("damaged catalogues: %d of 3000 refused\n", count);
  EXPECT_GT(count, 500);
}

TEST(BrightStarStability, DamagedStarBuffersAreReadOrRefused) {
  const StarProduct product = make_star_product(read_bright_star_catalogue(excerpt(), "excerpt"), {});
  const int count = refused(encode_star_glb(product.catalogue), [](const Bytes& bytes) {
    check_star_catalogue(decode_star_glb(bytes, "damaged.glb"), ErrorKind::argument, "");
  });
  std::printf("damaged star buffers: %d of 3000 refused\n", count);
  EXPECT_GT(count, 1500);
}

} // namespace
} // namespace vesper
