#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>

#include "interposer/x_connection.h"

/// Memory that this process and the X server share (MIT-SHM).
namespace arbiter::interposer {

/// True if the server has the extension; whether it reaches this process's memory shows when it is
/// attached.
[[nodiscard]] bool hasSharedMemory(xcb_connection_t *connection);

/// What of a segment is shown where, of 32 bits a pixel, the top row first.
struct Picture {
  std::uint32_t drawable = 0, gc = 0;
  std::uint8_t depth = 0;
  std::uint16_t width = 0, height = 0;
  std::uint16_t rowPixels = 0; ///< from one row to the next
  std::size_t offset = 0;      ///< bytes from memory() to the upper left
};

/// A segment and the pictures of it that the server has still to read. Pictures are put without
/// waiting: the server reads one while the next is drawn to another segment. Behind each goes a
/// question whose answer says that it was read, so that nothing enters the application's queue of
/// events, and errors come back to the segment. One picture of a segment is under way at a time, so
/// that answers do not pile up, even if they are never asked for.
class Segment {
public:
  /// A round trip. Null: there is no memory, or the server cannot reach it, which the connection
  /// then says.
  static std::unique_ptr<Segment> make(std::shared_ptr<Connection> connection, std::size_t bytes);
  ~Segment();
  Segment(const Segment &) = delete;
  Segment &operator=(const Segment &) = delete;

  [[nodiscard]] std::uint8_t *memory() const { return m_memory; }
  [[nodiscard]] std::size_t bytes() const { return m_bytes; }
  [[nodiscard]] const std::shared_ptr<Connection> &connection() const { return m_connection; }

  /// Asks the server to show it; the memory may not be written until isRead() is false.
  /// \param failed set, sooner or later, if the server refused; outlives the segment
  /// \return false: the connection is closed or broken
  bool show(const Picture &picture, std::atomic<bool> &failed);
  /// Whether the server has still to read a picture. \param wait until it has; without it another
  /// thread is not waited for either, and the answer may be true too long
  bool isRead(bool wait);

  bool used = false;         ///< by an image; the owner's
  std::uint64_t shownAt = 0; ///< the owner's count of pictures

private:
  Segment() = default;
  bool takeAnswers(xcb_connection_t *connection, bool wait);

  std::shared_ptr<Connection> m_connection;
  std::uint32_t m_name = 0;
  std::uint8_t *m_memory = nullptr;
  std::size_t m_bytes = 0;
  std::mutex m_mutex; ///< of what follows
  xcb_void_cookie_t m_put = {};
  xcb_get_input_focus_cookie_t m_behind = {};
  std::atomic<bool> m_underWay = false;
  std::atomic<bool> *m_failed = nullptr;
};

} // namespace arbiter::interposer
