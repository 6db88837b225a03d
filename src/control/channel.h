#pragma once
#include <cstdint>
#include <deque>
#include <string>

#include "control/address.h"

namespace arbiter::control {

/// Splits the bytes of a connected socket into lines, and queues lines for sending. The descriptor
/// becomes non-blocking, and nothing here waits. Only one thread may use it.
class Channel {
public:
  /// The limit of bytes waiting to be sent. A peer that exceeds it by not reading is disconnected.
  static constexpr std::size_t kMaxQueued = std::size_t(16) << 20;

  explicit Channel(Descriptor fd);

  [[nodiscard]] int fd() const { return m_fd.get(); }
  [[nodiscard]] bool wantsToWrite() const { return !m_out.empty(); }

  enum class Read { Nothing, Some, Closed };
  /// Reads available bytes, a limited amount for each call, so that no peer keeps the caller busy.
  /// \param takeDescriptors keep descriptors that are sent along; else the kernel drops them
  [[nodiscard]] Read read(bool takeDescriptors = false);
  enum class Line { None, One, TooLong };
  /// Returns the next whole line, without its end. After TooLong the stream is unusable.
  [[nodiscard]] Line next(std::string &line);
  /// Returns the next received descriptor, in the order in which they were sent, or an empty one.
  [[nodiscard]] Descriptor takeDescriptor();

  /// Queues a line. Returns false if the limit is exceeded; the peer is then disconnected.
  [[nodiscard]] bool queue(std::string line, Descriptor attached = {});
  /// Sends what the socket accepts. Returns false if the connection is broken.
  [[nodiscard]] bool write();

private:
  struct Outgoing {
    std::string bytes;
    std::size_t sent = 0;
    Descriptor attached; ///< sent with the first byte
  };
  Descriptor m_fd;
  std::string m_in;
  std::size_t m_begin = 0;    ///< of the next line, in m_in
  std::size_t m_searched = 0; ///< no line ends before this position
  std::deque<Descriptor> m_descriptors;
  std::deque<Outgoing> m_out;
  std::size_t m_queued = 0;
};

} // namespace arbiter::control
