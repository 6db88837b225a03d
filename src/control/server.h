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

/// Numbers connections from 1. No number is used twice.
using ClientId = std::uint64_t;

/// Handles a server's requests. The thread that runs the server calls all functions unless stated
/// otherwise.
class Service {
public:
  virtual ~Service() = default;
  virtual void connected(ClientId client, pid_t process) = 0;
  virtual void received(ClientId client, Request request) = 0;
  virtual void disconnected(ClientId client) = 0;
  /// Called when patience() has passed.
  virtual void waited() {}
  /// Returns the milliseconds until waited() is called; -1: never.
  [[nodiscard]] virtual int patience() { return -1; }
};

/// Serves clients at a socket, on the thread of run(). A hostile or broken client ends only its own
/// connection.
class Server {
public:
  static constexpr std::size_t kMaxClients = 8;

  /// Serves clients that connect to the socket. Returns null if the kernel has no more descriptors.
  /// \param path of the socket, to be removed at the end; empty: none
  [[nodiscard]] static std::unique_ptr<Server> listening(Descriptor fd, std::string path);
  /// Serves one client that is already connected, until it disconnects.
  [[nodiscard]] static std::unique_ptr<Server> connected(Descriptor fd);
  ~Server();
  Server(const Server &) = delete;
  Server &operator=(const Server &) = delete;

  /// Returns after stop(), or after the client of connected() is gone.
  void run(Service &service);
  /// Stops the server; any thread may call it.
  void stop();

  /// Sends a line, or drops it if the client is gone. Any thread may call it; it never waits for a
  /// client.
  void send(ClientId client, std::string line, Descriptor attached = {});

  /// Sends a line to every client.
  void broadcast(std::string line);
  /// Makes the server's thread call patience() again. Any thread may call it.
  void wake();

  /// Called in the child of a fork, as the connections belong to the parent. Nothing else of the
  /// object may be called then, not even its destructor.
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
