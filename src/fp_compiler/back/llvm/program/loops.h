#pragma once
#include <vector>

#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/ir/ir.h"

/// REP, BRK and ENDREP: a loop runs as long as any lane wants another iteration, and the lanes that
/// have left wait for the others.
namespace arbiter::fp::llvm_back {

/// A value that an iteration may find changed by the one before.
struct LoopSlot {
  Value **value = nullptr;  ///< where the walk keeps it; null until something is written
  Value *initial = nullptr; ///< what null stands for
};

class Loops {
public:
  /// \param lanes an i1 each: those that run at all
  Loops(Code &code, const ir::Program &program, Value *lanes);

  /// REP. \param count floats; \param slots the values that an iteration changes, and that the next
  /// one, or what is behind the loop, reads
  void begin(Value *count, std::vector<LoopSlot> slots);
  /// BRK. \param condition lanes that leave the innermost loop
  void leave(Value *condition);
  /// ENDREP.
  void end();
  /// The lanes that run what is written now; null, and all, outside of loops.
  [[nodiscard]] Value *running() const { return m_loops.empty() ? nullptr : m_running; }

private:
  struct Loop {
    llvm::BasicBlock *header = nullptr, *behind = nullptr;
    Value *outer = nullptr; ///< what runs behind it
    llvm::PHINode *left = nullptr;
    Value *nowLeft = nullptr; ///< iterations that have not begun, an i32 a lane
    std::vector<LoopSlot> slots;
    std::vector<llvm::PHINode *> phis; ///< of the slots
  };
  [[nodiscard]] Value *iterations(Value *count);

  Code &m_code;
  Value *m_running;
  Value *m_begun = nullptr; ///< iterations of all loops, an i32 a lane
  bool m_endsByItself;      ///< no run can come to the cap on iterations
  std::vector<Loop> m_loops;
};

} // namespace arbiter::fp::llvm_back
