#pragma once
#include <string_view>
#include <vector>

#include "fp_compiler/span.h"

namespace arbiter::scene {

enum class TokenKind : std::uint8_t {
  Word,   ///< letters, digits and _ - . / that begin with a letter; or a component suffix, ".xyz"
  Number, ///< "-0.5", "5s"
  String, ///< in double quotes
  Comma,
  Equals,
  Open,    ///< [
  Close,   ///< ]
  Range,   ///< ..
  Unknown, ///< a byte that begins no token, or a quote that is not closed
  End,     ///< follows the last token; empty
};

struct Token {
  TokenKind kind = TokenKind::End;
  fp::Span span;         ///< in the whole text
  std::string_view text; ///< of a string: the text between the quotes
  double value = 0;      ///< of a number
  bool seconds = false;  ///< of a number: an "s" follows it
  fp::Span digits() const { return {span.begin, span.end - (seconds ? 1 : 0)}; }
};

/// True if the token names a file and is no table word: a string, or a word with a dot.
[[nodiscard]] inline bool isFile(const Token &token) {
  return token.kind == TokenKind::String ||
         (token.kind == TokenKind::Word && token.text.find('.') != std::string_view::npos);
}

/// Returns the tokens of text[begin, end), followed by an End.
[[nodiscard]] std::vector<Token> tokenise(std::string_view text, fp::Span line);

/// Returns the rest of each line that begins with `#@`, without blanks around it.
[[nodiscard]] std::vector<fp::Span> panelLines(std::string_view text);

} // namespace arbiter::scene
