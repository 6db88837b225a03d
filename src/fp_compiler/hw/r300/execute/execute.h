#pragma once
#include "fp_compiler/hw/r300/machine.h"
#include "fp_compiler/ir/evaluate.h"

namespace arbiter::fp::hw::r300 {

/// What the interpreter's chip is set up with; any would do, as programs undo it.
inline constexpr ir::Vec4 kViewportScale = {8.0f, 8.0f, 0.5f, 1.0f};
inline constexpr ir::Vec4 kViewportOffset = {8.0f, 8.0f, 0.5f, 0.0f};
inline constexpr float kRectangleWidth = 256.0f, kRectangleHeight = 128.0f;

/// Runs \p code, which was made of \p program, for one fragment, so that the result can be compared
/// with ir::evaluate()'s. An output depth stands in Evaluation::depth alone.
///
/// Arithmetic is ir::apply()'s, each operation rounded by itself; a zero factor gives zero
/// (Legacy), unless \p inputs ask for Fp24. ReplAlpha and Dp take the other half's result before
/// its modifier and clamp.
///
/// The inputs are those of ir::evaluate(), with these forms of the chip:
/// - fragment.position comes as the clip position that gives it under the viewport above; what is
///   in inputs.attributes is the window position, as for ir::evaluate();
/// - the fog coordinate comes as (f,0,0,1), whatever else its attribute says;
/// - a shadow target samples the stored depth: inputs.texture is asked for the plain target at the
///   coordinate without reference, and its x is the depth in all four components;
/// - a rectangle's unit with a RectangleScale constant is sampled at [0,1]: inputs.texture gets
///   texels.
/// Requires: faults(code, program) is empty.
[[nodiscard]] ir::Evaluation execute(const Code &code, const ir::Program &program,
                                     const ir::Inputs &inputs);

} // namespace arbiter::fp::hw::r300
