#include "command_model.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace commanded {

using arbiter::fp::testing::Random;

namespace {

bool within(GLenum name, GLenum first, GLuint count) { return name - first < count; }

bool isReadable(GLenum name, GLuint units) {
  switch (name) {
  case GL_ZERO:
  case GL_CONSTANT_COLOR0_NV:
  case GL_CONSTANT_COLOR1_NV:
  case GL_FOG:
    return true;
  default:
    return within(name, GL_PRIMARY_COLOR_NV, 4) || within(name, GL_TEXTURE0, units);
  }
}
bool isWritable(GLenum name, GLuint units) {
  return name == GL_DISCARD_NV || within(name, GL_PRIMARY_COLOR_NV, 4) ||
         within(name, GL_TEXTURE0, units);
}
bool isUsage(GLenum name) { return name == GL_RGB || name == GL_ALPHA || name == GL_BLUE; }
bool isPortion(GLenum name) { return name == GL_RGB || name == GL_ALPHA; }
bool isPseudo(GLenum name) {
  return name == GL_E_TIMES_F_NV || name == GL_SPARE0_PLUS_SECONDARY_COLOR_NV;
}
Color clamped(Color color) {
  for (GLfloat &c : color)
    c = std::clamp(c, 0.0f, 1.0f);
  return color;
}

GLenum setInput(Model &model, const Command &c, GLuint units) {
  const auto [stage, portion, variable, input, mapping, usage, unused] = c.names;
  if (!within(stage, GL_COMBINER0_NV, kStages) || !isPortion(portion) ||
      !within(variable, GL_VARIABLE_A_NV, 4) || !isReadable(input, units) ||
      !within(mapping, GL_UNSIGNED_IDENTITY_NV, 8) || !isUsage(usage))
    return GL_INVALID_ENUM;
  if ((portion == GL_ALPHA && usage == GL_RGB) || (portion == GL_RGB && usage == GL_BLUE) ||
      (usage == GL_ALPHA && input == GL_FOG))
    return GL_INVALID_OPERATION;
  model.stages[stage - GL_COMBINER0_NV][portion == GL_ALPHA ? 1 : 0]
      .variables[variable - GL_VARIABLE_A_NV] = {input, mapping, usage};
  return GL_NO_ERROR;
}

GLenum setOutput(Model &model, const Command &c, GLuint units) {
  const auto [stage, portion, ab, cd, sum, scale, bias] = c.names;
  if (!within(stage, GL_COMBINER0_NV, kStages) || !isPortion(portion) || !isWritable(ab, units) ||
      !isWritable(cd, units) || !isWritable(sum, units) ||
      (scale != GL_NONE && !within(scale, GL_SCALE_BY_TWO_NV, 3)) ||
      (bias != GL_NONE && bias != GL_BIAS_BY_NEGATIVE_ONE_HALF_NV))
    return GL_INVALID_ENUM;
  if (portion == GL_ALPHA && (c.flags[0] || c.flags[1]))
    return GL_INVALID_VALUE;
  if (bias != GL_NONE && (scale == GL_SCALE_BY_FOUR_NV || scale == GL_SCALE_BY_ONE_HALF_NV))
    return GL_INVALID_OPERATION;
  if ((ab == cd && ab != GL_DISCARD_NV) || (ab == sum && ab != GL_DISCARD_NV) ||
      (cd == sum && cd != GL_DISCARD_NV))
    return GL_INVALID_OPERATION;
  Half &half = model.stages[stage - GL_COMBINER0_NV][portion == GL_ALPHA ? 1 : 0];
  half.ab = ab;
  half.cd = cd;
  half.sum = sum;
  half.scale = scale;
  half.bias = bias;
  half.abDot = c.flags[0];
  half.cdDot = c.flags[1];
  half.mux = c.flags[2];
  return GL_NO_ERROR;
}

GLenum setFinal(Model &model, const Command &c, GLuint units) {
  const GLenum variable = c.names[0], input = c.names[1], mapping = c.names[2], usage = c.names[3];
  if (!within(variable, GL_VARIABLE_A_NV, 7) || (!isReadable(input, units) && !isPseudo(input)) ||
      !within(mapping, GL_UNSIGNED_IDENTITY_NV, 2) || !isUsage(usage))
    return GL_INVALID_ENUM;
  const bool g = variable == GL_VARIABLE_G_NV;
  if ((isPseudo(input) && variable >= GL_VARIABLE_E_NV) ||
      (input == GL_SPARE0_PLUS_SECONDARY_COLOR_NV && variable == GL_VARIABLE_A_NV) ||
      (g && usage == GL_RGB) || (!g && usage == GL_BLUE) || (isPseudo(input) && usage != GL_RGB))
    return GL_INVALID_OPERATION;
  model.finals[variable - GL_VARIABLE_A_NV] = {input, mapping, usage};
  return GL_NO_ERROR;
}

GLenum setNumber(Model &model, GLenum pname, GLint number, bool isTrue) {
  if (pname == GL_COLOR_SUM_CLAMP_NV) {
    model.sumClamp = isTrue;
    return GL_NO_ERROR;
  }
  if (pname != GL_NUM_GENERAL_COMBINERS_NV)
    return GL_INVALID_ENUM;
  if (number < 1 || number > GLint(kStages))
    return GL_INVALID_VALUE;
  model.count = number;
  return GL_NO_ERROR;
}

} // namespace

GLenum apply(Model &model, const Command &c, int textureUnits) {
  const auto units = GLuint(textureUnits);
  switch (c.kind) {
  case 0:
    return setInput(model, c, units);
  case 1:
    return setOutput(model, c, units);
  case 2:
    return setFinal(model, c, units);
  case 3: // a vector
    if (!within(c.names[0], GL_CONSTANT_COLOR0_NV, 2))
      return setNumber(model, c.names[0], GLint(std::lround(c.color[0])), c.color[0] != 0.0f);
    model.constants[c.names[0] - GL_CONSTANT_COLOR0_NV] = clamped(c.color);
    return GL_NO_ERROR;
  case 4: // a stage's
    if (!within(c.names[0], GL_COMBINER0_NV, kStages) ||
        !within(c.names[1], GL_CONSTANT_COLOR0_NV, 2))
      return GL_INVALID_ENUM;
    model.stageConstants[c.names[0] - GL_COMBINER0_NV][c.names[1] - GL_CONSTANT_COLOR0_NV] =
        clamped(c.color);
    return GL_NO_ERROR;
  case 5: // a number
    return setNumber(model, c.names[0], c.number, c.number != 0);
  default:
    (c.kind == 6 ? model.enabled : model.perStage) = c.flags[0];
    return GL_NO_ERROR;
  }
}

namespace {

/// Names that may occur anywhere.
constexpr GLenum kOthers[] = {GL_ZERO,
                              GL_NONE,
                              GL_FOG,
                              GL_RGB,
                              GL_ALPHA,
                              GL_BLUE,
                              GL_RED,
                              GL_RGBA,
                              GL_DISCARD_NV,
                              GL_E_TIMES_F_NV,
                              GL_SPARE0_PLUS_SECONDARY_COLOR_NV,
                              GL_TEXTURE31,
                              GL_COMBINER7_NV + 1,
                              GL_COMBINER0_NV - 1,
                              0xFFFFFFFFu,
                              GL_VARIABLE_G_NV};

class Names {
public:
  Names(Random &random, int units) : m_random(random), m_units(units) {}

  /// Returns mostly one of `first` to `first + count - 1`.
  GLenum of(GLenum first, int count) {
    if (m_random.chance(4))
      return kOthers[m_random.below(int(std::size(kOthers)))];
    return first + GLenum(m_random.below(count));
  }
  template <std::size_t N> GLenum of(const GLenum (&names)[N]) {
    if (m_random.chance(4))
      return kOthers[m_random.below(int(std::size(kOthers)))];
    return names[m_random.below(int(N))];
  }
  GLenum input() {
    if (m_random.chance(30))
      return of(GL_TEXTURE0, m_units + (m_random.chance(10) ? 1 : 0));
    constexpr GLenum kNames[] = {GL_ZERO,      GL_CONSTANT_COLOR0_NV, GL_CONSTANT_COLOR1_NV,
                                 GL_FOG,       GL_PRIMARY_COLOR_NV,   GL_SECONDARY_COLOR_NV,
                                 GL_SPARE0_NV, GL_SPARE1_NV};
    return of(kNames);
  }
  GLenum output() { return m_random.chance(40) ? GLenum(GL_DISCARD_NV) : input(); }
  GLenum portion() {
    constexpr GLenum kNames[] = {GL_RGB, GL_ALPHA};
    return of(kNames);
  }
  GLenum usage() {
    constexpr GLenum kNames[] = {GL_RGB, GL_ALPHA, GL_BLUE};
    return of(kNames);
  }
  GLfloat number() { return m_random.real(-1.5f, 2.5f); }
  bool flag(int percent) { return m_random.chance(percent); }
  int below(int count) { return m_random.below(count); }

private:
  Random &m_random;
  int m_units;
};

} // namespace

Command randomCommand(Random &random, int units) {
  Names names(random, units);
  Command c;
  c.kind = names.below(8);
  for (bool &flag : c.flags)
    flag = names.flag(30);
  for (GLfloat &component : c.color)
    component = names.number();
  c.number = names.below(12) - 2;
  switch (c.kind) {
  case 0:
    c.names = {names.of(GL_COMBINER0_NV, 8),         names.portion(),
               names.of(GL_VARIABLE_A_NV, 4),        names.input(),
               names.of(GL_UNSIGNED_IDENTITY_NV, 8), names.usage()};
    break;
  case 1: {
    constexpr GLenum kScales[] = {GL_NONE, GL_SCALE_BY_TWO_NV, GL_SCALE_BY_FOUR_NV,
                                  GL_SCALE_BY_ONE_HALF_NV};
    constexpr GLenum kBiases[] = {GL_NONE, GL_BIAS_BY_NEGATIVE_ONE_HALF_NV};
    c.names = {names.of(GL_COMBINER0_NV, 8),
               names.portion(),
               names.output(),
               names.output(),
               names.output(),
               names.of(kScales),
               names.of(kBiases)};
    break;
  }
  case 2:
    c.names = {names.of(GL_VARIABLE_A_NV, 7),
               names.flag(20) ? names.of(GL_E_TIMES_F_NV, 2) : names.input(),
               names.of(GL_UNSIGNED_IDENTITY_NV, names.flag(10) ? 8 : 2), names.usage()};
    break;
  case 3:
    c.names[0] = names.of(GL_CONSTANT_COLOR0_NV, 2);
    break;
  case 4:
    c.names = {names.of(GL_COMBINER0_NV, 8), names.of(GL_CONSTANT_COLOR0_NV, 2)};
    break;
  default:
    c.names[0] = names.of(GL_NUM_GENERAL_COMBINERS_NV, 2);
  }
  return c;
}

} // namespace commanded
