#include "interposer/x_connection.h"

#include <dlfcn.h>

#include "util/cache/sealed.h"

namespace arbiter::interposer {

namespace {

template <typename Function> bool find(void *library, const char *name, Function &function) {
  function = library ? reinterpret_cast<Function>(dlsym(library, name)) : nullptr;
  return function != nullptr;
}

constinit Sealed<Xcb> g_xcb;
constinit Sealed<XlibBridge> g_xlibBridge;

void load(Xcb &xcb) {
  xcb.handle = dlopen("libxcb.so.1", RTLD_LAZY | RTLD_LOCAL);
  xcb.usable = true;
#define ARBITER_XCB_FIND(name) xcb.usable = find(xcb.handle, #name, xcb.name) && xcb.usable;
  ARBITER_XCB_FUNCTIONS(ARBITER_XCB_FIND)
#undef ARBITER_XCB_FIND
  (void)find(xcb.handle, "xcb_total_read", xcb.xcb_total_read);
}

} // namespace

bool Connection::sent(unsigned sequence) {
  const std::lock_guard lock(m_mutex);
  const bool follows = sequence == m_last + 1;
  // Two threads may arrive here in another order than they sent.
  if (int(sequence - m_last) > 0)
    m_last = sequence;
  if (!follows)
    ++m_changes;
  return !follows;
}

void Connection::listen(const std::function<void()> &takeOwn) {
  xcb_connection_t *const c = xcb;
  if (!c || !arbiter::interposer::xcb().xcb_total_read) {
    ++m_changes;
    return;
  }
  const auto total = [c] { return arbiter::interposer::xcb().xcb_total_read(c); };
  // Each look for answers reads from the socket. When it reads nothing more, all of the layer's
  // answers are taken.
  std::uint64_t before = total(), after = 0;
  for (int i = 0; i < 3; ++i, before = after) {
    takeOwn();
    after = total();
    if (after == before)
      break;
  }
  const std::lock_guard lock(m_mutex);
  const std::uint64_t others = after - m_taken;
  if (after == before && others == m_others)
    return;
  m_others = others;
  ++m_changes;
}

const Xcb &xcb() {
  static const Xcb &s_xcb = g_xcb.fill(load);
  return s_xcb;
}

const XlibBridge &xlibBridge() {
  static const XlibBridge &s_bridge = g_xlibBridge.fill([](XlibBridge &bridge) {
    bridge.handle = dlopen("libX11-xcb.so.1", RTLD_LAZY | RTLD_LOCAL);
    (void)find(bridge.handle, "XGetXCBConnection", bridge.connectionOf);
  });
  return s_bridge;
}

} // namespace arbiter::interposer
