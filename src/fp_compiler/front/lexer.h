#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "fp_compiler/front/token.h"

namespace arbiter::fp {

/// The kinds of words that a lexer cuts. Identifiers: a word begins with a letter, and numerals are
/// separate tokens. Suffixes: ATI's text, where "2x" and "0" are words and a full stop is always a
/// token. The numerals there are cut by a second lexer for Identifiers. Calls: nvparse's texts,
/// like Suffixes with parentheses, `*`, and the comments of C and C++ besides `#`.
enum class Words : std::uint8_t { Identifiers, Suffixes, Calls };

/// Cuts a program string into tokens. It uses the length and no terminator, and reads no byte
/// outside [text.data(), text.data() + text.size()). Spaces, tabs, newlines, carriage returns and
/// comments (`#` to the end of the line) separate tokens (3.11.2).
/// Requires: text.size() <= kMaxTextBytes.
class Lexer {
public:
  explicit Lexer(std::string_view text, std::uint32_t begin = 0, Words words = Words::Identifiers)
      : m_text(text), m_pos(begin), m_words(words) {}

  /// Returns the next token. After the last token it always returns EndOfText, with the empty span
  /// at the text's end.
  [[nodiscard]] Token next();

private:
  void skipWhitespace();
  void skipLine();
  bool skipCComment();
  Token finish(TokenKind kind, std::uint32_t begin);
  Token identifier(std::uint32_t begin);
  Token numeral(std::uint32_t begin);
  void skipDigits();
  [[nodiscard]] bool digitAt(std::uint32_t pos) const;
  [[nodiscard]] bool is(std::uint32_t pos, char c) const;

  std::string_view m_text;
  std::uint32_t m_pos;
  Words m_words;
};

/// A lexer with two tokens of look-ahead, which is enough for every grammar.
class TokenStream {
public:
  /// Begins at byte \p begin of \p text, which must outlive this object.
  TokenStream(std::string_view text, std::uint32_t begin, Words words = Words::Identifiers);

  /// Returns the next token, or the one after it (\p ahead 1), without consuming it.
  [[nodiscard]] const Token &peek(int ahead = 0) const { return m_ahead[std::size_t(ahead)]; }
  [[nodiscard]] bool at(TokenKind kind) const { return m_ahead[0].kind == kind; }
  /// Consumes the next token. After the last token it always returns EndOfText.
  Token next();
  /// Consumes the next token if it has this kind. Returns whether it did.
  bool accept(TokenKind kind);
  /// Consumes the next token by the grammar of numerals, which may be longer than a word: "0.5".
  Token nextNumeral();
  [[nodiscard]] std::string_view text(const Token &token) const {
    return m_text.substr(token.span.begin, token.span.end - token.span.begin);
  }
  /// Returns the last consumed token; before the first, an empty span at the start of the text.
  [[nodiscard]] Span last() const { return m_last; }
  [[nodiscard]] std::uint32_t lastEnd() const { return m_last.end; }

private:
  void lookAhead(std::uint32_t from);

  std::string_view m_text;
  Words m_words;
  Lexer m_lexer;
  std::array<Token, 2> m_ahead;
  Span m_last;
};

} // namespace arbiter::fp
