#pragma once
#include <cstdint>
#include <deque>
#include <memory>

#include "interposer/x_connection.h"

namespace arbiter::interposer {

/// A window as a place to show pictures in, and its size. The server comes to a question only after
/// the pictures before it, so that waiting for the answer would wait for the last frame; while
/// nothing but the layer's requests goes over the connection the last answer will do.
class Window {
public:
  Window(std::shared_ptr<Connection> to, std::uint32_t name, std::uint32_t graphicsContext,
         std::uint8_t bits)
      : connection(std::move(to)), window(name), gc(graphicsContext), depth(bits) {}
  const std::shared_ptr<Connection> connection;
  const std::uint32_t window, gc;
  const std::uint8_t depth;
  std::atomic<bool> failed = false; ///< the server refused a picture: the host is to show them
  std::atomic<bool> hostMissedFrames = false; ///< that were shown since it last looked at the size

  /// Asks for the size. Waits for the answer if it may be another one than the last answer's, or if
  /// `sure`; else the answer counts for a later call, since other clients may change the size too.
  /// \param takeOwn takes all answers to the layer's requests that are there, this window's too
  /// \return false: there is no such window
  bool size(int &width, int &height, bool sure, const std::function<void()> &takeOwn);
  /// Takes the answers that are there.
  void takeAnswers();
  /// The name may be another window's since.
  void forget();

private:
  bool take(xcb_connection_t *connection, bool wait);

  std::mutex m_mutex;
  std::deque<unsigned> m_questions; ///< without an answer as yet, the oldest first
  bool m_known = false;
  int m_width = 0, m_height = 0;
  std::uint64_t m_changes = 0; ///< of the connection, when the size was last known to hold
};

} // namespace arbiter::interposer
