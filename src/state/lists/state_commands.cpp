#include "state/lists/state_commands.h"

#include <algorithm>
#include <cstring>

#include "host/host_table.h"
#include "state/core/memory.h"
#include "state/lists/list_compiler.h"
#include "state/lists/texture_commands.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

/// Records the command if the list keeps state. Returns false if it does not.
bool record(RasterContext &context, const StateCommand &command, std::uint32_t dirty) {
  if (!command.isValid() || !listCompiler(context).keepsState())
    return false;
  withinMemory(context, "a command of a list",
               [&] { listCompiler(context).recordState(context, command, dirty); });
  return true;
}

} // namespace

bool recordMaterial(RasterContext &context, GLenum face, GLenum pname, const GLfloat *values) {
  const int count = materialValues(pname);
  if (count == 0 || !values)
    return false;
  StateCommand command{.target = face, .pname = pname};
  std::copy_n(values, count, command.values.begin());
  return record(context, command, dirty::kMaterial | dirty::kProgramState);
}

bool recordBindTexture(RasterContext &context, GLenum target, GLuint texture) {
  return record(context, {.target = target, .texture = texture}, dirty::kTextureBindings);
}

void executeStateCommands(RasterContext &context, const std::string &bytes) {
  StateCommand command;
  for (std::size_t at = 0; at < bytes.size(); at += sizeof command) {
    std::memcpy(&command, bytes.data() + at, sizeof command);
    if (command.pname == 0) {
      context.host->BindTexture(command.target, command.texture);
      noteTextureCommand(context);
    } else {
      context.host->Materialfv(command.target, command.pname, command.values.data());
    }
  }
}

} // namespace arbiter::state
