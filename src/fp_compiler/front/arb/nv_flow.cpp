// Parses labels, blocks, branches, and indexes by an address register: NV_fragment_program2 3.11.4,
// NV_vertex_program2_option 2.14.4, NV_vertex_program3 2.14.3.

#include <algorithm>

#include "fp_compiler/front/arb/parser.h"
#include "fp_compiler/front/nv/lowering.h"
#include "fp_compiler/nv_limits.h"

namespace arbiter::fp {

using ir::Opcode;

/// Parses a label, "name :". It may not be in a block.
bool Parser::parseBlockLabel(const Token &name) {
  if (!m_blocks.empty())
    error(DiagnosticId::NvFlow, name.span,
          "the label " + quote(text(name)) + " is inside of a block",
          "a subroutine begins outside of IF, LOOP and REP");
  return parseLabel(name);
}

/// Parses ELSE, ENDIF, ENDLOOP or ENDREP. The innermost block must be one that it can end.
bool Parser::endBlock(const Token &opcode, Opcode op) {
  const Opcode ended = m_blocks.empty() ? Opcode::Mov : m_blocks.back().begin;
  const bool fits = op == Opcode::Else      ? ended == Opcode::If
                    : op == Opcode::Endif   ? ended == Opcode::If || ended == Opcode::Else
                    : op == Opcode::Endloop ? ended == Opcode::Loop
                                            : ended == Opcode::Rep;
  if (!fits) {
    error(DiagnosticId::NvFlow, opcode.span,
          std::string(info(op).mnemonic) + " does not fit the innermost block",
          m_blocks.empty()
              ? "no block is open here"
              : "that one begins with " + std::string(info(m_blocks.back().begin).mnemonic) +
                    " in line " + std::to_string(locate(m_text, m_blocks.back().where.begin).line));
    return false;
  }
  m_blocks.pop_back();
  if (op == Opcode::Else)
    m_blocks.push_back({Opcode::Else, opcode.span});
  return true;
}

/// Parses the operand of LOOP or REP: a parameter, state or a constant.
bool Parser::beginLoop(nv::Statement &statement) {
  ir::Operand &operand = statement.instruction.src[0];
  const Token first = m_tokens.peek();
  bool absolute = false;
  if (!parseSource(false, operand, absolute))
    return false;
  statement.absolute = absolute ? 1 : 0;
  if (operand.file != ir::File::Parameter || operand.relative)
    error(DiagnosticId::NvFlow, first.span, "a loop's operand is no parameter",
          "write a parameter, state or a constant here");
  if (m_blocks.size() > nv::kMaxBlocks)
    error(DiagnosticId::NvFlow, first.span,
          "more than " + std::to_string(nv::kMaxBlocks) + " blocks, one in the other");
  return true;
}

/// Parses PUSHA or POPA, which take a whole address register and no condition.
bool Parser::parseStack(nv::Statement &statement) {
  ir::Instruction &instruction = statement.instruction;
  if (instruction.op == Opcode::Pusha)
    return parseAddressSource(instruction.src[0]);
  if (!parseAddressDestination(instruction.dst))
    return false;
  if (instruction.dst.mask != 0xF)
    error(DiagnosticId::BadMask, instruction.dst.span, "POPA writes all of an address register",
          "pop into another one and move what is wanted");
  const Span condition = m_tokens.peek().span;
  if (!parseConditionMask(statement.test))
    return false;
  if (statement.test.rule != nv::Rule::Tr)
    error(DiagnosticId::NvFlow, condition, "POPA under a condition", "branch around it");
  return true;
}

bool Parser::parseFlowParts(nv::Statement &statement, const Token &opcode) {
  const Opcode op = statement.instruction.op;
  bool parsed = true;
  switch (op) {
  case Opcode::If:
    parsed = parseTest(statement.test);
    m_blocks.push_back({op, opcode.span});
    return parsed;
  case Opcode::Loop:
  case Opcode::Rep:
    parsed = beginLoop(statement);
    m_blocks.push_back({op, opcode.span});
    return parsed;
  case Opcode::Else:
  case Opcode::Endif:
  case Opcode::Endloop:
  case Opcode::Endrep:
    return endBlock(opcode, op);
  case Opcode::Brk:
    if (std::none_of(m_blocks.begin(), m_blocks.end(), [](const Block &block) {
          return block.begin == Opcode::Loop || block.begin == Opcode::Rep;
        }))
      error(DiagnosticId::NvFlow, opcode.span, "BRK outside of a loop",
            "it ends the innermost LOOP or REP");
    return parseConditionMask(statement.test);
  case Opcode::Bra:
  case Opcode::Cal:
  case Opcode::Ret:
    return AssemblyParser::parseFlowParts(statement, opcode);
  default:
    return parseStack(statement);
  }
}

/// True at a binding's index that is an address register: "[" A0 "." x.
bool Parser::atAddress() const {
  return m_mayIndex && isSecondNv() && at(TokenKind::OpenBracket) &&
         m_tokens.peek(1).kind == TokenKind::Identifier;
}

/// Parses "[" <addrReg> "." <component> (("+" | "-") <integer>)? "]" of a binding. In fragment
/// programs the register is A0, which has only x and takes no negative values.
/// \param sequence of the `count` rows that `bind` returns, which is made at its first use
bool Parser::parseIndexed(std::optional<std::uint16_t> &sequence, std::uint32_t count,
                          const std::function<std::uint16_t(std::uint8_t)> &bind) {
  if (!sequence) {
    sequence = std::uint16_t(m_sequences.size());
    std::vector<std::uint16_t> &rows = m_sequences.emplace_back();
    for (std::uint32_t i = 0; i < byteLimit(count); ++i)
      rows.push_back(bind(std::uint8_t(i)));
  }
  m_tokens.next();
  const Token name = m_tokens.next();
  const bool vertex = isVertex();
  nv::Indexed indexed;
  if (vertex) {
    const auto address = addressOf(name, Access::Read, "declare one with ADDRESS");
    if (!address)
      return false;
    indexed.address = std::uint8_t(*address);
  } else if (text(name) != "A0") {
    return unexpectedToken(name, "an integer or A0");
  }
  std::uint8_t component = 0;
  if (!parseAddressComponent(component))
    return false;
  indexed.address = std::uint8_t(indexed.address + component);
  constexpr std::uint32_t kMaxOffset = 9;
  if (!vertex && m_tokens.accept(TokenKind::Plus)) {
    std::uint32_t offset = 0;
    if (!parseBounded(kMaxOffset + 1, DiagnosticId::RelativeOffset, "offset", offset))
      return false;
    indexed.offset = std::int16_t(offset);
  } else if (vertex && !parseRelativeOffset(indexed.offset)) {
    return false;
  }
  indexed.sequence = *sequence;
  m_indexed = indexed;
  return expect(TokenKind::CloseBracket, "']'");
}

/// Finishes the program: checks the blocks and labels, then lowers the statements.
void Parser::finish(Span end) {
  if (!isNv())
    return;
  if (!m_blocks.empty())
    error(DiagnosticId::NvFlow, end, "the program ends inside of a block",
          "the block of line " + std::to_string(locate(m_text, m_blocks.back().where.begin).line) +
              " has no end");
  m_labels.check();
  if (m_reporter.hasErrors())
    return;
  nv::NativeRules rules;
  rules.vertex = isVertex();
  nv::lower(m_statements, m_labels.start(), m_sequences, m_binder, m_reporter, rules);
}

} // namespace arbiter::fp
