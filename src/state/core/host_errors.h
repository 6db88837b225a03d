#pragma once
#include <GL/gl.h>

namespace arbiter::host {
struct HostTable;
}

namespace arbiter::state {

/// Takes all pending errors of the host. Returns the first one raised, or NO_ERROR.
[[nodiscard]] GLenum takeHostErrors(const host::HostTable &host);

/// Surrounds host calls of the layer's that may fail. It drops the errors that they raise and keeps
/// those that waited before.
class HostErrorScope {
public:
  /// \param pending the context's slot (PendingErrors::pending)
  HostErrorScope(const host::HostTable &host, GLenum &pending);
  ~HostErrorScope();
  HostErrorScope(const HostErrorScope &) = delete;
  HostErrorScope &operator=(const HostErrorScope &) = delete;
  /// True if the host raised an error since the scope began.
  [[nodiscard]] bool failed();

private:
  const host::HostTable &m_host;
  bool m_failed = false;
};

} // namespace arbiter::state
