#include "state/programs/fragment_shaders.h"

#include "state/core/errors.h"
#include "state/programs/ati_recorder.h"
#include "state/programs/parameters.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_context.h"
#include "state/share/share_group.h"

namespace arbiter::state {

void bindFragmentShader(ProgramContext &context, GLuint name) {
  if (context.atiRecorder)
    return raise(context, GL_INVALID_OPERATION,
                 "BindFragmentShader between Begin- and EndFragmentShader");
  ProgramTarget &row = context.row(Target::AtiApi);
  auto &recent = context.recentPrograms[name % context.recentPrograms.size()];
  if (!recent || recent->name != name || recent->target != Target::AtiApi ||
      recent->deleted.load(std::memory_order_acquire))
    recent = name == 0 ? context.group->defaultProgram(Target::AtiApi)
                       : context.group->fragmentShaders.findOrCreate(name);
  if (row.bound == recent && row.seenVersion == recent->version.load(std::memory_order_acquire))
    return;
  row.bound = recent;
  invalidateProgram(context);
}

void setFragmentShaderConstant(ProgramContext &context, int constant, const Vec4 &value) {
  if (context.atiRecorder)
    return context.atiRecorder->setConstant(constant, value);
  setEnv(context, context.row(Target::AtiApi), GLuint(constant), 1, &value);
}

} // namespace arbiter::state
