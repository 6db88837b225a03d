#pragma once
#include <string_view>

#include "fp_compiler/front/lexer.h"

namespace arbiter::fp {

/// The tokens of ATI's and nvparse's texts, with one token of look-ahead. Words are letters, digits
/// and underscores ("r0", "2x", "1", "str_dr").
class WordTokens {
public:
  /// Begins at byte \p begin of \p text, which must outlive this object.
  /// \param words Suffixes or Calls
  WordTokens(std::string_view text, std::uint32_t begin, Words words = Words::Suffixes);

  [[nodiscard]] const Token &peek() const { return m_ahead; }
  [[nodiscard]] bool at(TokenKind kind) const { return m_ahead.kind == kind; }
  [[nodiscard]] bool atWord(std::string_view word) const {
    return at(TokenKind::Identifier) && text(m_ahead) == word;
  }
  /// Consumes the next token. After the last token it always returns EndOfText.
  Token next();
  /// Consumes the next token if it has this kind. Returns whether it did.
  bool accept(TokenKind kind);
  /// Consumes the next token if it is this word. Returns whether it did.
  bool acceptWord(std::string_view word);
  /// Consumes the next token by the grammar of numerals, which may be longer: "0.5".
  Token nextNumeral();
  [[nodiscard]] std::string_view text(const Token &token) const {
    return m_text.substr(token.span.begin, token.span.end - token.span.begin);
  }
  /// Returns the last consumed token; before the first, an empty span at the start of the text.
  [[nodiscard]] Span last() const { return m_last; }
  [[nodiscard]] std::uint32_t lastEnd() const { return m_last.end; }

private:
  std::string_view m_text;
  Words m_words;
  Lexer m_lexer;
  Token m_ahead;
  Span m_last;
};

} // namespace arbiter::fp
