#pragma once
#include <GL/gl.h>

#include "state/objects/target.h"

/// The commands of ATI_fragment_shader that display lists hold, below the entry points.
namespace arbiter::state {

class Context;

/// BindFragmentShaderATI.
void bindFragmentShader(Context &context, GLuint name);
/// SetFragmentShaderConstantATI: the shader's own constant between Begin- and
/// EndFragmentShaderATI, else the context's. `constant` is 0 to 7.
void setFragmentShaderConstant(Context &context, int constant, const Vec4 &value);

} // namespace arbiter::state
