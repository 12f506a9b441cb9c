#include "vesper/base/error.hpp"

#include <gtest/gtest.h>

namespace vesper {
namespace {

TEST(Error, TextNamesFilePlaceMessageAndRemedyInThatOrder) {
  const Error error(ErrorKind::input, "parallax -3 is negative",
                    {"stars.dat", "line 12, column 103", "Give 0 where it is unknown"});
  EXPECT_STREQ(error.what(), "stars.dat: line 12, column 103: parallax -3 is negative. Give 0 where it is unknown");
  EXPECT_EQ(error.kind(), ErrorKind::input);
  EXPECT_EQ(error.message(), "parallax -3 is negative");
  EXPECT_EQ(error.context().file, "stars.dat");
  EXPECT_EQ(error.context().place, "line 12, column 103");
  EXPECT_EQ(error.context().remedy, "Give 0 where it is unknown");
}

TEST(Error, EmptyPartsLeaveNoSeparatorsBehind) {
  EXPECT_STREQ(Error(ErrorKind::gpu, "no context").what(), "no context");
  EXPECT_STREQ(Error(ErrorKind::file, "is empty", {"a.glb", "", ""}).what(), "a.glb: is empty");
  EXPECT_STREQ(Error(ErrorKind::argument, "is 91", {"", "--latitude", ""}).what(), "--latitude: is 91");
  EXPECT_STREQ(Error(ErrorKind::gpu, "no context", {"", "", "Install Mesa"}).what(), "no context. Install Mesa");
}

TEST(Error, IsCaughtAsRuntimeError) { EXPECT_THROW(throw Error(ErrorKind::argument, "bad"), std::runtime_error); }

} // namespace
} // namespace vesper
