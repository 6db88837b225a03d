#include "fp_compiler/front/assembly/parser.h"

namespace arbiter::fp {

using ir::Opcode;

AssemblyParser::AssemblyParser(const SourceText &source, const CompileOptions &options,
                               const Limits &limits, ir::Language language, const Style &style)
    : Reader(source, Words::Identifiers), m_limits(limits), m_style(style),
      m_binder(language, options, source.reporter) {}

void AssemblyParser::run(ParseResult &result) {
  parse();
  m_binder.finish();
  if (m_reporter.hasErrors())
    return;
  result.counts = m_binder.counts();
  result.program = m_binder.takeProgram();
}

void AssemblyParser::parse() {
  while (keywordAt().keyword == Keyword::Option && !m_reporter.full())
    if (!parseOption(false))
      recover();
  m_binder.setOptions(m_options);
  while (!m_reporter.full()) {
    const Token token = m_tokens.peek();
    if (token.kind == TokenKind::EndOfText)
      return error(DiagnosticId::EndMissing, token.span, "the text ends before END",
                   "every program ends with END; check the length given");
    if (keywordAt().keyword == Keyword::End) {
      m_tokens.next();
      reportBehindEnd(m_reporter, m_text, m_tokens.peek());
      return finish(token.span);
    }
    parseStatement();
  }
}

bool AssemblyParser::parseOption(bool late) {
  const Token option = m_tokens.next();
  Token name;
  if (!expectWord("the name of an option", name))
    return false;
  if (late)
    error(DiagnosticId::LateOption, option.span, "OPTION after the first statement",
          "options come directly after the header");
  else
    applyOption(name);
  return endStatement();
}

Word AssemblyParser::keywordAt() const {
  return at(TokenKind::Identifier) ? wordOf(text(m_tokens.peek())) : Word{};
}

bool AssemblyParser::endsStatement(const Token &token) const {
  return token.kind == TokenKind::Identifier && beginsStatement(wordOf(text(token)).keyword);
}

/// Returns the words that may begin a statement, to suggest from.
Vocabulary AssemblyParser::vocabulary() const {
  Vocabulary result = statementWords();
  for (int i = 0; i < ir::kOpcodeRowCount; ++i)
    if (offers(Opcode(i)))
      result.words.emplace_back(info(Opcode(i)).mnemonic);
  result.parts = [this](std::string_view word) {
    const Word known = wordOf(word);
    return known.keyword == Keyword::Opcode ? partCount(known.op) : 0;
  };
  return result;
}

std::string AssemblyParser::statementHintInC(const Token &first) const {
  return c_like::statementHint(m_text, first.span, m_style.dialect, vocabulary());
}

std::string AssemblyParser::operandHint(const Token &word) const {
  return c_like::operandHint(m_text, word.span, m_style.dialect, vocabulary());
}

std::string AssemblyParser::unknownHint(const Token &first, const std::string &later) const {
  const std::string_view word = text(first);
  const PartTexts parts = partsBehind(m_text, first.span.end);
  if (std::string hint = statementHintInC(first); !hint.empty())
    return hint;
  if (std::string hint = later.empty() ? meaningHint(word, parts, vocabulary()) : ""; !hint.empty())
    return hint;
  if (const auto base = baseOf(word))
    return std::string(info(*base).mnemonic) + " has no such suffix here";
  return later.empty() ? spellingHint(word, parts, vocabulary()) : later;
}

bool AssemblyParser::parseInstruction(const Token &opcode, const Word &word) {
  const ir::OpInfo &op = info(word.op);
  nv::Statement statement;
  ir::Instruction &instruction = statement.instruction;
  instruction.op = word.op;
  m_behindOpcode = opcode.span.end;
  const bool kills = op.has(ir::Kills);
  statement.tests = kills && killsByTest();
  if (statement.tests) {
    instruction.src[0].file = ir::File::Parameter; // it reads no register
    if (!parseTest(statement.test))
      return false;
  } else if ((!kills &&
              (!parseDestinationPart(statement) || !parseConditionMask(statement.test))) ||
             !parseOperands(statement)) {
    return false;
  }
  instruction.dst.saturate = word.saturate;
  statement.suffix = word.nv;
  if ((word.op == Opcode::Swz && !parseExtendedSwizzle(instruction)) ||
      (op.has(ir::Texture) && !parseTexture(instruction)))
    return false;
  instruction.span = spanFrom(opcode.span.begin);
  if (!endStatement("';'", statement.tests ? "" : surplusHint(word.op)))
    return false;
  keep(statement, opcode.span);
  return true;
}

bool AssemblyParser::parseLabel(const Token &name) {
  m_tokens.next();
  keep(m_labels.place(name.span), name.span);
  return true;
}

bool AssemblyParser::parseFlow(const Token &opcode, const Word &word) {
  nv::Statement statement;
  statement.instruction.op = word.op;
  statement.instruction.dst.file = ir::File::Output; // it writes no register
  if (!parseFlowParts(statement, opcode))
    return false;
  statement.instruction.span = spanFrom(opcode.span.begin);
  if (!endStatement())
    return false;
  keep(statement, opcode.span);
  return true;
}

/// Parses the label of BRA or CAL, and the condition that RET has too.
bool AssemblyParser::parseFlowParts(nv::Statement &statement, const Token &) {
  if (statement.instruction.op != Opcode::Ret) {
    if (!atLabel())
      return unexpected("a label");
    statement.label = m_labels.numberOf(m_tokens.next().span);
  }
  return parseConditionMask(statement.test);
}

void AssemblyParser::keep(const nv::Statement &statement, Span opcode) {
  if (m_options.nv == ir::NvOption::None)
    return m_binder.instruction(statement.instruction, opcode);
  const bool fits = statement.isLabel || m_binder.count(statement.instruction, opcode);
  if (fits && !m_reporter.hasErrors())
    m_statements.push_back(statement);
}

} // namespace arbiter::fp
