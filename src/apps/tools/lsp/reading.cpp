#include "apps/tools/lsp/reading.h"

#include <algorithm>

#include "fp_compiler/front/ati/words.h"
#include "fp_compiler/front/nv/words.h"

namespace arbiter::tools::lsp {

using fp::TokenKind;

std::string_view Reading::text(std::size_t token) const {
  const fp::Span span = m_tokens[token].span;
  return m_text.substr(span.begin, span.end - span.begin);
}

std::size_t Reading::before(std::uint32_t offset) const {
  const auto after = std::upper_bound(
      m_tokens.begin(), m_tokens.end(), offset,
      [](std::uint32_t at, const fp::Token &token) { return at < token.span.end; });
  return std::size_t(after - m_tokens.begin());
}

std::optional<std::size_t> Reading::at(std::uint32_t offset) const {
  const std::size_t next = before(offset);
  const bool within = next < m_tokens.size() && m_tokens[next].span.begin <= offset;
  const bool behind = next > 0 && m_tokens[next - 1].span.end == offset;
  const auto isWord = [&](std::size_t i) {
    return m_tokens[i].kind == TokenKind::Identifier || m_tokens[i].kind == TokenKind::Dimension;
  };
  if (behind && (!within || (isWord(next - 1) && !isWord(next))))
    return next - 1;
  return within ? std::optional(next) : std::nullopt;
}

bool Reading::inComment(std::uint32_t offset) const {
  const std::size_t next = before(offset);
  const std::uint32_t from = next > 0 ? m_tokens[next - 1].span.end : 0;
  // Only spaces and comments lie between two tokens.
  const std::string_view gap = m_text.substr(from, offset - std::min(from, offset));
  const std::size_t line = gap.find_last_of("\r\n");
  const std::size_t begin = line == std::string_view::npos ? 0 : line + 1;
  return gap.find('#', begin) != std::string_view::npos;
}

fp::Word Reading::word(std::size_t token) const {
  if (kind(token) != TokenKind::Identifier ||
      m_analysis.language == fp::ir::Language::AtiFragment || isNvparse(m_analysis.language))
    return {};
  if (m_analysis.ownLanguage != fp::ir::NativeLanguage::None)
    return fp::nv::classify(text(token), m_analysis.ownLanguage);
  const fp::ArbLanguage &language = fp::arbLanguage(m_analysis.language);
  return m_analysis.nv == fp::ir::NvOption::None
             ? fp::classify(text(token), language)
             : fp::nv::classify(text(token), language, m_analysis.nv);
}

bool Reading::beginsStatement(std::size_t token) const {
  if (m_analysis.language == fp::ir::Language::AtiFragment)
    return kind(token) == TokenKind::Identifier && fp::ati::beginsStatement(text(token));
  if (isNvparse(m_analysis.language))
    return token > 0 &&
           (kind(token - 1) == TokenKind::OpenBrace || kind(token - 1) == TokenKind::CloseBrace);
  return fp::beginsStatement(word(token).keyword);
}

std::size_t Reading::statementBegin(std::size_t token) const {
  while (token > 0 && kind(token - 1) != TokenKind::Semicolon && !beginsStatement(token))
    --token;
  return token;
}

fp::Span Reading::statement(std::size_t token) const {
  std::size_t last = token;
  while (kind(last) != TokenKind::Semicolon && last + 1 < size() && !beginsStatement(last + 1))
    ++last;
  return {span(statementBegin(token)).begin, span(last).end};
}

std::size_t Reading::comma(std::size_t begin, std::size_t end) const {
  while (begin < end && kind(begin) != TokenKind::Comma)
    ++begin;
  return begin;
}

std::vector<std::size_t> Reading::chainUpTo(std::size_t token) const {
  std::vector<std::size_t> found;
  if (kind(token) != TokenKind::Identifier)
    return found;
  found.push_back(token);
  std::size_t at = token;
  while (at >= 2 && kind(at - 1) == TokenKind::Dot) {
    at -= 2;
    if (kind(at) == TokenKind::CloseBracket)
      while (at > 0 && kind(at) != TokenKind::OpenBracket)
        --at;
    if (kind(at) == TokenKind::OpenBracket && at > 0)
      --at;
    if (kind(at) != TokenKind::Identifier)
      break;
    found.insert(found.begin(), at);
  }
  return found;
}

std::vector<std::size_t> Reading::chain(std::size_t token) const {
  std::vector<std::size_t> found = chainUpTo(token);
  while (!found.empty()) {
    std::size_t at = found.back() + 1;
    if (at < size() && kind(at) == TokenKind::OpenBracket) {
      while (at < size() && kind(at) != TokenKind::CloseBracket && kind(at) != TokenKind::Semicolon)
        ++at;
      ++at;
    }
    if (at + 1 >= size() || kind(at) != TokenKind::Dot || kind(at + 1) != TokenKind::Identifier)
      break;
    found.push_back(at + 1);
  }
  return found;
}

std::vector<std::string_view> Reading::words(const std::vector<std::size_t> &chain) const {
  std::vector<std::string_view> found;
  found.reserve(chain.size());
  for (const std::size_t token : chain)
    found.push_back(text(token));
  return found;
}

} // namespace arbiter::tools::lsp
