#include <algorithm>

#include "fp_compiler/front/parser.h"
#include "fp_compiler/front/unexpected.h"
#include "fp_compiler/front/words/numeral.h"
#include "fp_compiler/front/words/suffix.h"
#include "util/suggest.h"

namespace arbiter::fp {

namespace {

struct TargetRow {
  std::string_view word;
  ir::TexTarget target;
  bool shadow;
};

constexpr TargetRow kTargets[] = {
#define FP_TARGET(word, Enumerator, shadow, doc) {word, ir::TexTarget::Enumerator, shadow},
#include "fp_compiler/front/words/words.def"
};

std::string_view spelling(ir::TexTarget target) {
  for (const TargetRow &row : kTargets)
    if (row.target == target)
      return row.word;
  return {};
}

} // namespace

bool Parser::parseInstruction(const Token &opcode, const Word &word) {
  const ir::OpInfo &op = info(word.op);
  ir::Instruction instruction;
  instruction.op = word.op;
  m_behindOpcode = opcode.span.end;
  if (!op.has(ir::Kills)) {
    const bool loadsAddress = word.op == ir::Opcode::Arl;
    if (!expectPart(word.op, {PartKind::Destination}) ||
        !(loadsAddress ? parseAddressDestination(instruction.dst)
                       : parseDestination(instruction.dst)))
      return false;
    instruction.dst.saturate = word.saturate;
  }
  for (int i = 0; i < op.operandCount(); ++i) {
    ir::Operand &operand = instruction.src[std::size_t(i)];
    if (!expectPart(word.op, {PartKind::Operand, i}))
      return false;
    if (word.op == ir::Opcode::Swz ? !parseSwzSource(operand)
                                   : !parseSource(op.shapes[i] == 'S', operand))
      return false;
  }
  if (word.op == ir::Opcode::Swz && !parseExtendedSwizzle(instruction))
    return false;
  if (op.has(ir::Texture) && !parseTexture(instruction))
    return false;
  instruction.span = spanFrom(opcode.span.begin);
  if (!endInstruction(word.op))
    return false;
  m_binder.instruction(instruction, opcode.span);
  return true;
}

/// Expects the comma before a part of an instruction, unless it is the first, and the part itself.
bool Parser::expectPart(ir::Opcode op, Part part) {
  const bool begins = beginsInstruction(op, part);
  const auto missing = missingPart(m_tokens, m_text, begins, [this](const Token &token) {
    return beginsStatement(wordOf(token).keyword);
  });
  if (!missing)
    return begins || m_tokens.accept(TokenKind::Comma) ||
           unexpected(("',' before " + partName(op, part)).c_str());
  error(DiagnosticId::Syntax, *missing, partName(op, part) + " is missing", usageHint(op, parts()));
  return false;
}

/// Returns the hint for an instruction that has more parts than its opcode.
std::string Parser::surplusHint(ir::Opcode op) const {
  return m_tokens.at(TokenKind::Comma) ? usageHint(op, parts()) : std::string();
}

/// Parses <maskedDstReg>.
bool Parser::parseDestination(ir::Destination &destination) {
  const std::uint32_t begin = m_tokens.peek().span.begin;
  if (!parseDestinationRegister(destination))
    return false;
  if (m_tokens.accept(TokenKind::Dot) && !parseMask(destination.mask))
    return false;
  destination.span = spanFrom(begin);
  return true;
}

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
    return m_tokens.at(TokenKind::OpenBracket) ? skipIndex() : true;
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
    if (symbol->kind == SymbolKind::ParameterArray && m_tokens.at(TokenKind::OpenBracket)) {
      std::uint32_t index = 0;
      return parseIndex(UINT32_MAX, DiagnosticId::ArrayIndex, "array index", index);
    }
    return true;
  }
  if (m_tokens.at(TokenKind::OpenBracket)) {
    error(DiagnosticId::NotAnArray, m_tokens.peek().span, quote(text(first)) + " is no array");
    return false;
  }
  destination.index = symbol->index;
  m_written = symbol->size;
  return true;
}

/// Parses <maskedAddrReg>.
bool Parser::parseAddressDestination(ir::Destination &destination) {
  constexpr const char *kHint = "ARL writes a register declared with ADDRESS";
  const Token name = m_tokens.peek();
  if (name.kind != TokenKind::Identifier || wordOf(name).keyword != Keyword::None)
    return unexpected("an address register", kHint);
  m_tokens.next();
  note(name, Access::Write);
  const Symbol *symbol = m_symbols.find(text(name));
  if (!symbol && !undeclared(name))
    return false;
  const SymbolKind kind = symbol ? symbol->kind : SymbolKind::Unknown;
  if (kind == SymbolKind::Address)
    destination.index = symbol->index;
  else if (kind != SymbolKind::Unknown)
    error(DiagnosticId::AddressRegister, name.span, quote(text(name)) + " is no address register",
          kHint);
  destination.file = ir::File::Address;
  destination.mask = 1;
  if (!parseAddressComponent())
    return false;
  destination.span = spanFrom(name.span.begin);
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

/// Parses <optionalMask>, after its dot.
bool Parser::parseMask(std::uint8_t &mask) {
  if (!m_tokens.at(TokenKind::Identifier))
    return unexpected("a write mask");
  const Token token = m_tokens.next();
  const SuffixError wrong = readMask(text(token), m_language.colorLetters, mask);
  if (!wrong)
    return true;
  const std::uint32_t at = token.span.begin + wrong.offset;
  error(DiagnosticId::BadMask, {at, token.span.end},
        "bad write mask " + quote(text(token)) + ": " + wrong.reason,
        m_language.colorLetters ? "a mask names x, y, z, w, or r, g, b, a, in this order"
                                : "a mask names x, y, z, w, in this order");
  return true;
}

/// Parses <extendedSwizzle>, from the comma before it.
bool Parser::parseExtendedSwizzle(ir::Instruction &instruction) {
  ir::Operand &operand = instruction.src[0];
  char set = 0;
  operand.negate = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!expectPart(instruction.op, {PartKind::Selector, int(i)}))
      return false;
    if (m_tokens.at(TokenKind::Minus))
      operand.negate |= std::uint8_t(1u << i);
    if (m_tokens.at(TokenKind::Minus) || m_tokens.at(TokenKind::Plus))
      m_tokens.next();
    if (!m_tokens.at(TokenKind::Identifier) && !m_tokens.at(TokenKind::Integer))
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

/// Parses the word of a <texTarget>. An unknown one that begins with digits ("2d") is still one
/// word.
bool Parser::parseTarget(Token &word) {
  const TokenKind kind = m_tokens.peek().kind;
  const Token &second = m_tokens.peek(1);
  const bool split = kind == TokenKind::Integer && second.kind == TokenKind::Identifier &&
                     second.span.begin == m_tokens.peek().span.end;
  if (!split && kind != TokenKind::Identifier && kind != TokenKind::Dimension)
    return unexpected("a texture target");
  word = m_tokens.next();
  if (split)
    word.span.end = m_tokens.next().span.end;
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
  const bool inVertices = m_options.nv == ir::NvOption::Second && atWord(0, "texture");
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
  if (!parseTarget(token))
    return false;
  for (const TargetRow &candidate : kTargets)
    if (candidate.word == text(token))
      row = &candidate;
  if (!row) {
    error(DiagnosticId::UnknownTarget, token.span, "unknown texture target " + quote(text(token)),
          didYouMean(text(token),
                     {"1D", "2D", "3D", "CUBE", "RECT", "SHADOW1D", "SHADOW2D", "SHADOWRECT"},
                     "the targets are 1D, 2D, 3D, CUBE and RECT"));
    return true;
  }
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
