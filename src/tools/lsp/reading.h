#pragma once
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "fp_compiler/front/words/keywords.h"
#include "tools/lsp/document.h"

/// What stands where in a text, by its tokens alone: so also in a text that is not whole.
namespace arbiter::tools::lsp {

class Reading {
public:
  Reading(const Document &document, const Analysis &analysis)
      : m_text(document.text()), m_analysis(analysis), m_tokens(analysis.tokens) {}

  [[nodiscard]] std::string_view text(std::size_t token) const;
  [[nodiscard]] fp::TokenKind kind(std::size_t token) const { return m_tokens[token].kind; }
  [[nodiscard]] fp::Span span(std::size_t token) const { return m_tokens[token].span; }
  [[nodiscard]] std::size_t size() const { return m_tokens.size(); }

  /// The token that the byte is in or directly behind, a word before what follows it.
  [[nodiscard]] std::optional<std::size_t> at(std::uint32_t offset) const;
  /// The number of tokens that end before the byte or with it.
  [[nodiscard]] std::size_t before(std::uint32_t offset) const;
  [[nodiscard]] bool inComment(std::uint32_t offset) const;

  /// What a word is in the text's language. ATI's words have no keywords: None.
  [[nodiscard]] fp::Word word(std::size_t token) const;
  [[nodiscard]] bool beginsStatement(std::size_t token) const;
  /// The first token of the statement that a token is of.
  [[nodiscard]] std::size_t statementBegin(std::size_t token) const;
  /// From its first token to its semicolon; without one, to the token before the next statement.
  [[nodiscard]] fp::Span statement(std::size_t token) const;

  /// The first comma of [begin, end), or `end`.
  [[nodiscard]] std::size_t comma(std::size_t begin, std::size_t end) const;

  /// The words that full stops join around a token, without their indexes: "state", "light",
  /// "half". Tokens' numbers; empty where the token is no word.
  [[nodiscard]] std::vector<std::size_t> chain(std::size_t token) const;
  /// The part of chain() up to this token.
  [[nodiscard]] std::vector<std::size_t> chainUpTo(std::size_t token) const;
  [[nodiscard]] std::vector<std::string_view> words(const std::vector<std::size_t> &chain) const;

private:
  std::string_view m_text;
  const Analysis &m_analysis;
  const std::vector<fp::Token> &m_tokens;
};

} // namespace arbiter::tools::lsp
