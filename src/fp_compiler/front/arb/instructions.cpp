#include <algorithm>

#include "fp_compiler/front/arb/parser.h"
#include "fp_compiler/front/words/suffix.h"

namespace arbiter::fp {

bool Parser::parseDestinationRegister(ir::Destination &destination) {
  const Token first = m_tokens.peek();
  const Word word = keywordAt();
  if (word.keyword == Keyword::Result) {
    destination.file = ir::File::Output;
    return parseResultBinding(Place::Operand, destination.index);
  }
  if (first.kind != TokenKind::Identifier || word.keyword != Keyword::None)
    return readOnlyDestination(first, word);
  m_tokens.next();
  note(first, Access::Write);
  const Symbol *symbol = m_symbols.find(text(first));
  if (!symbol)
    return undeclared(first);
  switch (symbol->kind) {
  case SymbolKind::Temporary:
    destination.file = ir::File::Temporary;
    break;
  case SymbolKind::Output:
    destination.file = ir::File::Output;
    break;
  case SymbolKind::Unknown:
    return at(TokenKind::OpenBracket) ? skipIndex() : true;
  case SymbolKind::Address:
    error(DiagnosticId::AddressRegister, first.span,
          "the address register " + quote(text(first)) + " is written by ARL only",
          "compute in a temporary and load it with ARL");
    return true;
  case SymbolKind::Attribute:
  case SymbolKind::Parameter:
  case SymbolKind::ParameterArray:
    error(DiagnosticId::ReadOnly, first.span,
          std::string(symbol->kind == SymbolKind::Attribute ? "the attribute " : "the parameter ") +
              quote(text(first)) + " cannot be written",
          "write a temporary or a result");
    if (symbol->kind == SymbolKind::ParameterArray && at(TokenKind::OpenBracket)) {
      std::uint32_t index = 0;
      return parseIndex(UINT32_MAX, DiagnosticId::ArrayIndex, "array index", index);
    }
    return true;
  }
  if (at(TokenKind::OpenBracket)) {
    error(DiagnosticId::NotAnArray, m_tokens.peek().span, quote(text(first)) + " is no array");
    return false;
  }
  destination.index = symbol->index;
  m_written = symbol->size;
  return true;
}

/// Reports a destination that is read only and does not begin with a name or "result".
bool Parser::readOnlyDestination(const Token &first, const Word &word) {
  const bool attribute = word.keyword == Keyword::Attributes;
  const bool parameter = word.keyword == Keyword::State || word.keyword == Keyword::Program ||
                         first.kind == TokenKind::OpenBrace || first.kind == TokenKind::Integer ||
                         first.kind == TokenKind::Float;
  if (!attribute && !parameter)
    return unexpected("a temporary or a result");
  error(DiagnosticId::ReadOnly, first.span,
        attribute ? "an attribute cannot be written" : "a parameter cannot be written",
        "write a temporary or a result");
  ir::Operand ignored;
  return parseSourceRegister(ignored);
}

/// Parses <extendedSwizzle>, from the comma before it.
bool Parser::parseExtendedSwizzle(ir::Instruction &instruction) {
  ir::Operand &operand = instruction.src[0];
  char set = 0;
  operand.negate = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!expectPart(instruction.op, {PartKind::Selector, int(i)}))
      return false;
    if (acceptSign())
      operand.negate |= std::uint8_t(1u << i);
    if (!at(TokenKind::Identifier) && !at(TokenKind::Integer))
      return unexpected("0, 1 or a component");
    const Token token = m_tokens.next();
    const SuffixError wrong =
        readSelector(text(token), m_language.colorLetters, set, operand.swizzle[i]);
    if (wrong)
      error(DiagnosticId::SwzSelector, {token.span.begin + wrong.offset, token.span.end},
            "bad selector " + quote(text(token)) + ": " + wrong.reason,
            m_language.colorLetters ? "SWZ selects by 0, 1, and x, y, z, w or r, g, b, a"
                                    : "SWZ selects by 0, 1, and x, y, z, w");
  }
  operand.span.end = m_tokens.lastEnd();
  return true;
}

/// Returns the hint for something else in place of a texture image unit: "0" or "tex0".
std::string Parser::unitHint() const {
  const std::string_view word = text(m_tokens.peek());
  const std::size_t digits = std::min(word.find_last_not_of("0123456789") + 1, word.size());
  const bool numbered = word.size() > digits && word.size() < digits + 3;
  return "write texture[" + std::string(numbered ? word.substr(digits) : "0") +
         "]: the units have numbers and no names";
}

/// Parses <texImageUnit> "," <texTarget>, from the comma before them.
bool Parser::parseTexture(ir::Instruction &instruction) {
  if (!expectPart(instruction.op, {PartKind::Unit}))
    return false;
  const bool inVertices = isSecondNv() && atWord("texture");
  if (keywordAt().keyword != Keyword::Texture && !inVertices)
    return unexpected("texture[n]", unitHint());
  m_tokens.next();
  std::uint32_t unit = 0;
  const std::size_t errorsBefore = m_reporter.errorCount();
  if (!parseOptionalIndex(byteLimit(m_limits.textureImageUnits), DiagnosticId::ImageUnit,
                          "texture image unit", unit) ||
      !expectPart(instruction.op, {PartKind::Target}))
    return false;
  const bool unitKnown = m_reporter.errorCount() == errorsBefore;
  const TargetRow *row = nullptr;
  Token token;
  if (!parseTarget("a texture target", true, token, row))
    return false;
  if (!row)
    return true;
  if (row->shadow && !m_options.shadow)
    error(DiagnosticId::ShadowTarget, token.span,
          std::string(row->word) + " needs a program option",
          "add OPTION ARB_fragment_program_shadow;");
  instruction.unit = std::uint8_t(unit);
  instruction.target = row->target;
  if (!unitKnown)
    return true;
  if (m_units.size() <= unit)
    m_units.resize(unit + 1);
  UnitUse &use = m_units[unit];
  if (use.used && use.target != row->target)
    error(DiagnosticId::TargetConflict, token.span,
          "texture[" + std::to_string(unit) + "] is sampled as " + std::string(row->word) +
              " and before as " + std::string(spelling(use.target)),
          "one texture image unit has one target in a program");
  use = {true, use.used ? use.target : row->target};
  return true;
}

} // namespace arbiter::fp
