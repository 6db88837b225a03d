// What LD_PRELOAD finds under $LIB in processes of the machine's other width (32 bits beside 64).
// The loader complains of a library that is not there, or of the wrong width, in every such
// process; this one is always there. Where the layer is installed for that width too, it is loaded
// in this one's place (an auxiliary filter: the loader does without, and says nothing, where it is
// missing). Where it is not, the process runs as without the layer: libglvnd's variables, which
// select a vendor that no library of this width has, are what they were before.
//
// Compiled for the other width without its C library, and run before any constructor: it calls
// nothing.
#include "interposer/plain_text.h"

namespace {

using arbiter::interposer::after;
using arbiter::interposer::contains;

constexpr int kMostLength = 8192;

struct Selection {
  const char *name;  ///< libglvnd's variable
  const char *marks; ///< in a value of the layer's
  const char *saved; ///< has what it was
  char *before;      ///< room for the entry as it was
};

char g_glx[kMostLength];
char g_egl[kMostLength];
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

/// The entry `name` with `value` in `room`; null where it is too long.
char *entryOf(const char *name, const char *value, char *room) {
  int length = 0;
  const char *const texts[] = {name, value};
  for (const char *text : texts)
    for (; *text; ++text) {
      if (length == kMostLength - 1)
        return nullptr;
      room[length++] = *text;
    }
  room[length] = 0;
  return room;
}

/// The entry in the place of `entry`; null if there is to be none.
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

/// Of libarbiter_first.so, which the layer brings along.
extern "C" [[gnu::weak]] const char *arbiterReplacedVendor();

namespace {

[[gnu::constructor]] void restoreSelection(int /*argc*/, char ** /*argv*/, char **environment) {
  if (&arbiterReplacedVendor || !environment)
    return;
  // In two steps: what was saved may stand on either side of what it replaces.
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
