#pragma once
#include <GL/gl.h>

namespace arbiter::host {
struct HostTable;
}

namespace arbiter::state {

/// The host's pending error, if any, which was raised first; all of them are taken.
[[nodiscard]] GLenum takeHostErrors(const host::HostTable &host);

/// Around host calls of our own that may fail: what they raise is dropped, what waited before
/// stays.
class HostErrorScope {
public:
  /// \param pending the context's slot (Context::pendingError)
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
