#pragma once
#include "state/programs/combiners/combiner_commands.h"

namespace arbiter::state {

struct RasterContext;

/// Executes a command of register combiners, or records it in a list. Must be outside Begin/End.
/// The context must offer the extension.
void issueCombinerCommand(RasterContext &context, const CombinerCommand &command);

} // namespace arbiter::state
