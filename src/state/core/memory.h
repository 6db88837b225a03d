#pragma once
#include <exception>

#include "util/own_exception.h"

/// Handles commands for which the layer finds no memory. Commands allocate as any other code does.
/// The generated entry points and those of the window system catch what they throw.
namespace arbiter::state {

struct CoreContext;

/// Raises OUT_OF_MEMORY (2.5) for the command `name`, which may be carried out in part. The next
/// draw queries all state anew.
void outOfMemory(CoreContext &context, const char *name) noexcept;

/// Runs `work`, a step of a command that goes on even if the step fails. Without memory, raises the
/// error for the command `name`. It is not noexcept: `work` may call the host, and a thread that is
/// cancelled there unwinds through this.
/// \return false if `work` did not complete
template <typename Work> bool withinMemory(CoreContext &context, const char *name, Work work) {
  try {
    work();
    return true;
  } catch (const std::exception &error) {
    passOn(error);
    outOfMemory(context, name);
    return false;
  }
}

} // namespace arbiter::state
