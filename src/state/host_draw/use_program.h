#pragma once
#include <GL/gl.h>

/// Commands that change which programs and enables are current on the host, below the entry points.
namespace arbiter::state {

class Context;

/// UseProgram, UseProgramObjectARB.
void useProgram(Context &context, GLuint name);
void pushAttrib(Context &context, GLbitfield mask);
/// The attribute stack's entry of the layer's, after the host's.
void pushEnables(Context &context, GLbitfield mask);
/// Those that the entry holds become current again, after the host's.
void popEnables(Context &context);
void popAttrib(Context &context);

} // namespace arbiter::state
