#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace arbiter {

using HashKey = std::array<std::uint8_t, 16>;
using KeyedHash = std::array<std::uint8_t, 16>;

/// Computes SipHash-2-4 with a 128-bit result (Aumasson and Bernstein), a message authentication
/// code. Without the key no one can forge the hash of a message, or change a message unnoticed.
[[nodiscard]] KeyedHash keyedHash(const HashKey &key, std::string_view message);

} // namespace arbiter
