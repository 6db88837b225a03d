#include "interposer/x_display.h"

#include <mutex>
#include <type_traits>

#include <dlfcn.h>

#include "interposer/registry.h"
#include "interposer/x_present.h"
#include "interposer/x_server.h"
#include "util/cache/sealed.h"

// This include must be last: its macros are named min, max and None.
#include <X11/Xlibint.h>

namespace arbiter::interposer {

namespace {

int displayCloses(Display *display, XExtCodes *) {
  registry::displayClosed(state::Provider::Glx, display);
  presentingDisplayCloses(display);
  return 0;
}

/// Functions of the application's Xlib, which is not linked.
struct Xlib {
  decltype(&XAddExtension) addExtension;
  decltype(&XESetCloseDisplay) setCloseDisplay;
};
constinit Sealed<Xlib> g_xlib;

const Xlib &xlib() {
  static const Xlib &s_xlib = g_xlib.fill([](Xlib &x) {
    const auto find = [](auto &function, const char *name) {
      function =
          reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(RTLD_DEFAULT, name));
    };
    find(x.addExtension, "XAddExtension");
    find(x.setCloseDisplay, "XESetCloseDisplay");
  });
  return s_xlib;
}

} // namespace

void watchDisplay(void *ofApplication) {
  closeServerQuery();
  static std::mutex *const s_mutex = new std::mutex;
  auto *const display = static_cast<Display *>(ofApplication);
  const Xlib &x = xlib();
  if (!display || !x.addExtension || !x.setCloseDisplay)
    return;
  const std::lock_guard lock(*s_mutex);
  // The hook is recorded in the display's own list of extensions, which dies with it.
  for (const _XExtension *e = display->ext_procs; e; e = e->next)
    if (e->close_display == displayCloses)
      return;
  if (const XExtCodes *codes = x.addExtension(display))
    x.setCloseDisplay(display, codes->extension, displayCloses);
}

} // namespace arbiter::interposer
