#pragma once
#include <memory>

#include "fp_compiler/emit.h"
#include "fp_compiler/ir/ir.h"
#include "state/programs/program_object.h"

namespace arbiter::state {

class Context;

/// A program that GL state was made into, compiled for this context: there is no text of the
/// application's, and none of its limits count.
/// \param target whose env parameters the program reads
/// \param program valid, of language ArbFragment
[[nodiscard]] std::shared_ptr<const CompiledProgram> programOfState(const Context &context,
                                                                    Target target,
                                                                    fp::ir::Program program,
                                                                    const fp::GlslHost &host);

} // namespace arbiter::state
