#include "state/programs/ati_recorder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace arbiter::state {

namespace {

using fp::ati::Argument;
using fp::ati::Coordinates;
using fp::ati::Op;
using fp::ati::Operation;
using fp::ati::Pair;
using fp::ati::Pass;
using fp::ati::Replicate;
using fp::ati::Scale;
using fp::ati::SetupKind;
using fp::ati::Source;
using Verdict = AtiRecorder::Verdict;

struct OpName {
  GLenum name;
  Op op;
};
constexpr OpName kOps[] = {
    {GL_MOV_ATI, Op::Mov},   {GL_ADD_ATI, Op::Add},          {GL_MUL_ATI, Op::Mul},
    {GL_SUB_ATI, Op::Sub},   {GL_DOT3_ATI, Op::Dot3},        {GL_DOT4_ATI, Op::Dot4},
    {GL_MAD_ATI, Op::Mad},   {GL_LERP_ATI, Op::Lerp},        {GL_CND_ATI, Op::Cnd},
    {GL_CND0_ATI, Op::Cnd0}, {GL_DOT2_ADD_ATI, Op::Dot2Add},
};

/// Returns the opcode's row, or null if the command with that many arguments does not accept it.
const OpName *findOp(GLenum name, int argumentCount) {
  const auto *const found = std::find_if(std::begin(kOps), std::end(kOps), [&](const OpName &row) {
    return row.name == name && fp::ati::argumentCount(row.op) == argumentCount;
  });
  return found == std::end(kOps) ? nullptr : found;
}

bool parseSwizzle(GLenum name, Coordinates &coordinates) {
  switch (name) {
  case GL_SWIZZLE_STR_ATI:
    coordinates = Coordinates::Str;
    return true;
  case GL_SWIZZLE_STQ_ATI:
    coordinates = Coordinates::Stq;
    return true;
  case GL_SWIZZLE_STR_DR_ATI:
    coordinates = Coordinates::StrDr;
    return true;
  case GL_SWIZZLE_STQ_DQ_ATI:
    coordinates = Coordinates::StqDq;
    return true;
  default:
    return false;
  }
}

bool readsQ(Coordinates coordinates) {
  return coordinates == Coordinates::Stq || coordinates == Coordinates::StqDq;
}

bool parseReplicate(GLuint name, Replicate &replicate) {
  switch (name) {
  case GL_NONE:
    replicate = Replicate::None;
    return true;
  case GL_RED:
    replicate = Replicate::Red;
    return true;
  case GL_GREEN:
    replicate = Replicate::Green;
    return true;
  case GL_BLUE:
    replicate = Replicate::Blue;
    return true;
  case GL_ALPHA:
    replicate = Replicate::Alpha;
    return true;
  default:
    return false;
  }
}

bool parseSource(GLuint name, Argument &argument) {
  const int constant = atiConstant(name);
  if (constant >= 0) {
    argument.source = Source::Constant;
    argument.index = std::uint8_t(constant);
    return true;
  }
  if (name >= GL_REG_0_ATI && name < GL_REG_0_ATI + fp::ati::kRegisters) {
    argument.source = Source::Register;
    argument.index = std::uint8_t(name - GL_REG_0_ATI);
    return true;
  }
  switch (name) {
  case GL_ZERO:
    argument.source = Source::Zero;
    return true;
  case GL_ONE:
    argument.source = Source::One;
    return true;
  case GL_PRIMARY_COLOR_ARB:
    argument.source = Source::Primary;
    return true;
  case GL_SECONDARY_INTERPOLATOR_ATI:
    argument.source = Source::Secondary;
    return true;
  default:
    return false;
  }
}

Verdict parseArgument(const AtiRecorder::RawArgument &raw, Argument &argument) {
  constexpr GLuint kModifiers =
      GL_2X_BIT_ATI | GL_COMP_BIT_ATI | GL_NEGATE_BIT_ATI | GL_BIAS_BIT_ATI;
  if (!parseSource(raw.source, argument))
    return {GL_INVALID_ENUM, "an argument is no register, constant or interpolator"};
  if (!parseReplicate(raw.replicate, argument.replicate))
    return {GL_INVALID_ENUM, "an argument's replication is none of NONE, RED, GREEN, BLUE, ALPHA"};
  if ((raw.modifiers & ~kModifiers) != 0)
    return {GL_INVALID_ENUM, "an argument's modifiers have unknown bits"};
  argument.complement = (raw.modifiers & GL_COMP_BIT_ATI) != 0;
  argument.bias = (raw.modifiers & GL_BIAS_BIT_ATI) != 0;
  argument.twice = (raw.modifiers & GL_2X_BIT_ATI) != 0;
  argument.negate = (raw.modifiers & GL_NEGATE_BIT_ATI) != 0;
  return {};
}

/// Parses table 3.22; scales exclude each other.
Verdict parseDestinationModifiers(GLuint bits, Operation &operation) {
  constexpr Scale kScales[] = {Scale::Twice, Scale::Four,    Scale::Eight,
                               Scale::Half,  Scale::Quarter, Scale::Eighth};
  operation.saturate = (bits & GL_SATURATE_BIT_ATI) != 0;
  const GLuint scale = bits & ~GLuint(GL_SATURATE_BIT_ATI);
  if (scale == 0)
    return {};
  if (scale > GL_EIGHTH_BIT_ATI || !std::has_single_bit(scale))
    return {GL_INVALID_ENUM, "the destination's modifiers exclude each other"};
  operation.scale = kScales[std::countr_zero(scale)];
  return {};
}

/// True if the argument reads alpha of the secondary colour, which has none (AFS Errors).
bool readsSecondaryAlpha(bool alpha, Op op, const Argument &argument) {
  if (argument.source != Source::Secondary)
    return false;
  if (argument.replicate == Replicate::Alpha)
    return true;
  return argument.replicate == Replicate::None && (alpha || op == Op::Dot4);
}

bool readsColors(const Operation &operation) {
  const auto *const first = operation.arguments.begin();
  return std::any_of(first, first + argumentCount(operation.op), [](const Argument &argument) {
    return argument.source == Source::Primary || argument.source == Source::Secondary;
  });
}

bool readsThreeConstants(const Operation &operation) {
  if (argumentCount(operation.op) < 3)
    return false;
  const auto &[a, b, c] = operation.arguments;
  return a.source == Source::Constant && b.source == Source::Constant &&
         c.source == Source::Constant && a.index != b.index && b.index != c.index &&
         a.index != c.index;
}

Verdict parseOperation(const AtiRecorder::RawOperation &raw, Operation &operation) {
  constexpr GLuint kMask = GL_RED_BIT_ATI | GL_GREEN_BIT_ATI | GL_BLUE_BIT_ATI;
  const OpName *const op = findOp(raw.op, raw.argumentCount);
  if (!op)
    return {GL_INVALID_ENUM, "no opcode of this command"};
  operation.op = op->op;
  if ((raw.mask & ~kMask) != 0)
    return {GL_INVALID_ENUM, "the destination's mask has unknown bits"};
  operation.mask = std::uint8_t(raw.mask == GL_NONE ? kMask : raw.mask);
  Verdict verdict = parseDestinationModifiers(raw.modifiers, operation);
  for (int i = 0; i < raw.argumentCount && verdict.error == GL_NO_ERROR; ++i)
    verdict = parseArgument(raw.arguments[std::size_t(i)], operation.arguments[std::size_t(i)]);
  if (verdict.error != GL_NO_ERROR)
    return verdict;
  for (int i = 0; i < raw.argumentCount; ++i)
    if (readsSecondaryAlpha(raw.alpha, operation.op, operation.arguments[std::size_t(i)]))
      return {GL_INVALID_OPERATION, "SECONDARY_INTERPOLATOR_ATI has no alpha"};
  if (readsThreeConstants(operation))
    return {GL_INVALID_OPERATION, "three different constants in one operation"};
  return {};
}

} // namespace

bool AtiRecorder::isRegister(GLuint name) const {
  return name >= GL_REG_0_ATI && name < GL_REG_0_ATI + fp::ati::kRegisters &&
         name - GL_REG_0_ATI < m_imageUnits;
}

Verdict AtiRecorder::checkSource(int pass, GLuint source, GLenum swizzle) const {
  Coordinates coordinates = Coordinates::Str;
  if (!parseSwizzle(swizzle, coordinates))
    return {GL_INVALID_ENUM, "no swizzle"};
  if (isRegister(source)) {
    if (pass == 0)
      return {GL_INVALID_OPERATION, "the first pass cannot read registers of one before"};
    if (readsQ(coordinates))
      return {GL_INVALID_OPERATION, "a register has no q: use STR or STR_DR"};
    return {};
  }
  const GLuint set = source - GL_TEXTURE0;
  if (source < GL_TEXTURE0 || set >= GLuint(fp::ati::kTexCoords) || set >= m_coordinateSets)
    return {GL_INVALID_ENUM, "the source is neither a register nor a texture coordinate set"};
  if (m_families[set] != 0 && m_families[set] != (readsQ(coordinates) ? 2 : 1))
    return {GL_INVALID_OPERATION, "a texture coordinate set is read as STR and as STQ"};
  return {};
}

Verdict AtiRecorder::setup(SetupKind kind, GLuint destination, GLuint source, GLenum swizzle) {
  if (!isRegister(destination))
    return {GL_INVALID_ENUM, "the destination is no register"};
  const int current = m_shader.passCount == 0 ? 0 : m_shader.passCount - 1;
  const int pass = m_shader.passes[std::size_t(current)].pairCount != 0 ? current + 1 : current;
  const Verdict verdict = checkSource(pass, source, swizzle);
  if (verdict.error != GL_NO_ERROR)
    return verdict;
  if (pass >= fp::ati::kMaxPasses)
    return {GL_INVALID_OPERATION, "two passes are specified already"};
  fp::ati::Setup &setup = m_shader.passes[std::size_t(pass)].setups[destination - GL_REG_0_ATI];
  if (setup.kind != SetupKind::None)
    return {GL_INVALID_OPERATION, "the register is set up twice in a pass"};
  setup.kind = kind;
  (void)parseSwizzle(swizzle, setup.coordinates);
  setup.fromRegister = isRegister(source);
  setup.source = std::uint8_t(source - (setup.fromRegister ? GL_REG_0_ATI : GL_TEXTURE0));
  if (!setup.fromRegister)
    m_families[setup.source] = readsQ(setup.coordinates) ? 2 : 1;
  m_shader.passCount = std::uint8_t(pass + 1);
  m_afterColor = false;
  return {};
}

/// Checks a pair: dot products of alpha repeat those of colour, and a DOT4 of colour needs the
/// alpha unit.
Verdict AtiRecorder::checkPairing(const RawOperation &raw) const {
  const Pass &pass = m_shader.passes[m_shader.passCount == 0 ? 0 : m_shader.passCount - 1u];
  const Operation *const color = m_afterColor ? &*pass.pairs[pass.pairCount - 1u].color : nullptr;
  if (raw.alpha) {
    const Op op = findOp(raw.op, raw.argumentCount)->op;
    if (isDot(op) && (!color || color->op != op))
      return {GL_INVALID_OPERATION, "no colour operation with the same dot product before it"};
    if (color && color->op == Op::Dot4 && op != Op::Dot4)
      return {GL_INVALID_OPERATION, "only DOT4 may follow a DOT4 of the colour"};
  }
  if (!(raw.alpha && color) && pass.pairCount >= fp::ati::kMaxPairs)
    return {GL_INVALID_OPERATION, "more than 8 instructions in a pass"};
  return {};
}

Verdict AtiRecorder::operation(const RawOperation &raw) {
  Operation operation;
  if (!isRegister(raw.destination))
    return {GL_INVALID_ENUM, "the destination is no register"};
  operation.destination = std::uint8_t(raw.destination - GL_REG_0_ATI);
  Verdict verdict = parseOperation(raw, operation);
  if (verdict.error == GL_NO_ERROR)
    verdict = checkPairing(raw);
  if (verdict.error != GL_NO_ERROR)
    return verdict;
  if (m_shader.passCount == 0)
    m_shader.passCount = 1;
  Pass &pass = m_shader.passes[m_shader.passCount - 1u];
  if (!raw.alpha || !m_afterColor)
    ++pass.pairCount;
  Pair &pair = pass.pairs[pass.pairCount - 1u];
  (raw.alpha ? pair.alpha : pair.color) = operation;
  m_afterColor = !raw.alpha;
  m_colorsInFirstPass |= m_shader.passCount == 1 && readsColors(operation);
  return {};
}

void AtiRecorder::setConstant(int constant, const fp::ir::Vec4 &value) {
  fp::ati::Constant &row = m_shader.constants[std::size_t(constant)];
  row.kind = fp::ati::ConstantKind::Value;
  // Values outside of [0,1] are undefined (AFS:629), and some have no numeral in text.
  constexpr float kMax = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < value.size(); ++i)
    row.value[i] = std::isnan(value[i]) ? 0.0f : std::clamp(value[i], -kMax, kMax);
}

Verdict AtiRecorder::end() const {
  if (m_shader.passCount == 0)
    return {GL_INVALID_OPERATION, "the shader is empty"};
  if (m_shader.passCount > 1 && m_colorsInFirstPass)
    return {GL_INVALID_OPERATION, "the first of two passes reads an interpolated colour"};
  return {};
}

} // namespace arbiter::state
