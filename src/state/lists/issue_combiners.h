#pragma once
#include "state/programs/combiners/combiner_commands.h"

namespace arbiter::state {

/// Executes a command of register combiners, or records it in a list. Must be outside Begin/End.
/// The context must offer the extension.
void issueCombinerCommand(Context &context, const CombinerCommand &command);

} // namespace arbiter::state
