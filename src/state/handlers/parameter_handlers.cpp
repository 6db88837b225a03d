// Program parameters (3.11.1, 6.1.12; EXT_gpu_program_parameters; EXT_direct_state_access).
#include <algorithm>
#include <cstring>
#include <optional>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/host_draw/linking/host_assembly.h"
#include "state/lists/list_compiler.h"
#include "state/programs/nv/matrix_tracking.h"
#include "state/programs/parameters.h"
#include "state/programs/program_bind.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

void recordParameters(Context &context, Command::Kind kind, const ProgramTarget &row, GLuint index,
                      GLsizei count, const Vec4 *values) {
  Command command{.kind = kind, .target = row.info().name, .name = index};
  command.count = count;
  if (count > 0)
    command.values.assign(values, values + count);
  listCompiler(context).record(context, std::move(command));
}

/// Sets env parameters in the general case: errors, lists, tracked matrices.
[[gnu::noinline]] void env(Context &context, ProgramTarget &row, GLuint index, GLsizei count,
                           const Vec4 *values) {
  if (!outsideBeginEnd(context, "ProgramEnvParameter between Begin and End"))
    return;
  if (context.listMode)
    return recordParameters(context, Command::Kind::Env, row, index, count, values);
  setEnv(context, row, index, count, values);
}

[[gnu::noinline]] void local(Context &context, ProgramTarget &row, GLuint index, GLsizei count,
                             const Vec4 *values) {
  if (!outsideBeginEnd(context, "ProgramLocalParameter between Begin and End"))
    return;
  if (context.listMode)
    return recordParameters(context, Command::Kind::Local, row, index, count, values);
  setLocal(context, *row.bound, index, count, values);
}

/// Sets one env parameter. Applications call this thousands of times per frame.
[[gnu::always_inline]] inline void env(Context &context, ProgramTarget &row, GLuint index,
                                       const Vec4 &value) {
  if (!context.executesNow() || index >= row.env.size() || row.tracked != 0) [[unlikely]]
    return env(context, row, index, 1, &value);
  row.env[index] = value;
  ++row.envVersion;
  context.attention |= row.parameterBits;
}

/// Sets one local parameter of the bound program.
[[gnu::always_inline]] inline void local(Context &context, ProgramTarget &row, GLuint index,
                                         const Vec4 &value) {
  ProgramObject &object = *row.bound;
  if (!context.executesNow() || index >= row.limits.localParameters) [[unlikely]]
    return local(context, row, index, 1, &value);
  object.locals[index].store(value);
  object.changed(row.seenVersion);
  if (context.attention == 0 && row.target == Target::Vertex &&
      context.hostSide.assembly->sendLocal(context, index, value))
    return;
  context.attention |= row.parameterBits;
}

std::optional<Vec4> readEnv(Context &context, const ProgramTarget &row, GLuint index) {
  if (!outsideBeginEnd(context, "GetProgramEnvParameter between Begin and End") ||
      !isRange(context, index, 1, row.env.size(), "GetProgramEnvParameter: index"))
    return std::nullopt;
  if (row.tracked != 0)
    refreshTrackedMatrices(context);
  return row.env[index];
}

std::optional<Vec4> readLocal(Context &context, const ProgramTarget &row, GLuint index) {
  const ProgramObject &object = *row.bound;
  if (!outsideBeginEnd(context, "GetProgramLocalParameter between Begin and End") ||
      !isRange(context, index, 1, row.limits.localParameters, "GetProgramLocalParameter: index"))
    return std::nullopt;
  return object.locals[index].load();
}

template <typename T> void copyOut(const std::optional<Vec4> &value, T *params) {
  if (value && params)
    std::copy(value->begin(), value->end(), params);
}

/// Reads GLfloat quadruples, which need not be aligned like Vec4.
std::vector<Vec4> gather(GLsizei count, const GLfloat *params) {
  std::vector<Vec4> values(std::size_t(std::max(count, 0)));
  if (count > 0)
    std::memcpy(values.data(), params, values.size() * sizeof(Vec4));
  return values;
}

} // namespace

namespace handlers {

void ProgramEnvParameter4fARB(Context &context, GLenum target, GLuint index, GLfloat x, GLfloat y,
                              GLfloat z, GLfloat w) {
  if (ProgramTarget *const row = rowOf(context, target))
    return env(context, *row, index, {x, y, z, w});
  context.host->ProgramEnvParameter4fARB(target, index, x, y, z, w);
}

void ProgramEnvParameter4fARB(Context &context, GLenum target, GLuint index,
                              host::ParameterValues values) {
  ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return values.pass(context.host->ProgramEnvParameter4fvARB,
                       context.host->ProgramEnvParameter4dvARB, target, index);
  if (index >= row->env.size()) [[unlikely]]
    return env(context, *row, index, Vec4{});
  values.give([&](GLfloat x, GLfloat y, GLfloat z, GLfloat w) __attribute__((always_inline)) {
    env(context, *row, index, {x, y, z, w});
  });
}

void ProgramEnvParameters4fvEXT(Context &context, GLenum target, GLuint index, GLsizei count,
                                const GLfloat *params) {
  ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->ProgramEnvParameters4fvEXT(target, index, count, params);
  if (count < 0 || std::size_t(count) > row->env.size())
    return raise(context, GL_INVALID_VALUE, "ProgramEnvParameters: count");
  env(context, *row, index, count, gather(count, params).data());
}

void ProgramLocalParameter4fARB(Context &context, GLenum target, GLuint index, GLfloat x, GLfloat y,
                                GLfloat z, GLfloat w) {
  if (ProgramTarget *const row = rowOf(context, target))
    return local(context, *row, index, {x, y, z, w});
  context.host->ProgramLocalParameter4fARB(target, index, x, y, z, w);
}

void ProgramLocalParameter4fARB(Context &context, GLenum target, GLuint index,
                                host::ParameterValues values) {
  ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return values.pass(context.host->ProgramLocalParameter4fvARB,
                       context.host->ProgramLocalParameter4dvARB, target, index);
  if (index >= row->limits.localParameters) [[unlikely]]
    return local(context, *row, index, Vec4{});
  values.give([&](GLfloat x, GLfloat y, GLfloat z, GLfloat w) __attribute__((always_inline)) {
    local(context, *row, index, {x, y, z, w});
  });
}

void ProgramLocalParameters4fvEXT(Context &context, GLenum target, GLuint index, GLsizei count,
                                  const GLfloat *params) {
  ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->ProgramLocalParameters4fvEXT(target, index, count, params);
  if (count < 0 || GLuint(count) > row->limits.localParameters)
    return raise(context, GL_INVALID_VALUE, "ProgramLocalParameters: count");
  local(context, *row, index, count, gather(count, params).data());
}

void GetProgramEnvParameterfvARB(Context &context, GLenum target, GLuint index, GLfloat *params) {
  if (ProgramTarget *const row = rowOf(context, target))
    return copyOut(readEnv(context, *row, index), params);
  context.host->GetProgramEnvParameterfvARB(target, index, params);
}

void GetProgramEnvParameterdvARB(Context &context, GLenum target, GLuint index, GLdouble *params) {
  if (ProgramTarget *const row = rowOf(context, target))
    return copyOut(readEnv(context, *row, index), params);
  context.host->GetProgramEnvParameterdvARB(target, index, params);
}

void GetProgramLocalParameterfvARB(Context &context, GLenum target, GLuint index, GLfloat *params) {
  if (ProgramTarget *const row = rowOf(context, target))
    return copyOut(readLocal(context, *row, index), params);
  context.host->GetProgramLocalParameterfvARB(target, index, params);
}

void GetProgramLocalParameterdvARB(Context &context, GLenum target, GLuint index,
                                   GLdouble *params) {
  if (ProgramTarget *const row = rowOf(context, target))
    return copyOut(readLocal(context, *row, index), params);
  context.host->GetProgramLocalParameterdvARB(target, index, params);
}

} // namespace handlers
} // namespace arbiter::state
