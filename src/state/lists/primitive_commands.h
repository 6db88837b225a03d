#pragma once
#include <GL/gl.h>

/// Begin and End, called by the application or by a display list.
namespace arbiter::state {

struct RasterContext;

void issueBegin(RasterContext &context, GLenum mode);
void issueEnd(RasterContext &context);

} // namespace arbiter::state
