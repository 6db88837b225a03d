// Parses statements of NVIDIA's options: NV_fragment_program_option 3.11.2,
// NV_vertex_program2_option 2.14.2 and their successors. The other files of the parser have the
// parts of the ARB grammar.

#include <algorithm>
#include <utility>

#include "fp_compiler/front/nv/lowering.h"
#include "fp_compiler/front/parser.h"
#include "fp_compiler/front/words/suffix.h"

namespace arbiter::fp {

using ir::Opcode;

/// True at a byte that is not a token of the ARB grammar: a bar, a colon or a parenthesis.
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

/// True at <varSize> before TEMP or OUTPUT. Elsewhere the word is a free name.
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

/// Parses <ccTest>: a rule and a swizzle.
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

/// Parses <ccMask>, if there is one.
bool Parser::parseConditionMask(nv::Test &test) {
  return !acceptByte('(') || (parseTest(test) && expectByte(')'));
}

/// Parses <instOperandV> or <instOperandS>. Within bars the swizzle is inside, and signs may be on
/// both sides.
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
  // A number has the same value in every component and takes no suffix.
  m_mayIndex = true;
  m_indexed.reset();
  const bool read = parseSourceRegister(operand);
  m_mayIndex = false;
  if (!read || (!number && !parseSwizzle(scalar, operand.swizzle, begin)))
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
    if (!expectPart(instruction.op, {PartKind::Operand, i}))
      return false;
    bool absolute = false;
    // ARL reads a vector in these languages.
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

/// Parses SWZ's operand, which may be within bars.
bool Parser::parseNvSwzSource(ir::Operand &operand, bool &absolute) {
  absolute = acceptByte('|');
  return parseSwzSource(operand) && (!absolute || expectByte('|'));
}

/// Returns the number of the address register of that name, or 0 after an error if it is not one.
/// Returns nothing if the statement cannot be continued.
std::optional<std::uint16_t> Parser::readAddressVector(const Token &name) {
  note(name, Access::Read);
  const Symbol *symbol = m_symbols.find(text(name));
  if (!symbol && !undeclared(name))
    return std::nullopt;
  if (symbol && symbol->kind != SymbolKind::Address && symbol->kind != SymbolKind::Unknown)
    error(DiagnosticId::AddressRegister, name.span, quote(text(name)) + " is no address register",
          "declare one with ADDRESS");
  return symbol && symbol->kind == SymbolKind::Address ? symbol->index : std::uint16_t(0);
}

/// Parses <addrRegisterOperand> of ARA: a whole address register.
bool Parser::parseAddressSource(ir::Operand &operand) {
  const Token name = m_tokens.peek();
  if (name.kind != TokenKind::Identifier || wordOf(name).keyword != Keyword::None)
    return unexpected("an address register");
  m_tokens.next();
  const auto address = readAddressVector(name);
  if (!address)
    return false;
  operand.file = ir::File::Address;
  operand.index = *address;
  operand.span = name.span;
  return true;
}

/// Parses <maskedAddrReg>, with any components.
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
  if (!expectPart(instruction.op, {PartKind::Destination}))
    return false;
  if (!(address ? parseNvAddressDestination(instruction.dst) : parseDestination(instruction.dst)))
    return false;
  m_mayIndex = false;
  statement.indexedResult = std::exchange(m_indexed, {});
  if (instruction.dst.file == ir::File::Output && !statement.indexedResult)
    checkSize(instruction.dst);
  return parseConditionMask(statement.test);
}

/// Reports a result that is written under two sizes (NV_fragment_program_option 3.11.3.4).
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
  m_behindOpcode = opcode.span.end;
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
  if (word.op == Opcode::Swz && !parseExtendedSwizzle(instruction))
    return false;
  if (op.has(ir::Texture) && !parseTexture(instruction))
    return false;
  instruction.span = spanFrom(opcode.span.begin);
  if (!(statement.tests ? endStatement() : endInstruction(word.op)))
    return false;
  keep(statement, opcode.span);
  return true;
}

/// Counts the statement. Keeps it if the program can still load.
void Parser::keep(const nv::Statement &statement, Span opcode) {
  const bool fits = statement.isLabel || m_binder.count(statement.instruction, opcode);
  if (fits && !m_reporter.hasErrors())
    m_statements.push_back(statement);
}

/// Returns the hint for a statement that does not begin with a word of the option.
std::string Parser::unknownNvHint(const Token &first) const {
  const std::string_view word = text(first);
  const bool vertex = m_language.language == ir::Language::ArbVertex;
  const bool later =
      m_options.nv == ir::NvOption::First &&
      nv::classify(word, m_language, ir::NvOption::Second).keyword == Keyword::Opcode;
  const PartTexts parts = partsBehind(m_text, first.span.end);
  if (std::string hint = statementHintInC(first); !hint.empty())
    return hint;
  if (std::string hint = later ? "" : meaningHint(word, parts, vocabulary()); !hint.empty())
    return hint;
  if (const auto base = nv::baseOf(word, m_language, m_options.nv))
    return std::string(info(*base).mnemonic) + " has no such suffix here";
  if (later)
    return std::string("OPTION ") + (vertex ? "NV_vertex_program3" : "NV_fragment_program2") +
           " has it";
  return spellingHint(word, parts, vocabulary());
}

bool Parser::unknownNvStatement(const Token &first) {
  const std::string_view word = text(first);
  if (m_language.language == ir::Language::ArbFragment && (word == "SHORT" || word == "LONG"))
    error(DiagnosticId::UnknownInstruction, first.span,
          std::string(word) + " stands before TEMP or OUTPUT");
  else
    error(DiagnosticId::UnknownInstruction, first.span, "unknown instruction " + quote(word),
          unknownNvHint(first));
  settle(first);
  return false;
}

} // namespace arbiter::fp
