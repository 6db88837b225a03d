#pragma once
#include "fp_compiler/ir/ir.h"

/// The fog options (ARB_fragment_program 3.11.4.5.1): their names, their cost and their state. With
/// the coordinate c and the row r of StateItem::FogFactors, the factor is SAT of
///   exp     EX2(c * r.z)
///   exp2    EX2(-(c * r.w) * (c * r.w))
///   linear  c * r.x + r.y
namespace arbiter::fp::ir {

struct FogRow {
  const char *option = nullptr;   ///< null for FogMode::None
  std::uint32_t instructions = 0; ///< those of the factor, without the LRP that blends
};
/// Returns the row of a mode.
[[nodiscard]] constexpr FogRow rowOf(FogMode mode) {
  constexpr FogRow kRows[] = {{}, {"ARB_fog_exp", 2}, {"ARB_fog_exp2", 3}, {"ARB_fog_linear", 1}};
  return kRows[std::size_t(mode)];
}

/// Returns StateItem::FogFactors for the value of StateItem::FogParams, computed in singles:
/// (-s, end * s, -density / ln 2, density / sqrt(ln 2)), where s is 1 / (end - start). If start and
/// end are equal, s is so large that linear fog is a step there.
[[nodiscard]] Vec4 fogFactors(const Vec4 &params);

/// Returns the parameter that reads a row of state.
[[nodiscard]] Parameter stateRow(StateItem item);

} // namespace arbiter::fp::ir
