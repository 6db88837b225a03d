#include "fp_compiler/front/arb/parser.h"

#include <algorithm>

#include "fp_compiler/front/c_like/statements.h"
#include "fp_compiler/front/c_like/tokens.h"
#include "fp_compiler/front/nv/words.h"

namespace arbiter::fp {

namespace {
constexpr const char *kStatement = "an instruction, a declaration or END";
} // namespace

ParseResult parseArbProgram(const ArbLanguage &language, std::string_view text,
                            const CompileOptions &options, NameTable *names) {
  return readText<ParseResult>(language.header, text, names,
                               [&](const SourceText &source, ParseResult &result) {
                                 Parser(language, source, options).run(result);
                               });
}

Parser::Parser(const ArbLanguage &language, const SourceText &source, const CompileOptions &options)
    : AssemblyParser(source, options, options.limits, language.language,
                     {.dialect = c_like::dialectOf(language.language),
                      .colors = language.colorLetters,
                      .unit = "texture[0]",
                      .addressDot = "'.x'",
                      .addressComponent = "'x'",
                      .addressHint = "an address register has the component x only",
                      .addressAdvice = "write .x"}),
      m_language(language), m_policy(options.policy) {}

void Parser::parseStatement() {
  constexpr const char *kNoBlocks = "there are no blocks: END ends the program";
  if (at(TokenKind::CloseBrace)) { // the next statement may stand behind it
    unexpected(kStatement, kNoBlocks);
    m_tokens.next();
    return;
  }
  if (!atStatement(kStatement, at(TokenKind::OpenBrace) ? kNoBlocks : ""))
    return;
  const Word word = keywordAt();
  if (word.keyword == Keyword::Option) {
    if (!parseOption(true))
      recover();
    return;
  }
  if (atSize()) {
    if (!parseSized())
      recover();
    return;
  }
  const Token first = m_tokens.next();
  if (!parseStatementBody(first, word))
    recover();
}

bool Parser::parseStatementBody(const Token &first, const Word &word) {
  switch (word.keyword) {
  case Keyword::Opcode:
    return info(word.op).has(ir::Flow) ? parseFlow(first, word) : parseInstruction(first, word);
  case Keyword::Temp:
    return parseRegisters(SymbolKind::Temporary);
  case Keyword::Address:
    return parseRegisters(SymbolKind::Address);
  case Keyword::Attrib:
    return parseAttrib();
  case Keyword::Output:
    return parseOutput();
  case Keyword::Alias:
    return parseAlias();
  case Keyword::Param:
    return parseParam();
  case Keyword::None:
    if (isNv() && atByte(':'))
      return parseBlockLabel(first);
    return isNv() ? unknownNvStatement(first) : unknownStatement(first);
  case Keyword::Attributes:
  case Keyword::Program:
  case Keyword::Result:
  case Keyword::State:
  case Keyword::Texture:
    return unexpectedToken(first, kStatement, statementHintInC(first));
  case Keyword::Option:
  case Keyword::End:
    break; // the callers took these
  }
  return false;
}

/// True for an opcode of the ARB languages with NVIDIA's letters for precision or condition: ADDR,
/// MULH_SAT, MOVC.
bool Parser::isNvVariant(std::string_view word) const {
  const std::string_view base = word.substr(0, 3);
  const std::string_view letters = word.substr(base.size(), word.find('_') - base.size());
  return base.size() == 3 && classify(base, m_language).keyword == Keyword::Opcode &&
         !letters.empty() && letters.size() <= 2 &&
         letters.find_first_not_of("RHXC") == std::string_view::npos;
}

/// True for an instruction or a declaration of the other language.
bool Parser::isForeignStatement(std::string_view word) const {
  const ArbLanguage &other =
      arbLanguage(isVertex() ? ir::Language::ArbFragment : ir::Language::ArbVertex);
  return beginsStatement(classify(word, other).keyword);
}

std::string Parser::ofNvOptions() const {
  return std::string(" belongs to the ") + m_language.nvOptions + " options, " +
         (m_limits.nvOptions == 0 ? "which are not offered" : "which the text does not ask for");
}

std::string Parser::nvOptionsHint(std::string_view word) const {
  using ir::NvOption;
  const bool later = nv::baseOf(word, m_language, NvOption::Second) &&
                     !nv::baseOf(word, m_language, NvOption::First);
  if (m_limits.nvOptions >= std::uint32_t(later ? NvOption::Second : NvOption::First))
    return "an OPTION directly after the header asks for them";
  return later ? "the profiles nv40 and host have them"
               : "the profiles from nv30 to nv40 have them, and host";
}

Vocabulary Parser::statementWords() const {
  return {.words = fp::statementWords(m_language),
          .saturate = m_language.saturates || isSecondNv() ? "_SAT" : "",
          .parts = {}};
}

/// Goes on behind an unknown statement: accepts the names that it may declare or write, so that
/// their uses give no further errors, and skips the line of a call, which may have semicolons.
void Parser::settle(const Token &first) {
  for (std::string_view part : partsBehind(m_text, first.span.end)) {
    part = part.substr(0, part.find('='));
    const std::size_t end = part.find_last_not_of(" \t");
    part = part.substr(0, end == std::string_view::npos ? 0 : end + 1);
    part = part.substr(part.find_last_of(" \t\r\n") + 1);
    Lexer lexer(part);
    if (lexer.next().kind == TokenKind::Identifier && lexer.next().kind == TokenKind::EndOfText)
      m_symbols.declare(part, {});
  }
  while (c_like::isCall(m_text, first.span) && !at(TokenKind::EndOfText) &&
         !isOnLaterLine(m_text, m_tokens.lastEnd(), m_tokens.peek().span.begin))
    m_tokens.next();
}

bool Parser::unknownStatement(const Token &first) {
  const std::string_view word = text(first);
  const PartTexts parts = partsBehind(m_text, first.span.end);
  if (isForeignStatement(word)) {
    const bool saturated = word.ends_with("_SAT");
    const Word unsaturated = classify(word.substr(0, 3), m_language);
    if (saturated && unsaturated.keyword == Keyword::Opcode)
      error(m_language.foreignId, first.span,
            quote(word) + ": saturation belongs to " + m_language.foreignName,
            "write " + std::string(word.substr(0, 3)) + ", then MAX with 0 and MIN with 1");
    else
      foreign(first, word, meaningHint(word, parts, vocabulary()));
    // Declare the name, so that its uses give no further errors.
    if (word == "ADDRESS" && at(TokenKind::Identifier))
      m_symbols.declare(text(m_tokens.peek()), {});
  } else if (isNvInstruction(word, m_language) || isNvVariant(word)) {
    const std::string hint = isNvVariant(word) ? "write " + std::string(word.substr(0, 3))
                                               : meaningHint(word, parts, vocabulary());
    error(DiagnosticId::NvOnly, first.span, quote(word) + ofNvOptions(),
          hint.empty() ? nvOptionsHint(word) : hint);
  } else if (word == "KIL_SAT" && m_language.saturates) {
    error(DiagnosticId::UnknownInstruction, first.span, "KIL writes nothing and takes no _SAT",
          "write KIL");
  } else {
    const std::string hint = statementHintInC(first);
    error(DiagnosticId::UnknownInstruction, first.span, "unknown instruction " + quote(word),
          hint.empty() ? statementHint(word, parts, vocabulary()) : hint);
    settle(first);
  }
  return false;
}

/// Notes a known name in a statement that was skipped.
void Parser::skipped(const Token &token) {
  if (!m_names || token.kind != TokenKind::Identifier)
    return;
  const bool suffix = token.span.begin > 0 && m_text[token.span.begin - 1] == '.';
  if (!suffix && m_symbols.find(text(token)))
    note(token, Access::Read);
}

bool Parser::unexpectedToken(const Token &token, const char *expected, std::string hint) {
  if (!isByteOf(token, ownBytes()) && isByteOf(token, "|()<>") &&
      c_like::tokenHint(m_text, token).empty())
    hint = std::string("absolute values and condition codes belong to the ") +
           m_language.nvOptions + " options";
  return AssemblyParser::unexpectedToken(token, expected, std::move(hint));
}

bool Parser::offers(ir::Opcode op) const {
  return int(op) >= ir::kOpcodeCount && isNv() && nv::offers(m_language, m_options.nv, op);
}

Word Parser::wordOf(std::string_view identifier) const {
  return isNv() ? nv::classify(identifier, m_language, m_options.nv)
                : classify(identifier, m_language);
}

bool Parser::isFree(const Token &token) const {
  return token.kind == TokenKind::Identifier && wordOf(text(token)).keyword == Keyword::None;
}

void Parser::foreign(const Token &token, std::string_view what, std::string hint) {
  const std::string_view own = foreignHint(text(token), m_language);
  error(m_language.foreignId, token.span,
        std::string(what) + " belongs to " + m_language.foreignName,
        own.empty() ? std::move(hint) : std::string(own));
}

} // namespace arbiter::fp
