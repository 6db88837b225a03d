#include "control/address.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <dirent.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

namespace arbiter::control {

namespace {

SocketError failed(const std::string &path) { return {path + ": " + std::strerror(errno)}; }

bool toAddress(const std::string &path, sockaddr_un &address) {
  address = {};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path)
    return false;
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  return true;
}

/// Creates a socket. \param flags additional flags of socket()
Descriptor makeSocket(int flags = 0) {
  return Descriptor(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | flags, 0));
}

int connectSocket(int fd, const sockaddr_un &address) {
  int result = 0;
  do
    result = connect(fd, reinterpret_cast<const sockaddr *>(&address), sizeof address);
  while (result != 0 && errno == EINTR);
  return result;
}

/// True if nothing listens at the socket any more.
bool isDead(const std::string &path) {
  sockaddr_un address;
  if (!toAddress(path, address))
    return false;
  // non-blocking, as a stopped process may have a full queue
  const Descriptor fd = makeSocket(SOCK_NONBLOCK);
  return fd && connectSocket(fd.get(), address) != 0 && errno == ECONNREFUSED;
}

bool parseName(std::string_view name, Listener &listener) {
  const char *const end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data(), end, listener.process);
  if (error != std::errc() || listener.process <= 0)
    return false;
  const std::string_view suffix(rest, std::size_t(end - rest));
  listener.kind = suffix == ".render.sock" ? Kind::Renderer : Kind::Layer;
  return suffix == ".sock" || suffix == ".render.sock";
}

} // namespace

Descriptor &Descriptor::operator=(Descriptor &&other) noexcept {
  if (this != &other) {
    if (m_fd >= 0)
      close(m_fd);
    m_fd = other.release();
  }
  return *this;
}

Descriptor::~Descriptor() {
  if (m_fd >= 0)
    close(m_fd);
}

int Descriptor::release() { return std::exchange(m_fd, -1); }

namespace {

/// Returns advice for a missing folder. A login creates it; sudo, cron, ssh and containers may not
/// set its variable, or have no folder.
std::string remedy() {
  const std::string usual = "/run/user/" + std::to_string(geteuid());
  const bool there = access(usual.c_str(), W_OK) == 0;
  return "for the program and for this alike: " +
         (there ? "export XDG_RUNTIME_DIR=" + usual
                : "export XDG_RUNTIME_DIR=/tmp/run-" + std::to_string(geteuid()) +
                      "; mkdir -pm 700 $XDG_RUNTIME_DIR");
}

} // namespace

Result<std::string, SocketError> socketFolder() {
  const char *const runtime = secure_getenv("XDG_RUNTIME_DIR");
  if (!runtime || *runtime != '/')
    return SocketError{"XDG_RUNTIME_DIR names no folder, where processes listen for this user; " +
                       remedy()};
  const std::string folder = std::string(runtime) + "/arbiter";
  if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
    return failed(folder);
  struct stat state;
  if (lstat(folder.c_str(), &state) != 0)
    return failed(folder);
  if (!S_ISDIR(state.st_mode) || state.st_uid != geteuid() || (state.st_mode & 077) != 0)
    return SocketError{folder + ": is no folder of this user's alone (mode 0700)"};
  return folder;
}

std::string socketName(pid_t process, Kind kind) {
  return std::to_string(process) + (kind == Kind::Renderer ? ".render.sock" : ".sock");
}

Result<Descriptor, SocketError> listenAt(const std::string &path) {
  sockaddr_un address;
  if (!toAddress(path, address))
    return SocketError{path + ": is too long for a socket's name"};
  Descriptor fd = makeSocket();
  if (!fd)
    return failed(path);
  if (isDead(path))
    unlink(path.c_str());
  // The kernel gives the socket's mode to the file, so that it must be set before bind().
  (void)fchmod(fd.get(), 0600);
  if (bind(fd.get(), reinterpret_cast<const sockaddr *>(&address), sizeof address) != 0)
    return failed(path);
  if (chmod(path.c_str(), 0600) != 0 || listen(fd.get(), 8) != 0) {
    const SocketError error = failed(path);
    unlink(path.c_str());
    return error;
  }
  return fd;
}

Result<Descriptor, SocketError> connectTo(const std::string &path) {
  sockaddr_un address;
  if (!toAddress(path, address))
    return SocketError{path + ": is too long for a socket's name"};
  Descriptor fd = makeSocket();
  constexpr timeval kPatience = {2, 0};
  if (fd)
    (void)setsockopt(fd.get(), SOL_SOCKET, SO_SNDTIMEO, &kPatience, sizeof kPatience);
  if (!fd || connectSocket(fd.get(), address) != 0)
    return failed(path);
  pid_t process = 0;
  if (!isOwnPeer(fd.get(), process))
    return SocketError{path + ": belongs to another user"};
  return fd;
}

bool isOwnPeer(int fd, pid_t &process) {
  ucred peer{};
  socklen_t size = sizeof peer;
  if (getsockopt(fd, SOL_SOCKET, SO_PEERCRED, &peer, &size) != 0 || size != sizeof peer)
    return false;
  process = peer.pid;
  return peer.uid == geteuid();
}

std::vector<Listener> findListeners(const std::string &folder) {
  std::vector<Listener> listeners;
  DIR *const handle = opendir(folder.c_str());
  if (!handle)
    return listeners;
  while (const dirent *const entry = readdir(handle)) {
    Listener listener;
    if (!parseName(entry->d_name, listener))
      continue;
    listener.path = folder + "/" + entry->d_name;
    if (isDead(listener.path))
      unlink(listener.path.c_str());
    else
      listeners.push_back(std::move(listener));
  }
  closedir(handle);
  std::sort(listeners.begin(), listeners.end(), [](const Listener &a, const Listener &b) {
    return a.process != b.process ? a.process < b.process : a.kind < b.kind;
  });
  return listeners;
}

} // namespace arbiter::control
