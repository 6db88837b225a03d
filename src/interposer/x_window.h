#pragma once
#include <cstdint>
#include <deque>
#include <memory>

#include "interposer/x_connection.h"

namespace arbiter::interposer {

/// A window that shows pictures, and its size. The server answers a query only after the pictures
/// before it, so that waiting for the answer would wait for the last frame. While only the layer's
/// requests use the connection, the last answer stays valid.
class Window {
public:
  Window(std::shared_ptr<Connection> to, std::uint32_t name, std::uint32_t graphicsContext,
         std::uint8_t bits)
      : connection(std::move(to)), window(name), gc(graphicsContext), depth(bits) {}
  const std::shared_ptr<Connection> connection;
  const std::uint32_t window, gc;
  const std::uint8_t depth;
  /// Set if the server refused a picture: the host must show them
  std::atomic<bool> failed = false;
  std::atomic<bool> hostMissedFrames = false; ///< since the host last looked at the size

  /// Returns the window's size. Waits for the answer if `sure` is set or the size may have changed
  /// since the last answer. Otherwise the new answer serves a later call, as other clients may
  /// change the size too.
  /// \param takeOwn takes all answers to the layer's requests that have arrived, this window's too
  /// \return false if there is no such window
  bool size(int &width, int &height, bool sure, const std::function<void()> &takeOwn);
  /// Takes the answers that have arrived.
  void takeAnswers();
  /// Called when the name may belong to another window.
  void forget();

private:
  bool take(xcb_connection_t *connection, bool wait);

  std::mutex m_mutex;
  std::deque<unsigned> m_questions; ///< pending queries, the oldest first
  bool m_known = false;
  int m_width = 0, m_height = 0;
  /// The connection's changes() when the size was last known to be right
  std::uint64_t m_changes = 0;
};

} // namespace arbiter::interposer
