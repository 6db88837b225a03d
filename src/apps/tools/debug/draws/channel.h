#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace arbiter::tools::debug {

/// One end of the stream socket between the debugger and its drawing process. It transfers lines of
/// JSON text; a line may announce bytes that follow it. No call raises SIGPIPE.
class Channel {
public:
  /// Takes ownership of the descriptor.
  explicit Channel(int descriptor) : m_descriptor(descriptor) {}
  Channel(const Channel &) = delete;
  Channel &operator=(const Channel &) = delete;
  ~Channel();

  /// Sends a line and bytes. False if the other end is closed.
  bool send(std::string_view line, const void *bytes = nullptr, std::size_t count = 0);
  /// Returns the next line without its end. Returns nothing if the other end is closed, if a line
  /// is longer than kMaxLine, or after a silence of `seconds` (negative: waits forever).
  std::optional<std::string> receive(int seconds);
  /// Receives the bytes that follow a line. Returns false if fewer come.
  bool receive(void *bytes, std::size_t count, int seconds);

  static constexpr std::size_t kMaxLine = 8u << 20;

private:
  /// Waits for data, and adds it to m_waiting. Returns false if none comes.
  bool fill(int seconds);
  bool write(const char *bytes, std::size_t count);

  int m_descriptor;
  std::string m_waiting; ///< received data that was not returned yet
};

} // namespace arbiter::tools::debug
