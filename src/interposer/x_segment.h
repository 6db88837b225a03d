#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>

#include "interposer/x_connection.h"

/// Memory that this process and the X server share (MIT-SHM).
namespace arbiter::interposer {

/// True if the server has the extension. Only attaching memory shows whether the server can reach
/// it.
[[nodiscard]] bool hasSharedMemory(xcb_connection_t *connection);

/// A part of a segment and where it is shown. Pixels have 32 bits, the top row is first.
struct Picture {
  std::uint32_t drawable = 0, gc = 0;
  std::uint8_t depth = 0;
  std::uint16_t width = 0, height = 0;
  std::uint16_t rowPixels = 0; ///< from one row to the next
  std::size_t offset = 0;      ///< bytes from memory() to the upper left
};

/// A segment and its pictures that the server has yet to read. Pictures are put without waiting:
/// the server reads one while the next is drawn to another segment. A query follows each picture,
/// and its answer tells that the picture was read. That way nothing enters the application's event
/// queue, and errors come back to the segment. Each segment has at most one picture under way, so
/// that unread answers do not pile up.
class Segment {
public:
  /// Creates a segment, which costs a round trip. Returns null if there is no memory, or if the
  /// server cannot reach it; the connection is then marked as refused.
  static std::unique_ptr<Segment> make(std::shared_ptr<Connection> connection, std::size_t bytes);
  ~Segment();
  Segment(const Segment &) = delete;
  Segment &operator=(const Segment &) = delete;

  [[nodiscard]] std::uint8_t *memory() const { return m_memory; }
  [[nodiscard]] std::size_t bytes() const { return m_bytes; }
  [[nodiscard]] const std::shared_ptr<Connection> &connection() const { return m_connection; }

  /// Asks the server to show a picture. The memory must not be written until isRead() returns
  /// false.
  /// \param failed set, sooner or later, if the server refused; outlives the segment
  /// \return false if the connection is closed or broken
  bool show(const Picture &picture, std::atomic<bool> &failed);
  /// True while the server has yet to read a picture.
  /// \param wait waits until the server has read it; without it the call does not wait for another
  /// thread either, and may return true too long
  bool isRead(bool wait);

  bool used = false;         ///< by an image; the owner's
  std::uint64_t shownAt = 0; ///< the owner's number of the last picture

private:
  Segment() = default;
  bool takeAnswers(xcb_connection_t *connection, bool wait);

  std::shared_ptr<Connection> m_connection;
  std::uint32_t m_name = 0;
  std::uint8_t *m_memory = nullptr;
  std::size_t m_bytes = 0;
  std::mutex m_mutex; ///< guards the members below
  xcb_void_cookie_t m_put = {};
  xcb_get_input_focus_cookie_t m_behind = {};
  std::atomic<bool> m_underWay = false;
  std::atomic<bool> *m_failed = nullptr;
};

} // namespace arbiter::interposer
