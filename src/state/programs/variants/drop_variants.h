#pragma once

namespace arbiter::state {

struct ProgramContext;
struct CompiledProgram;

/// Deletes this context's linked programs of a program that left its object.
void dropVariants(ProgramContext &context, const CompiledProgram &compiled);

} // namespace arbiter::state
