#pragma once
#include <string>
#include <string_view>

namespace arbiter::fp {

/// Describes a text that is no program.
struct Foreign {
  std::string kind;        ///< "GLSL", "an ELF file"; empty: not certain
  std::string_view advice; ///< what the user can do
};

/// Returns the kind of a text without a header. The kind is empty if it is not certain, or if the
/// text has a statement of an assembly program, so that a program with a wrong header is checked as
/// a program.
[[nodiscard]] Foreign foreignText(std::string_view text);

} // namespace arbiter::fp
