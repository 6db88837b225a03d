#pragma once
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "apps/tools/lsp/document.h"
#include "fp_compiler/front/words/keywords.h"

/// Answers questions about a text's structure from its tokens alone, so that the text may be
/// incomplete.
namespace arbiter::tools::lsp {

class Reading {
public:
  Reading(const Document &document, const Analysis &analysis)
      : m_text(document.text()), m_analysis(analysis), m_tokens(analysis.tokens) {}

  [[nodiscard]] std::string_view text(std::size_t token) const;
  [[nodiscard]] fp::TokenKind kind(std::size_t token) const { return m_tokens[token].kind; }
  [[nodiscard]] fp::Span span(std::size_t token) const { return m_tokens[token].span; }
  [[nodiscard]] std::size_t size() const { return m_tokens.size(); }

  /// Returns the token that contains the byte or ends there; a word takes precedence over the next
  /// token.
  [[nodiscard]] std::optional<std::size_t> at(std::uint32_t offset) const;
  /// Returns the number of tokens that end at or before the byte.
  [[nodiscard]] std::size_t before(std::uint32_t offset) const;
  [[nodiscard]] bool inComment(std::uint32_t offset) const;

  /// Returns a word's meaning in the text's language. ATI's language has no keywords: None.
  [[nodiscard]] fp::Word word(std::size_t token) const;
  [[nodiscard]] bool beginsStatement(std::size_t token) const;
  /// Returns the first token of the statement that contains a token.
  [[nodiscard]] std::size_t statementBegin(std::size_t token) const;
  /// Returns a statement's span from its first token to its semicolon. Without one it ends with the
  /// token before the next statement.
  [[nodiscard]] fp::Span statement(std::size_t token) const;

  /// Returns the first comma in [begin, end), or `end`.
  [[nodiscard]] std::size_t comma(std::size_t begin, std::size_t end) const;

  /// Returns the tokens of the words that dots join around a token, without their indexes, such as
  /// "state", "light", "half". Empty if the token is no word.
  [[nodiscard]] std::vector<std::size_t> chain(std::size_t token) const;
  /// Returns the part of chain() up to the token.
  [[nodiscard]] std::vector<std::size_t> chainUpTo(std::size_t token) const;
  [[nodiscard]] std::vector<std::string_view> words(const std::vector<std::size_t> &chain) const;

private:
  std::string_view m_text;
  const Analysis &m_analysis;
  const std::vector<fp::Token> &m_tokens;
};

} // namespace arbiter::tools::lsp
