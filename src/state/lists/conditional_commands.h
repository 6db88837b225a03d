#pragma once
#include <GL/gl.h>

/// Conditional rendering, whose state GL does not tell. One that the host refuses counts as begun:
/// until its end the host draws, which is always right. A list that the layer keeps holds both as
/// commands of its own.
namespace arbiter::state {

struct RasterContext;

void issueBeginConditional(RasterContext &context, GLuint id, GLenum mode);
void issueEndConditional(RasterContext &context);

} // namespace arbiter::state
