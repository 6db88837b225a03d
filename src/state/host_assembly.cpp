#include "state/host_assembly.h"

#include <algorithm>

#include "host/host_table.h"
#include "state/context.h"
#include "state/errors.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

/// A host object that holds the text; 0 if the host refuses it.
GLuint load(Context &context, const CompiledProgram &compiled) {
  const host::HostTable &host = *context.host;
  GLuint name = 0;
  HostErrorScope scope(context);
  host.GenProgramsARB(1, &name);
  host.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, name);
  host.ProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB,
                        GLsizei(compiled.source().size()), compiled.source().data());
  if (!scope.failed())
    return name;
  logError("state", "the host's own compiler refuses program %s", toHex(compiled.hash).c_str());
  host.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, 0);
  host.DeleteProgramsARB(1, &name);
  return 0;
}

} // namespace

HostAssembly::Entry &HostAssembly::entryOf(Context &context,
                                           const std::shared_ptr<const CompiledProgram> &compiled) {
  const auto it = std::find_if(m_entries.begin(), m_entries.end(),
                               [&](const Entry &entry) { return entry.compiled == compiled; });
  if (it != m_entries.end())
    return *it;
  // Texts that left their object are held by nobody else any more.
  std::erase_if(m_entries, [&](const Entry &entry) {
    if (entry.compiled.use_count() > 1)
      return false;
    context.host->DeleteProgramsARB(1, &entry.name);
    return true;
  });
  return m_entries.emplace_back(Entry{compiled, load(context, *compiled)});
}

bool HostAssembly::apply(Context &context, const std::shared_ptr<const CompiledProgram> &compiled) {
  if (m_active == compiled)
    return true;
  const Entry &entry = entryOf(context, compiled);
  if (entry.name == 0) {
    release(context);
    return false;
  }
  context.host->BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, entry.name);
  if (!m_active)
    context.host->Enable(GL_FRAGMENT_PROGRAM_ARB);
  m_active = compiled;
  return true;
}

void HostAssembly::uploadParameters(Context &context) const {
  const host::HostTable &host = *context.host;
  const ProgramTarget &row = context.row(Target::Fragment);
  for (const fp::GlslUniform &uniform : m_active->glsl.uniforms) {
    const fp::ir::Parameter &parameter = uniform.parameter;
    if (parameter.kind == fp::ir::ParameterKind::Env)
      host.ProgramEnvParameter4fvARB(GL_FRAGMENT_PROGRAM_ARB, parameter.index,
                                     row.env[parameter.index].data());
    else if (parameter.kind == fp::ir::ParameterKind::Local &&
             parameter.index < row.bound->locals.size())
      host.ProgramLocalParameter4fvARB(GL_FRAGMENT_PROGRAM_ARB, parameter.index,
                                       row.bound->locals[parameter.index].load().data());
  }
}

void HostAssembly::release(Context &context) {
  if (!m_active)
    return;
  m_active.reset();
  context.host->Disable(GL_FRAGMENT_PROGRAM_ARB);
  context.host->BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, 0);
}

bool HostAssembly::owns(GLuint name) const {
  return std::any_of(m_entries.begin(), m_entries.end(),
                     [&](const Entry &entry) { return entry.name == name; });
}

std::vector<GLuint> HostAssembly::abandon() {
  std::vector<GLuint> names;
  for (const Entry &entry : m_entries)
    if (entry.name != 0)
      names.push_back(entry.name);
  m_entries.clear();
  m_active.reset();
  return names;
}

} // namespace arbiter::state
