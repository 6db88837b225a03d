#include "state/objects/linked_stages.h"

#include <GL/glext.h>

#include "host/host_table.h"

namespace arbiter::state {

void LinkedStages::linked(GLuint program, GlslStages attached) {
  const std::lock_guard lock(m_mutex);
  m_programs[program].linked = attached;
}

void LinkedStages::set(GLuint program, GlslStages executable) {
  const std::lock_guard lock(m_mutex);
  m_programs[program] = {executable, std::nullopt};
}

void LinkedStages::forget(GLuint program) {
  const std::lock_guard lock(m_mutex);
  m_programs.erase(program);
}

std::optional<GlslStages> LinkedStages::of(const host::HostTable &host, GLuint program) {
  const std::lock_guard lock(m_mutex);
  const auto it = m_programs.find(program);
  if (it == m_programs.end())
    return std::nullopt;
  Entry &entry = it->second;
  if (entry.linked) {
    // After a failed link, a program in use keeps its old executable.
    GLint succeeded = GL_FALSE;
    host.GetProgramiv(program, GL_LINK_STATUS, &succeeded);
    if (succeeded)
      entry.executable = *entry.linked;
    entry.linked.reset();
  }
  return entry.executable;
}

} // namespace arbiter::state
