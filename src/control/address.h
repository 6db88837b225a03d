#pragma once
#include <string>
#include <sys/types.h>
#include <vector>

#include "util/result.h"

/// Names the sockets that processes listen at: $XDG_RUNTIME_DIR/arbiter/PID.sock, and
/// PID.render.sock for renderers.
namespace arbiter::control {

enum class Kind { Layer, Renderer };

/// An error about a socket, as a sentence.
struct SocketError {
  std::string message;
};

/// Owns a file descriptor and closes it.
class Descriptor {
public:
  Descriptor() = default;
  explicit Descriptor(int fd) : m_fd(fd) {}
  Descriptor(Descriptor &&other) noexcept : m_fd(other.release()) {}
  Descriptor &operator=(Descriptor &&other) noexcept;
  ~Descriptor();
  Descriptor(const Descriptor &) = delete;
  Descriptor &operator=(const Descriptor &) = delete;

  [[nodiscard]] int get() const { return m_fd; }
  explicit operator bool() const { return m_fd >= 0; }
  [[nodiscard]] int release();

private:
  int m_fd = -1;
};

/// Returns the folder, and creates it if needed. Fails if XDG_RUNTIME_DIR is not set or too long,
/// or if the folder belongs to another user or others may enter it.
[[nodiscard]] Result<std::string, SocketError> socketFolder();
[[nodiscard]] std::string socketName(pid_t process, Kind kind);

/// Listens at the path. Fails if another process listens there; removes a dead process's socket.
/// The socket has mode 0600 from the first moment.
[[nodiscard]] Result<Descriptor, SocketError> listenAt(const std::string &path);
/// Connects, and checks the other end's user.
[[nodiscard]] Result<Descriptor, SocketError> connectTo(const std::string &path);
/// True if the other end of a connected socket belongs to this user (SO_PEERCRED). \param process
/// set to the other end's process id
[[nodiscard]] bool isOwnPeer(int fd, pid_t &process);

struct Listener {
  pid_t process = 0;
  Kind kind = Kind::Layer;
  std::string path;
};
/// Returns the folder's sockets by process. Removes those that nothing listens at any more.
[[nodiscard]] std::vector<Listener> findListeners(const std::string &folder);

} // namespace arbiter::control
