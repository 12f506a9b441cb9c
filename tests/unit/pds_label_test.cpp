// Labels of the Planetary Data System: what they say, and what is no label.
#include "support/expect_error.hpp"

#include "vesper/catalog_tools/pds_label.hpp"

#include <gtest/gtest.h>

#include <string>

namespace vesper {
namespace {

TEST(PdsLabel, ReadsStatementsInObjects) {
  const PdsLabel label("PDS_VERSION_ID = PDS3 /* a comment = 1 */\r\n"
                       "^IMAGE=\"A B.IMG\"\n"
                       "OBJECT = OUTER\n"
                       "  note = \"two\nlines, LINES = 3\"\n"
                       "  OBJECT = IMAGE\n"
                       "    LINES = 720\n    SCALE = +0.5 <m/pix>\n    NAMES = {\"A}\", (1, 2)}\n"
                       "  END_OBJECT = IMAGE\n  LINES = 5\nEND_OBJECT\n"
                       "END\n\x01 bytes after the end",
                       "a.lbl");
  EXPECT_EQ(label.get("", "^IMAGE").value, "A B.IMG");
  EXPECT_EQ(label.get("OUTER", "NOTE").value, "two\nlines, LINES = 3");
  EXPECT_EQ(label.whole(label.get("IMAGE", "LINES")), 720);
  EXPECT_EQ(label.get("IMAGE", "LINES").line, 7U);
  EXPECT_EQ(label.number(label.get("IMAGE", "SCALE")), 0.5);
  EXPECT_EQ(label.get("IMAGE", "SCALE").unit, "M/PIX");
  EXPECT_EQ(label.get("IMAGE", "NAMES").value, "{\"A}\", (1, 2)}");
  EXPECT_EQ(label.whole(label.get("OUTER", "LINES")), 5);
  EXPECT_EQ(label.find("IMAGE", "OFFSET"), nullptr);
}

TEST(PdsLabel, NamesTheLineOfWhatIsBroken) {
  const auto expect = [](const std::string& text, const std::vector<std::string>& words) {
    test::expect_error(ErrorKind::input, words, [&] { return PdsLabel(text, "a.lbl"); });
  };
  expect("", {"a.lbl: line 1", "is no label"});
  expect("\x89PNG\r\n", {"line 1", "stands where a keyword is expected"});
  expect("Some text\n", {"line 1", "SOME has no \"=\""});
  expect("A = 1\n", {"line 2", "ends without END"});
  expect("A =\n", {"line 2", "a value is missing"});
  expect("A = \"open\nB = 1\nEND\n", {"a quotation does not end"});
  expect("A = (1, 2\nEND\n", {"a list does not end"});
  expect("/* open\nEND\n", {"a comment does not end"});
  expect("A = 1 <km\nEND\n", {"a unit does not end"});
  expect("OBJECT = A\nEND\n", {"line 2", "END stands inside of the object A"});
  expect("OBJECT = A\nEND_OBJECT = B\nEND\n", {"line 2", "B ends where A is open"});
  expect("END_OBJECT\nEND\n", {"line 1", "an object ends that did not begin"});
}

TEST(PdsLabel, RefusesValuesThatAreNoNumbers) {
  const PdsLabel label("A = 1e400\nB = N/A\nC = 2.5\nC = 3\nD = -1\nE = 0x10 <km>\nEND\n", "a.lbl");
  const auto expect = [&](auto call, const std::vector<std::string>& words) {
    test::expect_error(ErrorKind::input, words, call);
  };
  expect([&] { return label.number(label.get("", "A")); }, {"a.lbl: line 1: A is \"1e400\"; allowed is a number"});
  expect([&] { return label.number(label.get("", "B")); }, {"line 2: B is \"N/A\""});
  expect([&] { return label.get("", "C"); }, {"line 4: C stands here again, first in line 3"});
  expect([&] { return label.whole(label.get("", "D")); }, {"D is \"-1\"; allowed is a whole number"});
  expect([&] { return label.number(label.get("", "E")); }, {"E is \"0x10 <KM>\""});
  expect([&] { return label.get("IMAGE", "LINES"); }, {"LINES is missing from the object IMAGE"});
}

} // namespace
} // namespace vesper
