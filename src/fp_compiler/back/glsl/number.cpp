#include "fp_compiler/back/glsl/number.h"

#include <charconv>
#include <cmath>

namespace arbiter::fp::glsl {

std::string number(float value) {
  if (std::isnan(value))
    return "(0.0 / 0.0)";
  if (std::isinf(value))
    return value > 0 ? "(1.0 / 0.0)" : "(-1.0 / 0.0)";
  char digits[64];
  // The output must not depend on the application's locale.
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  std::string text(digits, end.ptr);
  if (text.find_first_of(".e") == std::string::npos)
    text += ".0"; // an integer literal is a different type in GLSL 1.20
  return text;
}

} // namespace arbiter::fp::glsl
