#pragma once
#include <string_view>

namespace arbiter::fp {

/// Returns the kind of a text without a header: "GLSL", "an ELF file". Returns an empty text if the
/// kind is not certain. Also returns an empty text if it has a statement of an assembly program, so
/// that a program with a wrong header is checked as a program.
[[nodiscard]] std::string_view foreignKind(std::string_view text);

} // namespace arbiter::fp
