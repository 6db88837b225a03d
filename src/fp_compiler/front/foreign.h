#pragma once
#include <string>
#include <string_view>

namespace arbiter::fp {

/// What a text is that is no program.
struct Foreign {
  std::string kind;        ///< "GLSL", "an ELF file"; empty: that is not certain
  std::string_view advice; ///< what helps
};

/// Says what a text without a header is, where it is in another language or no text at all. Of no
/// kind where that is not certain, and always where a statement of an assembly program is in it, so
/// that a program with a wrong header is judged as a program.
[[nodiscard]] Foreign foreignText(std::string_view text);

} // namespace arbiter::fp
