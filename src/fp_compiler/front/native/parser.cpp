#include "fp_compiler/front/native/parser.h"

#include <algorithm>

#include "fp_compiler/front/header.h"
#include "fp_compiler/front/unexpected.h"

namespace arbiter::fp::native {

namespace {

/// Replaces the target's limits by those of the language itself: the grammar numbers the registers,
/// and an instruction reads one parameter.
CompileOptions optionsOf(const Traits &traits, CompileOptions options) {
  ResourceCounts &api = options.limits.api;
  api.temporaries = Budget::kCeiling;
  api.parameters = Budget::kCeiling;
  api.attribs = Budget::kCeiling;
  api.addressRegisters = traits.addresses;
  if (traits.instructions != 0) {
    api.instructions = traits.instructions;
    options.limits.card = "";
  }
  return options;
}

} // namespace

ParseResult parse(ir::NativeLanguage language, std::string_view text, const CompileOptions &options,
                  NameTable *names) {
  Reporter reporter;
  ParseResult result;
  if (checkLength(text, reporter)) {
    NativeParser parser(language, text, options, reporter, names);
    parser.parse();
    parser.binder().finish();
    if (!reporter.hasErrors()) {
      result.counts = parser.binder().counts();
      result.program = parser.binder().takeProgram();
      result.native = parser.takeInterface();
    }
  }
  result.diagnostics = reporter.take();
  return result;
}

NativeParser::NativeParser(ir::NativeLanguage language, std::string_view text,
                           const CompileOptions &options, Reporter &reporter, NameTable *names)
    : m_traits(traitsOf(language)), m_text(text), m_limits(options.limits), m_reporter(reporter),
      m_names(names), m_tokens(text, std::uint32_t(ir::headerOf(language).size())),
      m_binder(stageOf(language), optionsOf(m_traits, options), reporter) {
  m_options.nv = ir::NvOption::First;
  m_options.native = language;
  m_interface.language = language;
  m_rules.language = language;
  m_rules.vertex = !fragment();
}

NativeInterface NativeParser::takeInterface() {
  m_interface.rowsRead.assign(m_rowsRead.begin(), m_rowsRead.end());
  m_interface.rowsWritten.assign(m_rowsWritten.begin(), m_rowsWritten.end());
  return std::move(m_interface);
}

void NativeParser::parse() {
  parseOptions();
  m_binder.setOptions(m_options);
  while (!m_reporter.full()) {
    if (m_tokens.at(TokenKind::EndOfText)) {
      error(DiagnosticId::EndMissing, m_tokens.peek().span, "the text ends before END",
            "every program ends with END; check the length given");
      return;
    }
    if (atWord("END")) {
      const Span end = m_tokens.next().span;
      reportBehindEnd(m_reporter, m_text, m_tokens.peek());
      finish(end);
      return;
    }
    parseStatement();
  }
}

void NativeParser::parseOptions() {
  while (m_traits.invariance && atWord("OPTION") && !m_reporter.full())
    if (!parseOption())
      recover();
}

bool NativeParser::parseOption() {
  m_tokens.next();
  if (!m_tokens.at(TokenKind::Identifier))
    return unexpected("the name of an option");
  const Token name = m_tokens.next();
  if (text(name) == "NV_position_invariant")
    m_options.positionInvariant = true;
  else
    error(DiagnosticId::UnsupportedOption, name.span,
          "OPTION " + quote(text(name)) + " is none of " + header(),
          "the one option is NV_position_invariant");
  return endStatement();
}

void NativeParser::parseStatement() {
  constexpr const char *kStatement = "an instruction or END";
  if (!m_tokens.at(TokenKind::Identifier)) {
    unexpected(kStatement, m_tokens.at(TokenKind::OpenBrace) || m_tokens.at(TokenKind::CloseBrace)
                               ? "there are no blocks: END ends the program"
                               : "");
    if (!m_tokens.accept(TokenKind::Semicolon)) {
      m_tokens.next();
      recover();
    }
    return;
  }
  const Token first = m_tokens.next();
  const Word word = nv::classify(text(first), m_traits.language);
  bool parsed = false;
  if (m_traits.language == ir::NativeLanguage::Vp2 && atByte(':'))
    parsed = parseLabel(first);
  else if (word.keyword == Keyword::Opcode)
    parsed = info(word.op).has(ir::Flow) ? parseFlow(first, word) : parseInstruction(first, word);
  else if (word.keyword == Keyword::Param)
    parsed = text(first) == "DEFINE" ? parseDefine() : parseDeclare();
  else
    parsed = unknownStatement(first);
  if (!parsed)
    recover();
}

/// The words that may begin a statement, to suggest from.
Vocabulary NativeParser::vocabulary() const {
  Vocabulary result{.words = {"END"}, .saturate = fragment() ? "_SAT" : "", .parts = {}};
  if (fragment())
    result.words.insert(result.words.end(), {"DEFINE", "DECLARE"});
  for (int i = 0; i < ir::kOpcodeRowCount; ++i)
    if (nv::offers(m_traits.language, ir::Opcode(i)))
      result.words.emplace_back(info(ir::Opcode(i)).mnemonic);
  result.parts = [this](std::string_view word) {
    const Word known = nv::classify(word, m_traits.language);
    return known.keyword == Keyword::Opcode ? partCount(known.op) : 0;
  };
  return result;
}

bool NativeParser::unknownStatement(const Token &first) {
  const std::string_view word = text(first);
  if (word == "OPTION") {
    error(m_traits.invariance ? DiagnosticId::LateOption : DiagnosticId::UnsupportedOption,
          first.span,
          m_traits.invariance ? std::string("OPTION after the first statement")
                              : header() + " has no options",
          m_traits.invariance ? "options come directly after the header" : "remove it");
    return false;
  }
  const PartTexts parts = partsBehind(m_text, first.span.end);
  std::string hint = c_like::statementHint(m_text, first.span, dialect(), vocabulary());
  if (hint.empty())
    hint = meaningHint(word, parts, vocabulary());
  const auto base = hint.empty() ? nv::baseOf(word, m_traits.language) : std::nullopt;
  if (base)
    hint = std::string(info(*base).mnemonic) + " has no such suffix here";
  else if (hint.empty())
    hint = spellingHint(word, parts, vocabulary());
  error(DiagnosticId::UnknownInstruction, first.span,
        quote(word) + " is no instruction of " + header(), std::move(hint));
  return false;
}

/// Finishes the program: checks the required results and the labels, then lowers the statements.
void NativeParser::finish(Span end) {
  const bool vertex = !fragment() && !statesOnly();
  if (vertex && !m_writesPosition && !m_options.positionInvariant)
    error(DiagnosticId::NativeOutputs, end, "the program does not write o[HPOS]",
          "every vertex program gives a position");
  if (fragment() && m_results.empty())
    error(DiagnosticId::NativeOutputs, end, "the program writes no output register",
          "write o[COLR], o[COLH] or o[DEPR]");
  if (statesOnly() && m_rowsWritten.empty())
    error(DiagnosticId::NativeOutputs, end, "the program writes no program parameter",
          "a vertex state program writes c[n]");
  m_labels.check();
  if (m_reporter.hasErrors())
    return;
  if (m_interface.readsAnyRow)
    bindAllRows(end);
  nv::lower(m_statements, m_labels.start(), {}, m_binder, m_reporter, m_rules);
}

/// Binds c[] as the array that relative operands read. Rows that no operand names are not counted.
void NativeParser::bindAllRows(Span where) {
  std::vector<std::uint16_t> rows;
  for (std::uint32_t i = 0; i < m_traits.rows; ++i)
    rows.push_back(m_binder.hiddenEnv(i, where));
  m_binder.relativeArray("c", rows, where);
}

bool NativeParser::beginsStatement(const Token &token) const {
  return token.kind == TokenKind::Identifier &&
         fp::beginsStatement(nv::classify(text(token), m_traits.language).keyword);
}

void NativeParser::recover() {
  while (!m_tokens.at(TokenKind::EndOfText)) {
    if (beginsStatement(m_tokens.peek()) || beginsLine(m_text, m_tokens.last(), m_tokens.peek()))
      return;
    const Token token = m_tokens.next();
    if (token.kind == TokenKind::Semicolon)
      return;
    if (token.kind == TokenKind::Identifier && m_named.contains(text(token)))
      note(token, Access::Read);
  }
}

bool NativeParser::atByte(char byte) const {
  const Token &token = m_tokens.peek();
  return token.kind == TokenKind::InvalidByte && m_text[token.span.begin] == byte;
}

bool NativeParser::acceptByte(char byte) {
  if (!atByte(byte))
    return false;
  m_tokens.next();
  return true;
}

bool NativeParser::expectByte(char byte) {
  return acceptByte(byte) || unexpected((std::string("'") + byte + "'").c_str());
}

bool NativeParser::expect(TokenKind kind, const char *what, const char *hint) {
  return m_tokens.accept(kind) || unexpected(what, hint);
}

bool NativeParser::endStatement(const char *expected, std::string hint) {
  return m_tokens.accept(TokenKind::Semicolon) ||
         (!reportLostSemicolon(m_reporter, m_text, m_tokens.last(), m_tokens.peek(),
                               beginsStatement(m_tokens.peek()), expected) &&
          unexpected(expected, std::move(hint)));
}

bool NativeParser::unexpected(const char *expected, std::string hint) {
  const Token &token = m_tokens.peek();
  const bool known =
      token.kind == TokenKind::InvalidByte &&
      std::string_view("|():").find(m_text[token.span.begin]) != std::string_view::npos;
  if (!known)
    reportUnexpected(m_reporter, m_text, token, expected, std::move(hint));
  else
    error(DiagnosticId::Syntax, token.span,
          "expected " + std::string(expected) + ", found " + describe(m_text, token),
          std::move(hint));
  return false;
}

bool NativeParser::atWord(std::string_view word) const {
  return m_tokens.at(TokenKind::Identifier) && text(m_tokens.peek()) == word;
}

/// True at a register that is written with brackets: f[, o[, v[, c[, p[.
bool NativeParser::atBinding(std::string_view letter) const {
  return atWord(letter) && m_tokens.peek(1).kind == TokenKind::OpenBracket;
}

void NativeParser::error(DiagnosticId id, Span span, std::string message, std::string hint) {
  m_reporter.error(id, span, std::move(message), std::move(hint));
}

} // namespace arbiter::fp::native
