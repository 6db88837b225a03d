#pragma once
#include <GL/gl.h>

/// Begin and End, called by the application or by a display list.
namespace arbiter::state {

class Context;

void issueBegin(Context &context, GLenum mode);
void issueEnd(Context &context);

} // namespace arbiter::state
