// The commands of NV_register_combiners and NV_register_combiners2. Queries are executed at once
// even while a list is compiled (5.4).
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "enumerants/combiners.h"
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/lists/issue_combiners.h"
#include "state/programs/combiners/combiner_state.h"

namespace arbiter::state {

namespace {

using fp::combiners::Input;
using fp::combiners::Portion;
using Kind = CombinerCommand::Kind;

void issue(Context &context, const CombinerCommand &command, const char *between) {
  if (outsideBeginEnd(context, between))
    issueCombinerCommand(context, command);
}

bool isColor(GLenum pname) {
  return pname == GL_CONSTANT_COLOR0_NV || pname == GL_CONSTANT_COLOR1_NV;
}

/// Converts a colour component to float (OpenGL 1.2, table 2.6: a signed integer).
GLfloat component(GLfloat value) { return value; }
GLfloat component(GLint value) { return GLfloat((2.0 * double(value) + 1.0) / 4294967295.0); }

/// Issues CombinerParameter. For an unknown pname `params` may point to nothing.
template <typename T>
void setParameter(Context &context, GLenum pname, const T *params, bool scalar) {
  CombinerCommand command{.kind = Kind::Parameter, .scalar = scalar, .names = {pname}};
  if (params && isColor(pname) && !scalar)
    std::transform(params, params + 4, command.values.begin(),
                   [](T value) { return component(value); });
  else if (params && (pname == GL_NUM_GENERAL_COMBINERS_NV || pname == GL_COLOR_SUM_CLAMP_NV))
    command.values[0] = std::is_integral_v<T> || pname == GL_COLOR_SUM_CLAMP_NV
                            ? GLfloat(*params)
                            : std::nearbyint(GLfloat(*params));
  issue(context, command, "CombinerParameter between Begin and End");
}

/// Returns the queried portion. Raises an error and returns null for an invalid name.
const Portion *portionOf(Context &context, GLenum stageName, GLenum portion) {
  const GLenum stage = stageName - GL_COMBINER0_NV;
  if (stage >= GLenum(context.combiners->stages()) || (portion != GL_RGB && portion != GL_ALPHA)) {
    raise(context, GL_INVALID_ENUM, "GetCombiner: stage or portion");
    return nullptr;
  }
  const auto &found = context.combiners->state().stages[stage];
  return portion == GL_RGB ? &found.rgb : &found.alpha;
}

template <typename T>
void giveInput(Context &context, const Input &input, GLenum pname, T *params) {
  switch (pname) {
  case GL_COMBINER_INPUT_NV:
    *params = T(enumerants::nameOf(input.source));
    return;
  case GL_COMBINER_MAPPING_NV:
    *params = T(enumerants::nameOf(input.mapping));
    return;
  case GL_COMBINER_COMPONENT_USAGE_NV:
    *params = T(enumerants::nameOf(input.usage));
    return;
  default:
    raise(context, GL_INVALID_ENUM, "GetCombinerInputParameter: pname");
  }
}

template <typename T>
void getInput(Context &context, GLenum stage, GLenum portionName, GLenum variableName, GLenum pname,
              T *params) {
  if (!outsideBeginEnd(context, "GetCombinerInputParameter between Begin and End"))
    return;
  const Portion *const portion = portionOf(context, stage, portionName);
  const GLenum variable = variableName - GL_VARIABLE_A_NV;
  if (portion && variable > 3)
    raise(context, GL_INVALID_ENUM, "GetCombinerInputParameter: variable");
  else if (portion)
    giveInput(context, portion->inputs[variable], pname, params);
}

template <typename T>
void getOutput(Context &context, GLenum stage, GLenum portionName, GLenum pname, T *params) {
  if (!outsideBeginEnd(context, "GetCombinerOutputParameter between Begin and End"))
    return;
  const Portion *const portion = portionOf(context, stage, portionName);
  if (!portion)
    return;
  switch (pname) {
  case GL_COMBINER_AB_DOT_PRODUCT_NV:
    *params = T(portion->abDot);
    return;
  case GL_COMBINER_CD_DOT_PRODUCT_NV:
    *params = T(portion->cdDot);
    return;
  case GL_COMBINER_MUX_SUM_NV:
    *params = T(portion->mux);
    return;
  case GL_COMBINER_SCALE_NV:
    *params = T(enumerants::nameOf(portion->scale));
    return;
  case GL_COMBINER_BIAS_NV:
    *params = T(portion->bias ? GL_BIAS_BY_NEGATIVE_ONE_HALF_NV : GL_NONE);
    return;
  case GL_COMBINER_AB_OUTPUT_NV:
    *params = T(enumerants::nameOf(portion->ab));
    return;
  case GL_COMBINER_CD_OUTPUT_NV:
    *params = T(enumerants::nameOf(portion->cd));
    return;
  case GL_COMBINER_SUM_OUTPUT_NV:
    *params = T(enumerants::nameOf(portion->sum));
    return;
  default:
    raise(context, GL_INVALID_ENUM, "GetCombinerOutputParameter: pname");
  }
}

template <typename T>
void getFinalInput(Context &context, GLenum variableName, GLenum pname, T *params) {
  if (!outsideBeginEnd(context, "GetFinalCombinerInputParameter between Begin and End"))
    return;
  const GLenum variable = variableName - GL_VARIABLE_A_NV;
  if (variable > 6)
    return raise(context, GL_INVALID_ENUM, "GetFinalCombinerInputParameter: variable");
  giveInput(context, context.combiners->state().finals[variable], pname, params);
}

} // namespace

namespace handlers {

void CombinerParameterfNV(Context &context, GLenum pname, GLfloat param) {
  setParameter(context, pname, &param, true);
}
void CombinerParameteriNV(Context &context, GLenum pname, GLint param) {
  setParameter(context, pname, &param, true);
}
void CombinerParameterfvNV(Context &context, GLenum pname, const GLfloat *params) {
  setParameter(context, pname, params, false);
}
void CombinerParameterivNV(Context &context, GLenum pname, const GLint *params) {
  setParameter(context, pname, params, false);
}

void CombinerStageParameterfvNV(Context &context, GLenum stage, GLenum pname,
                                const GLfloat *params) {
  CombinerCommand command{.kind = Kind::StageParameter, .names = {stage, pname}};
  if (params && isColor(pname))
    std::copy_n(params, 4, command.values.begin());
  issue(context, command, "CombinerStageParameter between Begin and End");
}

void CombinerInputNV(Context &context, GLenum stage, GLenum portion, GLenum variable, GLenum input,
                     GLenum mapping, GLenum componentUsage) {
  issue(context,
        {.kind = Kind::Input, .names = {stage, portion, variable, input, mapping, componentUsage}},
        "CombinerInput between Begin and End");
}

void CombinerOutputNV(Context &context, GLenum stage, GLenum portion, GLenum abOutput,
                      GLenum cdOutput, GLenum sumOutput, GLenum scale, GLenum bias,
                      GLboolean abDotProduct, GLboolean cdDotProduct, GLboolean muxSum) {
  const auto flag = [](GLboolean set, unsigned bit) { return set != GL_FALSE ? bit : 0u; };
  issue(context,
        {.kind = Kind::Output,
         .flags = std::uint8_t(flag(abDotProduct, CombinerCommand::kAbDot) |
                               flag(cdDotProduct, CombinerCommand::kCdDot) |
                               flag(muxSum, CombinerCommand::kMux)),
         .names = {stage, portion, abOutput, cdOutput, sumOutput, scale, bias}},
        "CombinerOutput between Begin and End");
}

void FinalCombinerInputNV(Context &context, GLenum variable, GLenum input, GLenum mapping,
                          GLenum componentUsage) {
  issue(context, {.kind = Kind::FinalInput, .names = {variable, input, mapping, componentUsage}},
        "FinalCombinerInput between Begin and End");
}

void GetCombinerInputParameterfvNV(Context &context, GLenum stage, GLenum portion, GLenum variable,
                                   GLenum pname, GLfloat *params) {
  getInput(context, stage, portion, variable, pname, params);
}
void GetCombinerInputParameterivNV(Context &context, GLenum stage, GLenum portion, GLenum variable,
                                   GLenum pname, GLint *params) {
  getInput(context, stage, portion, variable, pname, params);
}

void GetCombinerOutputParameterfvNV(Context &context, GLenum stage, GLenum portion, GLenum pname,
                                    GLfloat *params) {
  getOutput(context, stage, portion, pname, params);
}
void GetCombinerOutputParameterivNV(Context &context, GLenum stage, GLenum portion, GLenum pname,
                                    GLint *params) {
  getOutput(context, stage, portion, pname, params);
}

void GetFinalCombinerInputParameterfvNV(Context &context, GLenum variable, GLenum pname,
                                        GLfloat *params) {
  getFinalInput(context, variable, pname, params);
}
void GetFinalCombinerInputParameterivNV(Context &context, GLenum variable, GLenum pname,
                                        GLint *params) {
  getFinalInput(context, variable, pname, params);
}

void GetCombinerStageParameterfvNV(Context &context, GLenum stageName, GLenum pname,
                                   GLfloat *params) {
  if (!outsideBeginEnd(context, "GetCombinerStageParameter between Begin and End"))
    return;
  const GLenum stage = stageName - GL_COMBINER0_NV;
  if (stage >= GLenum(context.combiners->stages()) || !isColor(pname))
    return raise(context, GL_INVALID_ENUM, "GetCombinerStageParameter: stage or pname");
  const Vec4 &color = context.combiners->constant(
      fp::combiners::stageConstant(int(stage), int(pname - GL_CONSTANT_COLOR0_NV)));
  std::copy(color.begin(), color.end(), params);
}

} // namespace handlers
} // namespace arbiter::state
