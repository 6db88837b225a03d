#pragma once
#include <string_view>

namespace arbiter::fp {

/// Says what a text without a header is, where it is in another language or no text at all: "GLSL",
/// "an ELF file". Empty where that is not certain, and always where a statement of an assembly
/// program is in it, so that a program with a wrong header is judged as a program.
[[nodiscard]] std::string_view foreignKind(std::string_view text);

} // namespace arbiter::fp
