#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

#include "fp_compiler/ati/shader.h"

/// The words of the grammar (ATFS 3.10.1). They are case-sensitive.
namespace arbiter::fp::ati {

/// Returns the operation that a word names; nothing for any other word.
[[nodiscard]] std::optional<Op> opOf(std::string_view word);
/// Returns the word of an operation: "MAD".
[[nodiscard]] std::string_view name(Op op);

/// Returns the choice for "str", "stq", "str_dr" or "stq_dq", without a dot; nothing for any other
/// word.
[[nodiscard]] std::optional<Coordinates> coordinatesOf(std::string_view word);

/// Returns the scale for "2x" to "eighth", without a dot; nothing for any other word. Never
/// Scale::None.
[[nodiscard]] std::optional<Scale> scaleOf(std::string_view word);

/// Returns the word: "str_dr", "4x". The word of Scale::None is empty.
[[nodiscard]] std::string_view name(Coordinates coordinates);
[[nodiscard]] std::string_view name(Scale scale);

/// Returns the write mask of "r", "rg" to "rgba", with the letters in that order. Bit 0 is r.
/// Returns 0 for any other word.
[[nodiscard]] std::uint8_t maskOf(std::string_view word);

/// Returns the number after a letter: 3 for "r3" with 'r'. Returns nothing for a number of more
/// than two digits or with a leading zero.
[[nodiscard]] std::optional<std::uint8_t> numbered(std::string_view word, char letter);

/// True for words at which the parser can resume after an error: those that begin a statement, or
/// begin or end a block.
[[nodiscard]] bool beginsStatement(std::string_view word);

} // namespace arbiter::fp::ati
