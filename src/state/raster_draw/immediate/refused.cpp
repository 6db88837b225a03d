#include "state/raster_draw/immediate/refused.h"

#include <GL/glext.h>

#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/raster_draw/immediate/held.h"
#include "state/raster_draw/immediate/replay.h"

namespace arbiter::state {

namespace {

/// Makes the real host available for queries while it lives. No primitive is open on it.
class HostBehind {
public:
  explicit HostBehind(RasterContext &context) : m_context(context) {
    context.host = context.trueHost;
    context.insideBeginEnd = false;
  }
  ~HostBehind() {
    m_context.host = &kRecordingHost;
    m_context.insideBeginEnd = true;
  }
  HostBehind(const HostBehind &) = delete;
  HostBehind &operator=(const HostBehind &) = delete;

private:
  RasterContext &m_context;
};

} // namespace

bool refuses(ContextHot &hot, const char *command) {
  auto &context = rasterStep(hot);
  if (isHeld(hot)) {
    drawHeld(hot);
    return false;
  }
  if (context.host == &kRecordingHost && context.listMode == 0) {
    const HostBehind behind(context);
    if (context.host->IsEnabled(GL_DEBUG_OUTPUT) == GL_FALSE) {
      raise(context, GL_INVALID_OPERATION, command);
      return true;
    }
  }
  context.attention &= ~attention::kRecorded;
  return false;
}

} // namespace arbiter::state
