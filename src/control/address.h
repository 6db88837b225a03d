#pragma once
#include <string>
#include <sys/types.h>
#include <vector>

#include "util/result.h"

/// Where processes listen: $XDG_RUNTIME_DIR/arbiter/PID.sock, and PID.render.sock of renderers.
namespace arbiter::control {

enum class Kind { Layer, Renderer };

/// What stood in the way of a socket: a sentence.
struct SocketError {
  std::string message;
};

/// A descriptor that is closed with the object.
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

/// The folder, made where it is not there. Errors: XDG_RUNTIME_DIR is not set or too long; the
/// folder is another user's, or others may enter it.
[[nodiscard]] Result<std::string, SocketError> socketFolder();
[[nodiscard]] std::string socketName(pid_t process, Kind kind);

/// Listens at the path, where nothing may listen yet; what a dead process left there goes. Mode
/// 0600 from the first moment on.
[[nodiscard]] Result<Descriptor, SocketError> listenAt(const std::string &path);
/// Connects, and looks who the other end is.
[[nodiscard]] Result<Descriptor, SocketError> connectTo(const std::string &path);
/// The other end of a connected socket belongs to this user (SO_PEERCRED). \param process its
/// process
[[nodiscard]] bool isOwnPeer(int fd, pid_t &process);

struct Listener {
  pid_t process = 0;
  Kind kind = Kind::Layer;
  std::string path;
};
/// Sockets of the folder by process; those that nothing listens at any more are removed.
[[nodiscard]] std::vector<Listener> findListeners(const std::string &folder);

} // namespace arbiter::control
