#include "state/host_draw/host_assembly.h"

#include <algorithm>
#include <utility>

#include "fp_compiler/back/assembly/assembly.h"
#include "host/host_table.h"
#include "state/core/context.h"
#include "state/core/errors.h"
#include "state/host_draw/linked_program.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

/// The host's targets, in the order of HostAssembly's stages.
constexpr GLenum kHostTargets[] = {GL_VERTEX_PROGRAM_ARB, GL_FRAGMENT_PROGRAM_ARB};

GLenum hostTarget(const CompiledProgram &compiled) {
  return kHostTargets[compiled.target == Target::Vertex ? 0 : 1];
}

/// A host object that holds the program; 0 if the host refuses it.
GLuint load(Context &context, const CompiledProgram &compiled) {
  const host::HostTable &host = *context.host;
  const GLenum target = hostTarget(compiled);
  GLuint name = 0;
  HostErrorScope scope(*context.host, context.pendingError);
  host.GenProgramsARB(1, &name);
  host.BindProgramARB(target, name);
  // The text of an ATI shader's form is assembly that was emitted already.
  const bool emitted =
      compiled.program && compiled.program->language == fp::ir::Language::AtiFragment;
  const std::string text =
      compiled.program && !emitted ? fp::emitAssembly(*compiled.program) : compiled.source();
  host.ProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.data());
  if (!scope.failed())
    return name;
  logError("state", "the host's own compiler refuses program %s", toHex(compiled.hash).c_str());
  host.BindProgramARB(target, 0);
  host.DeleteProgramsARB(1, &name);
  return 0;
}

} // namespace

GLuint HostAssembly::nameOf(Context &context,
                            const std::shared_ptr<const CompiledProgram> &compiled) {
  const auto it = std::find_if(m_entries.begin(), m_entries.end(),
                               [&](const Entry &entry) { return entry.compiled == compiled; });
  if (it != m_entries.end())
    return it->name;
  // Texts that left their object are held by nothing else any more.
  std::erase_if(m_entries, [&](const Entry &entry) {
    if (entry.compiled.use_count() > 1)
      return false;
    context.host->DeleteProgramsARB(1, &entry.name);
    return true;
  });
  return m_entries.emplace_back(Entry{compiled, load(context, *compiled)}).name;
}

bool HostAssembly::applyStage(Context &context, std::size_t stage,
                              const std::shared_ptr<const CompiledProgram> &compiled) {
  if (m_active[stage] == compiled)
    return true;
  if (!compiled) {
    releaseStage(context, stage);
    return true;
  }
  const GLuint name = nameOf(context, compiled);
  if (name == 0)
    return false;
  context.host->BindProgramARB(kHostTargets[stage], name);
  if (!m_active[stage])
    context.host->Enable(kHostTargets[stage]);
  m_used = true;
  m_active[stage] = compiled;
  return true;
}

bool HostAssembly::refuse(Context &context) {
  release(context);
  if (!context.caps.fragmentProgram)
    return false;
  context.host->Enable(GL_FRAGMENT_PROGRAM_ARB);
  m_used = m_refuses = true;
  return true;
}

void HostAssembly::disableAgain(Context &context) const {
  if (!m_used)
    return;
  for (const GLenum target : kHostTargets)
    context.host->Disable(target);
}

bool HostAssembly::apply(Context &context, const ProgramPair &pair) {
  if (m_refuses)
    release(context);
  if (applyStage(context, 0, pair.vertex) && applyStage(context, 1, pair.fragment))
    return true;
  release(context);
  return false;
}

void HostAssembly::uploadParameters(Context &context) const {
  const host::HostTable &host = *context.host;
  for (const auto &compiled : m_active) {
    if (!compiled)
      continue;
    const ProgramTarget &row = context.row(compiled->target);
    const GLenum target = hostTarget(*compiled);
    for (const fp::GlslUniform &uniform : compiled->glsl.uniforms) {
      const fp::ir::Parameter &parameter = uniform.parameter;
      if (parameter.kind == fp::ir::ParameterKind::Env)
        host.ProgramEnvParameter4fvARB(target, parameter.index, row.env[parameter.index].data());
      else if (parameter.kind == fp::ir::ParameterKind::Local &&
               parameter.index < row.bound->locals.size())
        host.ProgramLocalParameter4fvARB(target, parameter.index,
                                         row.bound->locals[parameter.index].load().data());
    }
  }
}

void HostAssembly::releaseStage(Context &context, std::size_t stage) {
  if (!m_active[stage])
    return;
  m_active[stage].reset();
  context.host->Disable(kHostTargets[stage]);
  context.host->BindProgramARB(kHostTargets[stage], 0);
}

void HostAssembly::release(Context &context) {
  if (std::exchange(m_refuses, false))
    context.host->Disable(GL_FRAGMENT_PROGRAM_ARB);
  releaseStage(context, 0);
  releaseStage(context, 1);
}

std::vector<GLuint> HostAssembly::abandon() {
  std::vector<GLuint> names;
  for (const Entry &entry : m_entries)
    if (entry.name != 0)
      names.push_back(entry.name);
  m_entries.clear();
  m_active = {};
  return names;
}

} // namespace arbiter::state
