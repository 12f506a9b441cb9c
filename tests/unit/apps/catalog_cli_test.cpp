// vesper-catalog as a person uses it: what it prints, writes and returns.
#include "support/command_line_test.hpp"
#include "support/gzip_of.hpp"

#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

namespace vesper {
namespace {

namespace fs = std::filesystem;

using test::CommandResult;

class CatalogCli : public test::CommandLineTest {
protected:
  CatalogCli() : CommandLineTest("vesper-catalog") {}
  void SetUp() override {
    CommandLineTest::SetUp();
    excerpt_ = text(VESPER_TEST_DATA "/catalogue/bsc5_excerpt.dat");
    write("in.dat", excerpt_);
  }

  std::string excerpt_;
};

TEST_F(CatalogCli, HelpAndVersionEverywhere) {
  for (const char* command : {"", "stars ", "info ", "check "}) {
    EXPECT_EQ(run(std::string(command) + "--help").status, 0) << command;
    EXPECT_NE(run(std::string(command) + "--help").out.find("Usage"), std::string::npos) << command;
    const CommandResult version = run(std::string(command) + "--version");
    EXPECT_EQ(version.status, 0) << command;
    EXPECT_EQ(version.out.rfind("vesper-catalog ", 0), 0U) << version.out;
  }
}

TEST_F(CatalogCli, ConvertsReportsAndReadsBack) {
  const CommandResult made = run("stars in.dat -o out.glb --json");
  ASSERT_EQ(made.status, 0) << made.err;
  const auto report = nlohmann::json::parse(made.out);
  EXPECT_EQ(report["read"], 37);
  EXPECT_EQ(report["kept"], 34);
  EXPECT_EQ(report["dropped"], 3);
  EXPECT_EQ(report["dropped_without_position"], 3);
  EXPECT_EQ(report["inferred_colors"], 1); // HR 133, A2IV
  EXPECT_EQ(report["assumed_colors"], 0);
  EXPECT_LT(std::abs(report["illuminance_relative_change"].get<double>()), 1e-6);

  const CommandResult info = run("info out.glb --json");
  ASSERT_EQ(info.status, 0) << info.err;
  const auto content = nlohmann::json::parse(info.out);
  EXPECT_EQ(content["stars"], 34);
  EXPECT_EQ(content["source_file"], "in.dat");
  EXPECT_EQ(content["source_sha256"], report["source_sha256"]);
  EXPECT_EQ(content["brightest_magnitude"], -1.46);

  const CommandResult check = run("check out.glb --json");
  EXPECT_EQ(check.status, 0) << check.err;
  EXPECT_EQ(nlohmann::json::parse(check.out)["valid"], true);
  EXPECT_EQ(run("check out.glb").status, 0);
  EXPECT_NE(run("info out.glb").out.find("public domain"), std::string::npos);
}

TEST_F(CatalogCli, SameInputSameBytes) {
  ASSERT_EQ(run("stars in.dat -o a.glb").status, 0);
  fs::create_directory(folder() / "elsewhere");
  fs::copy_file(folder() / "in.dat", folder() / "elsewhere/in.dat");
  ASSERT_EQ(run("--quiet stars ./elsewhere/in.dat --output elsewhere/b.glb --json").status, 0);
  EXPECT_EQ(text("a.glb"), text("elsewhere/b.glb"));
}

TEST_F(CatalogCli, LimitsTheMagnitude) {
  const CommandResult made = run("stars in.dat -o out.glb --limit-magnitude 9 --limit-magnitude 0.5 --json");
  ASSERT_EQ(made.status, 0) << made.err;
  const auto report = nlohmann::json::parse(made.out);
  EXPECT_EQ(report["kept"].get<int>() + report["dropped"].get<int>(), 37);
  const auto info = nlohmann::json::parse(run("info out.glb --json").out);
  EXPECT_LE(info["faintest_magnitude"].get<double>(), 0.5);
  EXPECT_EQ(info["options"], "--limit-magnitude 0.5");
  expect_failure(1, "stars in.dat -o none.glb --limit-magnitude -2", {"no star has a position and a magnitude"});
}

TEST_F(CatalogCli, DryRunWritesNothing) {
  const CommandResult outcome = run("stars in.dat -o out.glb --dry-run");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("without a position"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder() / "out.glb"));
  EXPECT_EQ(run("stars in.dat --dry-run").status, 0);
}

TEST_F(CatalogCli, ReadsGzip) {
  write_file_atomically(folder() / "in.dat.gz", test::gzip_of(excerpt_));
  EXPECT_EQ(run("stars in.dat.gz -o out.glb").status, 0);
  EXPECT_EQ(run("check out.glb").status, 0);
}

TEST_F(CatalogCli, WrongOptionsExitWith2AndSayWhatIsAllowed) {
  expect_failure(2, "", {"subcommand"});
  expect_failure(2, "stras in.dat", {"stras"});
  expect_failure(2, "stars", {"required"});
  expect_failure(2, "stars in.dat", {"--output is missing"});
  expect_failure(2, "stars in.dat -o out.glb --limit-magnitude 99",
                 {"--limit-magnitude: \"99\" is not a number from -2 to 30"});
  expect_failure(2, "stars in.dat -o out.glb --limit-magnitude bright", {"\"bright\" is not a number from -2 to 30"});
  expect_failure(2, "stars in.dat -o out.glb --limit-magnitude nan", {"\"nan\" is not a number from -2 to 30"});
  expect_failure(2, "stars in.dat -o out.glb --brightest", {"--brightest"});
  expect_failure(2, "stars in.dat -o in.dat", {"names the input itself"});
  expect_failure(2, "info", {"required"});
}

TEST_F(CatalogCli, MissingAndWrongFilesExitWith1) {
  expect_failure(1, "stars no.dat -o out.glb", {"no.dat"});
  expect_failure(1, "stars . -o out.glb", {"directory"});
  write("empty.dat", "");
  expect_failure(1, "stars empty.dat -o out.glb", {"empty.dat: the file is empty"});
  write("text.dat", "Not at all a star catalogue\n");
  expect_failure(1, "stars text.dat -o out.glb", {"text.dat: line 1, column 1:"});
  write("cut.dat", excerpt_.substr(0, excerpt_.find('\n') + 90));
  expect_failure(1, "stars cut.dat -o out.glb", {"cut.dat: line 2, column"});
  write("twice.dat", excerpt_ + excerpt_);
  expect_failure(1, "stars twice.dat -o out.glb", {"twice.dat: line 38, column 1: HR 1 occurs again, first in line 1"});
  expect_failure(1, "info in.dat", {"not a binary glTF file"});
  expect_failure(1, "check no.glb", {"no.glb"});
}

TEST_F(CatalogCli, CheckFindsAForgedFile) {
  ASSERT_EQ(run("stars in.dat -o out.glb").status, 0);
  std::string bytes = text("out.glb");
  write("short.glb", bytes.substr(0, bytes.size() - 4));
  expect_failure(1, "check short.glb", {"short.glb: byte 8: the header says"});
  const std::size_t count = bytes.find("\"count\":34");
  ASSERT_NE(count, std::string::npos);
  bytes.replace(count, 10, "\"count\":94");
  write("forged.glb", bytes);
  expect_failure(1, "check forged.glb", {"accessor 0.count: claims 94 stars"});
  const CommandResult json = run("check forged.glb --json");
  EXPECT_EQ(json.status, 1);
  EXPECT_EQ(nlohmann::json::parse(json.out)["valid"], false);
}

TEST_F(CatalogCli, NothingHalfWrittenWhenTheDiskIsFull) {
  expect_failure(1, "stars in.dat -o /dev/full", {"No space left on device"});
  // The limit of 1 block stops the write in the middle of the file, as a full disk does.
  expect_failure(1, "stars in.dat -o out.glb", {"out.glb: cannot be written: File too large"}, "ulimit -f 1");
  // An earlier file stays as it was.
  write("out.glb", "an earlier file");
  expect_failure(1, "stars in.dat -o out.glb", {"out.glb: cannot be written"}, "ulimit -f 1");
  EXPECT_EQ(text("out.glb"), "an earlier file");
}

TEST_F(CatalogCli, FoldersThatCannotBeWrittenAreNamed) {
  expect_failure(1, "stars in.dat -o no/such/folder/out.glb", {"no/such/folder/out.glb: cannot be created"});
  fs::create_directory(folder() / "folder.glb");
  expect_failure(1, "stars in.dat -o folder.glb", {"folder.glb: cannot be written"});
  expect_failure(1, "stars in.dat -o in.dat/out.glb", {"in.dat/out.glb: cannot be created"});
}

TEST_F(CatalogCli, AFullDiskBehindStandardOutputIsAnError) {
  EXPECT_EQ(run("stars in.dat --dry-run >/dev/full").status, 1);
}

} // namespace
} // namespace vesper
