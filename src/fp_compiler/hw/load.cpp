#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "fp_compiler/hw/names.h"
#include "fp_compiler/hw/profile.h"

namespace arbiter::fp::hw {

namespace {

/// The largest file that is read. A profile is a page of text, so a larger file is a mistake.
constexpr std::size_t kMaxFileBytes = 256u << 10;

/// Reads a whole regular file.
/// \returns false with errno set.
bool readFile(const char *path, std::string &text) {
  const int descriptor = ::open(path, O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (descriptor < 0)
    return false;
  struct stat status = {};
  bool good = ::fstat(descriptor, &status) == 0;
  if (good && !S_ISREG(status.st_mode)) {
    errno = EINVAL;
    good = false;
  }
  char buffer[4096];
  ssize_t count = 0;
  while (good && (count = ::read(descriptor, buffer, sizeof buffer)) != 0) {
    if (count < 0 && errno == EINTR)
      continue;
    if (count > 0 && text.size() + std::size_t(count) > kMaxFileBytes)
      errno = EFBIG;
    good = count > 0 && text.size() + std::size_t(count) <= kMaxFileBytes;
    if (good)
      text.append(buffer, std::size_t(count));
  }
  const int failure = errno;
  ::close(descriptor);
  errno = failure;
  return good;
}

} // namespace

bool isProfileFile(std::string_view nameOrPath) {
  return nameOrPath.find('/') != std::string_view::npos || nameOrPath.ends_with(".toml");
}

Result<Profile, ProfileError> loadProfile(std::string_view nameOrPath) {
  try {
    if (const Profile *builtin = findBuiltin(nameOrPath))
      return *builtin;
    if (!isProfileFile(nameOrPath))
      return ProfileError{unknownProfile(nameOrPath)};
    const std::string path(nameOrPath);
    std::string text;
    if (!readFile(path.c_str(), text))
      return ProfileError{path + ": " + std::strerror(errno)};
    return parseProfile(text, path);
  } catch (...) {
    return ProfileError{"out of memory while a profile was read"};
  }
}

} // namespace arbiter::fp::hw
