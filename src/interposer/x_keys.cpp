#include "interposer/x_keys.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <vector>

#include <unistd.h>

#include "interposer/x_connection.h"
#include "state/hud/hud.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::interposer {

namespace {

class Keyboard {
public:
  Keyboard();
  [[nodiscard]] bool isDown(const HudKey &key);
  [[nodiscard]] pid_t owner() const { return m_owner; }

private:
  template <typename Reply> std::unique_ptr<Reply, decltype(&std::free)> poll(unsigned &sequence);
  void askForMapping();
  void takeMapping();
  void takeEvents();
  [[nodiscard]] bool isKeysymDown(std::uint32_t keysym) const;

  const Xcb &m_xcb = xcb();
  pid_t m_owner = getpid();
  xcb_connection_t *m_connection = nullptr; ///< null: there is no server, or it is gone
  unsigned m_mapping = 0, m_state = 0;      ///< sequence numbers of pending requests; 0: none
  xcb_keycode_t m_first = 0;                ///< the key code of m_keysyms' first key
  std::size_t m_perKey = 0;                 ///< keysyms for each key
  std::vector<xcb_keysym_t> m_keysyms;
  std::uint8_t m_down[32] = {}; ///< one bit for each key code
};

Keyboard::Keyboard() {
  if (!m_xcb.usable || !secure_getenv("DISPLAY"))
    return;
  m_connection = m_xcb.xcb_connect(nullptr, nullptr);
  if (m_xcb.xcb_connection_has_error(m_connection) != 0) {
    m_connection = nullptr; // the object is never freed, as there is only one
    logInfo("hud", "no key shows and hides the figures: there is no X server");
    return;
  }
  askForMapping();
}

void Keyboard::askForMapping() {
  const xcb_setup_t *const setup = m_xcb.xcb_get_setup(m_connection);
  m_first = setup->min_keycode;
  m_mapping = m_xcb
                  .xcb_get_keyboard_mapping(m_connection, m_first,
                                            std::uint8_t(setup->max_keycode - m_first + 1))
                  .sequence;
  m_xcb.xcb_flush(m_connection);
}

/// Requests the keysyms again if the layout has changed, which the server reports to every client.
void Keyboard::takeEvents() {
  while (xcb_generic_event_t *const event = m_xcb.xcb_poll_for_event(m_connection)) {
    const bool mapping = (event->response_type & 0x7F) == XCB_MAPPING_NOTIFY;
    std::free(event);
    if (!mapping)
      continue;
    if (m_mapping != 0)
      m_xcb.xcb_discard_reply(m_connection, m_mapping);
    askForMapping();
  }
}

/// Takes the answer to a request if it has arrived, and clears `sequence` if the request has ended.
template <typename Reply>
std::unique_ptr<Reply, decltype(&std::free)> Keyboard::poll(unsigned &sequence) {
  void *reply = nullptr;
  xcb_generic_error_t *error = nullptr;
  if (sequence != 0 && m_xcb.xcb_poll_for_reply(m_connection, sequence, &reply, &error) != 0)
    sequence = 0;
  std::free(error);
  return {static_cast<Reply *>(reply), &std::free};
}

void Keyboard::takeMapping() {
  const auto reply = poll<xcb_get_keyboard_mapping_reply_t>(m_mapping);
  if (!reply)
    return;
  const xcb_keysym_t *const keysyms = m_xcb.xcb_get_keyboard_mapping_keysyms(reply.get());
  m_perKey = reply->keysyms_per_keycode;
  m_keysyms.assign(keysyms, keysyms + m_xcb.xcb_get_keyboard_mapping_keysyms_length(reply.get()));
}

/// True if a key is down that has the keysym with any modifier.
bool Keyboard::isKeysymDown(std::uint32_t keysym) const {
  for (std::size_t i = 0; i < m_keysyms.size(); ++i) {
    const std::size_t code = m_first + i / m_perKey;
    if (m_keysyms[i] == keysym && (m_down[code / 8 % sizeof m_down] >> code % 8 & 1) != 0)
      return true;
  }
  return false;
}

bool Keyboard::isDown(const HudKey &key) {
  if (!m_connection || m_xcb.xcb_connection_has_error(m_connection) != 0)
    return false;
  takeEvents();
  takeMapping();
  if (const auto reply = poll<xcb_query_keymap_reply_t>(m_state))
    std::copy(std::begin(reply->keys), std::end(reply->keys), m_down);
  if (m_state == 0) {
    m_state = m_xcb.xcb_query_keymap(m_connection).sequence;
    m_xcb.xcb_flush(m_connection);
  }
  // The right one's keysym follows the left one's
  constexpr std::uint32_t kShift = 0xFFE1, kControl = 0xFFE3, kAlt = 0xFFE9;
  const auto held = [&](std::uint32_t left) {
    return isKeysymDown(left) || isKeysymDown(left + 1);
  };
  return isKeysymDown(key.keysym) && held(kShift) == key.shift && held(kControl) == key.control &&
         held(kAlt) == key.alt;
}

/// True if the key and its modifiers were down at the server's last answer. Sends a new query.
bool isKeyDown(const HudKey &key) {
  // The objects are never freed: a child of fork() must leave its parent's connection alone, and
  // frames may end after static destructors began.
  static auto *const s_mutex = new std::mutex;
  static Keyboard *s_keyboard = nullptr;
  const std::lock_guard lock(*s_mutex);
  if (!s_keyboard || s_keyboard->owner() != getpid())
    s_keyboard = new Keyboard;
  return s_keyboard->isDown(key);
}

} // namespace

void offerHudKey() {
  if (settings().hud.on)
    state::hud::g_keyIsDown.store(isKeyDown, std::memory_order_release);
}

} // namespace arbiter::interposer
