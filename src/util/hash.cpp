#include "util/hash.h"

#include <cerrno>
#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace arbiter {

Hash128 hashBytes(std::string_view bytes) {
  const XXH128_hash_t h = XXH3_128bits(bytes.data(), bytes.size());
  return {h.high64, h.low64};
}

std::optional<Hash128> hashFile(const char *path) {
  // On the heap: an application's thread may have a smaller stack
  constexpr std::size_t kBlock = 65536;
  const auto block = std::make_unique<char[]>(kBlock);
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(),
                                                                       &XXH3_freeState);
  const int descriptor = ::open(path, O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (descriptor < 0)
    return std::nullopt;
  struct stat status = {};
  int failure = ::fstat(descriptor, &status) != 0 ? errno : S_ISREG(status.st_mode) ? 0 : EINVAL;
  if (!state)
    failure = ENOMEM;
  else
    XXH3_128bits_reset(state.get());
  while (failure == 0) {
    const ssize_t count = ::read(descriptor, block.get(), kBlock);
    if (count < 0 && errno != EINTR)
      failure = errno;
    if (count == 0)
      break;
    if (count > 0)
      XXH3_128bits_update(state.get(), block.get(), std::size_t(count));
  }
  ::close(descriptor);
  errno = failure;
  if (failure != 0)
    return std::nullopt;
  const XXH128_hash_t h = XXH3_128bits_digest(state.get());
  return Hash128{h.high64, h.low64};
}

std::string toHex(const Hash128 &hash) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text(32, '0');
  for (int i = 0; i < 16; ++i) {
    text[15 - i] = kDigits[(hash.high >> (4 * i)) & 15];
    text[31 - i] = kDigits[(hash.low >> (4 * i)) & 15];
  }
  return text;
}

} // namespace arbiter
