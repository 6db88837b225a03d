// Parses operands of NVIDIA's own languages.

#include <algorithm>

#include "fp_compiler/front/native/parser.h"
#include "util/suggest.h"

namespace arbiter::fp::native {

using ir::AttributeKind;
using ir::Select;

namespace {
struct AttributeRow {
  bool vertex;
  std::string_view name;
  std::uint32_t number; ///< v[number]; of a fragment none
  AttributeKind kind;
};
/// Attributes of NV_fragment_program table X.1 and NV_vertex_program table X.3, without texture
/// coordinates.
constexpr AttributeRow kAttributes[] = {
#define NATIVE_ATTRIBUTE(Stage, name, number, Kind, doc)                                           \
  {isOf(Languages::Stage, true), name, number, AttributeKind::Kind},
#include "fp_compiler/front/native/words.def"
};

const AttributeRow *findAttribute(bool vertex, std::string_view name) {
  const auto *const found =
      std::find_if(std::begin(kAttributes), std::end(kAttributes),
                   [&](const auto &row) { return row.vertex == vertex && row.name == name; });
  return found == std::end(kAttributes) ? nullptr : found;
}
constexpr std::uint32_t kFirstTexCoord = 8, kVertexAttributeCount = 16;

/// Returns v[number] as the attribute with which it shares a register.
ir::Attribute vertexAttribute(std::uint32_t number) {
  if (number >= kFirstTexCoord)
    return {AttributeKind::TexCoord, std::uint8_t(number - kFirstTexCoord)};
  for (const AttributeRow &row : kAttributes)
    if (row.vertex && row.number == number && row.kind != AttributeKind::Generic)
      return {row.kind, 0};
  return {AttributeKind::Generic, std::uint8_t(number)};
}

} // namespace

bool NativeParser::parseBase(Base &base) {
  if (!fragment() || (!at(TokenKind::Integer) && !at(TokenKind::Float)))
    return parseRegister(base);
  // A number sets every component. The sign right before it is a part of it.
  const std::uint32_t begin = m_tokens.peek().span.begin;
  ir::Vec4 value = {};
  if (!parseNumber(value[0]))
    return false;
  value.fill(base.inner ? -value[0] : value[0]);
  base.negative &= base.absolute;
  base.hasSuffix = false;
  base.operand.swizzle.fill(ir::Select::X);
  useConstant(base.operand, value, spanFrom(begin));
  return true;
}

/// Parses a register, a parameter or a vector.
bool NativeParser::parseRegister(Base &base) {
  ir::Operand &operand = base.operand;
  const Token first = m_tokens.peek();
  if (fragment() && first.kind == TokenKind::OpenBrace) {
    ir::Vec4 value = {};
    if (!parseVector(value))
      return false;
    useConstant(operand, value, spanFrom(first.span.begin));
    return true;
  }
  if (first.kind != TokenKind::Identifier)
    return unexpected(fragment() ? "a register or a parameter" : "a register");
  if (atBinding(fragment() ? "f" : "v"))
    return parseAttribute(operand);
  if (atBinding(fragment() ? "p" : "c"))
    return fragment() ? parseLocal(operand) : parseRow(operand);
  m_tokens.next();
  if (const auto row = temporary(first)) {
    operand.index = *row;
    return true;
  }
  const bool result = text(first) == "o" && at(TokenKind::OpenBracket);
  if (result || isNullRegister(text(first))) {
    error(DiagnosticId::WriteOnly, first.span,
          result ? std::string("a result cannot be read") : quote(text(first)) + " is written only",
          "compute in a temporary");
    return false;
  }
  if (m_named.find(text(first)))
    return parseNamed(first, base);
  if (!fragment() || numberBehind(text(first), "R") || numberBehind(text(first), "H"))
    return notThere(first, "a register");
  const std::string hint = operandHint(first);
  error(DiagnosticId::UndeclaredName, first.span, quote(text(first)) + " is not declared",
        hint.empty() ? "DEFINE a constant or DECLARE a parameter before it is used" : hint);
  m_named.declare(text(first), {});
  return !c_like::isCall(m_text, first.span);
}

/// Parses "f" or "v", "[" <name or number> "]". An instruction may read only one attribute.
bool NativeParser::parseAttribute(ir::Operand &operand) {
  const std::uint32_t begin = m_tokens.next().span.begin;
  m_tokens.next();
  ir::Attribute attribute;
  std::uint32_t number = 0;
  if (!(fragment() ? parseFragmentAttribute(attribute) : parseVertexAttribute(attribute, number)) ||
      !expect(TokenKind::CloseBracket, "']'"))
    return false;
  const Span where = spanFrom(begin);
  operand.file = ir::File::Attribute;
  operand.index = m_binder.attribute(attribute, where);
  if (!fragment())
    m_interface.attributes |= std::uint16_t(1u << number);
  else if (attribute.kind == AttributeKind::FogCoord) // (f, 0, 0, 0), and not ARB's w of 1
    operand.swizzle = {Select::X, Select::Zero, Select::Zero, Select::Zero};
  if (m_attribute && *m_attribute != operand.index)
    error(DiagnosticId::NativeOperands, where, "a second attribute in one instruction",
          "move one of the two into a temporary before");
  m_attribute = operand.index;
  return true;
}

bool NativeParser::parseFragmentAttribute(ir::Attribute &attribute) {
  Token name;
  if (!expectWord("the name of an attribute", name))
    return false;
  if (const auto unit = takeTexCoord(name)) {
    attribute = {AttributeKind::TexCoord, *unit};
    return true;
  }
  if (const AttributeRow *const row = findAttribute(false, text(name))) {
    attribute.kind = row->kind;
    return true;
  }
  error(DiagnosticId::UnknownBinding, name.span, "there is no attribute " + quote(text(name)),
        didYouMean(text(name), {"WPOS", "COL0", "COL1", "FOGC", "TEX0"},
                   "the attributes are WPOS, COL0, COL1, FOGC and TEX0 to TEX7"));
  return false;
}

bool NativeParser::parseVertexAttribute(ir::Attribute &attribute, std::uint32_t &number) {
  const Token name = m_tokens.peek();
  const std::uint32_t limit = statesOnly() ? 1 : kVertexAttributeCount;
  if (name.kind == TokenKind::Integer || statesOnly()) {
    if (!parseBounded(limit, DiagnosticId::AttributeIndex, "vertex attribute", number))
      return false;
    attribute = vertexAttribute(number);
    return true;
  }
  if (name.kind != TokenKind::Identifier)
    return unexpected("the number or the name of an attribute");
  m_tokens.next();
  const auto unit = numberBehind(text(name), "TEX");
  const AttributeRow *const row = findAttribute(true, text(name));
  if (!row && !(unit && *unit < kTexCoords)) {
    error(DiagnosticId::UnknownBinding, name.span, "there is no attribute " + quote(text(name)),
          didYouMean(text(name), {"OPOS", "WGHT", "NRML", "COL0", "COL1", "FOGC", "TEX0"},
                     "the attributes are 0 to 15, OPOS, WGHT, NRML, COL0, COL1, FOGC and TEX0 to "
                     "TEX7"));
    return false;
  }
  number = row ? row->number : kFirstTexCoord + *unit;
  attribute = vertexAttribute(number);
  return true;
}

/// Parses <numberedLocal>: "p" "[" <integer> "]".
bool NativeParser::parseLocal(ir::Operand &operand) {
  const std::uint32_t begin = m_tokens.next().span.begin;
  std::uint32_t index = 0;
  if (!parseIndex(std::min(m_limits.localParameters, kMaxLocals), DiagnosticId::ParameterIndex,
                  "local parameter", index))
    return false;
  operand.file = ir::File::Parameter;
  operand.index = m_binder.local(index, spanFrom(begin));
  useParameter(operand, spanFrom(begin));
  return true;
}

/// Parses <progParamRegister>: "c" "[" <integer> "]" or "c" "[" <address> "]".
bool NativeParser::parseRow(ir::Operand &operand) {
  const std::uint32_t begin = m_tokens.peek().span.begin;
  operand.file = ir::File::Parameter;
  m_tokens.next();
  if (m_tokens.peek(1).kind == TokenKind::Identifier) {
    if (!parseRelativeRow(operand))
      return false;
  } else {
    std::uint32_t index = 0;
    if (!parseIndex(m_traits.rows, DiagnosticId::ParameterIndex, "program parameter", index))
      return false;
    operand.index = m_binder.env(index, spanFrom(begin));
    m_rowsRead.insert(std::uint16_t(index));
  }
  useParameter(operand, spanFrom(begin));
  return true;
}

/// Parses "[" <address register> "." <component> <offset> "]". A row outside of the file reads as
/// zero.
bool NativeParser::parseRelativeRow(ir::Operand &operand) {
  m_tokens.next();
  const Token name = m_tokens.next();
  const auto row = address(name);
  std::uint8_t component = 0;
  if (!row)
    return notThere(name, m_traits.addresses > 1 ? "an integer, A0 or A1" : "an integer or A0");
  std::optional<Offset> offset;
  if (!parseAddressComponent(component) || !parseOffset(offset))
    return false;
  if (offset) {
    const int limit = offset->negative ? -m_traits.lowest : m_traits.highest;
    if (offset->magnitude > std::uint32_t(limit))
      error(DiagnosticId::RelativeOffset, offset->token.span,
            "the offset " + quote(text(offset->token)) + " is out of range",
            "offsets of " + header() + " reach from " + std::to_string(m_traits.lowest) + " to " +
                std::to_string(m_traits.highest));
    else
      operand.offset = offset->value();
  }
  if (!expect(TokenKind::CloseBracket, "'+', '-' or ']'"))
    return false;
  m_interface.readsAnyRow = true;
  operand.relative = true;
  operand.index = 0; // the program's one array
  operand.address = std::uint8_t(*row + component);
  return true;
}

/// Reports an error if an instruction reads more than one parameter, or constants of more than four
/// different numbers (NV_fragment_program 3.11.2).
void NativeParser::useParameter(const ir::Operand &operand, Span where) {
  const auto isSame = [&](const ir::Operand &other) {
    return other.relative == operand.relative && other.index == operand.index &&
           other.address == operand.address && other.offset == operand.offset;
  };
  if (!m_scalars.empty() || (m_parameter && !isSame(*m_parameter)))
    tooManyParameters(where);
  m_parameter = operand;
}

/// Binds a constant as an operand.
void NativeParser::useConstant(ir::Operand &operand, const ir::Vec4 &value, Span where) {
  operand.file = ir::File::Parameter;
  operand.index = m_binder.constant(value, where);
  m_scalars.insert(value.begin(), value.end());
  constexpr std::size_t kMaxScalars = 4;
  if (m_parameter || m_scalars.size() > kMaxScalars)
    tooManyParameters(where);
}

void NativeParser::tooManyParameters(Span where) {
  error(DiagnosticId::NativeOperands, where, "a second parameter in one instruction",
        fragment() ? "move one into a temporary before; constants of four different numbers may "
                     "stand beside each other"
                   : "move one of the two into a temporary before");
}

} // namespace arbiter::fp::native
