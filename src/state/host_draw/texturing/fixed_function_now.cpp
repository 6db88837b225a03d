#include "state/host_draw/texturing/fixed_function_now.h"

#include "host/host_table.h"
#include "state/host_draw/draw_context.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"

namespace arbiter::state {

namespace {

using fp::ir::FogMode;
using fp::ir::TexTarget;

/// Finds the target that the active unit samples (ARB_texture_rectangle, 3.8.15: "cube map ... is
/// used"). Returns false if none is enabled.
bool enabledTarget(DrawContext &context, TexTarget &target) {
  struct Row {
    GLenum cap;
    TexTarget target;
  };
  static constexpr Row kByPrecedence[] = {{GL_TEXTURE_CUBE_MAP, TexTarget::Cube},
                                          {GL_TEXTURE_3D, TexTarget::Tex3D},
                                          {GL_TEXTURE_RECTANGLE, TexTarget::Rect},
                                          {GL_TEXTURE_2D, TexTarget::Tex2D},
                                          {GL_TEXTURE_1D, TexTarget::Tex1D}};
  for (const Row &row : kByPrecedence) {
    if (row.cap == GL_TEXTURE_RECTANGLE && !context.caps.textureRectangle)
      continue;
    if (context.host->IsEnabled(row.cap)) {
      target = row.target;
      return true;
    }
  }
  return false;
}

void queryTargets(DrawContext &context, std::uint32_t units, fp::FixedFunction &state) {
  if (units == 0)
    return;
  GLint active = GL_TEXTURE0;
  context.host->GetIntegerv(GL_ACTIVE_TEXTURE, &active);
  GLenum selected = GLenum(active);
  for (unsigned unit = 0; unit < state.targets.size(); ++unit) {
    if ((units >> unit & 1u) == 0)
      continue;
    if (selected != GL_TEXTURE0 + unit)
      context.host->ActiveTexture(selected = GL_TEXTURE0 + unit);
    if (!enabledTarget(context, state.targets[unit]))
      state.disabledUnits |= std::uint8_t(1u << unit);
  }
  if (selected != GLenum(active))
    context.host->ActiveTexture(GLenum(active));
}

FogMode queryFog(DrawContext &context) {
  if (!context.host->IsEnabled(GL_FOG))
    return FogMode::None;
  GLint mode = GL_EXP;
  context.host->GetIntegerv(GL_FOG_MODE, &mode);
  switch (mode) {
  case GL_LINEAR:
    return FogMode::Linear;
  case GL_EXP2:
    return FogMode::Exp2;
  default:
    return FogMode::Exp;
  }
}

bool vertexProgramEffective(const DrawContext &context) {
  return context.application.program != 0 || context.row(Target::Vertex).enabled ||
         (context.vertexShaders && context.vertexShaders->effective);
}

/// Returns whether colour sum applies. Lighting computes the secondary colour itself, whatever
/// COLOR_SUM says, and leaves it black unless the specular part is kept separate (OpenGL 1.4,
/// sections 2.13.1 and 3.9).
bool queryColorSum(DrawContext &context) {
  if (vertexProgramEffective(context) || !context.host->IsEnabled(GL_LIGHTING))
    return context.host->IsEnabled(GL_COLOR_SUM) != GL_FALSE;
  GLint control = GL_SINGLE_COLOR;
  context.host->GetIntegerv(GL_LIGHT_MODEL_COLOR_CONTROL, &control);
  return control == GL_SEPARATE_SPECULAR_COLOR;
}

} // namespace

fp::FixedFunction fixedFunctionNow(DrawContext &context, std::uint32_t units) {
  fp::FixedFunction state;
  queryTargets(context, units, state);
  state.fog = queryFog(context);
  state.colorSum = queryColorSum(context);
  return state;
}

} // namespace arbiter::state
