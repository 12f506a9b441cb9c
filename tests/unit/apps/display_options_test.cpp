// The display's options as programs read them.
#include "common/display_options.hpp"

#include "support/expect_error.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace vesper {
namespace {

DisplayOptions parsed(std::vector<std::string> arguments) {
  CLI::App app;
  const DisplayOptionSet options(app);
  std::reverse(arguments.begin(), arguments.end());
  app.parse(arguments);
  return options.resolve();
}

TEST(DisplayOptions, DefaultsAreThoseOfADisplay) {
  const DisplayOptions options = parsed({});
  const Display display;
  EXPECT_EQ(options.bits, 8);
  EXPECT_EQ(options.display.peak, display.peak);
  EXPECT_EQ(options.display.black, display.black);
  EXPECT_EQ(options.display.ambient, display.ambient);
  EXPECT_EQ(options.display.pixels_per_degree, display.pixels_per_degree);
}

TEST(DisplayOptions, EachReachesTheDisplay) {
  const DisplayOptions options = parsed({"--display-peak",
                                         "600",
                                         "--display-black",
                                         "0.01",
                                         "--ambient",
                                         "2.5",
                                         "--primaries",
                                         "display-p3",
                                         "--transfer",
                                         "gamma",
                                         "--gamma",
                                         "2.4",
                                         "--dome-gain",
                                         "0.4",
                                         "--dome-reflectance",
                                         "0.35",
                                         "--pixels-per-degree",
                                         "20",
                                         "--bits",
                                         "16"});
  EXPECT_EQ(options.display.peak, 600.0 * candela_per_m2);
  EXPECT_EQ(options.display.black, 0.01 * candela_per_m2);
  EXPECT_EQ(options.display.ambient, 2.5 * candela_per_m2);
  EXPECT_EQ(options.display.primaries, Primaries::display_p3);
  EXPECT_EQ(options.display.transfer, Transfer::gamma);
  EXPECT_EQ(options.display.gamma, 2.4);
  EXPECT_EQ(options.display.dome_gain, 0.4);
  EXPECT_EQ(options.display.dome_reflectance, 0.35);
  EXPECT_EQ(options.display.pixels_per_degree, 20.0);
  EXPECT_EQ(options.bits, 16);
}

TEST(DisplayOptions, BlackFollowsThePeakAndADomeIsDark) {
  EXPECT_EQ(parsed({"--display-peak", "50"}).display.black, 0.05 * candela_per_m2);
  EXPECT_EQ(parsed({"--dome-reflectance", "0.5"}).display.ambient, Luminance());
  EXPECT_EQ(parsed({"--dome-reflectance", "0.5", "--ambient", "0.1"}).display.ambient, 0.1 * candela_per_m2);
}

TEST(DisplayOptions, WhatIsOutOfRangeIsRefusedByName) {
  const auto refused = [](const std::vector<std::string>& arguments, const std::vector<std::string>& words) {
    try {
      static_cast<void>(parsed(arguments));
      ADD_FAILURE() << arguments.front() << " is taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::argument);
      for (const std::string& word : words) {
        EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what() << " lacks " << word;
      }
    }
  };
  refused({"--display-peak", "0"}, {"--display-peak", "'0'", "0.001 to 10000"});
  refused({"--display-peak", "nan"}, {"--display-peak", "nan"});
  refused({"--display-peak", "bright"}, {"--display-peak", "bright"});
  refused({"--display-black=-1"}, {"--display-black", "-1", "0 to 1000"});
  refused({"--display-peak", "100", "--display-black", "100"}, {"black", "100", "half the peak"});
  refused({"--ambient", "2000"}, {"--ambient", "2000", "1000"});
  refused({"--primaries", "adobe"}, {"--primaries", "adobe", "srgb, display-p3, rec2020"});
  refused({"--transfer", "log"}, {"--transfer", "log", "srgb, gamma, pq"});
  refused({"--transfer", "gamma", "--gamma", "9"}, {"--gamma", "9", "1 to 4"});
  refused({"--gamma", "2.2"}, {"--gamma", "--transfer gamma"});
  refused({"--dome-gain", "0"}, {"--dome-gain", "0.05 to 10"});
  refused({"--dome-reflectance", "1"}, {"--dome-reflectance", "0.98"});
  refused({"--pixels-per-degree", "0"}, {"--pixels-per-degree", "0.1 to 1000"});
  refused({"--bits", "12"}, {"--bits", "12", "8, 16"});
  refused({"--transfer", "pq", "--display-peak", "8000", "--dome-gain", "2"}, {"16000", "PQ", "10000"});
}

} // namespace
} // namespace vesper
