#include "control/base64.h"

#include <array>

namespace arbiter::control {

namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::array<std::int8_t, 256> kValues = [] {
  std::array<std::int8_t, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < kDigits.size(); ++i)
    values[std::size_t(std::uint8_t(kDigits[i]))] = std::int8_t(i);
  return values;
}();

} // namespace

std::string toBase64(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const std::uint32_t group = std::uint32_t(bytes[i]) << 16 |
                                (left > 1 ? std::uint32_t(bytes[i + 1]) << 8 : 0) |
                                (left > 2 ? std::uint32_t(bytes[i + 2]) : 0);
    text += kDigits[group >> 18];
    text += kDigits[group >> 12 & 63];
    text += left > 1 ? kDigits[group >> 6 & 63] : '=';
    text += left > 2 ? kDigits[group & 63] : '=';
  }
  return text;
}

std::optional<std::vector<std::uint8_t>> fromBase64(std::string_view text) {
  if (text.size() % 4 != 0)
    return std::nullopt;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::size_t i = 0; i < text.size(); i += 4) {
    const bool last = i + 4 == text.size();
    const int padding = !last || text[i + 3] != '=' ? 0 : text[i + 2] == '=' ? 2 : 1;
    std::uint32_t group = 0;
    for (int digit = 0; digit < 4; ++digit) {
      const std::int8_t value = digit >= 4 - padding
                                    ? std::int8_t(0)
                                    : kValues[std::uint8_t(text[i + std::size_t(digit)])];
      if (value < 0)
        return std::nullopt;
      group = group << 6 | std::uint32_t(value);
    }
    // An encoder sets the bits that no byte uses to zero.
    if ((padding == 1 && (group & 0xff) != 0) || (padding == 2 && (group & 0xffff) != 0))
      return std::nullopt;
    bytes.push_back(std::uint8_t(group >> 16));
    if (padding < 2)
      bytes.push_back(std::uint8_t(group >> 8));
    if (padding < 1)
      bytes.push_back(std::uint8_t(group));
  }
  return bytes;
}

} // namespace arbiter::control
