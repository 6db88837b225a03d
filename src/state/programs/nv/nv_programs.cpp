#include "state/programs/nv/nv_programs.h"

#include <algorithm>

#include "state/core/errors.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/parameters.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_context.h"
#include "state/programs/program_load.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Returns the target that a text may be loaded for, including that of state programs.
ProgramTarget *loadRowOf(ProgramContext &context, GLenum target) {
  return target == infoOf(Target::VertexState).name ? &context.row(Target::VertexState)
                                                    : nvRowOf(context, target);
}

/// True if [index, index + count) are parameters and none of them tracks a matrix.
bool mayBeSet(ProgramContext &context, const ProgramTarget &row, GLuint index, GLsizei count) {
  const std::size_t size = std::min<std::size_t>(NvState::kParameters, row.env.size());
  if (!isRange(context, index, count, size, "ProgramParameters: index"))
    return false;
  for (GLuint i = index; i < index + GLuint(count); ++i)
    if (row.follows(i)) {
      raise(context, GL_INVALID_OPERATION, "ProgramParameters: a parameter follows a matrix");
      return false;
    }
  return true;
}

} // namespace

ProgramTarget *nvRowOf(ProgramContext &context, GLenum target) {
  switch (target) {
  case GL_VERTEX_PROGRAM_NV:
    return &context.row(Target::Vertex);
  case GL_FRAGMENT_PROGRAM_NV: // an enumerant of NV_fragment_program
    return rowOf(context, target);
  default:
    return nullptr;
  }
}

std::shared_ptr<ProgramObject> existingProgram(ProgramContext &context, GLuint id) {
  std::shared_ptr<ProgramObject> object = context.group->find(id);
  return object && object->exists.load(std::memory_order_relaxed) ? object : nullptr;
}

void loadNvProgram(ProgramContext &context, GLenum target, GLuint id, GLsizei length,
                   const void *text) {
  const ProgramTarget *const row = loadRowOf(context, target);
  if (!row)
    return raise(context, GL_INVALID_ENUM, "LoadProgram: target");
  if (id == 0 || length < 0)
    return raise(context, GL_INVALID_VALUE,
                 id == 0 ? "LoadProgram: 0 is no program's name"
                         : "LoadProgram: the length is negative");
  const std::shared_ptr<ProgramObject> object =
      context.group->findOrCreate(id, row->target, row->localsOfObject(), Existence::OnceLoaded);
  if (object->target != row->target)
    return raise(context, GL_INVALID_OPERATION, "LoadProgram: the program has another target");
  if (loadText(context, *object, {static_cast<const char *>(text), text ? std::size_t(length) : 0}))
    object->exists.store(true, std::memory_order_relaxed);
}

void bindNvProgram(ProgramContext &context, GLenum target, GLuint id) {
  ProgramTarget *const row = nvRowOf(context, target);
  if (!row)
    return raise(context, GL_INVALID_ENUM, "BindProgram: target");
  bindProgram(context, *row, id, Existence::OnceLoaded);
}

void setNvParameters(ProgramContext &context, GLenum target, GLuint index, GLsizei count,
                     const Vec4 *values) {
  if (target != GL_VERTEX_PROGRAM_NV)
    return raise(context, GL_INVALID_ENUM, "ProgramParameters: target");
  ProgramTarget &row = context.row(Target::Vertex);
  if (mayBeSet(context, row, index, count))
    setEnv(context, row, index, count, values);
}

} // namespace arbiter::state
