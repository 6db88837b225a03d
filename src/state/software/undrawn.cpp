// Until draw.cpp is built in: every draw is the host's.
#include "state/context.h"
#include "state/software/draw.h"
#include "state/software/residency.h"

namespace arbiter::state::software {

bool drawArrays(Context &context, const DrawCommand &) {
  hostDraws(context, "draw");
  return false;
}
bool begin(Context &context, GLenum) {
  hostDraws(context, "glBegin");
  return false;
}
void end(Context &) {}

} // namespace arbiter::state::software
