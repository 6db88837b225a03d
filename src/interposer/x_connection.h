#pragma once
#include <atomic>
#include <cstdlib>
#include <functional>
#include <memory>
#include <mutex>

#include <sys/uio.h>
#include <xcb/xcb.h>
#include <xcb/xcbext.h>

/// Speaks over an application's connection to its X server by libxcb, which returns errors as
/// answers instead of calling the application's error handler. Nothing is linked: libGLX has loaded
/// libxcb through libX11, and a process without X must be able to load the layer.
namespace arbiter::interposer {

/// The functions of libxcb that the layer uses.
struct Xcb {
  void *handle;
// NOLINTNEXTLINE(bugprone-macro-parentheses): a member's name cannot stand in parentheses.
#define ARBITER_XCB_FUNCTIONS(X)                                                                   \
  X(xcb_connect)                                                                                   \
  X(xcb_connection_has_error)                                                                      \
  X(xcb_create_gc_checked)                                                                         \
  X(xcb_depth_next)                                                                                \
  X(xcb_depth_visuals_iterator)                                                                    \
  X(xcb_discard_reply)                                                                             \
  X(xcb_disconnect)                                                                                \
  X(xcb_flush)                                                                                     \
  X(xcb_generate_id)                                                                               \
  X(xcb_get_extension_data)                                                                        \
  X(xcb_get_geometry)                                                                              \
  X(xcb_get_geometry_reply)                                                                        \
  X(xcb_get_input_focus)                                                                           \
  X(xcb_get_input_focus_reply)                                                                     \
  X(xcb_get_keyboard_mapping)                                                                      \
  X(xcb_get_keyboard_mapping_keysyms)                                                              \
  X(xcb_get_keyboard_mapping_keysyms_length)                                                       \
  X(xcb_get_setup)                                                                                 \
  X(xcb_get_window_attributes)                                                                     \
  X(xcb_get_window_attributes_reply)                                                               \
  X(xcb_poll_for_event)                                                                            \
  X(xcb_poll_for_reply)                                                                            \
  X(xcb_query_keymap)                                                                              \
  X(xcb_request_check)                                                                             \
  X(xcb_screen_allowed_depths_iterator)                                                            \
  X(xcb_screen_next)                                                                               \
  X(xcb_send_request)                                                                              \
  X(xcb_setup_roots_iterator)                                                                      \
  X(xcb_visualtype_next)                                                                           \
  X(xcb_wait_for_reply)
// NOLINTNEXTLINE(bugprone-macro-parentheses): a member's name cannot stand in parentheses.
#define ARBITER_XCB_MEMBER(name) decltype(&::name) name;
  ARBITER_XCB_FUNCTIONS(ARBITER_XCB_MEMBER)
#undef ARBITER_XCB_MEMBER
  decltype(&::xcb_total_read) xcb_total_read; ///< null before libxcb 1.14
  bool usable;                                ///< all other functions of libxcb were found
};
[[nodiscard]] const Xcb &xcb();

/// libX11-xcb, loaded at first use: a process without Xlib never needs it.
struct XlibBridge {
  void *handle;
  /// Returns the connection of an Xlib Display. Null if the library is missing.
  xcb_connection_t *(*connectionOf)(void *display);
};
[[nodiscard]] const XlibBridge &xlibBridge();

/// Owns an answer of libxcb and frees it.
template <typename Reply> using Answer = std::unique_ptr<Reply, decltype(&std::free)>;
template <typename Reply> Answer<Reply> answer(Reply *reply) { return {reply, &std::free}; }

/// A connection, and whether anything but the layer's requests went over it. If nothing did, the
/// application has neither asked the server to change anything nor heard of a change.
class Connection {
public:
  Connection(const void *ofDisplay, xcb_connection_t *connection)
      : display(ofDisplay), xcb(connection) {}
  const void *const display;
  std::atomic<xcb_connection_t *> xcb; ///< null: closed
  std::atomic<bool> refused = false;   ///< the server cannot reach this process's memory

  /// Returns a number that increases when the application, or another library, has sent a request
  /// or received an event or an answer.
  [[nodiscard]] std::uint64_t changes() const { return m_changes; }
  /// Notes that a request of the layer was sent. \return true if changes() has increased
  bool sent(unsigned sequence);
  /// Notes that an answer or error to a request of the layer was taken.
  void taken() { m_taken += kAnswerBytes; }
  /// Reads what came in. \param takeOwn takes all answers to the layer's requests that have arrived
  void listen(const std::function<void()> &takeOwn);

private:
  static constexpr std::uint64_t kAnswerBytes = 32; ///< both kinds of queries have short answers
  std::mutex m_mutex;                               ///< guards m_last and m_others
  unsigned m_last = 0;                              ///< the layer's last request
  std::uint64_t m_others = 0;                       ///< bytes that answer other requests
  std::atomic<std::uint64_t> m_taken = 0, m_changes = 1;
};

/// Sends a request of an extension without a reply.
/// \param checked its error waits for xcb_request_check(); else it goes to the application
/// \return its cookie
template <typename Request>
xcb_void_cookie_t send(xcb_connection_t *connection, xcb_extension_t &extension,
                       std::uint8_t opcode, Request request, bool checked) {
  const xcb_protocol_request_t protocol{2, &extension, opcode, 1};
  // libxcb writes into the two elements before the first.
  iovec parts[4] = {};
  parts[2] = {&request, sizeof request};
  return {
      xcb().xcb_send_request(connection, checked ? XCB_REQUEST_CHECKED : 0, parts + 2, &protocol)};
}

} // namespace arbiter::interposer
