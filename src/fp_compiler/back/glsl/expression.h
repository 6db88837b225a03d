#pragma once
#include <string>
#include <vector>

#include "fp_compiler/analysis/range_analysis.h"
#include "fp_compiler/back/glsl/registers.h"
#include "fp_compiler/ir/ir.h"
#include "fp_compiler/numerics.h"

namespace arbiter::fp::glsl {

/// Component positions 0..3 of an operand or destination, in order. There are 1 to 4.
using Components = std::vector<int>;

/// Returns the positions whose bit is set in \p mask.
[[nodiscard]] Components positions(std::uint8_t mask);

/// Returns a swizzle suffix: ".x", ".zw", or "" for all four components in order.
[[nodiscard]] std::string suffix(const Components &components);

/// Returns the GLSL type of `width` components: "float", "vec2", "vec3", "vec4".
[[nodiscard]] std::string typeName(std::size_t width);

/// Returns one component of an operand with swizzle and sign applied: "-t0.y", "0.0", "-1.5".
/// \param position 0..3, of the destination's component
[[nodiscard]] std::string component(const Registers &registers, const ir::Operand &operand,
                                    int position);

/// Returns several components as float or vecN. The text binds as tightly as a unary minus.
[[nodiscard]] std::string vector(const Registers &registers, const ir::Operand &operand,
                                 const Components &components);

/// Joins float expressions to one value: "a" if there is one, "vecN(a)" if they are equal, "vecN(a,
/// b, ..)" otherwise.
[[nodiscard]] std::string compose(const std::vector<std::string> &parts);

/// Returns the right-hand side of an instruction for the components of its mask, before _SAT.
/// \param numerics the arithmetic that the program follows (ir::numericsOf)
[[nodiscard]] std::string expression(const Registers &registers, const ir::Instruction &instruction,
                                     const Components &components,
                                     const analysis::OperandFacts &facts, Numerics numerics);

/// Returns the condition under which KIL discards.
[[nodiscard]] std::string killCondition(const Registers &registers, const ir::Operand &operand);

/// Returns the sampling call of a texture instruction: a vec4.
[[nodiscard]] std::string sample(const Registers &registers, const ir::Instruction &instruction);

} // namespace arbiter::fp::glsl
