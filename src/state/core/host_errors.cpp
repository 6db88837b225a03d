#include "state/core/host_errors.h"

#include "host/host_table.h"

namespace arbiter::state {

GLenum takeHostErrors(const host::HostTable &host) {
  // A lost context returns the same error from every GetError.
  constexpr int kMaxErrors = 16;
  GLenum first = GL_NO_ERROR;
  for (int i = 0; i < kMaxErrors; ++i) {
    const GLenum error = host.GetError();
    if (error == GL_NO_ERROR)
      break;
    if (first == GL_NO_ERROR)
      first = error;
  }
  return first;
}

HostErrorScope::HostErrorScope(const host::HostTable &host, GLenum &pending) : m_host(host) {
  const GLenum earlier = takeHostErrors(host);
  if (pending == GL_NO_ERROR)
    pending = earlier;
}

HostErrorScope::~HostErrorScope() { (void)takeHostErrors(m_host); }

bool HostErrorScope::failed() {
  if (takeHostErrors(m_host) != GL_NO_ERROR)
    m_failed = true;
  return m_failed;
}

} // namespace arbiter::state
