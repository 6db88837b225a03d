#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace arbiter::tools::debug {

/// One end of a stream socket between the debugger and the process that draws for it: lines of text
/// (JSON), some followed by bytes that the line announces. No call raises SIGPIPE.
class Channel {
public:
  /// Takes the descriptor over.
  explicit Channel(int descriptor) : m_descriptor(descriptor) {}
  Channel(const Channel &) = delete;
  Channel &operator=(const Channel &) = delete;
  ~Channel();

  /// False where the other end is gone.
  bool send(std::string_view line, const void *bytes = nullptr, std::size_t count = 0);
  /// The next line without its end; none where the other end is gone, has sent a line of more than
  /// kMostLine, or says nothing for `seconds` (negative: for ever).
  std::optional<std::string> receive(int seconds);
  bool receive(void *bytes, std::size_t count, int seconds);

  static constexpr std::size_t kMostLine = 8u << 20;

private:
  bool fill(int seconds);
  bool write(const char *bytes, std::size_t count);

  int m_descriptor;
  std::string m_waiting; ///< received and not yet given out
};

} // namespace arbiter::tools::debug
