#include "state/host_draw/kept_letters.h"

#include "host/host_table.h"
#include "state/core/host_errors.h"

namespace arbiter::state {

void drawKeptLetters(DrawContext &context) {
  if (context.insideBeginEnd || context.listMode != 0)
    return; // not possible now; a later draw will do it
  context.attention &= ~attention::kLetters;
  // Clear is an error if the framebuffer is incomplete.
  const HostErrorScope errors(*context.host, context.errors.pending);
  context.host->Clear(0);
}

} // namespace arbiter::state
