#pragma once
#include <GL/gl.h>

namespace arbiter::state {

class Context;

/// Records a GL error of ours (2.5). The first error since the last GetError wins, be it ours or
/// the host's: a host's error that waits was raised before. `why` goes to the log at level info.
void raise(Context &context, GLenum error, const char *why);

/// GetError: ours, or else the host's.
[[nodiscard]] GLenum takeError(Context &context);

/// Around host calls of our own that may fail: what they raise is dropped, what waited before
/// stays.
class HostErrorScope {
public:
  explicit HostErrorScope(Context &context);
  ~HostErrorScope();
  HostErrorScope(const HostErrorScope &) = delete;
  HostErrorScope &operator=(const HostErrorScope &) = delete;
  /// True if the host raised an error since the scope began.
  [[nodiscard]] bool failed();

private:
  Context &m_context;
  bool m_failed = false;
};

} // namespace arbiter::state
