#pragma once
#include <GL/gl.h>

#include "state/objects/target.h"

/// The commands of ATI_fragment_shader that display lists can hold, called by the entry points.
namespace arbiter::state {

struct ProgramContext;

/// Executes BindFragmentShaderATI.
void bindFragmentShader(ProgramContext &context, GLuint name);
/// Executes SetFragmentShaderConstantATI. It sets the shader's own constant between
/// BeginFragmentShaderATI and EndFragmentShaderATI, else the context's. Requires that `constant` is
/// 0 to 7.
void setFragmentShaderConstant(ProgramContext &context, int constant, const Vec4 &value);

} // namespace arbiter::state
