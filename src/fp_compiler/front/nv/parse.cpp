// Statements of NVIDIA's options: NV_fragment_program_option 3.11.2,
// NV_vertex_program2_option 2.14.2 and what follows them. The ARB grammar's parts are those of the
// other files of the parser.

#include <algorithm>
#include <utility>

#include "fp_compiler/front/nv/lowering.h"
#include "fp_compiler/front/parser.h"
#include "fp_compiler/front/words/suffix.h"
#include "fp_compiler/front/words/suggest.h"

namespace arbiter::fp {

using ir::Opcode;

/// A byte that is no token of the ARB grammar: a bar, a colon or a parenthesis.
bool Parser::atByte(char byte, int ahead) const {
  const Token &token = m_tokens.peek(ahead);
  return token.kind == TokenKind::InvalidByte && m_text[token.span.begin] == byte;
}

bool Parser::acceptByte(char byte) {
  if (!atByte(byte))
    return false;
  m_tokens.next();
  return true;
}

bool Parser::expectByte(char byte) {
  return acceptByte(byte) || unexpected((std::string("'") + byte + "'").c_str());
}

/// <varSize> before TEMP or OUTPUT: a free name elsewhere.
bool Parser::atSize() const {
  const bool offered =
      m_options.nv != ir::NvOption::None && m_language.language == ir::Language::ArbFragment;
  return offered && (atWord(0, "SHORT") || atWord(0, "LONG")) &&
         (atWord(1, "TEMP") || atWord(1, "OUTPUT"));
}

bool Parser::parseSized() {
  m_size = text(m_tokens.next()) == "SHORT" ? RegisterSize::Short : RegisterSize::Long;
  const bool parsed =
      text(m_tokens.next()) == "TEMP" ? parseRegisters(SymbolKind::Temporary) : parseOutput();
  m_size = RegisterSize::Long;
  return parsed;
}

/// <ccTest>: a rule and a swizzle.
bool Parser::parseTest(nv::Test &test) {
  constexpr const char *kRules = "a condition: EQ, GE, GT, LE, LT, NE, TR or FL";
  if (!m_tokens.at(TokenKind::Identifier))
    return unexpected(kRules);
  std::string_view word = text(m_tokens.peek());
  const bool numbered = m_language.language == ir::Language::ArbVertex &&
                        m_options.nv == ir::NvOption::Second && word.size() == 3 &&
                        (word[2] == '0' || word[2] == '1');
  test.condition = numbered && word[2] == '1' ? 1 : 0;
  const std::optional<nv::Rule> rule = nv::ruleOf(numbered ? word.substr(0, 2) : word);
  if (!rule)
    return unexpected(kRules);
  m_tokens.next();
  test.rule = *rule;
  return parseSwizzle(false, test.swizzle);
}

/// <ccMask>, where there is one.
bool Parser::parseConditionMask(nv::Test &test) {
  return !acceptByte('(') || (parseTest(test) && expectByte(')'));
}

/// <instOperandV> or <instOperandS>: within bars the swizzle is inside, and signs are on both
/// sides.
bool Parser::parseNvSource(bool scalar, ir::Operand &operand, bool &absolute) {
  const std::uint32_t begin = m_tokens.peek().span.begin;
  const auto sign = [&] {
    const bool negative = m_tokens.at(TokenKind::Minus);
    if (negative || m_tokens.at(TokenKind::Plus))
      m_tokens.next();
    return negative;
  };
  bool negative = sign();
  absolute = acceptByte('|');
  if (absolute)
    static_cast<void>(sign()); // the bars undo it
  const TokenKind kind = m_tokens.peek().kind;
  const bool number = kind == TokenKind::Integer || kind == TokenKind::Float;
  // A number stands for itself in every component and takes no suffix.
  m_mayIndex = true;
  m_indexed.reset();
  const bool read = parseSourceRegister(operand);
  m_mayIndex = false;
  if (!read || (!number && !parseSwizzle(scalar, operand.swizzle)))
    return false;
  if (absolute && !expectByte('|'))
    return false;
  if (number && scalar)
    operand.swizzle.fill(ir::Select::X); // all four are the same
  operand.negate = negative ? 0xF : 0;
  operand.span = spanFrom(begin);
  return true;
}

bool Parser::parseNvOperands(nv::Statement &statement) {
  ir::Instruction &instruction = statement.instruction;
  const ir::OpInfo &op = info(instruction.op);
  for (int i = 0; i < op.operandCount(); ++i) {
    ir::Operand &operand = instruction.src[std::size_t(i)];
    if (i > 0 && !expect(TokenKind::Comma, "','"))
      return false;
    bool absolute = false;
    // ARL takes a vector here.
    const bool scalar = op.shapes[i] == 'S' && instruction.op != Opcode::Arl;
    const bool parsed = instruction.op == Opcode::Ara   ? parseAddressSource(operand)
                        : instruction.op == Opcode::Swz ? parseNvSwzSource(operand, absolute)
                                                        : parseNvSource(scalar, operand, absolute);
    if (!parsed)
      return false;
    statement.absolute |= std::uint8_t(int(absolute) << i);
    statement.indexed[std::size_t(i)] = std::exchange(m_indexed, {});
  }
  return true;
}

/// SWZ's operand, which may stand within bars.
bool Parser::parseNvSwzSource(ir::Operand &operand, bool &absolute) {
  absolute = acceptByte('|');
  return parseSwzSource(operand) && (!absolute || expectByte('|'));
}

/// <addrRegisterOperand> of ARA: a whole address register.
bool Parser::parseAddressSource(ir::Operand &operand) {
  const Token name = m_tokens.peek();
  if (name.kind != TokenKind::Identifier || wordOf(name).keyword != Keyword::None)
    return unexpected("an address register");
  m_tokens.next();
  note(name, Access::Read);
  const Symbol *symbol = m_symbols.find(text(name));
  if (!symbol && !undeclared(name))
    return false;
  if (symbol && symbol->kind != SymbolKind::Address && symbol->kind != SymbolKind::Unknown)
    error(DiagnosticId::AddressRegister, name.span, quote(text(name)) + " is no address register",
          "declare one with ADDRESS");
  operand.file = ir::File::Address;
  operand.index = symbol && symbol->kind == SymbolKind::Address ? symbol->index : 0;
  operand.span = name.span;
  return true;
}

/// <maskedAddrReg>: any components.
bool Parser::parseNvAddressDestination(ir::Destination &destination) {
  const Token name = m_tokens.peek();
  ir::Operand address;
  if (!parseAddressSource(address))
    return false;
  destination.file = ir::File::Address;
  destination.index = address.index;
  if (m_tokens.accept(TokenKind::Dot) && !parseMask(destination.mask))
    return false;
  destination.span = spanFrom(name.span.begin);
  return true;
}

bool Parser::parseNvDestination(nv::Statement &statement) {
  ir::Instruction &instruction = statement.instruction;
  const bool address = instruction.op == Opcode::Arl || instruction.op == Opcode::Arr ||
                       instruction.op == Opcode::Ara;
  m_written = RegisterSize::Long;
  m_mayIndex = true;
  m_indexed.reset();
  if (!(address ? parseNvAddressDestination(instruction.dst) : parseDestination(instruction.dst)))
    return false;
  m_mayIndex = false;
  statement.indexedResult = std::exchange(m_indexed, {});
  if (instruction.dst.file == ir::File::Output && !statement.indexedResult)
    checkSize(instruction.dst);
  return parseConditionMask(statement.test) && expect(TokenKind::Comma, "','");
}

/// Instructions may not write one result under two sizes (NV_fragment_program_option 3.11.3.4).
void Parser::checkSize(const ir::Destination &destination) {
  const auto [entry, isNew] = m_resultSizes.try_emplace(destination.index, m_written);
  if (!isNew && entry->second != m_written)
    error(DiagnosticId::NvResultSize, destination.span,
          "this result is written as SHORT and as LONG", "declare it once, with one size");
}

bool Parser::parseNvInstruction(const Token &opcode, const Word &word) {
  const ir::OpInfo &op = info(word.op);
  if (op.has(ir::Flow))
    return parseNvFlow(opcode, word);
  nv::Statement statement;
  ir::Instruction &instruction = statement.instruction;
  instruction.op = word.op;
  instruction.dst.saturate = word.saturate;
  statement.suffix = word.nv;
  const bool kills = op.has(ir::Kills);
  statement.tests =
      kills && m_tokens.at(TokenKind::Identifier) && nv::ruleOf(text(m_tokens.peek())).has_value();
  if (statement.tests)
    instruction.src[0].file = ir::File::Parameter; // it reads no register
  if (statement.tests ? !parseTest(statement.test)
                      : !((kills || parseNvDestination(statement)) && parseNvOperands(statement)))
    return false;
  if (word.op == Opcode::Swz && !parseExtendedSwizzle(instruction.src[0]))
    return false;
  if (op.has(ir::Texture) && !parseTexture(instruction))
    return false;
  instruction.span = spanFrom(opcode.span.begin);
  if (!expect(TokenKind::Semicolon, "';'"))
    return false;
  keep(statement, opcode.span);
  return true;
}

/// Counts the statement, and keeps it if the program may still come to something.
void Parser::keep(const nv::Statement &statement, Span opcode) {
  const bool fits = statement.isLabel || m_binder.count(statement.instruction, opcode);
  if (fits && !m_reporter.hasErrors())
    m_statements.push_back(statement);
}

/// A statement that begins with no word of the option.
bool Parser::unknownNvStatement(const Token &first) {
  const std::string_view word = text(first);
  const bool vertex = m_language.language == ir::Language::ArbVertex;
  std::string message = "unknown instruction " + quote(word), hint;
  if (!vertex && (word == "SHORT" || word == "LONG")) {
    message = std::string(word) + " stands before TEMP or OUTPUT";
  } else if (const auto base = nv::baseOf(word, m_language, m_options.nv)) {
    hint = std::string(info(*base).mnemonic) + " has no such suffix here";
  } else if (m_options.nv == ir::NvOption::First &&
             nv::classify(word, m_language, ir::NvOption::Second).keyword == Keyword::Opcode) {
    hint = std::string("OPTION ") + (vertex ? "NV_vertex_program3" : "NV_fragment_program2") +
           " has it";
  } else {
    hint = didYouMean(word, statementWords(m_language));
  }
  error(DiagnosticId::UnknownInstruction, first.span, std::move(message), std::move(hint));
  return false;
}

/// "name :", before what a branch goes on with.
bool Parser::parseLabel(const Token &name) {
  m_tokens.next();
  if (!m_blocks.empty())
    error(DiagnosticId::NvFlow, name.span,
          "the label " + quote(text(name)) + " is inside of a block",
          "a subroutine begins outside of IF, LOOP and REP");
  Label &label = labelOf(name);
  if (label.placed)
    error(DiagnosticId::RedeclaredName, name.span,
          "the label " + quote(text(name)) + " stands twice", "rename one of the two");
  label.placed = true;
  nv::Statement statement;
  statement.isLabel = true;
  statement.label = std::uint16_t(&label - m_labels.data());
  statement.instruction.span = name.span;
  keep(statement, name.span);
  return true;
}

Parser::Label &Parser::labelOf(const Token &name) {
  const auto [entry, isNew] =
      m_labelNumbers.try_emplace(text(name), std::uint16_t(m_labels.size()));
  if (isNew)
    m_labels.push_back({name.span, false});
  return m_labels[entry->second];
}

/// ELSE, ENDIF, ENDLOOP, ENDREP: what they end must be the innermost block.
bool Parser::endBlock(const Token &opcode, const Word &word) {
  const Opcode ended = m_blocks.empty() ? Opcode::Mov : m_blocks.back().begin;
  const bool fits = word.op == Opcode::Else      ? ended == Opcode::If
                    : word.op == Opcode::Endif   ? ended == Opcode::If || ended == Opcode::Else
                    : word.op == Opcode::Endloop ? ended == Opcode::Loop
                                                 : ended == Opcode::Rep;
  if (!fits) {
    error(DiagnosticId::NvFlow, opcode.span,
          std::string(info(word.op).mnemonic) + " does not fit the innermost block",
          m_blocks.empty()
              ? "no block is open here"
              : "that one begins with " + std::string(info(m_blocks.back().begin).mnemonic) +
                    " in line " + std::to_string(locate(m_text, m_blocks.back().where.begin).line));
    return false;
  }
  m_blocks.pop_back();
  if (word.op == Opcode::Else)
    m_blocks.push_back({Opcode::Else, opcode.span});
  return true;
}

/// The operand of LOOP or REP: a parameter, state or a constant.
bool Parser::beginLoop(nv::Statement &statement) {
  constexpr std::size_t kMostBlocks = 256;
  ir::Operand &operand = statement.instruction.src[0];
  const Token first = m_tokens.peek();
  bool absolute = false;
  if (!parseNvSource(false, operand, absolute))
    return false;
  statement.absolute = absolute ? 1 : 0;
  if (operand.file != ir::File::Parameter || operand.relative)
    error(DiagnosticId::NvFlow, first.span, "a loop's operand is no parameter",
          "write a parameter, state or a constant here");
  if (m_blocks.size() > kMostBlocks)
    error(DiagnosticId::NvFlow, first.span, "more than 256 blocks, one in the other");
  return true;
}

/// PUSHA and POPA: of whole address registers, and always.
bool Parser::parseStack(nv::Statement &statement) {
  ir::Instruction &instruction = statement.instruction;
  if (instruction.op == Opcode::Pusha)
    return parseAddressSource(instruction.src[0]);
  if (!parseNvAddressDestination(instruction.dst))
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

bool Parser::parseNvFlow(const Token &opcode, const Word &word) {
  nv::Statement statement;
  statement.instruction.op = word.op;
  statement.instruction.dst.file = ir::File::Output; // it writes no register
  bool parsed = true;
  switch (word.op) {
  case Opcode::If:
    parsed = parseTest(statement.test);
    m_blocks.push_back({word.op, opcode.span});
    break;
  case Opcode::Loop:
  case Opcode::Rep:
    parsed = beginLoop(statement);
    m_blocks.push_back({word.op, opcode.span});
    break;
  case Opcode::Else:
  case Opcode::Endif:
  case Opcode::Endloop:
  case Opcode::Endrep:
    parsed = endBlock(opcode, word);
    break;
  case Opcode::Brk:
    if (std::none_of(m_blocks.begin(), m_blocks.end(), [](const Block &block) {
          return block.begin == Opcode::Loop || block.begin == Opcode::Rep;
        }))
      error(DiagnosticId::NvFlow, opcode.span, "BRK outside of a loop",
            "it ends the innermost LOOP or REP");
    parsed = parseConditionMask(statement.test);
    break;
  case Opcode::Bra:
  case Opcode::Cal: {
    const Token name = m_tokens.peek();
    if (name.kind != TokenKind::Identifier || wordOf(name).keyword != Keyword::None)
      return unexpected("a label");
    m_tokens.next();
    const Label &label = labelOf(name);
    statement.label = std::uint16_t(&label - m_labels.data());
    parsed = parseConditionMask(statement.test);
    break;
  }
  case Opcode::Ret:
    parsed = parseConditionMask(statement.test);
    break;
  default:
    parsed = parseStack(statement);
  }
  statement.instruction.span = spanFrom(opcode.span.begin);
  if (!parsed || !expect(TokenKind::Semicolon, "';'"))
    return false;
  keep(statement, opcode.span);
  return true;
}

/// An index of a binding that is an address register's: "[" A0 "." x.
bool Parser::atAddress() const {
  return m_mayIndex && m_options.nv == ir::NvOption::Second &&
         m_tokens.at(TokenKind::OpenBracket) && m_tokens.peek(1).kind == TokenKind::Identifier;
}

/// "[" <addrReg> "." <component> (("+" | "-") <integer>)? "]" of a binding. In fragment programs
/// the register is A0, which has x alone and takes what is not below zero.
bool Parser::parseIndexed(std::optional<std::uint16_t> &sequence) {
  m_tokens.next();
  const Token name = m_tokens.next();
  const bool vertex = m_language.language == ir::Language::ArbVertex;
  nv::Indexed indexed;
  if (vertex) {
    note(name, Access::Read);
    const Symbol *symbol = m_symbols.find(text(name));
    if (!symbol && !undeclared(name))
      return false;
    if (symbol && symbol->kind != SymbolKind::Address && symbol->kind != SymbolKind::Unknown)
      error(DiagnosticId::AddressRegister, name.span, quote(text(name)) + " is no address register",
            "declare one with ADDRESS");
    if (symbol && symbol->kind == SymbolKind::Address)
      indexed.address = std::uint8_t(symbol->index);
  } else if (text(name) != "A0") {
    return unexpectedToken(name, "an integer or A0");
  }
  if (!parseAddressComponent())
    return false;
  indexed.address = std::uint8_t(indexed.address + m_addressComponent);
  constexpr std::uint32_t kMostOffset = 9;
  if (!vertex && m_tokens.accept(TokenKind::Plus)) {
    std::uint32_t offset = 0;
    if (!parseBounded(kMostOffset + 1, DiagnosticId::RelativeOffset, "offset", offset))
      return false;
    indexed.offset = std::int16_t(offset);
  } else if (vertex && !parseRelativeOffset(indexed.offset)) {
    return false;
  }
  indexed.sequence = *sequence;
  m_indexed = indexed;
  return expect(TokenKind::CloseBracket, "']'");
}

/// The program is read: what its branches name must be there, and then it becomes code.
void Parser::finishNv(Span end) {
  if (!m_blocks.empty())
    error(DiagnosticId::NvFlow, end, "the program ends inside of a block",
          "the block of line " + std::to_string(locate(m_text, m_blocks.back().where.begin).line) +
              " has no end");
  for (const Label &label : m_labels)
    if (!label.placed)
      error(DiagnosticId::UndeclaredName, label.name,
            "the label " + quote(text({TokenKind::Identifier, label.name})) + " is nowhere",
            "write it before the instruction to go on with, and a colon");
  if (m_reporter.hasErrors())
    return;
  std::optional<std::uint16_t> start;
  if (const auto found = m_labelNumbers.find("main"); found != m_labelNumbers.end())
    start = found->second;
  nv::lower(m_statements, start, m_sequences, m_binder, m_reporter);
}

} // namespace arbiter::fp
