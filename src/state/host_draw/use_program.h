#pragma once
#include <GL/gl.h>

/// Commands that change the current programs and enables on the host, called by the entry points.
namespace arbiter::state {

struct DrawContext;

/// Executes UseProgram and UseProgramObjectARB.
void useProgram(DrawContext &context, GLuint name);
void pushAttrib(DrawContext &context, GLbitfield mask);
/// Pushes the layer's entry of the attribute stack, after the host's.
void pushEnables(DrawContext &context, GLbitfield mask);
/// Pops the layer's entry of the attribute stack and restores it, after the host's.
void popEnables(DrawContext &context);
void popAttrib(DrawContext &context);

} // namespace arbiter::state
