#include "control/server.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

namespace arbiter::control {

Server::Server(Descriptor listening, Descriptor wake, std::string path)
    : m_listening(std::move(listening)), m_wake(std::move(wake)), m_path(std::move(path)) {
  for (auto &fd : m_descriptors)
    fd = -1;
  noteDescriptors();
}

std::unique_ptr<Server> Server::listening(Descriptor fd, std::string path) {
  Descriptor wake(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (!wake)
    return nullptr;
  return std::unique_ptr<Server>(new Server(std::move(fd), std::move(wake), std::move(path)));
}

std::unique_ptr<Server> Server::connected(Descriptor fd) {
  std::unique_ptr<Server> server = listening({}, {});
  if (server) {
    server->m_first = std::move(fd);
    server->m_single = true;
  }
  return server;
}

Server::~Server() {
  if (!m_path.empty())
    unlink(m_path.c_str());
}

void Server::stop() {
  m_stopped = true;
  (void)eventfd_write(m_wake.get(), 1);
}

void Server::send(ClientId client, std::string line, Descriptor attached) {
  const std::lock_guard lock(m_mutex);
  m_sent.push_back({client, std::move(line), std::move(attached)});
  (void)eventfd_write(m_wake.get(), 1);
}

void Server::broadcast(std::string line) { send(0, std::move(line)); }

void Server::wake() { (void)eventfd_write(m_wake.get(), 1); }

void Server::closeAfterFork() noexcept {
  for (const auto &fd : m_descriptors)
    if (fd >= 0)
      close(fd);
}

void Server::noteDescriptors() {
  std::size_t i = 0;
  m_descriptors[i++] = m_listening.get();
  m_descriptors[i++] = m_wake.get();
  for (const auto &[id, client] : m_clients)
    m_descriptors[i++] = client->channel.fd();
  while (i < m_descriptors.size())
    m_descriptors[i++] = -1;
}

void Server::adopt(Service &service, Descriptor fd) {
  pid_t process = 0;
  if (!isOwnPeer(fd.get(), process))
    return;
  auto client = std::make_unique<Client>(Client{Channel(std::move(fd))});
  if (m_clients.size() >= kMaxClients) {
    refuse(*client, nullptr, {kTooBusy, "8 clients are connected already", {}});
    (void)client->channel.write();
    return;
  }
  const ClientId id = ++m_last;
  m_clients.emplace(id, std::move(client));
  noteDescriptors();
  service.connected(id, process);
}

void Server::acceptOne(Service &service) {
  Descriptor fd(accept4(m_listening.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
  if (fd)
    adopt(service, std::move(fd));
}

/// Passes lines that other threads queued to their clients.
void Server::distribute() {
  std::vector<Sent> sent;
  {
    const std::lock_guard lock(m_mutex);
    sent.swap(m_sent);
  }
  for (Sent &each : sent) {
    if (each.client == 0) {
      for (auto &[id, client] : m_clients)
        if (!client->lost && !client->channel.queue(each.line))
          client->lost = true;
      continue;
    }
    const auto found = m_clients.find(each.client);
    if (found == m_clients.end() || found->second->lost)
      continue;
    Client &client = *found->second;
    if (!client.channel.queue(std::move(each.line), std::move(each.attached)))
      client.lost = true;
  }
}

void Server::refuse(Client &client, const Json &id, const Fault &fault) {
  if (!client.channel.queue(answerLine(id, fault)))
    client.lost = true;
}

/// Handles a line. Returns false to end the connection.
bool Server::handle(Service &service, ClientId id, Client &client, const std::string &line) {
  Result<Json, Fault> message = parseMessage(line);
  if (!message) {
    refuse(client, nullptr, message.error());
    // a line over a limit ends the connection, as a line that is too long does
    return message.error().code == kNoJson;
  }
  Json requestId;
  Result<Request, Fault> request = toRequest(std::move(message.value()), requestId);
  if (!request)
    refuse(client, requestId, request.error());
  else
    service.received(id, std::move(request.value()));
  return true;
}

void Server::readFrom(Service &service, ClientId id, Client &client) {
  if (client.channel.read() == Channel::Read::Closed)
    client.lost = true;
  std::string line;
  while (!client.lost) {
    switch (client.channel.next(line)) {
    case Channel::Line::None:
      return;
    case Channel::Line::TooLong:
      refuse(client, nullptr, {kNoRequest, "a line has at most 4 MiB", {}});
      client.lost = true;
      break;
    case Channel::Line::One:
      client.lost = !handle(service, id, client, line);
      break;
    }
  }
  (void)client.channel.write(); // tells the reason, as far as the socket accepts it
}

void Server::dropLost(Service &service) {
  bool any = false;
  for (auto it = m_clients.begin(); it != m_clients.end();) {
    if (!it->second->lost) {
      ++it;
      continue;
    }
    const ClientId id = it->first;
    it = m_clients.erase(it);
    any = true;
    service.disconnected(id);
  }
  if (any)
    noteDescriptors();
}

void Server::run(Service &service) {
  if (m_first)
    adopt(service, std::move(m_first));
  while (!m_stopped && !(m_single && m_clients.empty())) {
    distribute();
    for (auto &[id, client] : m_clients)
      if (!client->lost && !client->channel.write())
        client->lost = true;
    dropLost(service);
    std::vector<pollfd> polled = {{m_wake.get(), POLLIN, 0}, {m_listening.get(), POLLIN, 0}};
    std::vector<ClientId> ids;
    for (const auto &[id, client] : m_clients) {
      const auto writes = short(client->channel.wantsToWrite() ? POLLOUT : 0);
      polled.push_back({client->channel.fd(), short(POLLIN | writes), 0});
      ids.push_back(id);
    }
    if (m_single && ids.empty())
      break;
    if (poll(polled.data(), nfds_t(polled.size()), service.patience()) == 0) {
      service.waited();
      continue;
    }
    eventfd_t count = 0;
    if ((polled[0].revents & POLLIN) != 0)
      (void)eventfd_read(m_wake.get(), &count);
    if ((polled[1].revents & POLLIN) != 0)
      acceptOne(service);
    for (std::size_t i = 0; i < ids.size(); ++i)
      if ((polled[i + 2].revents & (POLLIN | POLLHUP | POLLERR)) != 0)
        readFrom(service, ids[i], *m_clients.at(ids[i]));
  }
}

} // namespace arbiter::control
