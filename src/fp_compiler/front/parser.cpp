#include "fp_compiler/front/parser.h"

#include <algorithm>

#include "fp_compiler/front/c_like/statements.h"
#include "fp_compiler/front/c_like/tokens.h"
#include "fp_compiler/front/header.h"
#include "fp_compiler/front/nv/words.h"
#include "fp_compiler/front/unexpected.h"

namespace arbiter::fp {

namespace {
constexpr const char *kStatement = "an instruction, a declaration or END";
} // namespace

ParseResult parseArbProgram(const ArbLanguage &language, std::string_view text,
                            const CompileOptions &options, NameTable *names) {
  Reporter reporter;
  ParseResult result;
  const bool good = checkHeader(language.header, text, reporter);
  if (good || (names && text.size() <= kMaxTextBytes)) {
    const std::uint32_t begin =
        good ? std::uint32_t(language.header.size()) : endOfWrongHeader(text);
    Parser parser(language, text, options, reporter, begin, names);
    parser.parse();
    parser.binder().finish();
    if (!reporter.hasErrors()) {
      result.counts = parser.binder().counts();
      result.program = parser.binder().takeProgram();
    }
  }
  result.diagnostics = reporter.take();
  return result;
}

Parser::Parser(const ArbLanguage &language, std::string_view text, const CompileOptions &options,
               Reporter &reporter, std::uint32_t begin, NameTable *names)
    : m_language(language), m_text(text), m_limits(options.limits), m_policy(options.policy),
      m_reporter(reporter), m_names(names), m_tokens(text, begin),
      m_binder(language.language, options, reporter) {}

void Parser::parse() {
  parseOptions();
  m_binder.setOptions(m_options);
  while (!m_reporter.full()) {
    if (m_tokens.at(TokenKind::EndOfText)) {
      error(DiagnosticId::EndMissing, m_tokens.peek().span, "the text ends before END",
            "every program ends with END; check the length given");
      return;
    }
    if (keywordAt().keyword == Keyword::End) {
      const Span end = m_tokens.peek().span;
      parseEnd();
      if (m_options.nv != ir::NvOption::None)
        finishNv(end);
      return;
    }
    parseStatement();
  }
}

void Parser::parseStatement() {
  constexpr const char *kNoBlocks = "there are no blocks: END ends the program";
  if (m_tokens.at(TokenKind::CloseBrace)) { // the next statement may stand behind it
    unexpected(kStatement, kNoBlocks);
    m_tokens.next();
    return;
  }
  if (!m_tokens.at(TokenKind::Identifier)) {
    unexpected(kStatement, m_tokens.at(TokenKind::OpenBrace) ? kNoBlocks : "");
    if (!m_tokens.accept(TokenKind::Semicolon)) {
      m_tokens.next();
      recover();
    }
    return;
  }
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
    return m_options.nv == ir::NvOption::None ? parseInstruction(first, word)
                                              : parseNvInstruction(first, word);
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
    if (m_options.nv != ir::NvOption::None && atByte(':'))
      return parseLabel(first);
    return m_options.nv == ir::NvOption::None ? unknownStatement(first) : unknownNvStatement(first);
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
  const bool vertex = m_language.language == ir::Language::ArbVertex;
  const ArbLanguage &other =
      arbLanguage(vertex ? ir::Language::ArbFragment : ir::Language::ArbVertex);
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

/// The words that may begin a statement, to suggest from.
Vocabulary Parser::vocabulary() const {
  const ir::NvOption nv = m_options.nv;
  Vocabulary result{.words = statementWords(m_language),
                    .saturate = m_language.saturates ? "_SAT" : "",
                    .parts = {}};
  for (int i = ir::kOpcodeCount; i < ir::kOpcodeRowCount; ++i)
    if (nv != ir::NvOption::None && nv::offers(m_language, nv, ir::Opcode(i)))
      result.words.emplace_back(info(ir::Opcode(i)).mnemonic);
  if (nv == ir::NvOption::Second)
    result.saturate = "_SAT";
  result.parts = [this](std::string_view word) {
    const Word known = m_options.nv == ir::NvOption::None
                           ? classify(word, m_language)
                           : nv::classify(word, m_language, m_options.nv);
    return known.keyword == Keyword::Opcode ? partCount(known.op) : 0;
  };
  return result;
}

std::string Parser::statementHintInC(const Token &first) const {
  return c_like::statementHint(m_text, first.span, c_like::dialectOf(m_language.language),
                               vocabulary());
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
  while (c_like::isCall(m_text, first.span) && !m_tokens.at(TokenKind::EndOfText) &&
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
    if (word == "ADDRESS" && m_tokens.at(TokenKind::Identifier))
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

void Parser::parseEnd() {
  m_tokens.next();
  reportBehindEnd(m_reporter, m_text, m_tokens.peek());
}

void Parser::recover() {
  while (!m_tokens.at(TokenKind::EndOfText)) {
    if (beginsStatement(keywordAt().keyword) ||
        beginsLine(m_text, m_tokens.last(), m_tokens.peek()))
      return;
    const Token token = m_tokens.next();
    if (token.kind == TokenKind::Semicolon)
      return;
    noteSkipped(token);
  }
}

/// Notes a known name in a statement that was skipped.
void Parser::noteSkipped(const Token &token) {
  if (!m_names || token.kind != TokenKind::Identifier)
    return;
  const bool suffix = token.span.begin > 0 && m_text[token.span.begin - 1] == '.';
  if (!suffix && m_symbols.find(text(token)))
    note(token, Access::Read);
}

bool Parser::expect(TokenKind kind, const char *what, const char *hint) {
  if (m_tokens.accept(kind))
    return true;
  return unexpected(what, hint);
}

bool Parser::endStatement(const char *expected, std::string hint) {
  if (m_tokens.accept(TokenKind::Semicolon))
    return true;
  if (reportLostSemicolon(m_reporter, m_text, m_tokens.last(), m_tokens.peek(),
                          beginsStatement(keywordAt().keyword), expected))
    return false;
  return unexpected(expected, std::move(hint));
}

bool Parser::unexpected(const char *expected, std::string hint) {
  return unexpectedToken(m_tokens.peek(), expected, std::move(hint));
}

bool Parser::unexpectedToken(const Token &token, const char *expected, std::string hint) {
  // Name tokens of NVIDIA's options.
  if (m_options.nv != ir::NvOption::None && token.kind == TokenKind::InvalidByte &&
      std::string_view("|():").find(m_text[token.span.begin]) != std::string_view::npos) {
    error(DiagnosticId::Syntax, token.span,
          "expected " + std::string(expected) + ", found " + describe(token), std::move(hint));
    return false;
  }
  if (token.kind == TokenKind::InvalidByte &&
      std::string_view("|()<>").find(m_text[token.span.begin]) != std::string_view::npos &&
      c_like::tokenHint(m_text, token).empty())
    hint = std::string("absolute values and condition codes belong to the ") +
           m_language.nvOptions + " options";
  reportUnexpected(m_reporter, m_text, token, expected, std::move(hint));
  return false;
}

std::string Parser::describe(const Token &token) const { return fp::describe(m_text, token); }

Word Parser::keywordAt() const {
  return m_tokens.at(TokenKind::Identifier) ? wordOf(m_tokens.peek()) : Word{};
}

bool Parser::atWord(int ahead, std::string_view word) const {
  return m_tokens.peek(ahead).kind == TokenKind::Identifier && text(m_tokens.peek(ahead)) == word;
}

void Parser::foreign(const Token &token, std::string_view what, std::string hint) {
  const std::string_view own = foreignHint(text(token), m_language);
  error(m_language.foreignId, token.span,
        std::string(what) + " belongs to " + m_language.foreignName,
        own.empty() ? std::move(hint) : std::string(own));
}

void Parser::error(DiagnosticId id, Span span, std::string message, std::string hint) {
  m_reporter.error(id, span, std::move(message), std::move(hint));
}

} // namespace arbiter::fp
