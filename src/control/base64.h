#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Encodes bytes as text (RFC 4648, section 4, with padding).
namespace arbiter::control {

[[nodiscard]] std::string toBase64(std::span<const std::uint8_t> bytes);
/// Decodes a text; returns nothing unless it is exactly what toBase64() writes.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> fromBase64(std::string_view text);

} // namespace arbiter::control
