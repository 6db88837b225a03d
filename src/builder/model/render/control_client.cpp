#include "builder/model/render/control_client.h"

#include <QFile>
#include <QJsonDocument>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace arbiter::builder {

namespace {

constexpr std::size_t kPiece = 1 << 16;
constexpr std::size_t kMaxDescriptors = 4;

/// Takes the descriptors of a message; what is more than expected is closed by the kernel.
void takeDescriptors(msghdr &message, QList<int> &descriptors) {
  for (cmsghdr *part = CMSG_FIRSTHDR(&message); part; part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_RIGHTS)
      continue;
    const std::size_t count = (part->cmsg_len - CMSG_LEN(0)) / sizeof(int);
    for (std::size_t i = 0; i < count; ++i) {
      int descriptor = -1;
      std::memcpy(&descriptor, CMSG_DATA(part) + i * sizeof(int), sizeof(int));
      descriptors.append(descriptor);
    }
  }
}

bool sameUser(int descriptor) {
  ucred peer = {};
  socklen_t size = sizeof(peer);
  return ::getsockopt(descriptor, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 &&
         peer.uid == ::geteuid();
}

} // namespace

ControlClient::ControlClient(int descriptor, QObject *parent)
    : QObject(parent), m_descriptor(descriptor), m_readable(descriptor, QSocketNotifier::Read),
      m_writable(descriptor, QSocketNotifier::Write) {
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK);
  m_writable.setEnabled(false);
  connect(&m_readable, &QSocketNotifier::activated, this, &ControlClient::read);
  connect(&m_writable, &QSocketNotifier::activated, this, &ControlClient::flush);
}

ControlClient::~ControlClient() { close(); }

std::unique_ptr<ControlClient> ControlClient::connectTo(const QString &path, QString &why) {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  const QByteArray name = QFile::encodeName(path);
  if (std::size_t(name.size()) >= sizeof(address.sun_path)) {
    why = path + tr(": too long for a socket's name");
    return nullptr;
  }
  std::memcpy(address.sun_path, name.constData(), std::size_t(name.size()));
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0 ||
      ::connect(descriptor, reinterpret_cast<const sockaddr *>(&address), sizeof(address)) != 0) {
    why = path + QStringLiteral(": ") + QString::fromLocal8Bit(std::strerror(errno));
    if (descriptor >= 0)
      ::close(descriptor);
    return nullptr;
  }
  if (!sameUser(descriptor)) {
    why = path + tr(": belongs to another user");
    ::close(descriptor);
    return nullptr;
  }
  return std::make_unique<ControlClient>(descriptor);
}

void ControlClient::close() {
  if (m_descriptor < 0)
    return;
  m_readable.setEnabled(false);
  m_writable.setEnabled(false);
  ::close(std::exchange(m_descriptor, -1));
  for (const int descriptor : std::exchange(m_descriptors, {}))
    ::close(descriptor);
  const auto waiting = std::exchange(m_waiting, {});
  for (const Answer &answer : waiting)
    if (answer)
      answer({}, {});
}

void ControlClient::hangUp() {
  close();
  Q_EMIT closed();
}

int ControlClient::takeDescriptor() {
  return m_descriptors.isEmpty() ? -1 : m_descriptors.takeFirst();
}

void ControlClient::call(const QString &method, const QJsonObject &params, Answer answer) {
  if (m_descriptor < 0) {
    if (answer)
      answer({}, {});
    return;
  }
  const qint64 id = m_nextId++;
  m_waiting.insert(id, std::move(answer));
  send({{"id", id}, {"method", method}, {"params", params}});
}

void ControlClient::notify(const QString &method, const QJsonObject &params) {
  send({{"method", method}, {"params", params}});
}

void ControlClient::send(QJsonObject message) {
  if (m_descriptor < 0)
    return;
  message[u"jsonrpc"] = QStringLiteral("2.0");
  m_out += QJsonDocument(message).toJson(QJsonDocument::Compact) + '\n';
  flush();
}

void ControlClient::flush() {
  while (!m_out.isEmpty() && m_descriptor >= 0) {
    const ssize_t sent =
        ::send(m_descriptor, m_out.constData(), std::size_t(m_out.size()), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR)
      continue;
    if (sent < 0 && (errno == EAGAIN || errno == EWOULDBLOCK))
      break;
    if (sent <= 0) {
      m_out.clear(); // what reads will tell that the other side is gone
      break;
    }
    m_out.remove(0, sent);
  }
  if (m_descriptor >= 0)
    m_writable.setEnabled(!m_out.isEmpty());
}

void ControlClient::read() {
  std::array<char, kPiece> bytes;
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int) * kMaxDescriptors)> control;
  while (m_descriptor >= 0) {
    iovec piece{bytes.data(), bytes.size()};
    msghdr message = {};
    message.msg_iov = &piece;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    const ssize_t got = ::recvmsg(m_descriptor, &message, MSG_CMSG_CLOEXEC | MSG_DONTWAIT);
    if (got < 0 && errno == EINTR)
      continue;
    if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK))
      return;
    if (got <= 0)
      return hangUp();
    takeDescriptors(message, m_descriptors);
    if (std::size_t(m_descriptors.size()) > kMaxDescriptors)
      return hangUp();
    m_in.append(bytes.data(), got);
    qsizetype end = 0;
    while (m_descriptor >= 0 && (end = m_in.indexOf('\n')) >= 0) {
      const QByteArray line = m_in.left(end);
      m_in.remove(0, end + 1);
      receive(line);
    }
    if (m_in.size() > kMaxLine)
      return hangUp();
  }
}

void ControlClient::receive(const QByteArray &line) {
  const QJsonDocument json = QJsonDocument::fromJson(line);
  if (!json.isObject())
    return;
  const QJsonObject message = json.object();
  if (message.contains(u"method")) {
    Q_EMIT event(message[u"method"].toString(), message[u"params"].toObject());
    return;
  }
  const Answer answer = m_waiting.take(message[u"id"].toInteger(-1));
  if (answer)
    answer(message[u"result"].toObject(), message[u"error"].toObject());
}

} // namespace arbiter::builder
