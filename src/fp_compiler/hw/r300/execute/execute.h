#pragma once
#include "fp_compiler/hw/r300/machine.h"
#include "fp_compiler/ir/evaluate.h"

namespace arbiter::fp::hw::r300 {

/// The state that the interpreter gives the chip. Any values would do, because programs undo them.
inline constexpr ir::Vec4 kViewportScale = {8.0f, 8.0f, 0.5f, 1.0f};
inline constexpr ir::Vec4 kViewportOffset = {8.0f, 8.0f, 0.5f, 0.0f};
inline constexpr float kRectangleWidth = 256.0f, kRectangleHeight = 128.0f;

/// Runs \p code, compiled from \p program, for one fragment, so that the result can be compared
/// with ir::evaluate()'s. An output depth is in Evaluation::depth only.
///
/// Arithmetic is ir::apply()'s, and each operation is rounded separately. A zero factor gives zero
/// (Legacy), unless \p inputs ask for Fp24. ReplAlpha and Dp take the other half's result before
/// its modifier and clamp.
///
/// The inputs are those of ir::evaluate(), converted to the forms that the chip gets:
/// - fragment.position is the clip position that the viewport above maps to the window position in
/// inputs.attributes;
/// - the fog coordinate is (f,0,0,1), whatever its attribute holds besides f;
/// - a shadow target samples the stored depth: inputs.texture is asked for the plain target without
/// the reference, and its x is the depth in all four components;
/// - a rectangle's unit with a RectangleScale constant is sampled at [0,1], and inputs.texture gets
/// texels.
/// Requires: faults(code, program) is empty.
[[nodiscard]] ir::Evaluation execute(const Code &code, const ir::Program &program,
                                     const ir::Inputs &inputs);

} // namespace arbiter::fp::hw::r300
