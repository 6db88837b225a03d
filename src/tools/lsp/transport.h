#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace arbiter::tools::lsp {

/// Messages of the language server protocol over two file descriptors: each a block of header
/// lines with Content-Length, an empty line, and that many bytes.
class Transport {
public:
  Transport(int in, int out) : m_in(in), m_out(out) {}

  enum class Read {
    Message,
    BadHeader, ///< a header without a length that can be used; reading may go on
    TooLong,   ///< a message over kMaxBytes, which was passed over
    Closed,    ///< the other side has gone
  };
  static constexpr std::size_t kMaxBytes = std::size_t(64) << 20;

  /// Waits for a message. \p body is set for Message only.
  [[nodiscard]] Read read(std::string &body);
  /// True if read() has something to begin with at once.
  [[nodiscard]] bool pending() const;
  /// \returns false if the other side has gone.
  bool write(std::string_view body);

private:
  /// Waits for more bytes. False at the end of the input.
  bool more();
  bool skip(std::size_t bytes);
  /// The bytes that are read and not used yet.
  [[nodiscard]] std::string_view rest() const { return std::string_view(m_buffer).substr(m_used); }

  int m_in;
  int m_out;
  std::string m_buffer;
  std::size_t m_used = 0;
};

} // namespace arbiter::tools::lsp
