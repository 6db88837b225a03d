#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace arbiter {

using HashKey = std::array<std::uint8_t, 16>;
using KeyedHash = std::array<std::uint8_t, 16>;

/// SipHash-2-4 with 128 bits of result (Aumasson and Bernstein): a message authentication code. Who
/// does not have the key cannot make a message with the right hash, nor one with a chosen change.
[[nodiscard]] KeyedHash keyedHash(const HashKey &key, std::string_view message);

} // namespace arbiter
