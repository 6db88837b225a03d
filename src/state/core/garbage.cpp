#include "state/core/garbage.h"

#include "host/host_table.h"
#include "state/core/core_context.h"
#include "state/share/share_group.h"

namespace arbiter::state {

void collectGarbage(CoreContext &context) {
  const ShareGroup::Garbage garbage = context.group->takeGarbage();
  for (const GLuint program : garbage.programs) {
    context.group->removeHostProgram(program);
    context.host->DeleteProgram(program);
  }
  for (const GLuint shader : garbage.shaders) {
    context.group->removeHostProgram(shader);
    context.host->DeleteShader(shader);
  }
  if (!garbage.samplers.empty())
    context.host->DeleteSamplers(GLsizei(garbage.samplers.size()), garbage.samplers.data());
  if (!garbage.assembly.empty())
    context.host->DeleteProgramsARB(GLsizei(garbage.assembly.size()), garbage.assembly.data());
}

} // namespace arbiter::state
