#include "state/lists/issue_combiners.h"

#include "state/lists/list_compiler.h"
#include "state/programs/program_bind.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

void issueCombinerCommand(RasterContext &context, const CombinerCommand &command) {
  noteProgramApiUse(context);
  if (context.listMode)
    return listCompiler(context).record(
        context, {.kind = Command::Kind::Combiners, .bytes = bytesOf(command)});
  executeCombinerCommand(context, command);
}

} // namespace arbiter::state
