#pragma once
#include <vector>

#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/ir/ir.h"

/// A program's instructions as values. Fragments and vertices differ in where registers come from,
/// which is the hooks' business.
namespace arbiter::fp::llvm_back {

/// What the program reads from outside, as the walk comes to it.
class ProgramHooks {
public:
  virtual ~ProgramHooks() = default;
  /// Attribute `index` of Program::attributes; asked once each, with all components that are read.
  [[nodiscard]] virtual Vec attribute(int index, unsigned needed) = 0;
  /// Row `index` of Program::parameters, broadcast (constants are literals and are not asked for).
  [[nodiscard]] virtual Vec parameter(int index, unsigned needed) = 0;
  /// A texture access with its operands swizzled, negated and, for TXP, not yet divided. What lies
  /// in lanes that do not run (running()) does not matter.
  [[nodiscard]] virtual Vec texture(const ir::Instruction &instruction,
                                    const std::array<Vec, 3> &operands, unsigned needed) = 0;
  /// Whether lanes are 2x2 quads, which DDX and DDY compare; asked where one is met.
  [[nodiscard]] virtual bool hasQuads() { return false; }
  /// The lanes for which a loop may have to run, an i1 each; null for all.
  [[nodiscard]] virtual Value *wanted() { return nullptr; }
  /// KIL: lanes in which any component is below zero are discarded.
  virtual void kill(Value *lanes) = 0;
  /// A relative operand: row `index` (one i32 a lane; out of range gives zero) of Program::arrays.
  [[nodiscard]] virtual Vec relative(int array, Value *index, unsigned needed) = 0;

  /// Set by the walk: the lanes that run what is written now, in a loop; null for all.
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

/// Writes the code of the program. Only what reaches an output or a KIL is written. Fog and colour
/// sum are left to the caller.
[[nodiscard]] ProgramResults writeProgram(Code &code, const ir::Program &program, Numerics numerics,
                                          ProgramHooks &hooks);

} // namespace arbiter::fp::llvm_back
