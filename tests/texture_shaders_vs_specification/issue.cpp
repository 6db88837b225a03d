#include "issue.h"

#include <iterator>

namespace shaded {

using namespace arbiter::fp::texture_shader;

namespace {

struct Row {
  GLenum name;
  GLenum target;
};
/// The enumerants in the order of Operation.
constexpr Row kRows[] = {
    {GL_NONE, 0},
    {GL_TEXTURE_1D, GL_TEXTURE_1D},
    {GL_TEXTURE_2D, GL_TEXTURE_2D},
    {GL_TEXTURE_RECTANGLE_NV, GL_TEXTURE_RECTANGLE},
    {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP},
    {GL_PASS_THROUGH_NV, 0},
    {GL_CULL_FRAGMENT_NV, 0},
    {GL_OFFSET_TEXTURE_2D_NV, GL_TEXTURE_2D},
    {GL_OFFSET_TEXTURE_2D_SCALE_NV, GL_TEXTURE_2D},
    {GL_OFFSET_TEXTURE_RECTANGLE_NV, GL_TEXTURE_RECTANGLE},
    {GL_OFFSET_TEXTURE_RECTANGLE_SCALE_NV, GL_TEXTURE_RECTANGLE},
    {GL_DEPENDENT_AR_TEXTURE_2D_NV, GL_TEXTURE_2D},
    {GL_DEPENDENT_GB_TEXTURE_2D_NV, GL_TEXTURE_2D},
    {GL_DOT_PRODUCT_NV, 0},
    {GL_DOT_PRODUCT_TEXTURE_2D_NV, GL_TEXTURE_2D},
    {GL_DOT_PRODUCT_TEXTURE_RECTANGLE_NV, GL_TEXTURE_RECTANGLE},
    {GL_DOT_PRODUCT_TEXTURE_CUBE_MAP_NV, GL_TEXTURE_CUBE_MAP},
    {GL_DOT_PRODUCT_REFLECT_CUBE_MAP_NV, GL_TEXTURE_CUBE_MAP},
    {GL_DOT_PRODUCT_CONST_EYE_REFLECT_CUBE_MAP_NV, GL_TEXTURE_CUBE_MAP},
    {GL_DOT_PRODUCT_DIFFUSE_CUBE_MAP_NV, GL_TEXTURE_CUBE_MAP},
    {GL_DOT_PRODUCT_DEPTH_REPLACE_NV, 0},
    {GL_TEXTURE_3D, GL_TEXTURE_3D},
    {GL_DOT_PRODUCT_TEXTURE_3D_NV, GL_TEXTURE_3D},
    {GL_OFFSET_PROJECTIVE_TEXTURE_2D_NV, GL_TEXTURE_2D},
    {GL_OFFSET_PROJECTIVE_TEXTURE_2D_SCALE_NV, GL_TEXTURE_2D},
    {GL_OFFSET_PROJECTIVE_TEXTURE_RECTANGLE_NV, GL_TEXTURE_RECTANGLE},
    {GL_OFFSET_PROJECTIVE_TEXTURE_RECTANGLE_SCALE_NV, GL_TEXTURE_RECTANGLE},
    {GL_OFFSET_HILO_TEXTURE_2D_NV, GL_TEXTURE_2D},
    {GL_OFFSET_HILO_TEXTURE_RECTANGLE_NV, GL_TEXTURE_RECTANGLE},
    {GL_OFFSET_HILO_PROJECTIVE_TEXTURE_2D_NV, GL_TEXTURE_2D},
    {GL_OFFSET_HILO_PROJECTIVE_TEXTURE_RECTANGLE_NV, GL_TEXTURE_RECTANGLE},
    {GL_DEPENDENT_HILO_TEXTURE_2D_NV, GL_TEXTURE_2D},
    {GL_DEPENDENT_RGB_TEXTURE_3D_NV, GL_TEXTURE_3D},
    {GL_DEPENDENT_RGB_TEXTURE_CUBE_MAP_NV, GL_TEXTURE_CUBE_MAP},
    {GL_DOT_PRODUCT_PASS_THROUGH_NV, 0},
    {GL_DOT_PRODUCT_TEXTURE_1D_NV, GL_TEXTURE_1D},
    {GL_DOT_PRODUCT_AFFINE_DEPTH_REPLACE_NV, 0},
};
static_assert(std::size(kRows) == kOperations);

constexpr GLint kMappings[] = {GL_UNSIGNED_IDENTITY_NV, GL_EXPAND_NORMAL_NV,
                               GL_FORCE_BLUE_TO_ONE_NV};
constexpr GLint kModes[] = {GL_NONE,  GL_REPLACE, GL_MODULATE, GL_DECAL,
                            GL_BLEND, GL_ADD,     GL_COMBINE};
constexpr GLint kFunctions[] = {GL_REPLACE,
                                GL_MODULATE,
                                GL_ADD,
                                GL_ADD_SIGNED,
                                GL_INTERPOLATE,
                                GL_SUBTRACT,
                                GL_DOT3_RGB,
                                GL_DOT3_RGBA,
                                GL_MODULATE_ADD_ATI,
                                GL_MODULATE_SIGNED_ADD_ATI,
                                GL_MODULATE_SUBTRACT_ATI,
                                GL_ADD,
                                GL_ADD_SIGNED};

GLint nameOf(CombineSource source) {
  constexpr GLint kNames[] = {GL_TEXTURE,  GL_CONSTANT, GL_PRIMARY_COLOR,
                              GL_PREVIOUS, GL_ZERO,     GL_ONE};
  const auto at = std::size_t(source);
  return at < std::size(kNames) ? kNames[at] : GLint(GL_TEXTURE0 + at - std::size(kNames));
}

void issueHalf(const CombineHalf &half, bool alpha) {
  glTexEnvi(GL_TEXTURE_ENV, alpha ? GL_COMBINE_ALPHA : GL_COMBINE_RGB,
            kFunctions[std::size_t(half.function)]);
  for (int i = 0; i < argumentsOf(half.function); ++i) {
    const CombineArgument &argument = half.arguments[std::size_t(i)];
    glTexEnvi(GL_TEXTURE_ENV, GLenum(alpha ? GL_SOURCE0_ALPHA : GL_SOURCE0_RGB) + GLenum(i),
              nameOf(argument.source));
    const GLint operand = argument.alpha
                              ? argument.complement ? GL_ONE_MINUS_SRC_ALPHA : GL_SRC_ALPHA
                          : argument.complement ? GL_ONE_MINUS_SRC_COLOR
                                                : GL_SRC_COLOR;
    glTexEnvi(GL_TEXTURE_ENV, GLenum(alpha ? GL_OPERAND0_ALPHA : GL_OPERAND0_RGB) + GLenum(i),
              operand);
  }
  glTexEnvf(GL_TEXTURE_ENV, alpha ? GL_ALPHA_SCALE : GL_RGB_SCALE, half.scale);
}

} // namespace

GLenum targetOf(Operation operation) { return kRows[std::size_t(operation)].target; }

void issue(const State &state) {
  for (unsigned unit = 0; unit < state.units; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    const Stage &stage = state.stages[unit];
    for (const GLenum target :
         {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP})
      (state.conventional && target == targetOf(stage.operation) ? glEnable : glDisable)(target);
    glTexEnvi(GL_TEXTURE_SHADER_NV, GL_SHADER_OPERATION_NV,
              state.conventional ? GL_NONE : GLint(kRows[std::size_t(stage.operation)].name));
    if (unit > 0)
      glTexEnvi(GL_TEXTURE_SHADER_NV, GL_PREVIOUS_TEXTURE_INPUT_NV, GL_TEXTURE0 + stage.previous);
    GLint modes[4];
    for (unsigned i = 0; i < 4; ++i)
      modes[i] = (stage.cullLess >> i & 1) != 0 ? GL_LESS : GL_GEQUAL;
    glTexEnviv(GL_TEXTURE_SHADER_NV, GL_CULL_MODES_NV, modes);
    glTexEnvi(GL_TEXTURE_SHADER_NV, GL_RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV,
              kMappings[std::size_t(stage.mapping)]);
  }
  (state.conventional ? glDisable : glEnable)(GL_TEXTURE_SHADER_NV);
}

void issue(const Environments &environments, int units) {
  for (int unit = 0; unit < units; ++unit) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    const Environment &environment = environments[std::size_t(unit)];
    const bool combines = environment.mode == EnvironmentMode::Combine;
    const bool four = combines && argumentsOf(environment.color.function) == 4;
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
              four ? GL_COMBINE4_NV : kModes[std::size_t(environment.mode)]);
    if (!combines)
      continue;
    issueHalf(environment.color, false);
    issueHalf(environment.alpha, true);
  }
}

void showUnit(int unit) {
  const GLfloat half[] = {0.5f, 0.5f, 0.5f, 0.5f};
  glCombinerParameterfvNV(GL_CONSTANT_COLOR0_NV, half);
  glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, 1);
  for (const GLenum portion : {GL_RGB, GL_ALPHA}) {
    const auto input = [&](GLenum variable, GLenum source, GLenum mapping) {
      glCombinerInputNV(GL_COMBINER0_NV, portion, variable, source, mapping, portion);
    };
    input(GL_VARIABLE_A_NV, GLenum(GL_TEXTURE0 + unit), GL_SIGNED_IDENTITY_NV);
    input(GL_VARIABLE_B_NV, GL_CONSTANT_COLOR0_NV, GL_SIGNED_IDENTITY_NV);
    input(GL_VARIABLE_C_NV, GL_ZERO, GL_UNSIGNED_INVERT_NV);
    input(GL_VARIABLE_D_NV, GL_CONSTANT_COLOR0_NV, GL_SIGNED_IDENTITY_NV);
    glCombinerOutputNV(GL_COMBINER0_NV, portion, GL_DISCARD_NV, GL_DISCARD_NV, GL_SPARE0_NV,
                       GL_NONE, GL_NONE, GL_FALSE, GL_FALSE, GL_FALSE);
  }
  for (const GLenum variable : {GL_VARIABLE_A_NV, GL_VARIABLE_B_NV, GL_VARIABLE_C_NV})
    glFinalCombinerInputNV(variable, GL_ZERO, GL_UNSIGNED_IDENTITY_NV, GL_RGB);
  glFinalCombinerInputNV(GL_VARIABLE_D_NV, GL_SPARE0_NV, GL_UNSIGNED_IDENTITY_NV, GL_RGB);
  glFinalCombinerInputNV(GL_VARIABLE_G_NV, GL_SPARE0_NV, GL_UNSIGNED_IDENTITY_NV, GL_ALPHA);
}

} // namespace shaded
