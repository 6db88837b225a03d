// sequences [--first SEED] [--count N]: issues sequences of commands of NV_texture_shader, 2 and 3.
// Their names and values are valid and invalid, some commands are in display lists, some between
// PushAttrib and PopAttrib. A model from section 3.8.13.2 and the specifications' New State
// predicts each command's error and the whole state after each sequence. Ends with a line of JSON.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

#include <epoxy/gl.h>

#include "../combiners_vs_specification/command_sequences.h"
#include "fp_compiler/testing/random.h"

namespace {

using arbiter::fp::testing::Random;

constexpr int kMaxUnits = 8;
constexpr GLenum kShader = GL_TEXTURE_SHADER_NV;

/// An operation, the first unit that may have it, and whether another unit must follow.
struct Operation {
  GLenum name;
  int first;
  bool notLast;
};
constexpr Operation kOperations[] = {
    {GL_NONE, 0, false},
    {GL_TEXTURE_1D, 0, false},
    {GL_TEXTURE_2D, 0, false},
    {GL_TEXTURE_RECTANGLE_NV, 0, false},
    {GL_TEXTURE_CUBE_MAP, 0, false},
    {GL_TEXTURE_3D, 0, false},
    {GL_PASS_THROUGH_NV, 0, false},
    {GL_CULL_FRAGMENT_NV, 0, false},
    {GL_OFFSET_TEXTURE_2D_NV, 1, false},
    {GL_OFFSET_TEXTURE_RECTANGLE_SCALE_NV, 1, false},
    {GL_DEPENDENT_AR_TEXTURE_2D_NV, 1, false},
    {GL_DEPENDENT_RGB_TEXTURE_CUBE_MAP_NV, 1, false},
    {GL_DOT_PRODUCT_NV, 1, true},
    {GL_DOT_PRODUCT_TEXTURE_1D_NV, 1, false},
    {GL_DOT_PRODUCT_TEXTURE_2D_NV, 2, false},
    {GL_DOT_PRODUCT_DEPTH_REPLACE_NV, 2, false},
    {GL_DOT_PRODUCT_DIFFUSE_CUBE_MAP_NV, 2, true},
    {GL_DOT_PRODUCT_TEXTURE_3D_NV, 3, false},
    {GL_DOT_PRODUCT_REFLECT_CUBE_MAP_NV, 3, false},
};
constexpr GLenum kOthers[] = {GL_FOG,  GL_LESS,     GL_TEXTURE31, GL_RGBA,    0xFFFFFFu,
                              GL_ZERO, GL_MODULATE, GL_GEQUAL,    GL_TEXTURE0};
constexpr GLenum kMappings[] = {GL_UNSIGNED_IDENTITY_NV, GL_EXPAND_NORMAL_NV,
                                GL_FORCE_BLUE_TO_ONE_NV};
constexpr GLenum kParameters[] = {GL_SHADER_OPERATION_NV,
                                  GL_PREVIOUS_TEXTURE_INPUT_NV,
                                  GL_CULL_MODES_NV,
                                  GL_RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV,
                                  GL_OFFSET_TEXTURE_MATRIX_NV,
                                  GL_OFFSET_TEXTURE_SCALE_NV,
                                  GL_OFFSET_TEXTURE_BIAS_NV,
                                  GL_CONST_EYE_NV};

struct Unit {
  GLenum operation = GL_NONE, previous = GL_TEXTURE0, mapping = GL_UNSIGNED_IDENTITY_NV;
  std::array<GLenum, 4> cull = {GL_GEQUAL, GL_GEQUAL, GL_GEQUAL, GL_GEQUAL};
  std::array<GLfloat, 4> matrix = {1, 0, 0, 1};
  std::array<GLfloat, 3> eye = {0, 0, -1};
  GLfloat scale = 1, bias = 0;
  GLenum environment = GL_MODULATE;
  bool operator==(const Unit &) const = default;
};
struct Model {
  std::array<Unit, kMaxUnits> units{};
  bool enabled = false;
  bool operator==(const Model &) const = default;
};

struct Command {
  enum class Kind { Parameter, Environment, Enable } kind = Kind::Parameter;
  GLenum pname = 0;
  bool vector = false, floats = false, on = false;
  int unit = 0;
  std::array<GLfloat, 4> values{}; ///< names are small enough to be floats
};

template <std::size_t N> GLenum anyOf(Random &random, const GLenum (&names)[N]) {
  return names[random.below(int(N))];
}

GLenum randomValue(Random &random, GLenum pname, int units) {
  if (random.chance(10))
    return anyOf(random, kOthers);
  switch (pname) {
  case GL_SHADER_OPERATION_NV:
    return kOperations[random.below(int(std::size(kOperations)))].name;
  case GL_PREVIOUS_TEXTURE_INPUT_NV:
    return GLenum(GL_TEXTURE0 + random.below(units));
  case GL_RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV:
    return anyOf(random, kMappings);
  default:
    return random.chance(50) ? GL_LESS : GL_GEQUAL;
  }
}

bool isNumber(GLenum pname) {
  return pname == GL_OFFSET_TEXTURE_MATRIX_NV || pname == GL_OFFSET_TEXTURE_SCALE_NV ||
         pname == GL_OFFSET_TEXTURE_BIAS_NV || pname == GL_CONST_EYE_NV;
}

Command randomCommand(Random &random, int units) {
  Command c;
  c.unit = random.below(units);
  c.on = random.chance(50);
  const int kind = random.below(12);
  if (kind == 0) {
    c.kind = Command::Kind::Enable;
    return c;
  }
  if (kind == 1) {
    constexpr GLenum kModes[] = {GL_NONE, GL_NONE, GL_REPLACE, GL_ADD, GL_FOG};
    c.kind = Command::Kind::Environment;
    c.pname = anyOf(random, kModes);
    return c;
  }
  c.pname = random.chance(4) ? anyOf(random, kOthers) : anyOf(random, kParameters);
  c.vector = random.chance(70);
  c.floats = random.chance(50);
  for (GLfloat &value : c.values)
    value = isNumber(c.pname) ? std::floor(random.real(-8.0f, 8.0f))
                              : GLfloat(randomValue(random, c.pname, units));
  return c;
}

GLenum setOperation(Unit &unit, int number, int units, GLenum name) {
  const auto *const row = std::find_if(std::begin(kOperations), std::end(kOperations),
                                       [&](const Operation &o) { return o.name == name; });
  if (row == std::end(kOperations))
    return GL_INVALID_ENUM;
  if (number < row->first || (row->notLast && number == units - 1))
    return GL_INVALID_OPERATION;
  unit.operation = name;
  return GL_NO_ERROR;
}

GLenum apply(Model &model, const Command &c, int units) {
  Unit &unit = model.units[std::size_t(c.unit)];
  if (c.kind == Command::Kind::Enable) {
    model.enabled = c.on;
    return GL_NO_ERROR;
  }
  if (c.kind == Command::Kind::Environment) {
    if (c.pname == GL_FOG)
      return GL_INVALID_ENUM;
    unit.environment = c.pname;
    return GL_NO_ERROR;
  }
  const auto name = GLenum(c.values[0]);
  switch (c.pname) {
  case GL_SHADER_OPERATION_NV:
    return setOperation(unit, c.unit, units, name);
  case GL_PREVIOUS_TEXTURE_INPUT_NV:
    if (name - GL_TEXTURE0 >= GLenum(kMaxUnits))
      return GL_INVALID_ENUM;
    if (name - GL_TEXTURE0 >= GLenum(c.unit))
      return GL_INVALID_OPERATION;
    unit.previous = name;
    return GL_NO_ERROR;
  case GL_RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV:
    if (std::find(std::begin(kMappings), std::end(kMappings), name) == std::end(kMappings))
      return GL_INVALID_ENUM;
    unit.mapping = name;
    return GL_NO_ERROR;
  case GL_OFFSET_TEXTURE_SCALE_NV:
    unit.scale = c.values[0];
    return GL_NO_ERROR;
  case GL_OFFSET_TEXTURE_BIAS_NV:
    unit.bias = c.values[0];
    return GL_NO_ERROR;
  default:
    break;
  }
  if (!c.vector) // the others are vectors, or no parameters
    return GL_INVALID_ENUM;
  switch (c.pname) {
  case GL_CULL_MODES_NV:
    for (const GLfloat value : c.values)
      if (GLenum(value) != GL_LESS && GLenum(value) != GL_GEQUAL)
        return GL_INVALID_ENUM;
    std::transform(c.values.begin(), c.values.end(), unit.cull.begin(),
                   [](GLfloat value) { return GLenum(value); });
    return GL_NO_ERROR;
  case GL_OFFSET_TEXTURE_MATRIX_NV:
    unit.matrix = c.values;
    return GL_NO_ERROR;
  case GL_CONST_EYE_NV:
    unit.eye = {c.values[0], c.values[1], c.values[2]};
    return GL_NO_ERROR;
  default:
    return GL_INVALID_ENUM;
  }
}

void issue(const Command &c) {
  glActiveTexture(GLenum(GL_TEXTURE0 + c.unit));
  if (c.kind == Command::Kind::Enable)
    return c.on ? glEnable(kShader) : glDisable(kShader);
  if (c.kind == Command::Kind::Environment)
    return glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GLint(c.pname));
  GLint integers[4];
  std::transform(c.values.begin(), c.values.end(), integers,
                 [](GLfloat value) { return GLint(value); });
  if (c.vector)
    return c.floats ? glTexEnvfv(kShader, c.pname, c.values.data())
                    : glTexEnviv(kShader, c.pname, integers);
  return c.floats ? glTexEnvf(kShader, c.pname, c.values[0])
                  : glTexEnvi(kShader, c.pname, integers[0]);
}

Model queried(int units) {
  Model model;
  for (int i = 0; i < units; ++i) {
    Unit &unit = model.units[std::size_t(i)];
    glActiveTexture(GLenum(GL_TEXTURE0 + i));
    const auto name = [](GLenum target, GLenum pname) {
      GLint value = 0;
      glGetTexEnviv(target, pname, &value);
      return GLenum(value);
    };
    unit.operation = name(kShader, GL_SHADER_OPERATION_NV);
    unit.previous = name(kShader, GL_PREVIOUS_TEXTURE_INPUT_NV);
    unit.mapping = name(kShader, GL_RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV);
    unit.environment = name(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE);
    GLint cull[4] = {};
    glGetTexEnviv(kShader, GL_CULL_MODES_NV, cull);
    std::transform(cull, cull + 4, unit.cull.begin(), [](GLint value) { return GLenum(value); });
    glGetTexEnvfv(kShader, GL_OFFSET_TEXTURE_MATRIX_NV, unit.matrix.data());
    glGetTexEnvfv(kShader, GL_CONST_EYE_NV, unit.eye.data());
    glGetTexEnvfv(kShader, GL_OFFSET_TEXTURE_SCALE_NV, &unit.scale);
    glGetTexEnvfv(kShader, GL_OFFSET_TEXTURE_BIAS_NV, &unit.bias);
  }
  model.enabled = glIsEnabled(kShader) != GL_FALSE;
  return model;
}

struct TextureShaders {
  using Command = ::Command;
  using Model = ::Model;
  static constexpr const char *kExtension = "GL_NV_texture_shader3";
  static constexpr int kMaxUnits = ::kMaxUnits;
  // For its own environments the host raises errors when the list is compiled.
  static constexpr bool kListsRaise = false;

  static Command random(Random &random, int units) { return randomCommand(random, units); }
  static GLenum apply(Model &model, const Command &command, int units) {
    return ::apply(model, command, units);
  }
  static void issue(const Command &command) { ::issue(command); }
  static Model queried(int units) { return ::queried(units); }
  static void print(const Command &command) {
    std::printf("unit %d, 0x%04X, %g\n", command.unit, command.pname, double(command.values[0]));
  }
};

} // namespace

int main(int argc, char **argv) { return CommandSequences<TextureShaders>::main(argc, argv); }
