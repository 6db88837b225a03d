#pragma once
#include <vector>

#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/ir/ir.h"

/// Writes REP, BRK and ENDREP. A loop runs as long as any lane needs another iteration. Lanes that
/// have left wait for the others.
namespace arbiter::fp::llvm_back {

/// A value that one iteration may change for the next.
struct LoopSlot {
  Value **value = nullptr;  ///< the walk's variable; null until written
  Value *initial = nullptr; ///< the value that null stands for
};

class Loops {
public:
  /// \param lanes i1 lanes that run at all
  Loops(Code &code, const ir::Program &program, Value *lanes);

  /// Writes REP.
  /// \param count floats
  /// \param slots the values that an iteration changes and that the next one, or code after the
  /// loop, reads
  void begin(Value *count, std::vector<LoopSlot> slots);
  /// Writes BRK.
  /// \param condition lanes that leave the innermost loop
  void leave(Value *condition);
  /// Writes ENDREP.
  void end();
  /// Returns the lanes that run the current code; null, meaning all, outside of loops.
  [[nodiscard]] Value *running() const { return m_loops.empty() ? nullptr : m_running; }

private:
  struct Loop {
    llvm::BasicBlock *header = nullptr, *behind = nullptr;
    Value *outer = nullptr; ///< lanes that run after the loop
    llvm::PHINode *left = nullptr;
    Value *nowLeft = nullptr; ///< iterations still to come, as i32 lanes
    std::vector<LoopSlot> slots;
    std::vector<llvm::PHINode *> phis; ///< of the slots
  };
  [[nodiscard]] Value *iterations(Value *count);

  Code &m_code;
  Value *m_running;
  Value *m_begun = nullptr; ///< number of iterations of all loops, as i32 lanes
  bool m_endsByItself;      ///< no invocation can reach the cap on iterations
  std::vector<Loop> m_loops;
};

} // namespace arbiter::fp::llvm_back
