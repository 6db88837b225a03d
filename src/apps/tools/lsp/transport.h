#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace arbiter::tools::lsp {

/// Reads and writes messages of the language server protocol over two file descriptors. A message
/// is a block of header lines with Content-Length, an empty line, and that many bytes.
class Transport {
public:
  Transport(int in, int out) : m_in(in), m_out(out) {}

  enum class Read {
    Message,
    BadHeader, ///< a header without a usable length; reading can go on
    TooLong,   ///< a message over kMaxBytes, which was skipped
    Closed,    ///< the client has closed the connection
  };
  static constexpr std::size_t kMaxBytes = std::size_t(64) << 20;

  /// Waits for a message. Sets \p body only for Message.
  [[nodiscard]] Read read(std::string &body);
  /// True if read() can start without waiting.
  [[nodiscard]] bool pending() const;
  /// Writes a message.
  /// \returns false if the client has closed the connection.
  bool write(std::string_view body);

private:
  /// Waits for more bytes. False at the end of the input.
  bool more();
  bool skip(std::size_t bytes);
  /// Returns the bytes that were read but not used yet.
  [[nodiscard]] std::string_view rest() const { return std::string_view(m_buffer).substr(m_used); }

  int m_in;
  int m_out;
  std::string m_buffer;
  std::size_t m_used = 0;
};

} // namespace arbiter::tools::lsp
