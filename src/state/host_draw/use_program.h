#pragma once
#include <GL/gl.h>

/// Commands that change the current programs and enables on the host, called by the entry points.
namespace arbiter::state {

class Context;

/// Executes UseProgram and UseProgramObjectARB.
void useProgram(Context &context, GLuint name);
void pushAttrib(Context &context, GLbitfield mask);
/// Pushes the layer's entry of the attribute stack, after the host's.
void pushEnables(Context &context, GLbitfield mask);
/// Pops the layer's entry of the attribute stack and restores it, after the host's.
void popEnables(Context &context);
void popAttrib(Context &context);

} // namespace arbiter::state
