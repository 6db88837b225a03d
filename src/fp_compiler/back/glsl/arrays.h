#pragma once
#include <string>
#include <vector>

#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/ir.h"

/// Relative operands in GLSL. Each array that is read gets a function of the row's number, which
/// gives zero for a row that is not there, so that no index leaves its array on any host.
namespace arbiter::fp::glsl {

/// Gives each relative operand an instruction of its own: `MOV t, array[A+n]` with t read in its
/// place, so that a row is fetched once for each time the program names it. Needs at most three
/// more temporaries; programs without relative operands stay as they are.
void hoistRelative(ir::Program &program);

/// The arrays that a program's relative operands name.
class Arrays {
public:
  /// Appends to \p uniforms the rows of arrays that only the layer can fill, each array's in one
  /// run.
  Arrays(const ir::Program &program, const std::string &uniformArray,
         std::vector<GlslUniform> &uniforms);

  /// Global declarations and functions; they follow the uniform array's declaration.
  [[nodiscard]] const std::string &functions() const { return m_functions; }
  /// Statements for the top of main(): arrays whose rows come from built-in state.
  [[nodiscard]] const std::string &locals() const { return m_locals; }
  /// "arb_array0(a0 + 3)", a vec4.
  [[nodiscard]] static std::string element(const ir::Operand &operand);

private:
  void declare(const ir::Program &program, std::size_t index, const std::string &uniformArray,
               std::vector<GlslUniform> &uniforms);

  std::string m_functions, m_locals;
};

} // namespace arbiter::fp::glsl
