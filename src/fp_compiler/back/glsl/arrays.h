#pragma once
#include <string>
#include <vector>

#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/ir.h"

/// Relative operands in GLSL. Each array that is read gets a function of the row number. It returns
/// zero for rows out of range, so that no host reads outside the array.
namespace arbiter::fp::glsl {

/// Moves each relative operand to an instruction of its own: `MOV t, array[A+n]`, and reads t
/// instead. Each row is then fetched once for each time the program names it. Adds at most three
/// temporaries. Programs without relative operands do not change.
void hoistRelative(ir::Program &program);

/// Declares the arrays that a program's relative operands name.
class Arrays {
public:
  /// Appends to \p uniforms the rows of arrays that only the layer can fill. Those of one array are
  /// contiguous.
  Arrays(const ir::Program &program, const std::string &uniformArray,
         std::vector<GlslUniform> &uniforms);

  /// Returns global declarations and functions, which must follow the uniform array's declaration.
  [[nodiscard]] const std::string &functions() const { return m_functions; }
  /// Returns statements for the top of main(): arrays whose rows are built-in state.
  [[nodiscard]] const std::string &locals() const { return m_locals; }
  /// Returns an element as a vec4: "arb_array0(a0 + 3)".
  [[nodiscard]] static std::string element(const ir::Operand &operand);

private:
  void declare(const ir::Program &program, std::size_t index, const std::string &uniformArray,
               std::vector<GlslUniform> &uniforms);

  std::string m_functions, m_locals;
};

} // namespace arbiter::fp::glsl
