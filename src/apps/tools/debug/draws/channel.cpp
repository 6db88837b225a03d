#include "apps/tools/debug/draws/channel.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace arbiter::tools::debug {

Channel::~Channel() { ::close(m_descriptor); }

bool Channel::write(const char *bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t sent = ::send(m_descriptor, bytes, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR)
      continue;
    if (sent <= 0)
      return false;
    bytes += sent;
    count -= std::size_t(sent);
  }
  return true;
}

bool Channel::send(std::string_view line, const void *bytes, std::size_t count) {
  std::string whole(line);
  whole += '\n';
  return write(whole.data(), whole.size()) && write(static_cast<const char *>(bytes), count);
}

bool Channel::fill(int seconds) {
  pollfd wanted{m_descriptor, POLLIN, 0};
  int ready = 0;
  do
    ready = ::poll(&wanted, 1, seconds < 0 ? -1 : seconds * 1000);
  while (ready < 0 && errno == EINTR);
  if (ready <= 0)
    return false;
  char bytes[65536];
  ssize_t count = 0;
  do
    count = ::recv(m_descriptor, bytes, sizeof bytes, 0);
  while (count < 0 && errno == EINTR);
  if (count <= 0)
    return false;
  m_waiting.append(bytes, std::size_t(count));
  return true;
}

std::optional<std::string> Channel::receive(int seconds) {
  std::size_t searched = 0; // the part of m_waiting that has no end of a line
  for (;;) {
    const std::size_t end = m_waiting.find('\n', searched);
    if (end != std::string::npos) {
      std::string line = m_waiting.substr(0, end);
      m_waiting.erase(0, end + 1);
      return line;
    }
    searched = m_waiting.size();
    if (searched > kMaxLine || !fill(seconds))
      return {};
  }
}

bool Channel::receive(void *bytes, std::size_t count, int seconds) {
  auto *to = static_cast<char *>(bytes);
  while (count > 0) {
    if (m_waiting.empty() && !fill(seconds))
      return false;
    const std::size_t part = std::min(count, m_waiting.size());
    std::memcpy(to, m_waiting.data(), part);
    m_waiting.erase(0, part);
    to += part;
    count -= part;
  }
  return true;
}

} // namespace arbiter::tools::debug
