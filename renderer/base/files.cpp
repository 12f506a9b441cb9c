#include "vesper/base/files.hpp"

#include "vesper/base/error.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vesper {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what, int error_number, const std::string& remedy) {
  throw Error(ErrorKind::file, what + ": " + std::strerror(error_number), {path.string(), "", remedy});
}

class Descriptor {
public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) {
      ::close(fd_);
    }
  }
  [[nodiscard]] int get() const { return fd_; }
  /// Closes now, so that an error of the delayed write is seen. True when it succeeded.
  bool close() {
    const int fd = fd_;
    fd_ = -1;
    return ::close(fd) == 0;
  }

private:
  int fd_;
};

bool write_all(int fd, std::span<const std::byte> data) {
  while (!data.empty()) {
    const ssize_t written = ::write(fd, data.data(), data.size());
    if (written < 0) {
      if (errno == EINTR) {
        continue;
      }
      return false;
    }
    data = data.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

constexpr const char* space_remedy = "Free some space or choose another place; the earlier file, if any, is unchanged";
constexpr const char* folder_remedy = "Create the folder or choose a path that can be written";

/// The file that a write to `path` ends in: the path itself, or what a symbolic link points to, there or not yet.
fs::path write_target(const fs::path& path) {
  constexpr int most_links = 40; // as Linux has it
  fs::path target = path;
  std::error_code not_there;
  for (int links = 0; fs::is_symlink(target, not_there); ++links) {
    if (links == most_links) {
      fail(path, "cannot be written", ELOOP, folder_remedy);
    }
    target = target.parent_path() / fs::read_symlink(target, not_there);
  }
  return target;
}

/// What a write to a path replaces.
class Target {
public:
  explicit Target(const fs::path& path) : given_(path), path_(write_target(path)) {
    exists_ = ::stat(path_.c_str(), &status_) == 0;
    if (exists_ && S_ISDIR(status_.st_mode)) {
      fail(path, "cannot be written", EISDIR, "Give the path of a file");
    }
  }
  [[nodiscard]] const fs::path& path() const { return path_; }
  [[nodiscard]] bool replaceable() const { return !exists_ || S_ISREG(status_.st_mode); }

  /// Has `write` fill a temporary file, given as descriptor and as path, and lets it take the target's place; false
  /// stands for a failure that errno tells of.
  template <class Write> void replace(const Write& write) const {
    std::string name = path_.string() + ".XXXXXX";
    Descriptor file(::mkostemp(name.data(), O_CLOEXEC));
    if (file.get() < 0) {
      fail(given_, "cannot be created", errno, folder_remedy);
    }
    // mkostemp makes the file private; a new file gets what open() would have given it, an old one keeps its mode.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    const mode_t mode = exists_ ? (status_.st_mode & 07777) : (0666 & ~mask);
    try {
      if (!write(file.get(), fs::path(name)) || ::fchmod(file.get(), mode) != 0 || ::fsync(file.get()) != 0 ||
          !file.close() || ::rename(name.c_str(), path_.c_str()) != 0) {
        fail(given_, "cannot be written", errno, space_remedy);
      }
    } catch (...) {
      ::unlink(name.c_str());
      throw;
    }
  }

private:
  const fs::path& given_;
  fs::path path_;
  struct stat status_ {};
  bool exists_ = false;
};

} // namespace

Bytes read_file(const fs::path& path) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) {
    fail(path, "cannot be opened", errno, "Check the path and its permissions");
  }
  struct stat status {};
  Bytes data;
  if (::fstat(file.get(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) {
      fail(path, "cannot be read", EISDIR, "Give the path of a file");
    }
    data.reserve(static_cast<std::size_t>(status.st_size));
  }
  std::array<std::byte, 1 << 16> buffer{};
  for (;;) {
    const ssize_t count = ::read(file.get(), buffer.data(), buffer.size());
    if (count < 0) {
      if (errno == EINTR) {
        continue;
      }
      fail(path, "cannot be read", errno, "Check the file and the disk");
    }
    if (count == 0) {
      return data;
    }
    data.insert(data.end(), buffer.begin(), buffer.begin() + count);
  }
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> data) {
  const Target target(path);
  if (!target.replaceable()) {
    // A device or a pipe has no earlier content to protect, and renaming over it would destroy it.
    Descriptor file(::open(target.path().c_str(), O_WRONLY | O_CLOEXEC));
    if (file.get() < 0 || !write_all(file.get(), data) || !file.close()) {
      fail(path, "cannot be written", errno, space_remedy);
    }
    return;
  }
  target.replace([&](int fd, const fs::path&) { return write_all(fd, data); });
}

void write_file_atomically(const fs::path& path, const std::function<void(const fs::path& temporary)>& write) {
  const Target target(path);
  if (!target.replaceable()) {
    write(target.path());
    return;
  }
  target.replace([&](int, const fs::path& temporary) {
    write(temporary);
    return true;
  });
}

void write_file_atomically(const fs::path& path, const std::string& text) {
  write_file_atomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

void require_writable(const fs::path& path) {
  const fs::path target = write_target(path);
  struct stat status {};
  if (::stat(target.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) {
      fail(path, "cannot be written", EISDIR, "Give the path of a file");
    }
    if (!S_ISREG(status.st_mode)) {
      return;
    }
  }
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (::stat(folder.c_str(), &status) != 0) {
    fail(path, "cannot be created", errno, folder_remedy);
  }
  if (!S_ISDIR(status.st_mode)) {
    fail(path, "cannot be created", ENOTDIR, folder_remedy);
  }
  if (::access(folder.c_str(), W_OK) != 0) {
    fail(path, "cannot be created", errno, folder_remedy);
  }
}

} // namespace vesper
