// Parses destinations of NVIDIA's own languages, and registers by their names.

#include "fp_compiler/front/native/parser.h"
#include "util/suggest.h"

namespace arbiter::fp::native {

using ir::OutputKind;

namespace {
struct ResultRow {
  bool vertex;
  std::string_view name;
  OutputKind kind;
};
/// Results of NV_fragment_program table X.3 and NV_vertex_program table X.1, without texture
/// coordinates.
constexpr ResultRow kResults[] = {
#define NATIVE_RESULT(Stage, name, Kind, doc)                                                      \
  {isOf(Languages::Stage, true), name, OutputKind::Kind},
#include "fp_compiler/front/native/words.def"
};

const ResultRow *findResult(bool vertex, std::string_view name) {
  for (const ResultRow &row : kResults)
    if (row.vertex == vertex && row.name == name)
      return &row;
  return nullptr;
}
constexpr std::uint32_t kClipDistances = 6; // CLP0 to CLP5 (NV_vertex_program2, table X.1)
constexpr std::uint32_t kMaxUnits = 64;     // of !!FP1.0's registers
} // namespace

bool NativeParser::parseDestinationRegister(ir::Destination &destination) {
  const std::string expected = statesOnly() ? "a temporary or c[n]" : "a temporary or a result";
  if (!at(TokenKind::Identifier))
    return unexpected(expected.c_str());
  if (atBinding("o"))
    return parseResult(destination);
  if (statesOnly() && atBinding("c"))
    return parseWrittenRow(destination);
  const Token name = m_tokens.next();
  if (const auto row = temporary(name)) {
    destination.index = *row;
    return true;
  }
  if (isNullRegister(text(name))) {
    destination.index = nullRegister(name.span);
    return true;
  }
  const std::string_view word = text(name);
  const bool binding = at(TokenKind::OpenBracket) &&
                       (word == (fragment() ? "f" : "v") || word == (fragment() ? "p" : "c"));
  if (!binding && !m_named.find(word))
    return notThere(name, expected.c_str());
  error(DiagnosticId::ReadOnly, name.span,
        std::string(word == "f" || word == "v" ? "an attribute" : "a parameter") +
            " cannot be written",
        "write " + expected);
  return false;
}

/// Reports a word in place of a register: one that the language lacks, or not a register at all.
bool NativeParser::notThere(const Token &name, const char *expected) {
  const std::string_view word = text(name);
  const auto number = numberBehind(word, "R");
  if (number && *number >= m_traits.registers)
    error(DiagnosticId::NativeRegister, name.span, header() + " has no register " + quote(word),
          "its temporaries are R0 to R" + std::to_string(m_traits.registers - 1));
  else if (const auto half = numberBehind(word, "H"); half && fragment())
    error(DiagnosticId::NativeRegister, name.span, header() + " has no register " + quote(word),
          "its temporaries of 16 bits are H0 to H" + std::to_string(m_traits.halves - 1));
  else if (numberBehind(word, "A"))
    error(DiagnosticId::AddressRegister, name.span,
          "the address register " + quote(word) + " cannot stand here",
          m_traits.addresses != 0 ? "ARL loads it, and an index reads it: c[A0.x]" : "");
  else
    unexpectedToken(name, expected, operandHint(name));
  return false;
}

/// Returns the row of a temporary, which is added at its first use. Returns nothing for other
/// words.
std::optional<std::uint16_t> NativeParser::temporary(const Token &name) {
  const auto full = numberBehind(text(name), "R");
  const auto half = full ? std::nullopt : numberBehind(text(name), "H");
  const bool there = full ? *full < m_traits.registers : half && *half < m_traits.halves;
  if (!there)
    return std::nullopt;
  std::optional<std::uint16_t> &row = m_temporaries[full ? *full : 32 + *half];
  if (!row) {
    row = m_binder.temporary(text(name), name.span);
    countUnits(full ? 2 : 1, name.span);
  }
  return row;
}

std::optional<std::uint8_t> NativeParser::takeTexCoord(const Token &name) {
  const auto unit = numberBehind(text(name), "TEX");
  if (!unit || *unit >= kTexCoords)
    return std::nullopt;
  if (*unit >= m_limits.textureCoords)
    error(DiagnosticId::TexCoordIndex, name.span,
          "there is no texture coordinate set " + std::to_string(*unit));
  return std::uint8_t(*unit);
}

/// Counts register units of !!FP1.0. A register of 32 bits counts twice.
void NativeParser::countUnits(std::uint32_t units, Span where) {
  const bool before = m_units > kMaxUnits;
  m_units += units;
  if (fragment() && !before && m_units > kMaxUnits)
    error(DiagnosticId::LimitTemporaries, where,
          "more than " + std::to_string(kMaxUnits) + " register halves",
          "each of R0 to R31, o[COLR] and o[DEPR] counts as two, each of H0 to H63 and o[COLH] as "
          "one");
}

bool NativeParser::isNullRegister(std::string_view word) const {
  return fragment() ? word == "RC" || word == "HC"
                    : m_traits.language == ir::NativeLanguage::Vp2 && word == "CC";
}

std::uint16_t NativeParser::nullRegister(Span where) {
  if (!m_nullRegister)
    m_nullRegister = m_binder.hiddenTemporary(fragment() ? "RC" : "CC", where);
  return *m_nullRegister;
}

bool NativeParser::isRegisterName(std::string_view word) const {
  const auto full = numberBehind(word, "R"), half = numberBehind(word, "H");
  return (full && *full < m_traits.registers) || (half && *half < m_traits.halves) ||
         isNullRegister(word);
}

/// Returns the first of the four IR registers of A0 or A1; nothing for other words.
std::optional<std::uint16_t> NativeParser::address(const Token &name) {
  const auto number = numberBehind(text(name), "A");
  if (!number || *number >= m_traits.addresses)
    return std::nullopt;
  std::optional<std::uint16_t> &row = m_addresses[*number];
  if (!row)
    row = m_binder.addressVector(text(name), name.span);
  return row;
}

std::optional<std::uint16_t> NativeParser::takeAddress(Access) {
  const Token name = m_tokens.peek();
  const auto row = name.kind == TokenKind::Identifier ? address(name) : std::nullopt;
  if (row)
    m_tokens.next();
  else
    unexpected(m_traits.addresses > 1 ? "A0 or A1" : "A0");
  return row;
}

/// Parses "o" "[" <name> "]".
bool NativeParser::parseResult(ir::Destination &destination) {
  const Token letter = m_tokens.next();
  m_tokens.next();
  if (!at(TokenKind::Identifier))
    return unexpected("the name of a result");
  if (statesOnly()) {
    error(DiagnosticId::NativeRegister, letter.span, "a vertex state program has no results",
          "it writes program parameters, c[n]");
    return false;
  }
  const Token name = m_tokens.next();
  ir::Output output;
  if (!(fragment() ? parseFragmentResult(name, output) : parseVertexResult(name, output)))
    return false;
  destination.file = ir::File::Output;
  destination.index = m_binder.output(output);
  if (m_results.insert(destination.index).second && fragment())
    countUnits(text(name) == "COLH" ? 1 : 2, letter.span);
  return expect(TokenKind::CloseBracket, "']'");
}

bool NativeParser::parseFragmentResult(const Token &name, ir::Output &output) {
  const std::string_view word = text(name);
  const ResultRow *const row = findResult(false, word);
  if (!row) {
    error(DiagnosticId::UnknownBinding, name.span, "there is no result " + quote(word),
          didYouMean(word, {"COLR", "COLH", "DEPR"}, "the results are COLR, COLH and DEPR"));
    return false;
  }
  output.kind = row->kind;
  if (row->kind != OutputKind::Color)
    return true;
  if (m_color && *m_color != word)
    error(DiagnosticId::NativeOutputs, name.span, "o[COLR] and o[COLH] are both written",
          "a program gives one colour; write all of it to one of the two");
  m_color = word;
  return true;
}

bool NativeParser::parseVertexResult(const Token &name, ir::Output &output) {
  const std::string_view word = text(name);
  if (const auto unit = takeTexCoord(name)) {
    output = {OutputKind::TexCoord, *unit};
    return true;
  }
  if (const ResultRow *const row = findResult(true, word)) {
    output.kind = row->kind;
    const bool position = row->kind == OutputKind::Position;
    m_writesPosition |= position;
    if (position && m_options.positionInvariant)
      error(DiagnosticId::InvariantPosition, name.span,
            "o[HPOS] under OPTION NV_position_invariant",
            "the option computes the position; remove one of the two");
    return true;
  }
  const auto plane = numberBehind(word, "CLP");
  if (m_traits.language == ir::NativeLanguage::Vp2 && plane && *plane < kClipDistances) {
    output = {OutputKind::ClipDistance, std::uint8_t(*plane)};
    return true;
  }
  error(DiagnosticId::UnknownBinding, name.span, "there is no result " + quote(word),
        didYouMean(word, {"HPOS", "COL0", "COL1", "BFC0", "BFC1", "FOGC", "PSIZ", "TEX0"},
                   std::string("the results are HPOS, COL0, COL1, BFC0, BFC1, FOGC, PSIZ, TEX0 to "
                               "TEX7") +
                       (m_traits.language == ir::NativeLanguage::Vp2 ? ", CLP0 to CLP5" : "")));
  return false;
}

/// Parses "c" "[" <integer> "]" of a vertex state program.
bool NativeParser::parseWrittenRow(ir::Destination &destination) {
  const Token letter = m_tokens.next();
  std::uint32_t index = 0;
  if (!parseIndex(m_traits.rows, DiagnosticId::ParameterIndex, "program parameter", index))
    return false;
  destination.file = ir::File::Output;
  destination.index = m_binder.output({OutputKind::EnvParameter, std::uint8_t(index)});
  m_rowsWritten.insert(std::uint16_t(index));
  m_rules.rows[destination.index] = {m_binder.env(index, spanFrom(letter.span.begin)),
                                     std::uint16_t(index)};
  return true;
}

bool NativeParser::parseBounded(std::uint32_t limit, DiagnosticId id, const char *what,
                                std::uint32_t &value) {
  Token token;
  if (!expectInteger(token, value))
    return false;
  if (value < limit)
    return true;
  error(id, token.span,
        std::string("there is no ") + what + " " + quote(text(token)) + " in " + header(),
        "they go from 0 to " + std::to_string(limit - 1));
  value = 0;
  return true;
}

/// Parses <texImageUnit> "," <texImageTarget>, from the comma before them.
bool NativeParser::parseTexture(ir::Instruction &instruction) {
  if (!expectPart(instruction.op, {PartKind::Unit}))
    return false;
  constexpr std::uint32_t kNamed = 16; // TEX0 to TEX15
  const std::uint32_t limit = std::min(m_limits.textureImageUnits, kNamed);
  const Token unit = m_tokens.peek();
  const auto number =
      unit.kind == TokenKind::Identifier ? numberBehind(text(unit), "TEX") : std::nullopt;
  if (!number)
    return unexpected("a texture image unit: TEX0 and up");
  m_tokens.next();
  const bool there = *number < limit;
  if (!there)
    error(DiagnosticId::ImageUnit, unit.span, "there is no image unit " + quote(text(unit)),
          "units are TEX0 to TEX" + std::to_string(limit - 1));
  instruction.unit = std::uint8_t(there ? *number : 0);
  Token word;
  const TargetRow *row = nullptr;
  if (!expectPart(instruction.op, {PartKind::Target}) ||
      !parseTarget("a texture target: 1D, 2D, 3D, CUBE or RECT", false, word, row))
    return false;
  if (!row)
    return true;
  instruction.target = row->target;
  std::optional<ir::TexTarget> &target = m_targets[instruction.unit];
  if (target && *target != row->target)
    error(DiagnosticId::TargetConflict, word.span,
          quote(text(unit)) + " is sampled with another target before",
          "one texture image unit has one target in a program");
  if (!target)
    target = row->target;
  return true;
}

} // namespace arbiter::fp::native
