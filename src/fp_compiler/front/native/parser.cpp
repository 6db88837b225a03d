#include "fp_compiler/front/native/parser.h"

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
  return readText<ParseResult>(ir::headerOf(language), text, names,
                               [&](const SourceText &source, ParseResult &result) {
                                 NativeParser parser(traitsOf(language), source, options);
                                 parser.run(result);
                                 if (result.program)
                                   result.native = parser.takeInterface();
                               });
}

NativeParser::NativeParser(const Traits &traits, const SourceText &source,
                           const CompileOptions &options)
    : AssemblyParser(
          source, optionsOf(traits, options), options.limits, stageOf(traits.language),
          {.dialect = traits.language == ir::NativeLanguage::Fp1 ? c_like::Dialect::OwnFragment
                                                                 : c_like::Dialect::OwnVertex,
           .colors = false,
           .unit = "TEX0",
           .addressDot = "'.'",
           .addressComponent = "a component of the address register",
           .addressHint = "",
           .addressAdvice = traits.addressVectors ? "it has x, y, z and w" : "write .x"}),
      m_traits(traits) {
  m_options.nv = ir::NvOption::First;
  m_options.native = traits.language;
  m_interface.language = traits.language;
  m_rules.language = traits.language;
  m_rules.vertex = !fragment();
}

NativeInterface NativeParser::takeInterface() {
  m_interface.rowsRead.assign(m_rowsRead.begin(), m_rowsRead.end());
  m_interface.rowsWritten.assign(m_rowsWritten.begin(), m_rowsWritten.end());
  return std::move(m_interface);
}

void NativeParser::applyOption(const Token &name) {
  if (text(name) == "NV_position_invariant")
    m_options.positionInvariant = true;
  else
    error(DiagnosticId::UnsupportedOption, name.span,
          "OPTION " + quote(text(name)) + " is none of " + header(),
          "the one option is NV_position_invariant");
}

void NativeParser::parseStatement() {
  const bool block = at(TokenKind::OpenBrace) || at(TokenKind::CloseBrace);
  if (!atStatement("an instruction or END",
                   block ? "there are no blocks: END ends the program" : ""))
    return;
  m_attribute.reset();
  m_parameter.reset();
  m_scalars.clear();
  const Token first = m_tokens.next();
  const Word word = wordOf(text(first));
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

Vocabulary NativeParser::statementWords() const {
  Vocabulary result{.words = {"END"}, .saturate = fragment() ? "_SAT" : "", .parts = {}};
  if (fragment())
    result.words.insert(result.words.end(), {"DEFINE", "DECLARE"});
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
  error(DiagnosticId::UnknownInstruction, first.span,
        quote(word) + " is no instruction of " + header(), unknownHint(first, ""));
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

void NativeParser::skipped(const Token &token) {
  if (token.kind == TokenKind::Identifier && m_named.find(text(token)))
    note(token, Access::Read);
}

/// True at a register that is written with brackets: f[, o[, v[, c[, p[.
bool NativeParser::atBinding(std::string_view letter) const {
  return atWord(letter) && m_tokens.peek(1).kind == TokenKind::OpenBracket;
}

} // namespace arbiter::fp::native
