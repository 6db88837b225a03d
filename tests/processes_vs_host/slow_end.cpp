// A library with a slow destructor. A client that opens it stays in exit() for long. By then libGLX
// is finalised, as it does not depend on this library, but Xlib, which this library uses, is not.
#include <unistd.h>

#include <X11/Xlib.h>

namespace {

[[gnu::destructor]] void finalised() {
  usleep(300'000);
  XFree(nullptr);
}

} // namespace
