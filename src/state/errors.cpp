#include "state/errors.h"

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context.h"
#include "state/memory.h"
#include "state/program_api.h"
#include "state/software/stale.h"
#include "util/flags.h"

namespace arbiter::state {

namespace {

/// A lost context answers GetError with the same error for ever.
constexpr int kMaxHostErrors = 16;

/// The host's pending error, if any; all of them are taken.
GLenum drainHost(Context &context) {
  GLenum first = GL_NO_ERROR;
  for (int i = 0; i < kMaxHostErrors; ++i) {
    const GLenum error = context.host->GetError();
    if (error == GL_NO_ERROR)
      break;
    if (first == GL_NO_ERROR)
      first = error;
  }
  return first;
}

const char *errorName(GLenum error) {
  switch (error) {
  case GL_INVALID_ENUM:
    return "INVALID_ENUM";
  case GL_INVALID_VALUE:
    return "INVALID_VALUE";
  case GL_INVALID_OPERATION:
    return "INVALID_OPERATION";
  case GL_OUT_OF_MEMORY:
    return "OUT_OF_MEMORY";
  default:
    return "error";
  }
}

} // namespace

void raise(Context &context, GLenum error, const char *why) {
  if (debugFlag(DebugFlag::Errors))
    logFlag(DebugFlag::Errors, "state", "context %u: GL_%s: %s", context.serial, errorName(error),
            why);
  else
    logInfo("state", "context %u: GL_%s: %s", context.serial, errorName(error), why);
  if (context.pendingError != GL_NO_ERROR)
    return;
  // GetError is itself an error between Begin and End: there the order cannot be known.
  const GLenum earlier = context.insideBeginEnd ? GLenum(GL_NO_ERROR) : drainHost(context);
  context.pendingError = earlier != GL_NO_ERROR ? earlier : error;
}

GLenum takeError(Context &context) {
  if (context.insideBeginEnd)
    return context.host->GetError(); // raises INVALID_OPERATION there, as it should
  if (context.pendingError == GL_NO_ERROR)
    return context.host->GetError();
  (void)drainHost(context); // raised later than ours, hence never recorded
  const GLenum error = context.pendingError;
  context.pendingError = GL_NO_ERROR;
  return error;
}

HostErrorScope::HostErrorScope(Context &context) : m_context(context) {
  const GLenum earlier = drainHost(context);
  if (context.pendingError == GL_NO_ERROR)
    context.pendingError = earlier;
}

HostErrorScope::~HostErrorScope() { (void)drainHost(m_context); }

bool HostErrorScope::failed() {
  if (drainHost(m_context) != GL_NO_ERROR)
    m_failed = true;
  return m_failed;
}

void outOfMemory(Context &context, const char *name) noexcept {
  raise(context, GL_OUT_OF_MEMORY, name);
  if (context.passThrough)
    return;
  context.stale = software::stale::kAll;
  invalidateProgram(context);
  // What was chosen before is not what a draw that failed half-way has left.
  if (context.software)
    context.software->draws.reset();
}

namespace handlers {
GLenum GetError(Context &context) { return takeError(context); }
} // namespace handlers

} // namespace arbiter::state
