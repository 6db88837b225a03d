#pragma once
#include <vector>

#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/ir/ir.h"

/// Walks a program's instructions and emits their code. The hooks provide the registers, which
/// differ between fragments and vertices.
namespace arbiter::fp::llvm_back {

/// Provides the inputs that a program reads during the walk.
class ProgramHooks {
public:
  virtual ~ProgramHooks() = default;
  /// Returns attribute `index` of Program::attributes. It is called once for each, with all
  /// components that are read.
  [[nodiscard]] virtual Vec attribute(int index, unsigned needed) = 0;
  /// Returns row `index` of Program::parameters in all lanes. Constants are literals and not read
  /// here.
  [[nodiscard]] virtual Vec parameter(int index, unsigned needed) = 0;
  /// Returns a texture access. The operands are swizzled and negated, but not yet divided for TXP.
  /// Values in lanes that do not run (running()) do not matter.
  [[nodiscard]] virtual Vec texture(const ir::Instruction &instruction,
                                    const std::array<Vec, 3> &operands, unsigned needed) = 0;
  /// True if lanes are 2x2 quads, which DDX and DDY compare. Called only for those opcodes.
  [[nodiscard]] virtual bool hasQuads() { return false; }
  /// Returns the lanes for which a loop may run, as i1 lanes; null for all.
  [[nodiscard]] virtual Value *wanted() { return nullptr; }
  /// Handles KIL: discards lanes in which any component is below zero.
  virtual void kill(Value *lanes) = 0;
  /// Returns row `index` (i32 lanes; out of range gives zero) of an array in Program::arrays.
  [[nodiscard]] virtual Vec relative(int array, Value *index, unsigned needed) = 0;

  /// Sets the lanes that run the current code in a loop; null for all. The walk calls it.
  void setRunning(Value *lanes) { m_running = lanes; }

protected:
  [[nodiscard]] Value *running() const { return m_running; }

private:
  Value *m_running = nullptr;
};

/// One Vec for each of Program::outputs; a component that was never written is null.
struct ProgramResults {
  std::vector<Vec> outputs;
};

/// Writes the code of the program, as far as it reaches an output or a KIL.
[[nodiscard]] ProgramResults writeProgram(Code &code, const ir::Program &program, Numerics numerics,
                                          ProgramHooks &hooks);

} // namespace arbiter::fp::llvm_back
