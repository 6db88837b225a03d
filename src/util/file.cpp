#include "util/file.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace arbiter {

int openPrivate(const char *path, OpenMode mode) noexcept {
  // O_NONBLOCK makes opening a pipe without a reader fail instead of hanging the application.
  // Truncation waits until the file has proved to be a regular one.
  const int flags = O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC | O_NOCTTY | O_NONBLOCK |
                    (mode == OpenMode::Append ? O_APPEND : 0);
  const int descriptor = ::open(path, flags, 0600);
  if (descriptor < 0)
    return -1;
  struct stat status = {};
  bool good = ::fstat(descriptor, &status) == 0;
  if (good && !S_ISREG(status.st_mode)) {
    errno = EINVAL;
    good = false;
  }
  if (good && mode == OpenMode::Truncate)
    good = ::ftruncate(descriptor, 0) == 0;
  if (good)
    return descriptor;
  const int failure = errno;
  ::close(descriptor);
  errno = failure;
  return -1;
}

namespace {

/// True if a write would exceed RLIMIT_FSIZE, whose signal (SIGXFSZ) would end the application's
/// process.
bool exceedsLimit(int descriptor, std::size_t bytes) {
  rlimit limit = {};
  if (::getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return false;
  struct stat status = {};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode))
    return false;
  return std::uint64_t(status.st_size) + bytes > limit.rlim_cur;
}

} // namespace

bool writeAll(int descriptor, std::string_view bytes) noexcept {
  if (exceedsLimit(descriptor, bytes.size())) {
    errno = EFBIG;
    return false;
  }
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR)
      continue;
    if (written <= 0)
      return false;
    bytes.remove_prefix(std::size_t(written));
  }
  return true;
}

bool writePrivateFile(const char *path, std::string_view bytes) noexcept {
  const int descriptor = openPrivate(path, OpenMode::Truncate);
  if (descriptor < 0)
    return false;
  const bool written = writeAll(descriptor, bytes);
  const int failure = errno;
  const bool closed = ::close(descriptor) == 0;
  if (!written)
    errno = failure;
  return written && closed;
}

namespace {

/// Writes the bytes to a file beside `path`. Returns its name, or nothing with errno set.
std::string writeBeside(const std::string &path, std::string_view bytes) {
  std::string temporary = path + "." + std::to_string(::getpid()) + ".tmp";
  if (writePrivateFile(temporary.c_str(), bytes))
    return temporary;
  const int failure = errno;
  ::unlink(temporary.c_str());
  errno = failure;
  return {};
}

/// Removes a file and keeps errno, which describes the earlier failure.
void removeQuietly(const std::string &path) {
  const int failure = errno;
  ::unlink(path.c_str());
  errno = failure;
}

} // namespace

bool replacePrivateFile(const std::string &path, std::string_view bytes) {
  struct stat status = {};
  if (::lstat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    errno = ELOOP;
    return false;
  }
  const std::string temporary = writeBeside(path, bytes);
  if (temporary.empty())
    return false;
  if (std::rename(temporary.c_str(), path.c_str()) == 0)
    return true;
  removeQuietly(temporary);
  return false;
}

bool createPrivateFile(const std::string &path, std::string_view bytes) {
  struct stat status = {};
  if (::lstat(path.c_str(), &status) == 0)
    return true;
  const std::string temporary = writeBeside(path, bytes);
  if (temporary.empty())
    return false;
  // Unlike a rename, a link fails if another process has created the file meanwhile.
  bool created = ::link(temporary.c_str(), path.c_str()) == 0 || errno == EEXIST;
  if (!created && (errno == EPERM || errno == ENOTSUP || errno == ENOSYS)) // no hard links here
    return std::rename(temporary.c_str(), path.c_str()) == 0;
  removeQuietly(temporary);
  return created;
}

FileState stateOf(const char *path) noexcept {
  struct stat status = {};
  if (::stat(path, &status) != 0 || !S_ISREG(status.st_mode))
    return {};
  const auto nanoseconds = [](const timespec &time) {
    return std::int64_t(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
  };
  return {nanoseconds(status.st_mtim), nanoseconds(status.st_ctim), std::uint64_t(status.st_size),
          status.st_ino, true};
}

bool readFile(const char *path, std::size_t limit, std::string &bytes) {
  const int descriptor = ::open(path, O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (descriptor < 0)
    return false;
  struct stat status = {};
  int failure = ::fstat(descriptor, &status) != 0 ? errno : S_ISREG(status.st_mode) ? 0 : EINVAL;
  bytes.clear();
  char block[16384];
  while (failure == 0) {
    const ssize_t count = ::read(descriptor, block, sizeof block);
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0)
      failure = errno;
    if (count <= 0)
      break;
    bytes.append(block, std::size_t(count));
    if (bytes.size() > limit)
      failure = EFBIG;
  }
  ::close(descriptor);
  errno = failure;
  return failure == 0;
}

std::string expandPid(std::string_view path) {
  std::string expanded;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const char next = i + 1 < path.size() ? path[i + 1] : '\0';
    if (path[i] == '%' && next == 'p') {
      expanded += std::to_string(::getpid());
      ++i;
    } else if (path[i] == '%' && next == '%') {
      expanded += '%';
      ++i;
    } else {
      expanded += path[i];
    }
  }
  return expanded;
}

} // namespace arbiter
