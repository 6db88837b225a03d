#pragma once
#include <optional>
#include <vector>

#include "fp_compiler/front/bindings/binder.h"
#include "fp_compiler/front/nv/statement.h"

/// Programs of NVIDIA's options as code of the IR, which has no condition codes and no flow: a
/// write under a condition becomes a CMP of what was there and what is written, a block under IF
/// writes so whatever is in it, and a subroutine stands where it is called.
namespace arbiter::fp::nv {

/// Appends the code of \p statements to \p binder's program.
/// \param start the label to begin at; none: the first statement
/// \error flow-control a branch backwards or a recursive call, at the branch; limit-instructions
///        where calls make more code than any program may have
void lower(const std::vector<Statement> &statements, std::optional<std::uint16_t> start,
           Binder &binder, Reporter &reporter);

} // namespace arbiter::fp::nv
