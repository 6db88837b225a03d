#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace arbiter {

/// 128-bit content hash of a program string (XXH3), the key by which a program is named in
/// statistics, captures and caches. Not a defence against a deliberate collision.
struct Hash128 {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
  bool operator==(const Hash128 &) const = default;
};

[[nodiscard]] Hash128 hashBytes(std::string_view bytes);

/// The same of a regular file's bytes, read piece by piece. Nothing if it cannot be read; errno is
/// set.
[[nodiscard]] std::optional<Hash128> hashFile(const char *path);

/// 32 lower-case hexadecimal digits.
[[nodiscard]] std::string toHex(const Hash128 &hash);

} // namespace arbiter
