#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "state/objects/linked_program.h"
#include "state/objects/target.h"

namespace arbiter::state {

struct DrawContext;

/// Updates the host's uniforms of the effective linked program, as far as `attention` says that
/// they may have changed. Requires that its host program is current. It allocates nothing, and
/// makes one call for each run of changed values.
void uploadParameters(DrawContext &context, LinkedProgram &linkedProgram, std::uint32_t attention);
/// Returns a parameter's current value. \param row the effective program's target
[[nodiscard]] Vec4 currentValue(DrawContext &context, const ProgramTarget &row,
                                const fp::ir::Parameter &parameter);
/// Returns the value that the application set for an env or local parameter.
[[nodiscard]] inline Vec4 givenValue(const ProgramTarget &row, bool env, std::size_t index) {
  if (env)
    return index < row.env.size() ? row.env[index] : Vec4{};
  return index < row.bound->locals.size() ? row.bound->locals[index].load() : Vec4{};
}
/// Returns the value of a parameter that is no GL state, while no client of control holds any.
[[nodiscard]] inline Vec4 ownValue(const ProgramTarget &row, const fp::ir::Parameter &parameter) {
  return parameter.kind == fp::ir::ParameterKind::Constant
             ? parameter.constant
             : givenValue(row, parameter.kind == fp::ir::ParameterKind::Env, parameter.index);
}

} // namespace arbiter::state
