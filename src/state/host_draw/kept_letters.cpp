#include "state/host_draw/kept_letters.h"

#include "host/host_table.h"
#include "state/core/host_errors.h"

namespace arbiter::state {

void drawKeptLetters(Context &context) {
  if (context.insideBeginEnd || context.listMode != 0)
    return; // it is not the time, and there will be another
  context.attention &= ~attention::kLetters;
  // An incomplete framebuffer makes an error of it.
  const HostErrorScope errors(*context.host, context.pendingError);
  context.host->Clear(0);
}

} // namespace arbiter::state
