#include "apps/tools/lsp/transport.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <optional>
#include <poll.h>
#include <unistd.h>

#include "util/file.h"
#include "util/text/letters.h"

namespace arbiter::tools::lsp {

namespace {

constexpr std::size_t kMaxHeaderBytes = 8192;

/// True for the name Content-Length; header names are not case-sensitive.
bool isLength(std::string_view name) {
  constexpr std::string_view kName = "content-length";
  return std::equal(name.begin(), name.end(), kName.begin(), kName.end(),
                    [](char a, char b) { return lowerCase(a) == b; });
}

/// Returns the value of Content-Length in a block of header lines.
std::optional<std::size_t> lengthOf(std::string_view header) {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find("\r\n"), header.size());
    const std::string_view line = header.substr(0, end);
    header.remove_prefix(std::min(end + 2, header.size()));
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || !isLength(line.substr(0, colon)))
      continue;
    std::string_view digits = line.substr(colon + 1);
    while (!digits.empty() && digits.front() == ' ')
      digits.remove_prefix(1);
    std::size_t length = 0;
    const auto [last, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), length);
    if (error != std::errc() || last != digits.data() + digits.size())
      return std::nullopt;
    return length;
  }
  return std::nullopt;
}

} // namespace

bool Transport::more() {
  if (m_used != 0) {
    m_buffer.erase(0, m_used);
    m_used = 0;
  }
  char bytes[65536];
  ssize_t count = 0;
  do
    count = ::read(m_in, bytes, sizeof bytes);
  while (count < 0 && errno == EINTR);
  if (count <= 0)
    return false;
  m_buffer.append(bytes, std::size_t(count));
  return true;
}

bool Transport::skip(std::size_t bytes) {
  while (rest().size() < bytes) {
    bytes -= rest().size();
    m_used = m_buffer.size();
    if (!more())
      return false;
  }
  m_used += bytes;
  return true;
}

Transport::Read Transport::read(std::string &body) {
  constexpr std::string_view kEnd = "\r\n\r\n";
  std::size_t end = rest().find(kEnd);
  while (end == std::string_view::npos) {
    if (rest().size() > kMaxHeaderBytes) {
      m_used = m_buffer.size(); // discard it all: without a header no byte can be interpreted
      return Read::BadHeader;
    }
    if (!more())
      return Read::Closed;
    end = rest().find(kEnd);
  }
  const std::optional<std::size_t> length = lengthOf(rest().substr(0, end));
  m_used += end + kEnd.size();
  if (!length)
    return Read::BadHeader;
  if (*length > kMaxBytes)
    return skip(*length) ? Read::TooLong : Read::Closed;
  while (rest().size() < *length)
    if (!more())
      return Read::Closed;
  body.assign(rest().substr(0, *length));
  m_used += *length;
  return Read::Message;
}

bool Transport::pending() const {
  if (!rest().empty())
    return true;
  pollfd descriptor = {m_in, POLLIN, 0};
  return ::poll(&descriptor, 1, 0) > 0;
}

bool Transport::write(std::string_view body) {
  std::string message = "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n";
  message += body;
  return writeAll(m_out, message);
}

} // namespace arbiter::tools::lsp
