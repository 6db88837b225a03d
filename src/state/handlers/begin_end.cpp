// Begin and End: a primitive goes to the host vertex by vertex, or is recorded for the rasterizer.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/lists/primitive_commands.h"
#include "state/raster_draw/immediate/list_arrays.h"

namespace arbiter::state::handlers {

void Begin(Context &context, GLenum mode) { issueBegin(context, mode); }

void End(Context &context) { issueEnd(context); }

void ArrayElement(Context &context, GLint index) {
  if (!recordElement(context, index))
    context.host->ArrayElement(index);
}

} // namespace arbiter::state::handlers
