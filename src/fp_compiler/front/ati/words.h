#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

#include "fp_compiler/ati/shader.h"

/// The words of the grammar (ATFS 3.10.1), case-sensitive as it is.
namespace arbiter::fp::ati {

/// The operation that a word names; nothing for any other word.
[[nodiscard]] std::optional<Op> opOf(std::string_view word);
/// The word of an operation: "MAD".
[[nodiscard]] std::string_view name(Op op);

/// Of "str", "stq", "str_dr", "stq_dq", without their dot; nothing for any other word.
[[nodiscard]] std::optional<Coordinates> coordinatesOf(std::string_view word);

/// Of "2x" to "eighth", without their dot; nothing for any other word. Never Scale::None.
[[nodiscard]] std::optional<Scale> scaleOf(std::string_view word);

/// The words of both: "str_dr", "4x"; that of Scale::None is empty.
[[nodiscard]] std::string_view name(Coordinates coordinates);
[[nodiscard]] std::string_view name(Scale scale);

/// The write mask of "r", "rg" to "rgba": letters of rgba in order. Bit 0 is r; 0 for any other
/// word.
[[nodiscard]] std::uint8_t maskOf(std::string_view word);

/// The number after a letter: "r3" with 'r' is 3. Nothing for numbers of more than two digits, or
/// with a leading zero.
[[nodiscard]] std::optional<std::uint8_t> numbered(std::string_view word, char letter);

/// True for the words with which a parser that lost its way finds it again: those that begin a
/// statement, a block or the end of one.
[[nodiscard]] bool beginsStatement(std::string_view word);

} // namespace arbiter::fp::ati
