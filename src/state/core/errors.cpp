#include "state/core/errors.h"

#include "host/host_table.h"
#include "state/core/core_context.h"
#include "util/flags.h"

namespace arbiter::state {

namespace {

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

void raise(CoreContext &context, GLenum error, const char *why) {
  if (debugFlag(DebugFlag::Errors))
    logFlag(DebugFlag::Errors, "state", "context %u: GL_%s: %s", context.serial, errorName(error),
            why);
  else
    logInfo("state", "context %u: GL_%s: %s", context.serial, errorName(error), why);
  if (context.errors.pending != GL_NO_ERROR)
    return;
  // GetError is itself an error between Begin and End, so the order of errors cannot be known.
  const GLenum earlier =
      context.insideBeginEnd ? GLenum(GL_NO_ERROR) : takeHostErrors(*context.host);
  context.errors.pending = earlier != GL_NO_ERROR ? earlier : error;
}

GLenum takeError(CoreContext &context) {
  if (context.insideBeginEnd)
    return context.host->GetError(); // raises INVALID_OPERATION there, as it should
  if (context.errors.pending == GL_NO_ERROR)
    return context.host->GetError();
  (void)takeHostErrors(*context.host); // raised after the layer's error, so GL would not have
                                       // recorded them
  const GLenum error = context.errors.pending;
  context.errors.pending = GL_NO_ERROR;
  return error;
}

bool outsideBeginEnd(CoreContext &context, const char *command) {
  if (!context.insideBeginEnd) [[likely]]
    return true;
  raise(context, GL_INVALID_OPERATION, command);
  return false;
}

} // namespace arbiter::state
