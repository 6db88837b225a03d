// Parses the parts of instructions.

#include <algorithm>

#include "fp_compiler/front/assembly/parser.h"
#include "fp_compiler/front/words/suffix.h"
#include "util/suggest.h"

namespace arbiter::fp {

using ir::Opcode;

namespace {
constexpr const char *kRules = "a condition: EQ, GE, GT, LE, LT, NE, TR or FL";
constexpr std::string_view kTargetWords[] = {"1D",   "2D",       "3D",       "CUBE",
                                             "RECT", "SHADOW1D", "SHADOW2D", "SHADOWRECT"};
constexpr std::size_t kPlainTargets = 5;

/// Returns the swizzle that applies \p before and then \p after.
ir::Swizzle composed(const ir::Swizzle &before, const ir::Swizzle &after) {
  ir::Swizzle result;
  std::transform(after.begin(), after.end(), result.begin(),
                 [&](ir::Select select) { return before[std::size_t(select)]; });
  return result;
}
} // namespace

/// Returns the place of a missing part, and consumes the comma before it. Returns nothing if the
/// part is there. The place is the semicolon or comma in the part's stead, or the end of the last
/// token if the next statement begins or the text ends. After a comma on the same line a word is
/// the part, even if a wrong one.
/// \param first true for the statement's first part, which has no comma before it
std::optional<Span> AssemblyParser::missingPart(bool first) {
  const bool comma = !first && at(TokenKind::Comma);
  const Token next = m_tokens.peek(comma ? 1 : 0);
  const bool stops =
      next.kind == TokenKind::Semicolon || (next.kind == TokenKind::Comma && (first || comma));
  const std::uint32_t end = comma ? m_tokens.peek().span.end : m_tokens.lastEnd();
  const bool ends = next.kind == TokenKind::EndOfText ||
                    (endsParts(next) && (!comma || isOnLaterLine(m_text, end, next.span.begin)));
  if (!stops && !ends)
    return std::nullopt;
  if (comma)
    m_tokens.next();
  return stops ? next.span : Span{end, end};
}

/// Expects the comma before a part of an instruction, unless it is the first, and the part itself.
bool AssemblyParser::expectPart(Opcode op, Part part) {
  const bool begins = beginsInstruction(op, part);
  const auto missing = missingPart(begins);
  if (!missing)
    return begins || expect(TokenKind::Comma, ("',' before " + partName(op, part)).c_str());
  error(DiagnosticId::Syntax, *missing, partName(op, part) + " is missing",
        usageHint(op, parts(), m_style.unit));
  return false;
}

/// Returns the hint for an instruction that has more parts than its opcode.
std::string AssemblyParser::surplusHint(Opcode op) const {
  return at(TokenKind::Comma) ? usageHint(op, parts(), m_style.unit) : std::string();
}

bool AssemblyParser::parseDestinationPart(nv::Statement &statement) {
  ir::Instruction &instruction = statement.instruction;
  const bool loadsAddress = instruction.op == Opcode::Arl || instruction.op == Opcode::Arr ||
                            instruction.op == Opcode::Ara;
  return expectPart(instruction.op, {PartKind::Destination}) &&
         (loadsAddress ? parseAddressDestination(instruction.dst)
                       : parseDestination(instruction.dst));
}

/// Parses <maskedDstReg>.
bool AssemblyParser::parseDestination(ir::Destination &destination) {
  const std::uint32_t begin = m_tokens.peek().span.begin;
  if (!parseDestinationRegister(destination) ||
      (m_tokens.accept(TokenKind::Dot) && !parseMask(destination.mask)))
    return false;
  destination.span = spanFrom(begin);
  return true;
}

/// Parses <maskedAddrReg>: any components of a vector, or the one component x.
bool AssemblyParser::parseAddressDestination(ir::Destination &destination) {
  const std::uint32_t begin = m_tokens.peek().span.begin;
  const auto row = takeAddress(Access::Write);
  if (!row)
    return false;
  destination.file = ir::File::Address;
  destination.index = *row;
  if (hasAddressVectors()) {
    if (m_tokens.accept(TokenKind::Dot) && !parseMask(destination.mask))
      return false;
  } else {
    std::uint8_t component = 0;
    if (!parseAddressComponent(component))
      return false;
    destination.mask = 1;
  }
  destination.span = spanFrom(begin);
  return true;
}

/// Parses <optionalMask>, after its dot.
bool AssemblyParser::parseMask(std::uint8_t &mask) {
  Token token;
  if (!expectWord("a write mask", token))
    return false;
  if (const SuffixError wrong = readMask(text(token), m_style.colors, mask))
    error(DiagnosticId::BadMask, {token.span.begin + wrong.offset, token.span.end},
          "bad write mask " + quote(text(token)) + ": " + wrong.reason,
          m_style.colors ? "a mask names x, y, z, w, or r, g, b, a, in this order"
                         : "a mask names x, y, z, w, in this order");
  return true;
}

bool AssemblyParser::parseOperands(nv::Statement &statement) {
  const Opcode op = statement.instruction.op;
  for (int i = 0; i < info(op).operandCount(); ++i)
    if (!expectPart(op, {PartKind::Operand, i}) || !parseOperand(statement, i))
      return false;
  return true;
}

bool AssemblyParser::parseOperand(nv::Statement &statement, int number) {
  const Opcode op = statement.instruction.op;
  ir::Operand &operand = statement.instruction.src[std::size_t(number)];
  if (op == Opcode::Ara)
    return parseAddressSource(operand);
  const bool scalar = info(op).shapes[number] == 'S' && !(op == Opcode::Arl && hasAddressVectors());
  bool absolute = false;
  if (!parseSource(scalar, operand, absolute))
    return false;
  statement.absolute |= std::uint8_t(int(absolute) << number);
  return true;
}

/// Parses an operand with its sign, bars and suffix. Within bars the suffix is inside, and signs
/// may be on both sides. The component of a scalar is repeated.
bool AssemblyParser::parseSource(bool scalar, ir::Operand &operand, bool &absolute) {
  const std::uint32_t begin = m_tokens.peek().span.begin;
  const auto sign = [&] { return (hasPlusSigns() || !at(TokenKind::Plus)) && acceptSign(); };
  bool negative = sign();
  absolute = hasConditions() && acceptByte('|');
  Base base{operand, scalar, absolute, negative, absolute ? sign() : negative};
  ir::Swizzle suffix = ir::kIdentity;
  if (!parseBase(base) || (base.hasSuffix && !parseSwizzle(scalar, suffix, begin)) ||
      (absolute && !expectByte('|')))
    return false;
  operand.swizzle = composed(operand.swizzle, suffix);
  operand.negate = negative ? 0xF : 0;
  operand.span = spanFrom(begin);
  return true;
}

/// Parses a whole address register, which ARA and PUSHA read.
bool AssemblyParser::parseAddressSource(ir::Operand &operand) {
  const Span where = m_tokens.peek().span;
  const auto row = takeAddress(Access::Read);
  if (!row)
    return false;
  operand.file = ir::File::Address;
  operand.index = *row;
  operand.span = where;
  return true;
}

/// Parses <addrComponent>, with its dot.
bool AssemblyParser::parseAddressComponent(std::uint8_t &component) {
  if (!expect(TokenKind::Dot, m_style.addressDot, m_style.addressHint))
    return false;
  const Token token = m_tokens.peek();
  if (!expect(TokenKind::Identifier, m_style.addressComponent, m_style.addressHint))
    return false;
  const std::size_t found = std::string_view("xyzw").find(text(token));
  const bool there = text(token).size() == 1 && found < 4 && (found == 0 || hasAddressVectors());
  if (!there)
    error(DiagnosticId::AddressComponent, token.span,
          "an address register has no component " + quote(text(token)), m_style.addressAdvice);
  component = std::uint8_t(there ? found : 0);
  return true;
}

/// Parses <optionalSuffix> or <scalarSuffix>, with its dot.
/// \param begin of a scalar operand, for the hint
bool AssemblyParser::parseSwizzle(bool scalar, ir::Swizzle &swizzle, std::uint32_t begin) {
  if (!m_tokens.accept(TokenKind::Dot)) {
    if (scalar)
      error(DiagnosticId::ScalarSuffix, m_tokens.peek().span,
            "this operand is a scalar and needs one component",
            componentHint(m_text.substr(begin, m_tokens.lastEnd() - begin)));
    return true;
  }
  Token token;
  if (!expectWord("a component", token))
    return false;
  if (const SuffixError wrong = readSwizzle(text(token), m_style.colors, scalar, swizzle))
    error(scalar ? DiagnosticId::ScalarSuffix : DiagnosticId::BadSwizzle,
          {token.span.begin + wrong.offset, token.span.end},
          "bad suffix " + quote(text(token)) + ": " + wrong.reason,
          suffixHint(text(token), scalar));
  return true;
}

std::string AssemblyParser::suffixHint(std::string_view, bool scalar) const {
  std::string hint =
      scalar ? "a scalar operand takes one of x, y, z, w" : "a suffix is one or four of x, y, z, w";
  if (!m_style.colors)
    return hint;
  return hint + (scalar ? " or r, g, b, a" : ", or of r, g, b, a");
}

/// Parses <ccTest>: a rule and a swizzle.
bool AssemblyParser::parseTest(nv::Test &test) {
  if (!at(TokenKind::Identifier))
    return unexpected(kRules);
  std::string_view word = text(m_tokens.peek());
  const bool numbered =
      hasSecondCondition() && word.size() == 3 && (word[2] == '0' || word[2] == '1');
  test.condition = numbered && word[2] == '1' ? 1 : 0;
  const std::optional<nv::Rule> rule = nv::ruleOf(numbered ? word.substr(0, 2) : word);
  if (!rule)
    return unexpected(kRules);
  m_tokens.next();
  test.rule = *rule;
  return parseSwizzle(false, test.swizzle);
}

/// Parses <ccMask>, if there is one.
bool AssemblyParser::parseConditionMask(nv::Test &test) {
  return !hasConditions() || !acceptByte('(') || (parseTest(test) && expectByte(')'));
}

/// Parses a texture target. `row` is null after an error about an unknown one.
/// \param expected in place of a token that can be none
bool AssemblyParser::parseTarget(const char *expected, bool shadows, Token &word,
                                 const TargetRow *&row) {
  word = m_tokens.peek();
  const Token second = m_tokens.peek(1);
  const bool split = shadows && word.kind == TokenKind::Integer &&
                     second.kind == TokenKind::Identifier && second.span.begin == word.span.end;
  if (!split && word.kind != TokenKind::Identifier && word.kind != TokenKind::Dimension)
    return unexpected(expected);
  m_tokens.next();
  if (split)
    word.span.end = m_tokens.next().span.end;
  row = findTarget(text(word));
  row = row && row->shadow && !shadows ? nullptr : row;
  const std::span<const std::string_view> words(kTargetWords);
  if (!row)
    error(DiagnosticId::UnknownTarget, word.span, "unknown texture target " + quote(text(word)),
          didYouMean(text(word), shadows ? words : words.first(kPlainTargets),
                     "the targets are 1D, 2D, 3D, CUBE and RECT"));
  return true;
}

} // namespace arbiter::fp
