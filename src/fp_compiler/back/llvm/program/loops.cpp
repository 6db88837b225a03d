#include "fp_compiler/back/llvm/program/loops.h"

#include "fp_compiler/ir/loop_counts.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::llvm_back {

Loops::Loops(Code &code, const ir::Program &program, Value *lanes)
    : m_code(code), m_running(lanes), m_endsByItself(ir::endsByItself(program)) {
  if (!m_endsByItself)
    m_begun = code.splat(0);
}

/// Returns ir::iterations() in each lane that runs, and 0 in the others.
Value *Loops::iterations(Value *count) {
  llvm::IRBuilder<> &ir = m_code.ir;
  Value *const some = ir.CreateFCmpOGE(count, m_code.splat(1.0f));
  Value *const whole = m_code.toInt(m_code.min(count, m_code.splat(float(ir::kMaxIterations))));
  return m_code.select(ir.CreateAnd(some, m_running), whole, m_code.splat(0));
}

void Loops::begin(Value *count, std::vector<LoopSlot> slots) {
  llvm::IRBuilder<> &ir = m_code.ir;
  llvm::Function *const function = ir.GetInsertBlock()->getParent();
  const auto block = [&](const char *name) {
    return llvm::BasicBlock::Create(m_code.context(), name, function);
  };
  Loop loop;
  loop.outer = m_running;
  loop.slots = std::move(slots);
  if (m_begun)
    loop.slots.push_back({&m_begun, nullptr});
  Value *const left = iterations(count);
  llvm::BasicBlock *const before = ir.GetInsertBlock(), *const body = block("iteration");
  loop.header = block("rep");
  loop.behind = block("endrep");
  ir.CreateBr(loop.header);

  ir.SetInsertPoint(loop.header);
  const auto phi = [&](Value *initial) {
    llvm::PHINode *const made = ir.CreatePHI(initial->getType(), 2);
    made->addIncoming(initial, before);
    return made;
  };
  loop.left = phi(left);
  for (const LoopSlot &slot : loop.slots) {
    loop.phis.push_back(phi(*slot.value ? *slot.value : slot.initial));
    *slot.value = loop.phis.back();
  }
  m_running = ir.CreateICmpSGT(loop.left, m_code.splat(0));
  if (m_begun)
    m_running =
        ir.CreateAnd(m_running, ir.CreateICmpSLT(m_begun, m_code.splat(int(ir::kMaxIterations))));
  ir.CreateCondBr(ir.CreateOrReduce(m_running), body, loop.behind);

  ir.SetInsertPoint(body);
  Value *const one = ir.CreateZExt(m_running, m_code.i32);
  loop.nowLeft = ir.CreateSub(loop.left, one);
  if (m_begun)
    m_begun = ir.CreateAdd(m_begun, one);
  m_loops.push_back(std::move(loop));
}

void Loops::leave(Value *condition) {
  llvm::IRBuilder<> &ir = m_code.ir;
  Loop &loop = m_loops.back();
  Value *const leaving = ir.CreateAnd(condition, m_running);
  loop.nowLeft = m_code.select(leaving, m_code.splat(0), loop.nowLeft);
  m_running = ir.CreateAnd(m_running, ir.CreateNot(condition));
}

void Loops::end() {
  llvm::IRBuilder<> &ir = m_code.ir;
  Loop &loop = m_loops.back();
  llvm::BasicBlock *const last = ir.GetInsertBlock();
  ir.CreateBr(loop.header);
  loop.left->addIncoming(loop.nowLeft, last);
  for (std::size_t i = 0; i < loop.slots.size(); ++i) {
    const LoopSlot &slot = loop.slots[i];
    loop.phis[i]->addIncoming(*slot.value, last);
    *slot.value = loop.phis[i];
  }
  ir.SetInsertPoint(loop.behind);
  m_running = loop.outer;
  m_loops.pop_back();
}

} // namespace arbiter::fp::llvm_back
