#pragma once
#include <string>
#include <string_view>

#include "apps/scene/panel/panel.h"

/// Edits of a panel that leave the rest of the text unchanged, byte for byte.
namespace arbiter::scene {

struct Edit {
  fp::Span span;    ///< the text to remove
  std::string text; ///< the text to insert
};

/// Returns the shortest decimal that reads back as the same 32-bit float; "0" for NaN and
/// infinities.
[[nodiscard]] std::string numberText(double value);

/// Replaces a number. Requires number.written().
[[nodiscard]] Edit setNumber(const Number &number, double value);
/// Inserts an argument behind \p word, as " NAME VALUE".
[[nodiscard]] Edit addArgument(fp::Span word, std::string_view name, double value);
/// Replaces a word.
[[nodiscard]] Edit setWord(fp::Span word, std::string_view text);
/// Inserts a line "#@ WORDS" behind the last one of the panel, or behind the header line if there
/// is none. It ends as the line before it does.
[[nodiscard]] Edit addLine(std::string_view text, std::string_view words);

/// Returns the edited text. Requires that the span is within the text.
[[nodiscard]] std::string applied(std::string_view text, const Edit &edit);
/// Applies setNumber().
[[nodiscard]] std::string withNumber(std::string_view text, const Number &number, double value);

} // namespace arbiter::scene
