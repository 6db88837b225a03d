// Parses instructions of NVIDIA's own languages, and the branches of !!VP2.0 (NV_vertex_program2
// 2.14.1.8).

#include <algorithm>

#include "fp_compiler/front/native/parser.h"
#include "fp_compiler/front/unexpected.h"
#include "util/suggest.h"

namespace arbiter::fp::native {

using ir::Opcode;

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
constexpr std::string_view kUnit = "TEX0"; // in usageHint()
} // namespace

bool NativeParser::parseInstruction(const Token &opcode, const Word &word) {
  const ir::OpInfo &op = info(word.op);
  nv::Statement statement;
  ir::Instruction &instruction = statement.instruction;
  instruction.op = word.op;
  m_behindOpcode = opcode.span.end;
  m_attribute.reset();
  m_parameter.reset();
  m_scalars.clear();
  if (op.has(ir::Kills)) {
    statement.tests = true;
    instruction.src[0].file = ir::File::Parameter; // it reads no register
    if (!parseTest(statement.test))
      return false;
  } else {
    const bool loadsAddress =
        word.op == Opcode::Arl || word.op == Opcode::Arr || word.op == Opcode::Ara;
    if (!expectPart(word.op, {PartKind::Destination}) ||
        !(loadsAddress ? parseAddressDestination(instruction.dst)
                       : parseDestination(instruction.dst)) ||
        !parseConditionMask(statement.test) || !parseOperands(statement))
      return false;
  }
  instruction.dst.saturate = word.saturate;
  statement.suffix = word.nv;
  if (op.has(ir::Texture) && !parseTexture(instruction))
    return false;
  instruction.span = spanFrom(opcode.span.begin);
  const bool surplus = m_tokens.at(TokenKind::Comma) && !op.has(ir::Kills);
  if (!endStatement("';'", surplus ? usageHint(word.op, parts(), kUnit) : ""))
    return false;
  keep(statement, opcode.span);
  return true;
}

/// The comma before a part of an instruction, if it is not the first one, and something behind it.
bool NativeParser::expectPart(ir::Opcode op, Part part) {
  const bool begins = beginsInstruction(op, part);
  // A name may be a word that begins statements (newName()).
  const auto missing = missingPart(m_tokens, m_text, begins, [this](const Token &token) {
    return beginsStatement(token) && !m_named.contains(text(token));
  });
  if (!missing)
    return begins || m_tokens.accept(TokenKind::Comma) ||
           unexpected(("',' before " + partName(op, part)).c_str());
  error(DiagnosticId::Syntax, *missing, partName(op, part) + " is missing",
        usageHint(op, parts(), kUnit));
  return false;
}

bool NativeParser::parseOperands(nv::Statement &statement) {
  ir::Instruction &instruction = statement.instruction;
  const ir::OpInfo &op = info(instruction.op);
  for (int i = 0; i < op.operandCount(); ++i) {
    ir::Operand &operand = instruction.src[std::size_t(i)];
    if (!expectPart(instruction.op, {PartKind::Operand, i}))
      return false;
    bool absolute = false;
    // ARL reads a vector in !!VP2.0.
    const bool scalar =
        op.shapes[i] == 'S' && !(m_traits.addressVectors && instruction.op == Opcode::Arl);
    if (!(instruction.op == Opcode::Ara ? parseAddressSource(operand)
                                        : parseSource(scalar, operand, absolute)))
      return false;
    statement.absolute |= std::uint8_t(int(absolute) << i);
  }
  return true;
}

/// Parses <ccMask>: a rule and a swizzle.
bool NativeParser::parseTest(nv::Test &test) {
  constexpr const char *kRules = "a condition: EQ, GE, GT, LE, LT, NE, TR or FL";
  if (!m_tokens.at(TokenKind::Identifier))
    return unexpected(kRules);
  const std::optional<nv::Rule> rule = nv::ruleOf(text(m_tokens.peek()));
  if (!rule)
    return unexpected(kRules);
  m_tokens.next();
  test.rule = *rule;
  return parseSuffix(false, test.swizzle);
}

/// Parses <optionalCCMask>.
bool NativeParser::parseConditionMask(nv::Test &test) {
  return !m_traits.conditions || !acceptByte('(') || (parseTest(test) && expectByte(')'));
}

/// Parses <texImageUnit> "," <texImageTarget>, from the comma before them.
bool NativeParser::parseTexture(ir::Instruction &instruction) {
  if (!expectPart(instruction.op, {PartKind::Unit}))
    return false;
  constexpr std::uint32_t kNamed = 16; // TEX0 to TEX15
  const std::uint32_t limit = std::min(m_limits.textureImageUnits, kNamed);
  const Token unit = m_tokens.peek();
  const auto number =
      unit.kind == TokenKind::Identifier ? numberBehind(text(unit), "TEX") : std::nullopt;
  if (!number)
    return unexpected("a texture image unit: TEX0 and up");
  m_tokens.next();
  const bool there = *number < limit;
  if (!there)
    error(DiagnosticId::ImageUnit, unit.span, "there is no image unit " + quote(text(unit)),
          "units are TEX0 to TEX" + std::to_string(limit - 1));
  instruction.unit = std::uint8_t(there ? *number : 0);
  return expectPart(instruction.op, {PartKind::Target}) && parseTarget(unit.span, instruction);
}

bool NativeParser::parseTarget(Span unitSpan, ir::Instruction &instruction) {
  if (!m_tokens.at(TokenKind::Identifier) && !m_tokens.at(TokenKind::Dimension))
    return unexpected("a texture target: 1D, 2D, 3D, CUBE or RECT");
  const Token token = m_tokens.next();
  const TargetRow *row = nullptr;
  for (const TargetRow &candidate : kTargets)
    if (candidate.word == text(token) && !candidate.shadow)
      row = &candidate;
  if (!row) {
    error(DiagnosticId::UnknownTarget, token.span, "unknown texture target " + quote(text(token)),
          didYouMean(text(token), {"1D", "2D", "3D", "CUBE", "RECT"},
                     "the targets are 1D, 2D, 3D, CUBE and RECT"));
    return true;
  }
  instruction.target = row->target;
  std::optional<ir::TexTarget> &target = m_targets[instruction.unit];
  if (target && *target != row->target)
    error(DiagnosticId::TargetConflict, token.span,
          quote(at(unitSpan)) + " is sampled with another target before",
          "one texture image unit has one target in a program");
  if (!target)
    target = row->target;
  return true;
}

/// Parses a label, "name :".
bool NativeParser::parseLabel(const Token &name) {
  m_tokens.next();
  keep(m_labels.place(name.span), name.span);
  return true;
}

/// Parses BRA, CAL or RET.
bool NativeParser::parseFlow(const Token &opcode, const Word &word) {
  nv::Statement statement;
  statement.instruction.op = word.op;
  statement.instruction.dst.file = ir::File::Output; // it writes no register
  if (word.op != Opcode::Ret) {
    if (!m_tokens.at(TokenKind::Identifier))
      return unexpected("a label");
    statement.label = m_labels.numberOf(m_tokens.next().span);
  }
  if (!parseConditionMask(statement.test))
    return false;
  statement.instruction.span = spanFrom(opcode.span.begin);
  if (!endStatement())
    return false;
  keep(statement, opcode.span);
  return true;
}

/// Counts the statement. Keeps it if the program can still load.
void NativeParser::keep(const nv::Statement &statement, Span opcode) {
  const bool fits = statement.isLabel || m_binder.count(statement.instruction, opcode);
  if (fits && !m_reporter.hasErrors())
    m_statements.push_back(statement);
}

} // namespace arbiter::fp::native
