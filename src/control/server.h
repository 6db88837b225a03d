#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "control/address.h"
#include "control/channel.h"
#include "control/message.h"

namespace arbiter::control {

/// Counts connections, from 1: none is used twice.
using ClientId = std::uint64_t;

/// What a server is for. All functions are called by the thread that runs the server, except where
/// it is said.
class Service {
public:
  virtual ~Service() = default;
  virtual void connected(ClientId client, pid_t process) = 0;
  virtual void received(ClientId client, Request request) = 0;
  virtual void disconnected(ClientId client) = 0;
  /// Called when patience() is over.
  virtual void waited() {}
  /// Milliseconds until waited() is to be called; -1: never.
  [[nodiscard]] virtual int patience() { return -1; }
};

/// Serves clients at a socket, on one thread: run()'s. What is hostile or broken ends its own
/// connection and no other.
class Server {
public:
  static constexpr std::size_t kMaxClients = 8;

  /// Null where the kernel has no more descriptors. \param path of the socket, to be removed when
  /// it ends; empty: none
  [[nodiscard]] static std::unique_ptr<Server> listening(Descriptor fd, std::string path);
  /// Serves one client, which is connected already, until it disconnects.
  [[nodiscard]] static std::unique_ptr<Server> connected(Descriptor fd);
  ~Server();
  Server(const Server &) = delete;
  Server &operator=(const Server &) = delete;

  /// Returns after stop(), or, of connected(), when the client is gone.
  void run(Service &service);
  /// Any thread.
  void stop();

  /// Sends a line; one for a client that is gone is dropped. Any thread; never waits for a client.
  void send(ClientId client, std::string line, Descriptor attached = {});

  /// The same to every client.
  void broadcast(std::string line);
  /// The thread that runs the server asks for patience() anew. Any thread.
  void wake();

  /// In the child of a fork: the connections are the parent's. Nothing but this may be called of
  /// the object then, its destructor neither.
  void closeAfterFork() noexcept;

private:
  struct Client {
    Channel channel;
    bool lost = false;
  };
  struct Sent {
    ClientId client;
    std::string line;
    Descriptor attached;
  };
  Server(Descriptor listening, Descriptor wake, std::string path);
  void adopt(Service &service, Descriptor fd);
  void acceptOne(Service &service);
  void distribute();
  void readFrom(Service &service, ClientId id, Client &client);
  bool handle(Service &service, ClientId id, Client &client, const std::string &line);
  static void refuse(Client &client, const Json &id, const Fault &fault);
  void dropLost(Service &service);
  void noteDescriptors();

  Descriptor m_listening, m_first, m_wake;
  std::string m_path;
  bool m_single = false;
  std::map<ClientId, std::unique_ptr<Client>> m_clients;
  ClientId m_last = 0;
  std::atomic<bool> m_stopped{false};
  std::mutex m_mutex;
  std::vector<Sent> m_sent;                                      ///< under m_mutex
  std::array<std::atomic<int>, kMaxClients + 2> m_descriptors{}; ///< for closeAfterFork()
};

} // namespace arbiter::control
