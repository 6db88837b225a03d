#pragma once

namespace arbiter::state {

class Context;
struct CompiledProgram;

/// Deletes this context's linked programs of a program that left its object.
void dropVariants(Context &context, const CompiledProgram &compiled);

} // namespace arbiter::state
