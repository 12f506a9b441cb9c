#include "support/numbered_tables.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/sky_tables_maker.hpp"
#include "vesper/base/error.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace vesper::test {
namespace {

using namespace std::chrono_literals;

std::shared_ptr<const Medium> medium_to(double top_km) {
  Medium medium = published_medium();
  medium.top_radius = top_km * kilometre;
  return std::make_shared<const Medium>(std::move(medium));
}

/// Tables that tell by their top which medium they are of.
SkyTables tables_of(const Medium& medium) {
  SkyTables tables = numbered_tables();
  tables.frame.top_km = static_cast<float>(medium.top_radius.to(kilometre));
  return tables;
}

template <class Condition> bool within_seconds(Condition&& condition) {
  for (int i = 0; i < 10000; ++i) {
    if (condition()) {
      return true;
    }
    std::this_thread::sleep_for(1ms);
  }
  return false;
}

std::shared_ptr<const SkyTables> wait_for(SkyTablesMaker& maker) {
  std::shared_ptr<const SkyTables> tables;
  EXPECT_TRUE(within_seconds([&] { return (tables = maker.take()) != nullptr; }));
  return tables;
}

TEST(SkyTablesMaker, HandsOverOnce) {
  SkyTablesMaker maker([](const Medium& medium, const Progress&) { return tables_of(medium); });
  EXPECT_EQ(maker.take(), nullptr);
  EXPECT_EQ(maker.progress(), 1.0);
  maker.request(medium_to(6450.0));
  EXPECT_EQ(wait_for(maker)->frame.top_km, 6450.0F);
  EXPECT_EQ(maker.take(), nullptr);
  EXPECT_EQ(maker.progress(), 1.0);
}

TEST(SkyTablesMaker, OnlyTheLastRequestCounts) {
  std::atomic<int> begun{0};
  std::atomic<int> given_up{0};
  std::atomic<bool> may_finish{false};
  std::atomic<double> top_km{0.0};
  SkyTablesMaker maker([&](const Medium& medium, const Progress& progress) {
    ++begun;
    top_km = medium.top_radius.to(kilometre);
    try {
      do {
        progress(0.25);
        std::this_thread::sleep_for(1ms);
      } while (!may_finish);
    } catch (...) {
      ++given_up;
      throw;
    }
    return tables_of(medium);
  });
  maker.request(medium_to(6401.0));
  ASSERT_TRUE(within_seconds([&] { return maker.progress() == 0.25; }));
  for (int i = 2; i <= 50; ++i) { // a knob that is turned
    maker.request(medium_to(6400.0 + i));
  }
  ASSERT_TRUE(within_seconds([&] { return given_up >= 1; }));
  EXPECT_EQ(maker.take(), nullptr) << "nothing of an obsolete medium";
  // An obsolete run that is let go on would finish instead of giving up.
  ASSERT_TRUE(within_seconds([&] { return top_km == 6450.0; }));
  may_finish = true;
  EXPECT_EQ(wait_for(maker)->frame.top_km, 6450.0F);
  EXPECT_LE(begun, given_up + 1);
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(maker.take(), nullptr);
}

TEST(SkyTablesMaker, ARequestDropsWhatWasNotTaken) {
  std::atomic<bool> hold{false};
  SkyTablesMaker maker([&](const Medium& medium, const Progress& progress) {
    while (hold) {
      progress(0.5);
    }
    return tables_of(medium);
  });
  maker.request(medium_to(6401.0));
  ASSERT_TRUE(within_seconds([&] { return maker.progress() == 1.0; }));
  hold = true;
  maker.request(medium_to(6402.0));
  EXPECT_EQ(maker.take(), nullptr);
  hold = false;
  EXPECT_EQ(wait_for(maker)->frame.top_km, 6402.0F);
}

TEST(SkyTablesMaker, SaysWhatFailedAndGoesOn) {
  SkyTablesMaker maker([](const Medium& medium, const Progress&) {
    if (medium.top_radius > 6500.0 * kilometre) {
      throw Error(ErrorKind::argument, "too high");
    }
    return tables_of(medium);
  });
  maker.request(medium_to(6600.0));
  bool thrown = false;
  ASSERT_TRUE(within_seconds([&] {
    try {
      EXPECT_EQ(maker.take(), nullptr);
    } catch (const Error& e) {
      thrown = e.message() == "too high";
    }
    return thrown;
  }));
  EXPECT_EQ(maker.take(), nullptr) << "told once";
  maker.request(medium_to(6400.0));
  EXPECT_EQ(wait_for(maker)->frame.top_km, 6400.0F);
}

TEST(SkyTablesMaker, TheSolverEndsWithWhatItsListenerThrows) {
  struct Enough {};
  double last = 0.0;
  const Progress enough = [&](double share) {
    last = share;
    throw Enough();
  };
  Medium medium = published_medium();
  medium.wavelengths_nm = {550.0};
  EXPECT_THROW(static_cast<void>(make_sky_tables(medium, {2, 2, 2, 2}, 2, enough)), Enough);
  EXPECT_LT(last, 0.9);
}

} // namespace
} // namespace vesper::test
