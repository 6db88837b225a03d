#include "interposer/first.h"
#include "interposer/plain_text.h"

// Runs before libc's own constructor and before any other library's, a sanitizer's too: it calls
// nothing.

namespace arbiter::interposer {

namespace {

char g_selection[] = "__GLX_VENDOR_LIBRARY_NAME=arbiter";
const char *g_replaced = nullptr;

/// The value of the variable in `entry` (NAME=VALUE), if it is the one of that name.
const char *valueOf(const char *entry, const char *name) {
  const char *const rest = after(entry, name);
  return rest && *rest == '=' ? rest + 1 : nullptr;
}

bool isOurs(const char *vendor) {
  const char *const rest = after(vendor, kVendorName);
  return rest && !*rest;
}

/// The loader passes the environment as it will be libc's. It cannot grow here, so that only a
/// selection that stands is replaced; the rest is the layer's constructor's (process.cpp). In a
/// set-user-id program the loader has taken LD_PRELOAD out.
[[gnu::constructor]] void replaceSelection(int /*argc*/, char ** /*argv*/, char **environment) {
  bool preloaded = false;
  char **selection = nullptr;
  for (char **entry = environment; entry && *entry; ++entry) {
    if (const char *const libraries = valueOf(*entry, "LD_PRELOAD"))
      preloaded = contains(libraries, kLibrary);
    else if (!selection && valueOf(*entry, kGlxSelection))
      selection = entry;
  }
  if (!preloaded || !selection)
    return;
  const char *const vendor = valueOf(*selection, kGlxSelection);
  if (!*vendor || isOurs(vendor))
    return;
  g_replaced = vendor;
  *selection = g_selection;
}

} // namespace

} // namespace arbiter::interposer

extern "C" __attribute__((visibility("default"))) const char *arbiterReplacedVendor() {
  return arbiter::interposer::g_replaced;
}
