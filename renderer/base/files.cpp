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
  const fs::path target = write_target(path);
  struct stat status {};
  const bool exists = ::stat(target.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    fail(path, "cannot be written", EISDIR, "Give the path of a file");
  }
  if (exists && !S_ISREG(status.st_mode)) {
    // A device or a pipe has no earlier content to protect, and renaming over it would destroy it.
    Descriptor file(::open(target.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.get() < 0 || !write_all(file.get(), data) || !file.close()) {
      fail(path, "cannot be written", errno, space_remedy);
    }
    return;
  }
  std::string name = target.string() + ".XXXXXX";
  Descriptor file(::mkostemp(name.data(), O_CLOEXEC));
  if (file.get() < 0) {
    fail(path, "cannot be created", errno, folder_remedy);
  }
  // mkostemp makes the file private; a new file gets what open() would have given it, an old one keeps its mode.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  const mode_t mode = exists ? (status.st_mode & 07777) : (0666 & ~mask);
  if (!write_all(file.get(), data) || ::fchmod(file.get(), mode) != 0 || ::fsync(file.get()) != 0 || !file.close() ||
      ::rename(name.c_str(), target.c_str()) != 0) {
    const int error_number = errno;
    ::unlink(name.c_str());
    fail(path, "cannot be written", error_number, space_remedy);
  }
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
