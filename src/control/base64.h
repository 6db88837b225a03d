#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Bytes as text (RFC 4648, section 4, with padding).
namespace arbiter::control {

[[nodiscard]] std::string toBase64(std::span<const std::uint8_t> bytes);
/// Nothing where the text is not exactly what toBase64() makes.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> fromBase64(std::string_view text);

} // namespace arbiter::control
