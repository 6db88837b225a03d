#include "fp_compiler/front/parser.h"

#include <algorithm>

#include "fp_compiler/front/suggest.h"

namespace arbiter::fp {

namespace {

constexpr std::string_view kHeader = "!!ARBfp1.0";

constexpr std::string_view kNvInstructions[] = {
    "DDX", "DDY", "PK2H", "PK2US", "PK4B",  "PK4UB", "RFL",     "SEQ",    "SFL", "SGT",
    "SLE", "SNE", "STR",  "TXD",   "UP2H",  "UP2US", "UP4B",    "UP4UB",  "X2D", "BRK",
    "CAL", "DIV", "DP2",  "DP2A",  "ELSE",  "ENDIF", "ENDLOOP", "ENDREP", "IF",  "LOOP",
    "NRM", "REP", "RET",  "TXL",   "SHORT", "LONG",  "FLOAT",   "INT"};

constexpr std::string_view kStatementWords[] = {
#define FP_OP(Enumerator, mnemonic, shapes, traits, section, doc) mnemonic,
#include "fp_compiler/ir/ops.def"
#undef FP_OP
    "ALIAS", "ATTRIB", "OUTPUT", "PARAM", "TEMP", "END"};

bool contains(std::span<const std::string_view> words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// ADDR, MULH_SAT, MOVC: an opcode of ours with the precision or condition letters of NV.
bool isNvVariant(std::string_view word) {
  const std::string_view base = word.substr(0, 3);
  const std::string_view letters = word.substr(base.size(), word.find('_') - base.size());
  return base.size() == 3 && classify(base).keyword == Keyword::Opcode && !letters.empty() &&
         letters.size() <= 2 && letters.find_first_not_of("RHXC") == std::string_view::npos;
}

bool checkHeader(std::string_view text, Reporter &reporter) {
  if (text.substr(0, kHeader.size()) == kHeader)
    return true;
  std::uint32_t wrong = 0;
  while (wrong < text.size() && text[wrong] == kHeader[wrong])
    ++wrong;
  std::string hint = "the first ten bytes must be !!ARBfp1.0, with nothing before them";
  if (text.empty())
    hint = "the text is empty; the length given was 0";
  else if (text.starts_with("\xEF\xBB\xBF"))
    hint = "a byte order mark precedes the header; save the file without one";
  else if (text.starts_with("!!ARBvp") || text.starts_with("!!VP") || text.starts_with("!!VSP"))
    hint = "this is a vertex program; load it for GL_VERTEX_PROGRAM_ARB";
  else if (text.starts_with("!!FP") || text.starts_with("!!FCP"))
    hint = "this is an NV_fragment_program, which is not offered";
  else if (text.find(kHeader) < 64)
    hint = "the header is there, but not at the first byte";
  reporter.error(DiagnosticId::HeaderMissing,
                 {wrong, std::min(wrong + 1, std::uint32_t(text.size()))},
                 "the header !!ARBfp1.0 is missing", std::move(hint));
  return false;
}

} // namespace

ParseResult parseFragmentProgram(std::string_view text, const CompileOptions &options) {
  Reporter reporter;
  ParseResult result;
  if (text.size() > kMaxTextBytes) {
    reporter.error(DiagnosticId::TextTooLong, {kMaxTextBytes, kMaxTextBytes + 1},
                   "the text is longer than " + std::to_string(kMaxTextBytes) + " bytes",
                   "check the length given; no program needs so much");
  } else if (checkHeader(text, reporter)) {
    Parser parser(text, std::uint32_t(kHeader.size()), options, reporter);
    parser.parse();
    if (!reporter.hasErrors()) {
      result.counts = parser.binder().counts();
      result.program = parser.binder().takeProgram();
    }
  }
  result.diagnostics = reporter.take();
  return result;
}

Parser::Parser(std::string_view text, std::uint32_t begin, const CompileOptions &options,
               Reporter &reporter)
    : m_text(text), m_limits(options.limits), m_policy(options.policy), m_reporter(reporter),
      m_tokens(text, begin), m_binder(options, reporter) {}

void Parser::parse() {
  parseOptions();
  m_binder.setOptions(m_options);
  while (!m_reporter.full()) {
    if (m_tokens.at(TokenKind::EndOfText)) {
      error(DiagnosticId::EndMissing, m_tokens.peek().span, "the text ends before END",
            "every program ends with END; check the length given");
      return;
    }
    if (keywordAt().keyword == Keyword::End)
      return parseEnd();
    parseStatement();
  }
}

void Parser::parseOptions() {
  while (keywordAt().keyword == Keyword::Option && !m_reporter.full())
    if (!parseOption(false))
      recover();
}

bool Parser::parseOption(bool late) {
  const Token option = m_tokens.next();
  if (!m_tokens.at(TokenKind::Identifier))
    return unexpected("the name of an option");
  const Token name = m_tokens.next();
  if (late)
    error(DiagnosticId::LateOption, option.span, "OPTION after the first statement",
          "options come directly after the header");
  else
    applyOption(name);
  return expect(TokenKind::Semicolon, "';'");
}

void Parser::applyOption(const Token &token) {
  const std::string_view name = text(token);
  const auto fog = [&](ir::FogMode mode) {
    if (m_options.fog != ir::FogMode::None && m_options.fog != mode)
      error(DiagnosticId::ConflictingFog, token.span, "a second, different fog option",
            "a program may have one of ARB_fog_exp, ARB_fog_exp2 and ARB_fog_linear");
    else
      m_options.fog = mode;
  };
  const auto precision = [&](ir::Precision wanted) {
    if (m_options.precision != ir::Precision::Unspecified && m_options.precision != wanted)
      error(DiagnosticId::ConflictingPrecision, token.span, "both precision hints",
            "keep either ARB_precision_hint_fastest or ARB_precision_hint_nicest");
    else
      m_options.precision = wanted;
  };
  if (name == "ARB_fog_exp")
    fog(ir::FogMode::Exp);
  else if (name == "ARB_fog_exp2")
    fog(ir::FogMode::Exp2);
  else if (name == "ARB_fog_linear")
    fog(ir::FogMode::Linear);
  else if (name == "ARB_precision_hint_fastest")
    precision(ir::Precision::Fastest);
  else if (name == "ARB_precision_hint_nicest")
    precision(ir::Precision::Nicest);
  else if (name == "ARB_fragment_program_shadow")
    m_options.shadow = true;
  else if (name == "ARB_draw_buffers" || name == "ATI_draw_buffers")
    m_options.drawBuffers = true;
  else if (name == "ARB_fragment_coord_origin_upper_left")
    m_options.originUpperLeft = true;
  else if (name == "ARB_fragment_coord_pixel_center_integer")
    m_options.pixelCenterInteger = true;
  else if (name == "ARB_position_invariant")
    error(DiagnosticId::UnsupportedOption, token.span,
          "OPTION ARB_position_invariant: vertex programs only",
          "remove it; a fragment program keeps the rasterizer's position");
  else if (name.starts_with("NV_"))
    error(DiagnosticId::UnsupportedOption, token.span,
          "OPTION " + std::string(name.substr(0, 48)) + ": not offered",
          "this implementation offers ARB_fragment_program as published; use a path of the "
          "application that needs no NV option");
  else
    error(DiagnosticId::UnsupportedOption, token.span, "OPTION " + quote(name) + " is not offered",
          didYouMean(name, {"ARB_fog_exp", "ARB_fog_exp2", "ARB_fog_linear",
                            "ARB_precision_hint_fastest", "ARB_precision_hint_nicest",
                            "ARB_fragment_program_shadow", "ARB_draw_buffers", "ATI_draw_buffers",
                            "ARB_fragment_coord_origin_upper_left",
                            "ARB_fragment_coord_pixel_center_integer"}));
}

void Parser::parseStatement() {
  if (!m_tokens.at(TokenKind::Identifier)) {
    unexpected("an instruction, a declaration or END");
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
  const Token first = m_tokens.next();
  if (!parseStatementBody(first, word))
    recover();
}

bool Parser::parseStatementBody(const Token &first, const Word &word) {
  switch (word.keyword) {
  case Keyword::Opcode:
    return parseInstruction(first, word);
  case Keyword::Temp:
    return parseTemp();
  case Keyword::Attrib:
    return parseAttrib();
  case Keyword::Output:
    return parseOutput();
  case Keyword::Alias:
    return parseAlias();
  case Keyword::Param:
    return parseParam();
  case Keyword::None:
    return unknownStatement(first);
  case Keyword::Fragment:
  case Keyword::Program:
  case Keyword::Result:
  case Keyword::State:
  case Keyword::Texture:
    return unexpectedToken(first, "an instruction, a declaration or END");
  case Keyword::Option:
  case Keyword::End:
    break; // the callers took these
  }
  return false;
}

bool Parser::unknownStatement(const Token &first) {
  const std::string_view word = text(first);
  if (word == "ADDRESS" || word == "ARL" || word == "EXP" || word == "LOG") {
    error(DiagnosticId::VertexOnly, first.span, std::string(word) + " belongs to vertex programs",
          word == "EXP"   ? "use EX2"
          : word == "LOG" ? "use LG2"
                          : "arrays of a fragment program take constant indexes only");
    // The name is declared, so that its uses are not reported as well.
    if (word == "ADDRESS" && m_tokens.at(TokenKind::Identifier))
      m_symbols.declare(text(m_tokens.peek()), {});
  } else if (contains(kNvInstructions, word.substr(0, word.find('_'))) || isNvVariant(word)) {
    error(DiagnosticId::NvOnly, first.span,
          quote(word) + " belongs to the NV_fragment_program options, which are not offered",
          isNvVariant(word) ? "write " + std::string(word.substr(0, 3)) : "");
  } else if (word == "KIL_SAT") {
    error(DiagnosticId::UnknownInstruction, first.span, "KIL writes nothing and takes no _SAT",
          "write KIL");
  } else {
    error(DiagnosticId::UnknownInstruction, first.span, "unknown instruction " + quote(word),
          didYouMean(word, kStatementWords));
  }
  return false;
}

void Parser::parseEnd() {
  m_tokens.next();
  if (m_tokens.at(TokenKind::EndOfText))
    return;
  const Token token = m_tokens.peek();
  const std::string_view rest = m_text.substr(token.span.begin);
  // Callers that pass sizeof of a literal count its terminator.
  if (rest.find_first_not_of('\0') == std::string_view::npos) {
    m_reporter.warning(DiagnosticId::TrailingNul, {token.span.begin, std::uint32_t(m_text.size())},
                       "the length counts a NUL byte after END");
    return;
  }
  error(DiagnosticId::TextAfterEnd, token.span, "text after END", "only comments may follow END");
}

void Parser::recover() {
  while (!m_tokens.at(TokenKind::EndOfText)) {
    if (beginsStatement(keywordAt().keyword))
      return;
    if (m_tokens.next().kind == TokenKind::Semicolon)
      return;
  }
}

bool Parser::expect(TokenKind kind, const char *what, const char *hint) {
  if (m_tokens.accept(kind))
    return true;
  return unexpected(what, hint);
}

bool Parser::unexpected(const char *expected, std::string hint) {
  return unexpectedToken(m_tokens.peek(), expected, std::move(hint));
}

bool Parser::unexpectedToken(const Token &token, const char *expected, std::string hint) {
  switch (token.kind) {
  case TokenKind::InvalidByte: {
    const char c = m_text[token.span.begin];
    if (c == '|' || c == '(' || c == ')' || c == '<' || c == '>')
      hint = "absolute values and condition codes belong to the NV_fragment_program options";
    else if (c == '/' || c == '*')
      hint = "a comment begins with #";
    error(DiagnosticId::InvalidCharacter, token.span, "invalid character " + describe(token),
          std::move(hint));
    break;
  }
  case TokenKind::OverlongIdentifier:
    error(DiagnosticId::IdentifierTooLong, token.span,
          "an identifier of more than " + std::to_string(kMaxIdentifierBytes) + " bytes");
    break;
  case TokenKind::OverlongNumeral:
    error(DiagnosticId::NumeralTooLong, token.span,
          "a numeral of more than " + std::to_string(kMaxNumeralBytes) + " characters");
    break;
  default:
    error(DiagnosticId::Syntax, token.span,
          "expected " + std::string(expected) + ", found " + describe(token), std::move(hint));
  }
  return false;
}

std::string Parser::describe(const Token &token) const {
  if (token.kind == TokenKind::EndOfText)
    return "the end of the text";
  const auto byte = token.span.begin < m_text.size() ? std::uint8_t(m_text[token.span.begin]) : 0;
  if (token.kind == TokenKind::InvalidByte && (byte < ' ' || byte > '~')) {
    static constexpr char kHex[] = "0123456789ABCDEF";
    return std::string("0x") + kHex[byte >> 4] + kHex[byte & 15];
  }
  return quote(text(token));
}

Word Parser::keywordAt() const {
  return m_tokens.at(TokenKind::Identifier) ? classify(text(m_tokens.peek())) : Word{};
}

bool Parser::atWord(int ahead, std::string_view word) const {
  return m_tokens.peek(ahead).kind == TokenKind::Identifier && text(m_tokens.peek(ahead)) == word;
}

void Parser::error(DiagnosticId id, Span span, std::string message, std::string hint) {
  m_reporter.error(id, span, std::move(message), std::move(hint));
}

} // namespace arbiter::fp
