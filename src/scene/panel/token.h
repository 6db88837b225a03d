#pragma once
#include <string_view>
#include <vector>

#include "fp_compiler/span.h"

namespace arbiter::scene {

enum class TokenKind : std::uint8_t {
  Word,   ///< letters, digits and _ - . / from a letter on; or a component suffix, ".xyz"
  Number, ///< "-0.5", "5s"
  String, ///< in double quotes
  Comma,
  Equals,
  Open,    ///< [
  Close,   ///< ]
  Range,   ///< ..
  Unknown, ///< a byte that begins no token, or a quote without its end
  End,     ///< behind the last one; empty
};

struct Token {
  TokenKind kind = TokenKind::End;
  fp::Span span;         ///< in the whole text
  std::string_view text; ///< of a string: what is between the quotes
  double value = 0;      ///< of a number
  bool seconds = false;  ///< of a number: an "s" follows it
  fp::Span digits() const { return {span.begin, span.end - (seconds ? 1 : 0)}; }
};

/// Whether it names a file and is no word of a table: a string, or a word with a dot.
[[nodiscard]] inline bool isFile(const Token &token) {
  return token.kind == TokenKind::String ||
         (token.kind == TokenKind::Word && token.text.find('.') != std::string_view::npos);
}

/// The tokens of text[begin, end), with an End behind them.
[[nodiscard]] std::vector<Token> tokenise(std::string_view text, fp::Span line);

/// What follows `#@` of each line that begins so, blanks aside.
[[nodiscard]] std::vector<fp::Span> panelLines(std::string_view text);

} // namespace arbiter::scene
