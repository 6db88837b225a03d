#include "control/channel.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/socket.h>
#include <utility>

#include "control/message.h"

namespace arbiter::control {

namespace {

constexpr std::size_t kPart = std::size_t(64) << 10;
constexpr std::size_t kMaxDescriptors = 8; ///< received and not taken yet

} // namespace

Channel::Channel(Descriptor fd) : m_fd(std::move(fd)) {
  (void)fcntl(m_fd.get(), F_SETFL, fcntl(m_fd.get(), F_GETFL) | O_NONBLOCK);
  (void)fcntl(m_fd.get(), F_SETFD, FD_CLOEXEC);
}

Channel::Read Channel::read(bool takeDescriptors) {
  // Lines that were taken free their room.
  m_in.erase(0, m_begin);
  m_searched -= m_begin;
  m_begin = 0;
  std::array<char, kPart> part;
  iovec bytes = {part.data(), part.size()};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int) * 4)> extra;
  msghdr message = {};
  message.msg_iov = &bytes;
  message.msg_iovlen = 1;
  if (takeDescriptors) {
    message.msg_control = extra.data();
    message.msg_controllen = extra.size();
  }
  const ssize_t count = recvmsg(m_fd.get(), &message, MSG_CMSG_CLOEXEC | MSG_DONTWAIT);
  if (count < 0)
    return errno == EAGAIN || errno == EINTR ? Read::Nothing : Read::Closed;
  for (cmsghdr *head = takeDescriptors ? CMSG_FIRSTHDR(&message) : nullptr; head;
       head = CMSG_NXTHDR(&message, head)) {
    if (head->cmsg_level != SOL_SOCKET || head->cmsg_type != SCM_RIGHTS)
      continue;
    const std::size_t got = (head->cmsg_len - CMSG_LEN(0)) / sizeof(int);
    for (std::size_t i = 0; i < got; ++i) {
      int fd = -1;
      std::memcpy(&fd, CMSG_DATA(head) + i * sizeof fd, sizeof fd);
      Descriptor own(fd);
      if (m_descriptors.size() < kMaxDescriptors)
        m_descriptors.push_back(std::move(own));
    }
  }
  if (count == 0)
    return Read::Closed;
  m_in.append(part.data(), std::size_t(count));
  return Read::Some;
}

Channel::Line Channel::next(std::string &line) {
  const std::size_t end = m_in.find('\n', m_searched);
  if (end == std::string::npos) {
    m_searched = m_in.size();
    return m_in.size() - m_begin >= kMaxLineBytes ? Line::TooLong : Line::None;
  }
  if (end - m_begin >= kMaxLineBytes)
    return Line::TooLong;
  line.assign(m_in, m_begin, end - m_begin);
  m_begin = m_searched = end + 1;
  return Line::One;
}

Descriptor Channel::takeDescriptor() {
  if (m_descriptors.empty())
    return {};
  Descriptor first = std::move(m_descriptors.front());
  m_descriptors.pop_front();
  return first;
}

bool Channel::queue(std::string line, Descriptor attached) {
  if (m_queued + line.size() > kMaxQueued)
    return false;
  m_queued += line.size();
  m_out.push_back({std::move(line), 0, std::move(attached)});
  return true;
}

bool Channel::write() {
  while (!m_out.empty()) {
    Outgoing &first = m_out.front();
    iovec bytes = {first.bytes.data() + first.sent, first.bytes.size() - first.sent};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> extra{};
    msghdr message = {};
    message.msg_iov = &bytes;
    message.msg_iovlen = 1;
    if (first.attached) {
      message.msg_control = extra.data();
      message.msg_controllen = extra.size();
      cmsghdr *const head = CMSG_FIRSTHDR(&message);
      head->cmsg_level = SOL_SOCKET;
      head->cmsg_type = SCM_RIGHTS;
      head->cmsg_len = CMSG_LEN(sizeof(int));
      const int fd = first.attached.get();
      std::memcpy(CMSG_DATA(head), &fd, sizeof fd);
    }
    const ssize_t count = sendmsg(m_fd.get(), &message, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0)
      return errno == EAGAIN || errno == EINTR;
    first.attached = {};
    first.sent += std::size_t(count);
    m_queued -= std::size_t(count);
    if (first.sent == first.bytes.size())
      m_out.pop_front();
  }
  return true;
}

} // namespace arbiter::control
