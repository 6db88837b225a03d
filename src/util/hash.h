#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace arbiter {

/// A 128-bit content hash of a program string (XXH3). It identifies the program in statistics,
/// captures and caches. It is no protection against deliberate collisions.
struct Hash128 {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
  bool operator==(const Hash128 &) const = default;
};

[[nodiscard]] Hash128 hashBytes(std::string_view bytes);

/// Hashes a regular file's bytes in blocks. Returns nothing, with errno set, if it cannot be read.
[[nodiscard]] std::optional<Hash128> hashFile(const char *path);

/// Returns 32 lower-case hexadecimal digits.
[[nodiscard]] std::string toHex(const Hash128 &hash);

} // namespace arbiter
