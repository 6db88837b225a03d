#pragma once
#include <string_view>

#include "fp_compiler/front/lexer.h"

namespace arbiter::fp {

/// The tokens of a text whose words are letters, digits and underscores ("r0", "2x", "1",
/// "str_dr"), one ahead: ATI's and nvparse's.
class WordTokens {
public:
  /// Begins at byte \p begin of \p text, which must outlive this.
  /// \param words Suffixes or Calls
  WordTokens(std::string_view text, std::uint32_t begin, Words words = Words::Suffixes);

  [[nodiscard]] const Token &peek() const { return m_ahead; }
  [[nodiscard]] bool at(TokenKind kind) const { return m_ahead.kind == kind; }
  [[nodiscard]] bool atWord(std::string_view word) const {
    return at(TokenKind::Identifier) && text(m_ahead) == word;
  }
  /// Consumes the next token; EndOfText for ever after the last.
  Token next();
  /// Consumes the next token if it is of this kind.
  bool accept(TokenKind kind);
  /// Consumes the next token if it is this word.
  bool acceptWord(std::string_view word);
  /// The next token as the grammar of numerals cuts it, which may be longer: "0.5". Consumed.
  Token nextNumeral();
  [[nodiscard]] std::string_view text(const Token &token) const {
    return m_text.substr(token.span.begin, token.span.end - token.span.begin);
  }
  /// The token that was consumed last; before the first an empty span where the text begins.
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
