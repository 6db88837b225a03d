// Parses the final combiner (NV_register_combiners 3.8.12.3).
#include <utility>

#include "fp_compiler/front/nvparse/combiner_parser.h"
#include "util/suggest.h"

namespace arbiter::fp::nvparse {

using combiners::Input;
using combiners::Mapping;
using combiners::Register;

namespace {
constexpr Input kZero = {Register::Zero, Mapping::UnsignedIdentity, combiners::Usage::Rgb};
constexpr Input kOne = {Register::Zero, Mapping::UnsignedInvert, combiners::Usage::Rgb};
} // namespace

bool CombinerParser::parseFinalInput(Usage usage, Input &input) {
  bool inverts = false;
  bool wrapped = false;
  if (at(TokenKind::Minus) || atWord("expand") || atWord("half_bias"))
    error(DiagnosticId::RcMapping, m_tokens.peek().span,
          "the final combiner maps by unsigned() and unsigned_invert() alone",
          "map it in a stage before");
  m_tokens.accept(TokenKind::Minus);
  if (atWord("unsigned") || atWord("unsigned_invert") || atWord("expand") || atWord("half_bias")) {
    inverts = atWord("unsigned_invert");
    wrapped = true;
    m_tokens.next();
    if (!expect(TokenKind::OpenParen, "'('"))
      return false;
  }
  Named named;
  if (!parseRegister(named, Access::Read))
    return false;
  if (wrapped && !expect(TokenKind::CloseParen, "')'"))
    return false;
  input = {named.name, inverts != named.one ? Mapping::UnsignedInvert : Mapping::UnsignedIdentity,
           named.usage.value_or(usage)};
  Token where = named.word;
  where.span = named.span;
  checkFinalInput(input, usage, where);
  if (input.source == Register::ETimesF && !m_readsProduct)
    m_readsProduct = named.span;
  return true;
}

void CombinerParser::checkFinalInput(const Input &input, Usage usage, const Token &word) {
  if (input.source == Register::Discard)
    error(DiagnosticId::RcRegister, word.span, "nothing reads discard");
  else if (usage == Usage::Alpha && input.source >= Register::TexturesEnd)
    error(DiagnosticId::RcRegister, word.span, wordOf(input.source) + " has no alpha");
  else if (usage == Usage::Alpha && input.usage == Usage::Rgb)
    error(DiagnosticId::RcComponent, word.span, "out.a reads .a or .b");
  else if (usage == Usage::Rgb && input.usage == Usage::Blue)
    error(DiagnosticId::RcComponent, word.span, "the final combiner's colours read .rgb or .a");
}

bool CombinerParser::parseFinalProduct() {
  const Span whole = {m_tokens.lastEnd(), m_tokens.lastEnd()};
  Input &e = m_state.finals[4], &f = m_state.finals[5];
  if (!expect(TokenKind::Equals, "'='") || !parseFinalInput(Usage::Rgb, e) ||
      !expect(TokenKind::Times, "'*'") || !parseFinalInput(Usage::Rgb, f))
    return false;
  for (const Input &input : {e, f})
    if (input.source == Register::ETimesF || input.source == Register::Spare0PlusSecondary)
      error(DiagnosticId::RcRegister, {whole.begin, m_tokens.lastEnd()},
            wordOf(input.source) + " cannot be a factor of final_product");
  return endStatement();
}

bool CombinerParser::parseLerp() {
  m_tokens.next();
  if (!expect(TokenKind::OpenParen, "'('"))
    return false;
  for (std::size_t v = 0; v < 3; ++v)
    if (!parseFinalInput(Usage::Rgb, m_state.finals[v]) ||
        !expect(v < 2 ? TokenKind::Comma : TokenKind::CloseParen, v < 2 ? "','" : "')'"))
      return false;
  return true;
}

/// Parses A*B + (1 - A)*C + D, of which the text may leave out parts.
bool CombinerParser::parseColor(const Token &out) {
  if (m_hasColor)
    error(DiagnosticId::RcTwice, out.span, "out.rgb is written a second time");
  m_hasColor = true;
  auto &[a, b, c, d, e, f, g] = m_state.finals;
  a = b = c = d = kZero;
  if (!expect(TokenKind::Equals, "'='"))
    return false;
  if (atWord("lerp")) {
    if (!parseLerp() || (m_tokens.accept(TokenKind::Plus) && !parseFinalInput(Usage::Rgb, d)))
      return false;
  } else {
    Input first;
    if (!parseFinalInput(Usage::Rgb, first))
      return false;
    if (m_tokens.accept(TokenKind::Times)) {
      a = first;
      if (!parseFinalInput(Usage::Rgb, b) ||
          (m_tokens.accept(TokenKind::Plus) && !parseFinalInput(Usage::Rgb, d)))
        return false;
    } else if (m_tokens.accept(TokenKind::Plus)) {
      if (atWord("lerp")) {
        if (!parseLerp())
          return false;
        d = first;
      } else {
        a = first;
        b = kOne;
        if (!parseFinalInput(Usage::Rgb, d))
          return false;
      }
    } else {
      d = first;
    }
  }
  // A cannot be color_sum, but the factors may be exchanged.
  if (a.source == Register::Spare0PlusSecondary && b.source != a.source && c == kZero)
    std::swap(a, b);
  if (a.source == Register::Spare0PlusSecondary)
    error(DiagnosticId::RcRegister, {out.span.begin, m_tokens.lastEnd()},
          "color_sum cannot be what lerp() chooses by, nor be squared");
  return endStatement("'*', '+' or ';'");
}

bool CombinerParser::parseAlpha(const Token &out) {
  if (m_hasAlpha)
    error(DiagnosticId::RcTwice, out.span, "out.a is written a second time");
  m_hasAlpha = true;
  return expect(TokenKind::Equals, "'='") && parseFinalInput(Usage::Alpha, m_state.finals[6]) &&
         endStatement();
}

} // namespace arbiter::fp::nvparse
