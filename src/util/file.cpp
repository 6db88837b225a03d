#include "util/file.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace arbiter {

int openPrivate(const char *path, OpenMode mode) noexcept {
  // O_NONBLOCK: opening a pipe without a reader must fail, not hang the application. Truncation
  // waits until the file has proved to be a regular one.
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

bool writeAll(int descriptor, std::string_view bytes) noexcept {
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
