#pragma once
#include <exception>

#include "util/own_exception.h"

/// What becomes of a command that finds no memory of the layer's. Commands allocate as any other
/// code does, and what they throw is caught where they were entered: by the generated entry points,
/// and by the window system's.
namespace arbiter::state {

class Context;

/// The command `name` raises OUT_OF_MEMORY (2.5); it may not have been carried out, or not to its
/// end. The next draw looks at all state anew.
void outOfMemory(Context &context, const char *name) noexcept;

/// Runs `work`; where it finds no memory, raises the error in the name of the command `name`. For
/// steps of a command that goes on whatever becomes of them. Not noexcept, as `work` may ask the
/// host: a thread that is cancelled there is unwound through this. \return false if it was not
/// carried out to its end
template <typename Work> bool withinMemory(Context &context, const char *name, Work work) {
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
