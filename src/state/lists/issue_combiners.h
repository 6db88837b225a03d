#pragma once
#include "state/programs/combiners/combiner_commands.h"

namespace arbiter::state {

/// A command of register combiners, between no Begin and End: into the list that is compiled, else
/// executed. The context offers the extension.
void issueCombinerCommand(Context &context, const CombinerCommand &command);

} // namespace arbiter::state
