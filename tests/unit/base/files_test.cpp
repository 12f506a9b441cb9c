#include "vesper/base/files.hpp"

#include "vesper/base/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <functional>
#include <iterator>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace vesper {
namespace {

namespace fs = std::filesystem;

std::string text_of(const Bytes& bytes) {
  std::string text(bytes.size(), '\0');
  std::transform(bytes.begin(), bytes.end(), text.begin(), [](std::byte b) { return static_cast<char>(b); });
  return text;
}

/// The error that `action` throws, which must be of kind `file`, name `path` and offer a remedy.
Error file_error(const fs::path& path, const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::file);
    EXPECT_EQ(error.context().file, path.string());
    EXPECT_FALSE(error.context().remedy.empty());
    return error;
  }
  ADD_FAILURE() << "no Error for " << path;
  return {ErrorKind::argument, "none"};
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

mode_t mode_of(const fs::path& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
  return status.st_mode & 07777;
}

/// Runs `check` as a user whom permissions bind: in a child process, since root may write anywhere. The child's
/// failed expectations are printed there and show here as a non-zero exit status.
void as_ordinary_user(const std::function<void()>& check) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    constexpr uid_t nobody = 65534;
    if (::geteuid() == 0 && (::setgid(nobody) != 0 || ::setuid(nobody) != 0)) {
      ::_exit(2);
    }
    check();
    ::_exit(::testing::Test::HasFailure() ? 1 : 0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "wait status " << status;
}

/// A folder of its own for each test. Whatever a test does, no temporary file may stay behind in it.
class Files : public testing::Test {
public:
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

protected:
  Files() {
    std::string name = (fs::temp_directory_path() / "vesper-files-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~Files() override {
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }

  [[nodiscard]] const fs::path& folder() const { return folder_; }
  [[nodiscard]] std::vector<std::string> entries() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

private:
  fs::path folder_;
};

using Names = std::vector<std::string>;

TEST_F(Files, ReadsBackWhatWasWritten) {
  const fs::path path = folder() / "a.bin";
  std::string text(200'000, '\0'); // several read buffers
  for (std::size_t i = 0; i < text.size(); ++i) {
    text[i] = static_cast<char>(i * 31 % 256);
  }
  write_file_atomically(path, text);
  EXPECT_EQ(text_of(read_file(path)), text);
  EXPECT_EQ(entries(), Names{"a.bin"});
}

TEST_F(Files, EmptyFileIsWrittenAndRead) {
  write_file_atomically(folder() / "empty", std::string());
  EXPECT_TRUE(fs::is_regular_file(folder() / "empty"));
  EXPECT_TRUE(read_file(folder() / "empty").empty());
}

TEST_F(Files, ReplacesAnEarlierFileByAnotherOne) {
  const fs::path path = folder() / "a.txt";
  write_file_atomically(path, std::string("earlier and longer"));
  // Whoever has the earlier file open keeps reading it whole: that is what renaming gives and rewriting does not.
  const int reader = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_GE(reader, 0);
  write_file_atomically(path, std::string("new"));
  std::string seen(64, '\0');
  seen.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::read(reader, seen.data(), seen.size()))));
  ::close(reader);
  EXPECT_EQ(seen, "earlier and longer");
  EXPECT_EQ(text_of(read_file(path)), "new");
  EXPECT_EQ(entries(), Names{"a.txt"});
}

TEST_F(Files, NewFileGetsTheModeThatUmaskAllowsAndAnOldOneKeepsIts) {
  const mode_t earlier = ::umask(027);
  write_file_atomically(folder() / "new", std::string("x"));
  ::umask(earlier);
  EXPECT_EQ(mode_of(folder() / "new"), 0640U);

  fs::permissions(folder() / "new", fs::perms{0604});
  write_file_atomically(folder() / "new", std::string("y"));
  EXPECT_EQ(mode_of(folder() / "new"), 0604U);
}

TEST_F(Files, RelativePathWithoutFolderIsWrittenHere) {
  const fs::path before = fs::current_path();
  fs::current_path(folder());
  write_file_atomically("plain.txt", std::string("x"));
  require_writable("plain.txt");
  require_writable("other.txt");
  fs::current_path(before);
  EXPECT_EQ(entries(), Names{"plain.txt"});
}

TEST_F(Files, MissingFileCannotBeRead) {
  const fs::path path = folder() / "absent.dat";
  EXPECT_TRUE(contains(file_error(path, [&] { (void)read_file(path); }).message(), "No such file"));
}

TEST_F(Files, FolderCannotBeReadOrWritten) {
  EXPECT_TRUE(contains(file_error(folder(), [&] { (void)read_file(folder()); }).message(), "Is a directory"));
  EXPECT_TRUE(contains(file_error(folder(), [&] { write_file_atomically(folder(), "x"); }).message(), "Is a dir"));
  EXPECT_TRUE(contains(file_error(folder(), [&] { require_writable(folder()); }).message(), "Is a directory"));
}

TEST_F(Files, MissingFolderIsAnError) {
  const fs::path path = folder() / "absent" / "a.txt";
  EXPECT_TRUE(contains(file_error(path, [&] { write_file_atomically(path, "x"); }).message(), "No such file"));
  EXPECT_TRUE(contains(file_error(path, [&] { require_writable(path); }).message(), "No such file"));
  EXPECT_TRUE(entries().empty());
}

TEST_F(Files, FileInPlaceOfAFolderIsAnError) {
  write_file_atomically(folder() / "file", std::string("x"));
  const fs::path path = folder() / "file" / "a.txt";
  EXPECT_TRUE(contains(file_error(path, [&] { write_file_atomically(path, "x"); }).message(), "Not a directory"));
  EXPECT_TRUE(contains(file_error(path, [&] { require_writable(path); }).message(), "Not a directory"));
}

TEST_F(Files, UnwritableFolderIsAnErrorAndKeepsTheEarlierFile) {
  const fs::path path = folder() / "a.txt";
  write_file_atomically(path, std::string("earlier"));
  fs::permissions(path, fs::perms{0644});
  fs::permissions(folder(), fs::perms{0555});
  as_ordinary_user([&] {
    EXPECT_TRUE(contains(file_error(path, [&] { write_file_atomically(path, "new"); }).message(), "Permission"));
    EXPECT_TRUE(contains(file_error(path, [&] { require_writable(path); }).message(), "Permission denied"));
    const fs::path other = folder() / "b.txt";
    EXPECT_TRUE(contains(file_error(other, [&] { require_writable(other); }).message(), "Permission denied"));
  });
  EXPECT_EQ(text_of(read_file(path)), "earlier");
  EXPECT_EQ(entries(), Names{"a.txt"});
}

TEST_F(Files, UnreadableFileIsAnError) {
  const fs::path path = folder() / "secret";
  write_file_atomically(path, std::string("x"));
  fs::permissions(path, fs::perms::none);
  fs::permissions(folder(), fs::perms{0755});
  as_ordinary_user(
      [&] { EXPECT_TRUE(contains(file_error(path, [&] { (void)read_file(path); }).message(), "Permission denied")); });
}

TEST_F(Files, WriteThatDoesNotFitLeavesTheEarlierFileAlone) {
  const fs::path path = folder() / "a.txt";
  write_file_atomically(path, std::string("earlier"));
  // A limit on file sizes stands in for a full disk: write() stores a part and then fails.
  rlimit earlier{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &earlier), 0);
  const rlimit limited{4096, earlier.rlim_max};
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limited), 0);
  const Error error = file_error(path, [&] { write_file_atomically(path, std::string(100'000, 'n')); });
  const Error fresh =
      file_error(folder() / "b.txt", [&] { write_file_atomically(folder() / "b.txt", std::string(100'000, 'n')); });
  ::setrlimit(RLIMIT_FSIZE, &earlier);
  (void)std::signal(SIGXFSZ, old_handler);
  EXPECT_TRUE(contains(error.message(), "File too large")) << error.what();
  EXPECT_TRUE(contains(fresh.message(), "File too large")) << fresh.what();
  EXPECT_EQ(text_of(read_file(path)), "earlier");
  EXPECT_EQ(entries(), Names{"a.txt"}) << "a part was left behind";
}

TEST_F(Files, FullDeviceIsAnError) {
  const fs::path path = "/dev/full";
  if (!fs::exists(path)) {
    GTEST_SKIP() << "no /dev/full";
  }
  EXPECT_TRUE(contains(file_error(path, [&] { write_file_atomically(path, "x"); }).message(), "No space left"));
  EXPECT_TRUE(fs::is_character_file(path)) << "the device was replaced";
}

TEST_F(Files, DeviceIsWrittenNotReplaced) {
  write_file_atomically("/dev/null", std::string("x"));
  require_writable("/dev/null");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Files, SymbolicLinkStaysAndItsTargetIsReplaced) {
  fs::create_directory(folder() / "elsewhere");
  const fs::path target = folder() / "elsewhere" / "target.txt";
  write_file_atomically(target, std::string("earlier"));
  fs::create_symlink("elsewhere/target.txt", folder() / "link.txt");
  write_file_atomically(folder() / "link.txt", std::string("new"));
  EXPECT_TRUE(fs::is_symlink(folder() / "link.txt"));
  EXPECT_FALSE(fs::is_symlink(target));
  EXPECT_EQ(text_of(read_file(target)), "new");
}

TEST_F(Files, DanglingSymbolicLinkCreatesItsTarget) {
  fs::create_symlink("target.txt", folder() / "link.txt");
  require_writable(folder() / "link.txt");
  write_file_atomically(folder() / "link.txt", std::string("new"));
  EXPECT_TRUE(fs::is_symlink(folder() / "link.txt"));
  EXPECT_EQ(text_of(read_file(folder() / "target.txt")), "new");
}

TEST_F(Files, SymbolicLinkToADeviceWritesTheDevice) {
  fs::create_symlink("/dev/null", folder() / "link");
  write_file_atomically(folder() / "link", std::string("x"));
  EXPECT_TRUE(fs::is_symlink(folder() / "link"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Files, SymbolicLinkToItselfIsAnError) {
  const fs::path path = folder() / "loop";
  fs::create_symlink("loop", path);
  (void)file_error(path, [&] { write_file_atomically(path, "x"); });
  (void)file_error(path, [&] { require_writable(path); });
  (void)file_error(path, [&] { (void)read_file(path); });
  EXPECT_TRUE(fs::is_symlink(path));
  EXPECT_EQ(entries(), Names{"loop"});
}

TEST_F(Files, PipeIsReadAndWrittenWhole) {
  const fs::path path = folder() / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const std::string text(300'000, 'p'); // more than a pipe holds
  std::jthread writer([&] { write_file_atomically(path, text); });
  EXPECT_EQ(text_of(read_file(path)), text);
  writer.join();
  EXPECT_TRUE(fs::is_fifo(path)) << "the pipe was replaced";
}

TEST_F(Files, RequireWritableTouchesNothing) {
  write_file_atomically(folder() / "a.txt", std::string("earlier"));
  require_writable(folder() / "a.txt");
  require_writable(folder() / "new.txt");
  EXPECT_EQ(entries(), Names{"a.txt"});
  EXPECT_EQ(text_of(read_file(folder() / "a.txt")), "earlier");
}

} // namespace
} // namespace vesper
