#pragma once
#include <string>
#include <string_view>

#include "scene/panel/panel.h"

/// Changes of a panel that leave the rest of the text as it is, byte for byte.
namespace arbiter::scene {

struct Edit {
  fp::Span span;    ///< what goes
  std::string text; ///< what comes in its place
};

/// The shortest decimal that reads back as the same 32-bit float; "0" for what is not finite.
[[nodiscard]] std::string numberText(double value);

/// Requires number.written().
[[nodiscard]] Edit setNumber(const Number &number, double value);
/// An argument that is not written yet: it comes behind \p word, as " NAME VALUE".
[[nodiscard]] Edit addArgument(fp::Span word, std::string_view name, double value);
/// Another word in the place of one.
[[nodiscard]] Edit setWord(fp::Span word, std::string_view text);
/// A line "#@ WORDS" behind the last one of the panel, or behind the header line if there is none.
/// The line ends as the one before it does.
[[nodiscard]] Edit addLine(std::string_view text, std::string_view words);

/// Requires: the span lies in the text.
[[nodiscard]] std::string applied(std::string_view text, const Edit &edit);
/// applied(setNumber()).
[[nodiscard]] std::string withNumber(std::string_view text, const Number &number, double value);

} // namespace arbiter::scene
