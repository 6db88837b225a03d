#include "state/host_draw/linking/host_assembly.h"

#include <algorithm>
#include <utility>

#include "host/host_table.h"
#include "state/host_draw/draw_context.h"
#include "state/host_draw/linking/linked_program_cache.h"
#include "state/host_draw/uniforms.h"
#include "state/objects/linked_program.h"
#include "state/programs/program_edits.h"
#include "state/share/share_group.h"
#include "util/numbers/same_bits.h"

namespace arbiter::state {

namespace {

/// The host's targets, in the order of HostAssembly's stages.
constexpr GLenum kHostTargets[] = {GL_VERTEX_PROGRAM_ARB, GL_FRAGMENT_PROGRAM_ARB};

/// Collects consecutive parameters whose values are adjacent in memory, and sends them in one call
/// if the host can take several.
class ParameterRun {
public:
  ParameterRun(const DrawContext &context, GLenum target) : m_context(context), m_target(target) {}
  void add(bool env, GLuint index, const Vec4 &value) {
    const bool joins = m_count != 0 && m_context.caps.parameterRuns && env == m_env &&
                       index == m_index + m_count && &value == m_values + m_count;
    if (!joins) {
      send();
      m_env = env;
      m_index = index;
      m_values = &value;
    }
    ++m_count;
  }
  void send() {
    const GLuint count = std::exchange(m_count, 0u);
    if (count == 0)
      return;
    m_sent = true;
    const host::HostTable &host = *m_context.host;
    const GLfloat *const values = m_values->data();
    if (count == 1)
      (m_env ? host.ProgramEnvParameter4fvARB : host.ProgramLocalParameter4fvARB)(m_target, m_index,
                                                                                  values);
    else
      (m_env ? host.ProgramEnvParameters4fvEXT
             : host.ProgramLocalParameters4fvEXT)(m_target, m_index, GLsizei(count), values);
  }

  [[nodiscard]] bool sent() const { return m_sent; }

private:
  const DrawContext &m_context;
  GLenum m_target;
  bool m_sent = false;
  bool m_env = false;
  GLuint m_index = 0, m_count = 0;
  const Vec4 *m_values = nullptr;
};

} // namespace

GLenum hostAssemblyTarget(const CompiledProgram &compiled) {
  return kHostTargets[isOfVertices(compiled.target) ? 0 : 1];
}

void HostAssembly::applyStage(DrawContext &context, std::size_t stage, AssemblyProgram *program) {
  if (m_active[stage] == program)
    return;
  m_direct = nullptr;
  if (program && m_bound[stage] != program->name) {
    context.host->BindProgramARB(kHostTargets[stage], program->name);
    m_bound[stage] = program->name;
  }
  if (!m_active[stage] || !program)
    (program ? context.host->Enable : context.host->Disable)(kHostTargets[stage]);
  m_used = true;
  m_active[stage] = program;
}

void HostAssembly::applyStages(DrawContext &context,
                               const std::array<AssemblyProgram *, 2> &programs) {
  for (std::size_t stage = 0; stage < programs.size(); ++stage)
    applyStage(context, stage, programs[stage]);
  if (std::exchange(m_copied, false))
    restoreEnables(context);
}

bool HostAssembly::apply(DrawContext &context, const ProgramPair &pair) {
  std::array<AssemblyProgram *, 2> programs = {};
  const std::array<const std::shared_ptr<const CompiledProgram> *, 2> wanted = {&pair.vertex,
                                                                                &pair.fragment};
  for (std::size_t stage = 0; stage < wanted.size(); ++stage)
    if (*wanted[stage]) {
      programs[stage] = context.hostSide.linkedPrograms->assemblyOf(context, *wanted[stage]);
      if (!programs[stage]) {
        release(context);
        return false;
      }
    }
  if (m_refuses)
    release(context);
  applyStages(context, programs);
  return true;
}

void HostAssembly::apply(DrawContext &context, const LinkedProgram &linkedProgram) {
  if (m_refuses)
    release(context);
  applyStages(context, {linkedProgram.vertexAssembly, linkedProgram.fragmentAssembly});
}

bool HostAssembly::refuse(DrawContext &context) {
  release(context);
  if (!context.caps.fragmentProgram)
    return false;
  if (std::exchange(m_bound[1], 0u) != 0)
    context.host->BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, 0);
  context.host->Enable(GL_FRAGMENT_PROGRAM_ARB);
  m_used = m_refuses = true;
  return true;
}

void HostAssembly::restoreEnables(DrawContext &context) const {
  if (!m_used)
    return;
  const std::array<bool, 2> enabled = {m_active[0] != nullptr, m_active[1] != nullptr || m_refuses};
  const std::array<bool, 2> offered = {context.caps.vertexProgram, context.caps.fragmentProgram};
  for (std::size_t stage = 0; stage < enabled.size(); ++stage)
    if (offered[stage])
      (enabled[stage] ? context.host->Enable : context.host->Disable)(kHostTargets[stage]);
}

void HostAssembly::bindAgain(DrawContext &context, GLenum target) const {
  const std::size_t stage = target == kHostTargets[0] ? 0 : 1;
  context.host->BindProgramARB(target, m_bound[stage]);
}

void HostAssembly::uploadStage(DrawContext &context, std::size_t stage) {
  AssemblyProgram &program = *m_active[stage];
  std::vector<Vec4> &uploaded = program.stage.uploaded;
  const ProgramTarget &row = context.row(program.stage.compiled->target);
  ParameterRun run{context, kHostTargets[stage]};
  const bool held = anyHeld();
  for (const GivenParameter &given : program.given) {
    const bool env = given.kind == fp::ir::ParameterKind::Env;
    const bool local = given.kind == fp::ir::ParameterKind::Local;
    const Vec4 value =
        held || (!env && !local)
            ? currentValue(context, row,
                           program.stage.compiled->glsl.uniforms[given.place].parameter)
            : givenValue(row, env, given.index);
    if (env && given.index >= m_env[stage].size()) {
      run.send(); // growing the vector would move what the run points to
      m_env[stage].resize(given.index + 1, Vec4{}); // the host's initial values
    }
    Vec4 &sent = env ? m_env[stage][given.index] : uploaded[given.place];
    const bool changed = !sameBits(value, sent);
    sent = value;
    if (env)
      uploaded[given.place] = value; // for captures
    if (changed && (env || local))
      run.add(env, given.index, sent);
  }
  run.send();
  if (run.sent() && kHostTargets[stage] == GL_FRAGMENT_PROGRAM_ARB && m_fragmentPace.isFast())
    program.changesOften = true;
}

void HostAssembly::uploadParameters(DrawContext &context, std::uint32_t attention) {
  constexpr std::array<std::uint32_t, 2> kBits = {attention::kVertexParameters,
                                                  attention::kFragmentParameters};
  for (std::size_t stage = 0; stage < m_active.size(); ++stage)
    if (m_active[stage] && (attention & kBits[stage]) != 0)
      uploadStage(context, stage);
}

bool HostAssembly::sendLocal(DrawContext &context, GLuint index, const Vec4 &value) {
  if (!m_direct || index >= m_direct->localPlaces.size() ||
      context.group->contexts.load(std::memory_order_relaxed) != 1)
    return false;
  const std::uint32_t place = m_direct->localPlaces[index];
  if (place == AssemblyProgram::kNoPlace)
    return true; // the program does not read this parameter
  Vec4 &sent = m_direct->stage.uploaded[place];
  if (sameBits(value, sent))
    return true;
  if (m_directAt == *context.drawCounter)
    return false;
  m_directAt = *context.drawCounter;
  sent = value;
  context.host->ProgramLocalParameter4fvARB(GL_VERTEX_PROGRAM_ARB, index, sent.data());
  return true;
}

void HostAssembly::release(DrawContext &context) {
  if (std::exchange(m_refuses, false))
    context.host->Disable(GL_FRAGMENT_PROGRAM_ARB);
  applyStages(context, {});
}

void HostAssembly::forget(DrawContext &context, const AssemblyProgram *program) {
  if (m_direct == program)
    m_direct = nullptr;
  for (std::size_t stage = 0; stage < m_active.size(); ++stage) {
    if (m_active[stage] == program)
      applyStage(context, stage, nullptr);
    if (m_bound[stage] == program->name) // deleting a bound program binds none
      m_bound[stage] = 0;
  }
}

bool HostAssembly::runs(const CompiledProgram *compiled) const {
  return std::any_of(m_active.begin(), m_active.end(), [&](const AssemblyProgram *program) {
    return program && program->stage.compiled == compiled;
  });
}

} // namespace arbiter::state
