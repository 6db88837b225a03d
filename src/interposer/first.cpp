#include "interposer/first.h"
#include "interposer/plain_text.h"

// This code runs before libc's own constructor and any other library's, even a sanitizer's. It must
// not call anything.

namespace arbiter::interposer {

namespace {

char g_selection[] = "__GLX_VENDOR_LIBRARY_NAME=arbiter";
const char *g_replaced = nullptr;

/// Returns the value in `entry` (NAME=VALUE) if it has that name, else null.
const char *valueOf(const char *entry, const char *name) {
  const char *const rest = after(entry, name);
  return rest && *rest == '=' ? rest + 1 : nullptr;
}

bool isOurs(const char *vendor) {
  const char *const rest = after(vendor, kVendorName);
  return rest && !*rest;
}

/// Replaces the vendor selection in the environment, which the loader passes as libc will use it.
/// The environment cannot grow here, so that only an existing selection is replaced; the layer's
/// constructor does the rest (process.cpp). In a set-user-id program the loader has removed
/// LD_PRELOAD.
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
