// A library whose destructor takes its time. A client that opens it is in exit() for so long, with
// libGLX finalised, which nothing of this depends on, and Xlib not yet, which this uses.
#include <unistd.h>

#include <X11/Xlib.h>

namespace {

[[gnu::destructor]] void finalised() {
  usleep(300'000);
  XFree(nullptr);
}

} // namespace
