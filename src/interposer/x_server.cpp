#include "interposer/x_server.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include <sys/uio.h>
#include <unistd.h>

#include "interposer/x_connection.h"

namespace arbiter::interposer {

namespace {

/// The request glXQueryServerString of the GLX protocol, and the name that GLX_EXT_libglvnd adds.
constexpr std::uint8_t kQueryServerString = 19;
constexpr std::uint32_t kVendorNamesExt = 0x20F6;

struct Request {
  std::uint8_t majorOpcode;
  std::uint8_t minorOpcode;
  std::uint16_t length;
  std::uint32_t screen;
  std::uint32_t name;
};

struct Reply {
  std::uint8_t type;
  std::uint8_t unused;
  std::uint16_t sequence;
  std::uint32_t length;
  std::uint32_t pad;
  std::uint32_t bytes;
  std::uint32_t padding[4];
};

xcb_extension_t g_glx = {"GLX", 0};

std::atomic<xcb_connection_t *> g_connection; ///< the layer's own; null: closed
std::atomic<pid_t> g_owner;                   ///< the process that opened g_connection

std::string queryVendorNames(const Xcb &xcb, xcb_connection_t *connection, int screen) {
  const xcb_query_extension_reply_t *const glx = xcb.xcb_get_extension_data(connection, &g_glx);
  if (!glx || !glx->present)
    return {};
  Request request{0, kQueryServerString, 0, std::uint32_t(screen), kVendorNamesExt};
  const xcb_protocol_request_t protocol{2, &g_glx, kQueryServerString, 0};
  // libxcb writes into the two elements before the first.
  iovec parts[4] = {};
  parts[2] = {&request, sizeof request};
  parts[3] = {nullptr, 0};
  const unsigned sequence =
      xcb.xcb_send_request(connection, XCB_REQUEST_CHECKED, parts + 2, &protocol);
  xcb_generic_error_t *error = nullptr;
  auto *const reply = static_cast<Reply *>(xcb.xcb_wait_for_reply(connection, sequence, &error));
  std::string names;
  if (reply && reply->bytes <= reply->length * 4u)
    names.assign(reinterpret_cast<const char *>(reply + 1), reply->bytes);
  while (!names.empty() && names.back() == '\0')
    names.pop_back();
  std::free(reply);
  std::free(error);
  return names;
}

} // namespace

std::string serverVendorNames() {
  const char *const display = secure_getenv("DISPLAY");
  if (!display || !*display)
    return {};
  const Xcb &xcb = interposer::xcb();
  if (!xcb.usable)
    return {};
  int screen = 0;
  xcb_connection_t *const connection = xcb.xcb_connect(nullptr, &screen);
  std::string names;
  if (connection && !xcb.xcb_connection_has_error(connection))
    names = queryVendorNames(xcb, connection, screen);
  closeServerQuery(); // an earlier one of this process; that of a parent is the parent's to close
  g_owner = getpid();
  g_connection = connection;
  return names;
}

void closeServerQuery() {
  // A child of fork() shares the socket, and closing it there would end it for the parent too.
  if (!g_connection || g_owner != getpid())
    return;
  if (xcb_connection_t *const connection = g_connection.exchange(nullptr))
    xcb().xcb_disconnect(connection);
}

} // namespace arbiter::interposer
