#pragma once
#include <cstdint>
#include <deque>
#include <string>

#include "control/address.h"

namespace arbiter::control {

/// Bytes of a connected socket, cut into lines, and lines on their way out. The descriptor is
/// made non-blocking: nothing here waits. Used by one thread.
class Channel {
public:
  /// What waits to be sent; a peer that reads nothing is given up beyond it.
  static constexpr std::size_t kMaxQueued = std::size_t(16) << 20;

  explicit Channel(Descriptor fd);

  [[nodiscard]] int fd() const { return m_fd.get(); }
  [[nodiscard]] bool wantsToWrite() const { return !m_out.empty(); }

  enum class Read { Nothing, Some, Closed };
  /// Takes what has come, a part at a time, so that no peer keeps the caller busy.
  /// \param takeDescriptors keep descriptors that are sent along; else the kernel drops them
  [[nodiscard]] Read read(bool takeDescriptors = false);
  enum class Line { None, One, TooLong };
  /// The next whole line, without its end. After TooLong nothing that comes can be understood.
  [[nodiscard]] Line next(std::string &line);
  /// The next descriptor that came, in the order in which they were sent; none: false in bool.
  [[nodiscard]] Descriptor takeDescriptor();

  /// False: too much waits already; the peer is given up.
  [[nodiscard]] bool queue(std::string line, Descriptor attached = {});
  /// Sends what the socket takes. False: the connection is broken.
  [[nodiscard]] bool write();

private:
  struct Outgoing {
    std::string bytes;
    std::size_t sent = 0;
    Descriptor attached; ///< goes with the first byte
  };
  Descriptor m_fd;
  std::string m_in;
  std::size_t m_begin = 0;    ///< of the line that comes next, in m_in
  std::size_t m_searched = 0; ///< no end of a line lies before
  std::deque<Descriptor> m_descriptors;
  std::deque<Outgoing> m_out;
  std::size_t m_queued = 0;
};

} // namespace arbiter::control
