#include <algorithm>
#include <string>

#include "fp_compiler/front/nv/lowerer.h"
#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/nv_limits.h"

namespace arbiter::fp::nv {

/// Adds a flag register with that value.
std::uint16_t Lowerer::flag(const Operand &value) {
  const std::uint16_t index = m_code.temporary("");
  m_code.write(Opcode::Mov, writtenTo(index, kX), {component(value, 0)});
  return index;
}

/// Makes sure that a flag has a register, so that it can be written.
void Lowerer::require(Flag &wanted) {
  if (!wanted)
    wanted = flag(one());
}

/// Returns a flag that holds if any tested component passes, as branches and IF require. Not for TR
/// and FL.
Lowerer::Flag Lowerer::passesAny(const Test &test) {
  const Operand each = passes(test, kAll);
  const bool alike = std::all_of(test.swizzle.begin(), test.swizzle.end(),
                                 [&](Select select) { return select == test.swizzle[0]; });
  if (alike)
    return flag(each);
  const std::uint16_t index = m_code.temporary("");
  ir::Destination dst = writtenTo(index, kX);
  dst.saturate = true;
  m_code.write(Opcode::Dp4, dst, {each, each});
  return index;
}

/// Returns an operand that is 1 if the current lane runs. Returns nothing if all lanes run.
std::optional<Operand> Lowerer::active() {
  std::optional<Operand> all;
  for (const Flag &part : {m_function.base, m_function.block, m_function.alive}) {
    if (!part)
      continue;
    all = all ? component(m_code.make(Opcode::Mul, {*all, flagOf(*part)}, kX), 0) : flagOf(*part);
  }
  return all;
}

Operand Lowerer::activeOr1() {
  const std::optional<Operand> runs = active();
  return runs ? *runs : one();
}

/// Returns the statements that can run from one on, without those of subroutines. For languages
/// with branches; programs with blocks are always straight-line.
std::vector<bool> Lowerer::reachedFrom(std::size_t entry, bool &backwards) const {
  std::vector<bool> reached(m_statements.size(), false);
  std::vector<std::size_t> next = {entry};
  while (!next.empty()) {
    std::size_t at = next.back();
    next.pop_back();
    for (; at < m_statements.size() && !reached[at]; ++at) {
      reached[at] = true;
      const Statement &statement = m_statements[at];
      const bool always = statement.test.rule == Rule::Tr;
      if (!statement.isLabel && statement.instruction.op == Opcode::Bra &&
          statement.test.rule != Rule::Fl) {
        const std::size_t target = m_places.at(statement.label);
        backwards |= target <= at || target < entry;
        next.push_back(target);
        if (always)
          break;
      }
      if (!statement.isLabel && statement.instruction.op == Opcode::Ret && always)
        break;
    }
  }
  return reached;
}

/// Lowers the statements from one on, until a RET or the end.
void Lowerer::function(std::size_t entry) {
  bool backwards = false;
  const std::vector<bool> reached = reachedFrom(entry, backwards);
  if (backwards)
    rounds(entry, reached);
  else
    straight(entry);
}

/// Lowers statements in order, until no lane can run.
void Lowerer::straight(std::size_t entry) {
  for (std::size_t at = entry; at < m_statements.size() && !m_reporter.hasErrors(); ++at) {
    const Statement &next = m_statements[at];
    m_code.begin(next.instruction.span);
    if (next.isLabel)
      arrive(next.label);
    else if (!m_function.dead)
      statement(next);
    else if (m_function.pending.empty())
      return;
  }
}

/// Lowers a function that branches backwards to one loop over all statements that it reaches, from
/// first to last. A statement runs in the round in which a lane arrives at it. A forward branch
/// arrives in the same round, a backward one in the next.
void Lowerer::rounds(std::size_t entry, const std::vector<bool> &reached) {
  m_code.begin(m_statements[entry].instruction.span);
  m_function.turns = true;
  const std::uint16_t first = flag(one());
  m_function.alive = flag(zero());
  for (std::size_t i = 0; i < m_statements.size(); ++i)
    if (reached[i] && m_statements[i].isLabel)
      m_function.pending[m_statements[i].label] = flag(zero());
  m_code.write(Opcode::Rep, {}, {m_code.constant(float(ir::kMaxIterations))});
  for (std::size_t at = 0; at < m_statements.size() && !m_reporter.hasErrors(); ++at) {
    if (!reached[at])
      continue;
    const Statement &next = m_statements[at];
    m_code.begin(next.instruction.span);
    if (at == entry) {
      m_code.write(Opcode::Add, writtenTo(*m_function.alive, kX),
                   {flagOf(*m_function.alive), flagOf(first)});
      m_code.write(Opcode::Mov, writtenTo(first, kX), {zero()});
    }
    if (next.isLabel)
      arrive(next.label);
    else
      statement(next);
  }
  Operand left = zero();
  for (const auto &[label, pending] : m_function.pending)
    left = component(m_code.make(Opcode::Add, {left, flagOf(*pending)}, kX), 0);
  const Operand none = component(m_code.make(Opcode::Seq, {left, zero()}, kX), 0);
  m_code.write(Opcode::Brk, {}, {none});
  m_code.write(Opcode::Mov, writtenTo(*m_function.alive, kX), {zero()});
  m_code.write(Opcode::Endrep, {}, {});
}

void Lowerer::statement(const Statement &statement) {
  if (info(statement.instruction.op).has(ir::Flow))
    flow(statement);
  else
    execute(statement);
}

void Lowerer::flow(const Statement &statement) {
  switch (statement.instruction.op) {
  case Opcode::If:
    return enter(statement);
  case Opcode::Else:
    return turn();
  case Opcode::Endif:
    if (m_function.blocks.back().selection)
      endSelection();
    m_function.block = m_function.blocks.back().outer;
    m_function.blocks.pop_back();
    return;
  case Opcode::Loop:
  case Opcode::Rep:
    return beginLoop(statement);
  case Opcode::Endloop:
  case Opcode::Endrep:
    return endLoop();
  case Opcode::Brk:
    return leaveLoop(statement);
  case Opcode::Bra:
    return branch(statement);
  case Opcode::Cal:
    return call(statement);
  case Opcode::Pusha:
    return push(statement);
  case Opcode::Popa:
    return pop(statement);
  default: // RET
    if (statement.test.rule != Rule::Fl)
      leave(statement.test.rule == Rule::Tr ? Flag{} : passesAny(statement.test));
  }
}

void Lowerer::enter(const Statement &statement) {
  if (selects(statement))
    return beginSelection(statement);
  Flag inner = m_function.block;
  if (statement.test.rule == Rule::Fl) {
    inner = flag(zero());
  } else if (statement.test.rule != Rule::Tr) {
    inner = passesAny(statement.test);
    if (m_function.block)
      m_code.write(Opcode::Mul, writtenTo(*inner, kX), {flagOf(*inner), flagOf(*m_function.block)});
  }
  m_function.blocks.push_back({m_function.block, inner});
  m_function.block = inner;
}

/// Begins ELSE: the lanes of the outer block that did not run the first part.
void Lowerer::turn() {
  const Block &block = m_function.blocks.back();
  if (block.selection) {
    m_selections.back().turned = true;
    return;
  }
  const Operand outer = block.outer ? flagOf(*block.outer) : one();
  const Operand inner = block.inner ? flagOf(*block.inner) : one();
  m_function.block = flag(m_code.make(Opcode::Sub, {outer, inner}, kX));
}

void Lowerer::beginLoop(const Statement &statement) {
  if (m_loops.size() >= nv::kMaxLoops) {
    m_reporter.error(DiagnosticId::NvFlow, statement.instruction.span,
                     "more than " + std::to_string(nv::kMaxLoops) + " loops, one in the other",
                     "no program can be that deep");
    return;
  }
  const Operand operand = instructionOf(statement).src[0];
  Operand count = component(operand, 0);
  if (const std::optional<Operand> runs = active())
    count = component(m_code.make(Opcode::Mul, {count, *runs}, kX), 0);
  Loop loop;
  loop.counts = statement.instruction.op == Opcode::Loop;
  if (loop.counts) {
    loop.index = m_code.temporary("A0");
    loop.step = m_code.temporary("");
    m_code.write(Opcode::Flr, writtenTo(loop.index, kX), {component(operand, 1)});
    m_code.write(Opcode::Flr, writtenTo(loop.step, kX), {component(operand, 2)});
  }
  // A RET in the loop changes this flag in place, so that the next iteration sees it.
  if (returnsWithin(statement))
    require(m_function.alive);
  m_code.write(Opcode::Rep, {}, {count});
  m_loops.push_back(loop);
  ++m_function.loops;
}

void Lowerer::endLoop() {
  const Loop &loop = m_loops.back();
  if (loop.counts)
    m_code.write(Opcode::Add, writtenTo(loop.index, kX), {flagOf(loop.index), flagOf(loop.step)});
  m_code.write(Opcode::Endrep, {}, {});
  m_loops.pop_back();
  --m_function.loops;
}

void Lowerer::leaveLoop(const Statement &statement) {
  if (statement.test.rule == Rule::Fl)
    return;
  Operand leaves = activeOr1();
  if (statement.test.rule != Rule::Tr)
    leaves =
        component(m_code.make(Opcode::Mul, {flagOf(*passesAny(statement.test)), leaves}, kX), 0);
  m_code.write(Opcode::Brk, {}, {leaves});
}

/// Stops \p lanes, of those that run, until a label or the end of a block lets them run again.
void Lowerer::leave(const Flag &lanes) {
  if (!lanes && m_function.blocks.empty() && m_function.loops == 0 && !m_function.turns) {
    m_function.dead = true;
    return;
  }
  Operand leaving = activeOr1();
  if (lanes)
    leaving = component(m_code.make(Opcode::Mul, {flagOf(*lanes), leaving}, kX), 0);
  require(m_function.alive);
  m_code.write(Opcode::Sub, writtenTo(*m_function.alive, kX), {flagOf(*m_function.alive), leaving});
}

void Lowerer::branch(const Statement &statement) {
  if (statement.test.rule == Rule::Fl)
    return;
  const Flag lanes = statement.test.rule == Rule::Tr ? Flag{} : passesAny(statement.test);
  Operand going = activeOr1();
  if (lanes)
    going = component(m_code.make(Opcode::Mul, {flagOf(*lanes), going}, kX), 0);
  Flag &pending = m_function.pending[statement.label];
  if (!pending)
    pending = flag(going);
  else
    m_code.write(Opcode::Add, writtenTo(*pending, kX), {flagOf(*pending), going});
  leave(lanes);
}

void Lowerer::arrive(std::uint16_t label) {
  const auto found = m_function.pending.find(label);
  if (found == m_function.pending.end())
    return;
  const std::uint16_t pending = *found->second;
  if (m_function.dead)
    m_function.alive = flag(flagOf(pending));
  else if (m_function.alive)
    m_code.write(Opcode::Add, writtenTo(*m_function.alive, kX),
                 {flagOf(*m_function.alive), flagOf(pending)});
  m_function.dead = false;
  if (m_function.turns)
    m_code.write(Opcode::Mov, writtenTo(pending, kX), {zero()});
  else
    m_function.pending.erase(found);
}

/// Inlines the subroutine. It runs the lanes that run here. Lanes that leave by its RET continue
/// after the call.
void Lowerer::call(const Statement &statement) {
  if (statement.test.rule == Rule::Fl)
    return;
  const bool within = std::find(m_calls.begin(), m_calls.end(), statement.label) != m_calls.end();
  if (within || m_calls.size() >= nv::kMaxCalls) {
    m_reporter.error(DiagnosticId::NvFlow, statement.instruction.span,
                     within ? std::string("a subroutine calls itself")
                            : "more than " + std::to_string(nv::kMaxCalls) +
                                  " calls, one in the other",
                     "no program can be that deep");
    return;
  }
  Function callee;
  if (statement.test.rule != Rule::Tr)
    callee.base = passesAny(statement.test);
  if (const std::optional<Operand> runs = active()) {
    if (callee.base)
      m_code.write(Opcode::Mul, writtenTo(*callee.base, kX), {flagOf(*callee.base), *runs});
    else
      callee.base = flag(*runs);
  }
  std::swap(m_function, callee);
  m_calls.push_back(statement.label);
  function(m_places[statement.label]);
  m_calls.pop_back();
  std::swap(m_function, callee);
}

} // namespace arbiter::fp::nv
