#include "util/cache/cache_key.h"

#include <fcntl.h>
#include <string_view>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include "util/file.h"

namespace arbiter {

namespace {

std::optional<HashKey> read(const std::string &path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (file < 0)
    return std::nullopt;
  HashKey key;
  struct stat status = {};
  const bool good = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode) &&
                    status.st_uid == ::geteuid() && (status.st_mode & 077) == 0 &&
                    status.st_size == off_t(key.size()) &&
                    ::read(file, key.data(), key.size()) == ssize_t(key.size());
  ::close(file);
  return good ? std::optional(key) : std::nullopt;
}

} // namespace

std::optional<HashKey> cacheKeyOf(const std::string &folder) {
  const std::string path = folder + "/key";
  if (const auto key = read(path))
    return key;
  HashKey fresh;
  if (::getrandom(fresh.data(), fresh.size(), GRND_NONBLOCK) != ssize_t(fresh.size()))
    return std::nullopt;
  ::unlink(path.c_str());
  // If another process was first, its key counts.
  if (!createPrivateFile(path, {reinterpret_cast<const char *>(fresh.data()), fresh.size()}))
    return std::nullopt;
  return read(path);
}

} // namespace arbiter
