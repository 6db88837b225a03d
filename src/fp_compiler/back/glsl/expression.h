#pragma once
#include <string>
#include <vector>

#include "fp_compiler/analysis/range_analysis.h"
#include "fp_compiler/back/glsl/registers.h"
#include "fp_compiler/ir/ir.h"
#include "fp_compiler/numerics.h"

namespace arbiter::fp::glsl {

/// Component positions 0..3 of an operand or destination, in order; 1 to 4 of them.
using Components = std::vector<int>;

/// The positions whose bit is set in \p mask.
[[nodiscard]] Components positions(std::uint8_t mask);

/// A swizzle's letters: "x", "zw"; "" for all four in order, which needs none.
[[nodiscard]] std::string suffix(const Components &components);

/// The GLSL type of `width` components: "float", "vec2", "vec3", "vec4".
[[nodiscard]] std::string typeName(std::size_t width);

/// The GLSL of one component of an operand, swizzle and sign applied: "-t0.y", "0.0", "-1.5".
/// \param position 0..3, of the destination's component
[[nodiscard]] std::string component(const Registers &registers, const ir::Operand &operand,
                                    int position);

/// The GLSL of several components, of type float or vecN by their number. Binds as tightly as a
/// unary minus.
[[nodiscard]] std::string vector(const Registers &registers, const ir::Operand &operand,
                                 const Components &components);

/// A list of float expressions as one value: "a" if there is one, "vecN(a)" if they are alike,
/// "vecN(a, b, ..)" otherwise.
[[nodiscard]] std::string compose(const std::vector<std::string> &parts);

/// The right-hand side of an instruction for the components of its mask, before _SAT.
/// \param numerics that the program follows (ir::numericsOf)
[[nodiscard]] std::string expression(const Registers &registers, const ir::Instruction &instruction,
                                     const Components &components,
                                     const analysis::OperandFacts &facts, Numerics numerics);

/// The condition under which KIL discards.
[[nodiscard]] std::string killCondition(const Registers &registers, const ir::Operand &operand);

/// The sampling call of TEX, TXP or TXB: a vec4.
[[nodiscard]] std::string sample(const Registers &registers, const ir::Instruction &instruction);

} // namespace arbiter::fp::glsl
