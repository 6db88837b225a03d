#include "apps/tools/debug/trace/numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace arbiter::tools::debug {

std::string numberText(float value, int digits) {
  if (std::isnan(value))
    return "nan";
  char text[64];
  std::snprintf(text, sizeof text, "%.*g", digits, double(value));
  return text;
}

std::string vectorText(const std::array<float, 4> &value, std::uint8_t mask, int digits) {
  for (std::size_t c = 0; c < 4; ++c)
    if (mask == 1u << c)
      return numberText(value[c], digits);
  std::string text;
  for (std::size_t c = 0; c < 4; ++c)
    text += (c ? ", " : "(") + (mask >> c & 1 ? numberText(value[c], digits) : "-");
  return text + ")";
}

std::uint8_t byteOf(float value) {
  const float clamped = value > 0 ? std::min(value, 1.0f) : 0.0f;
  return std::uint8_t(std::lround(clamped * 255.0f));
}

std::string lettersOf(std::uint8_t mask) {
  std::string text;
  for (int c = 0; c < 4; ++c)
    if (mask >> c & 1)
      text += "xyzw"[c];
  return text;
}

std::string colorText(const std::array<float, 4> &value) {
  std::array<std::uint8_t, 4> bytes = {};
  std::transform(value.begin(), value.end(), bytes.begin(), byteOf);
  return hexColor(bytes);
}

std::string hexColor(const std::array<std::uint8_t, 4> &bytes) {
  char text[9];
  std::snprintf(text, sizeof text, "%02x%02x%02x%02x", bytes[0], bytes[1], bytes[2], bytes[3]);
  return text;
}

} // namespace arbiter::tools::debug
