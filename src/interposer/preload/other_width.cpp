// The library that LD_PRELOAD finds under $LIB in processes of the machine's other word size
// (32-bit beside 64-bit). The loader complains in every such process about a missing library or one
// of the wrong word size; this one is always there. If the layer is installed for that word size
// too, it is loaded in place of this library (an auxiliary filter, which the loader skips silently
// if it is missing). If not, the process runs without the layer: this library restores libglvnd's
// variables, as they select a vendor that has no library of this word size.
//
// It is compiled for the other word size without a C library, and runs before any constructor, so
// that it must not call anything.
#include "interposer/plain_text.h"

namespace {

using arbiter::interposer::after;
using arbiter::interposer::contains;

constexpr int kMaxLength = 8192;

struct Selection {
  const char *name;  ///< libglvnd's variable
  const char *marks; ///< identifies a value that the layer set
  const char *saved; ///< the variable with the previous value
  char *before;      ///< a buffer for the previous entry
};

char g_glx[kMaxLength];
char g_egl[kMaxLength];
const Selection kSelections[] = {
    {"__GLX_VENDOR_LIBRARY_NAME=", "arbiter", "ARBITER_SAVED_GLX_VENDOR=", g_glx},
    {"__EGL_VENDOR_LIBRARY_FILENAMES=", "_arbiter.json", "ARBITER_SAVED_EGL_VENDORS=", g_egl},
};

const char *valueOf(char **environment, const char *name) {
  for (; *environment; ++environment)
    if (const char *const value = after(*environment, name))
      return value;
  return nullptr;
}

/// Writes the entry `name` with `value` to `room`; null if it is too long.
char *entryOf(const char *name, const char *value, char *room) {
  int length = 0;
  const char *const texts[] = {name, value};
  for (const char *text : texts)
    for (; *text; ++text) {
      if (length == kMaxLength - 1)
        return nullptr;
      room[length++] = *text;
    }
  room[length] = 0;
  return room;
}

/// Returns the previous entry in the place of `entry`; null if it is to be removed.
char *asBefore(char *entry, char **environment) {
  for (const Selection &selection : kSelections) {
    if (after(entry, selection.saved))
      return nullptr;
    const char *const value = after(entry, selection.name);
    if (!value || !contains(value, selection.marks))
      continue;
    const char *const saved = valueOf(environment, selection.saved);
    return saved ? entryOf(selection.name, saved, selection.before) : nullptr;
  }
  return entry;
}

} // namespace

/// Defined by libarbiter_first.so, which the layer brings along.
extern "C" [[gnu::weak]] const char *arbiterReplacedVendor();

namespace {

[[gnu::constructor]] void restoreSelection(int /*argc*/, char ** /*argv*/, char **environment) {
  if (&arbiterReplacedVendor || !environment)
    return;
  // This takes two passes, as a saved value may stand before or after the one it replaces.
  for (char **entry = environment; *entry; ++entry)
    for (const Selection &selection : kSelections)
      if (after(*entry, selection.name))
        if (char *const before = asBefore(*entry, environment))
          *entry = before;
  char **kept = environment;
  for (char **entry = environment; *entry; ++entry)
    if (*entry == g_glx || *entry == g_egl || asBefore(*entry, environment))
      *kept++ = *entry;
  *kept = nullptr;
}

} // namespace
