#include "fp_compiler/front/ati/parser.h"

#include <algorithm>

#include "fp_compiler/front/ati/words.h"
#include "fp_compiler/front/c_like/statements.h"
#include "util/suggest.h"

namespace arbiter::fp::ati {

ParseResult parse(std::string_view text, const CompileOptions &options, NameTable *names) {
  const auto read = [&](const SourceText &source, ParseResult &result) {
    Parser parser(source, options.limits);
    parser.run();
    if (source.reporter.hasErrors())
      return;
    result.counts = parser.counts();
    result.shader = parser.shader();
  };
  return readText<ParseResult>(kHeader, text, names, read);
}

void Parser::run() {
  if (acceptWord("StartConstants"))
    parseConstants();
  if (acceptWord("StartPrelimPass"))
    parsePass(true);
  if (acceptWord("StartOutputPass")) {
    parsePass(false);
    return parseEnd();
  }
  if (m_reporter.full())
    return;
  std::string hint = "the result is what the output pass leaves in r0";
  if (atWord("StartConstants"))
    hint = "there is one block of constants, before the passes";
  else if (atWord("StartPrelimPass"))
    hint = "there is one preliminary pass, before the output pass";
  else if (at(TokenKind::Identifier))
    hint = didYouMean(text(m_tokens.peek()),
                      {"StartConstants", "StartPrelimPass", "StartOutputPass"}, std::move(hint));
  if (at(TokenKind::Identifier) || at(TokenKind::EndOfText))
    error(DiagnosticId::AtiOutputPass, m_tokens.peek().span,
          "expected StartOutputPass, found " + describe(m_text, m_tokens.peek()), std::move(hint));
  else
    unexpected("StartOutputPass", std::move(hint));
}

void Parser::parsePass(bool prelim) {
  m_pass = &m_shader.passes[m_shader.passCount++];
  m_prelim = prelim;
  m_hasInstructions = m_openPair = m_openDot4 = false;
  m_pairs = 0;
  if (!endStatement())
    recover();
  while (!m_reporter.full()) {
    if (atWord("EndPass"))
      return closePass();
    // Another block, or the end of the text, ends this block.
    if (at(TokenKind::EndOfText) || atWord("StartOutputPass") || atWord("StartPrelimPass") ||
        atWord("StartConstants")) {
      error(DiagnosticId::AtiPassOpen, m_tokens.peek().span,
            "expected EndPass, found " + describe(m_text, m_tokens.peek()),
            "every pass ends with EndPass;");
      return;
    }
    parsePassStatement();
  }
}

void Parser::parsePassStatement() {
  if (!atStatement("an instruction or EndPass"))
    return;
  const Token first = m_tokens.next();
  const std::optional<Op> op = opOf(text(first));
  bool whole = false;
  if (op) {
    whole = parseInstruction(first, *op);
  } else if (text(first) == "PassTexCoord" || text(first) == "SampleMap") {
    if (m_hasInstructions)
      error(DiagnosticId::AtiSetupOrder, first.span,
            std::string(text(first)) + " after the first instruction of the pass",
            "PassTexCoord and SampleMap begin a pass");
    whole = parseSetup(first,
                       text(first) == "SampleMap" ? SetupKind::SampleMap : SetupKind::PassTexCoord);
  } else {
    unknownStatement(first);
  }
  if (!whole)
    recover();
}

/// The words that may begin a statement of a pass, to suggest from.
Vocabulary Parser::vocabulary() {
  constexpr int kSetupParts = 2;
  return {.words = {"MOV", "ADD", "MUL", "SUB", "DOT3", "DOT4", "MAD", "LERP", "CND", "CND0",
                    "DOT2ADD", "PassTexCoord", "SampleMap", "EndPass"},
          .saturate = ".sat",
          .parts = [](std::string_view word) {
            const std::optional<Op> op = opOf(word);
            return op                                              ? 1 + argumentCount(*op)
                   : word == "PassTexCoord" || word == "SampleMap" ? kSetupParts
                                                                   : 0;
          }};
}

void Parser::unknownStatement(const Token &first) {
  const std::string_view word = text(first);
  if (word == "CONSTANT")
    return error(DiagnosticId::Syntax, first.span, "CONSTANT in a pass",
                 "constants are declared between StartConstants; and EndConstants;");
  // The specification's prose and the API form write LERP_ATI and SampleMapATI.
  std::string_view bare = word;
  for (const std::string_view suffix : {"ATI", "_"})
    if (bare.size() > suffix.size() && bare.ends_with(suffix))
      bare.remove_suffix(suffix.size());
  const std::string hint =
      c_like::statementHint(m_text, first.span, c_like::Dialect::Ati, vocabulary());
  error(DiagnosticId::UnknownInstruction, first.span, "unknown instruction " + quote(word),
        hint.empty() ? statementHint(bare, partsBehind(m_text, first.span.end), vocabulary())
                     : hint);
}

void Parser::closePass() {
  const Token token = m_tokens.next();
  if (m_prelim && !m_hasInstructions)
    error(DiagnosticId::AtiPrelimPassEmpty, token.span, "a preliminary pass without an instruction",
          "move its setups to the output pass, or give it an instruction");
  if (!endStatement())
    recover();
}

void Parser::parseEnd() {
  if (m_reporter.full() || at(TokenKind::EndOfText))
    return;
  const Token token = m_tokens.peek();
  // Callers that pass sizeof of a literal include its terminator in the length.
  if (m_text.find_first_not_of('\0', token.span.begin) == std::string_view::npos) {
    m_reporter.warning(DiagnosticId::TrailingNul, {token.span.begin, std::uint32_t(m_text.size())},
                       "the length counts a NUL byte after the last EndPass");
    return;
  }
  error(DiagnosticId::TextAfterEnd, token.span, "text after the output pass",
        "only comments may follow its EndPass;");
}

bool Parser::endsStatement(const Token &token) const {
  return token.kind == TokenKind::Identifier && beginsStatement(text(token));
}

std::string Parser::hintAt(const Token &token) const {
  return token.kind == TokenKind::Identifier ? c_like::nameHint(text(token), c_like::Dialect::Ati)
                                             : "";
}

ResourceCounts Parser::counts() const {
  const auto count = [](const auto &flags) {
    return std::uint32_t(std::count(flags.begin(), flags.end(), true));
  };
  ResourceCounts counts;
  for (std::size_t i = 0; i < m_shader.passCount; ++i) {
    const Pass &pass = m_shader.passes[i];
    counts.aluInstructions += pass.pairCount;
    counts.texInstructions +=
        std::uint32_t(std::count_if(pass.setups.begin(), pass.setups.end(), [](const Setup &setup) {
          return setup.kind == SetupKind::SampleMap;
        }));
  }
  counts.instructions = counts.aluInstructions + counts.texInstructions;
  counts.texIndirections = m_shader.passCount;
  counts.temporaries = count(m_registersUsed);
  counts.parameters = count(m_declared);
  counts.attribs = count(m_colorsUsed) +
                   std::uint32_t(std::count_if(m_thirds.begin(), m_thirds.end(),
                                               [](Third third) { return third != Third::Unused; }));
  return counts;
}

} // namespace arbiter::fp::ati
