#include "vesper/base/csv.hpp"

#include <gtest/gtest.h>

#include <span>

namespace vesper {
namespace {

CsvTable table_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {Bytes(bytes.begin(), bytes.end()), "t.csv"};
}

std::string error_of(std::string_view text) {
  try {
    (void)table_of(text);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    return e.what();
  }
  return "";
}

TEST(Csv, ReadsPlainAndQuotedFields) {
  const CsvTable table = table_of("a, b ,c\r\n1,\"x, \"\"y\"\"\nz\",\r\n\r\n 2,,3\n");
  ASSERT_EQ(table.header(), (std::vector<std::string_view>{"a", "b", "c"}));
  ASSERT_EQ(table.row_count(), 2U);
  EXPECT_EQ(table.cell(0, 0), "1");
  EXPECT_EQ(table.cell(0, 1), "x, \"y\"\nz");
  EXPECT_EQ(table.cell(0, 2), "");
  EXPECT_EQ(table.line(0), 2U);
  EXPECT_EQ(table.line(1), 5U);
  EXPECT_EQ(table.number(1, 0), 2.0);
  EXPECT_EQ(table.column("c"), 2U);
  EXPECT_FALSE(table.find_column("d").has_value());
}

TEST(Csv, SkipsAByteOrderMarkAndNeedsNoLastLineBreak) {
  const CsvTable table = table_of("\xEF\xBB\xBF"
                                  "a\n+1.5");
  EXPECT_EQ(table.header().front(), "a");
  EXPECT_EQ(table.number(0, 0), 1.5);
}

TEST(Csv, NamesThePlaceOfEachFault) {
  EXPECT_NE(error_of("").find("t.csv: the table is empty"), std::string::npos);
  EXPECT_NE(error_of("a,b,a\n").find("line 1, column 3: column 'a' stands twice"), std::string::npos);
  EXPECT_NE(error_of("a,b\n1,2\n1,2,3\n").find("line 3: 3 fields where the header has 2"), std::string::npos);
  EXPECT_NE(error_of("a,b\n1,\"2\n\n").find("line 2, column 2: a quoted field has no end"), std::string::npos);
  EXPECT_NE(error_of("a,b\n1,\"2\"x\n").find("line 2, column 2: text follows"), std::string::npos);
  EXPECT_NE(error_of("a,b\n1,2\"\n").find("line 2, column 2: a quotation mark"), std::string::npos);
  const CsvTable table = table_of("a,b\n1,x\n2,nan\n3,95\n");
  for (std::size_t row = 0; row < 2; ++row) {
    try {
      (void)table.number(row, 1);
      ADD_FAILURE();
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find("column b"), std::string::npos) << e.what();
    }
  }
  EXPECT_THROW((void)table.number(2, 1, -90.0, 90.0), Error);
  EXPECT_THROW((void)table.column("c"), Error);
}

TEST(Csv, WritesWhatItReads) {
  std::string row;
  for (const char* field : {"plain", "with, comma", "with \"marks\"", "two\nlines", ""}) {
    append_csv_field(row, field);
    row += ',';
  }
  row.back() = '\n';
  const CsvTable table = table_of("a,b,c,d,e\n" + row);
  EXPECT_EQ(table.cell(0, 1), "with, comma");
  EXPECT_EQ(table.cell(0, 2), "with \"marks\"");
  EXPECT_EQ(table.cell(0, 3), "two\nlines");
}

TEST(Csv, NumbersRoundTripInTheShortestForm) {
  for (const double number : {0.1, -1.0 / 3.0, 1e-300, 12345678.9, 0.0}) {
    std::string text;
    append_number(text, number);
    EXPECT_EQ(std::stod(text), number);
  }
  std::string text;
  append_number(text, 0.1);
  EXPECT_EQ(text, "0.1");
}

} // namespace
} // namespace vesper
