#include "fp_compiler/front/nv/lowering.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "fp_compiler/front/nv/code.h"
#include "fp_compiler/front/nv/words_code.h"

namespace arbiter::fp::nv {

using ir::Destination;
using ir::File;
using ir::Instruction;
using ir::Opcode;
using ir::Operand;
using ir::Select;

namespace {
constexpr std::uint8_t kX = 1, kAll = 0xF;
constexpr std::uint32_t kMostCalls = 32; ///< one in the other

Operand temporary(std::uint16_t index) { return registerOf(File::Temporary, index); }
Operand flagOf(std::uint16_t index) { return component(temporary(index), 0); }

Destination destination(std::uint16_t index, std::uint8_t mask) {
  Destination dst;
  dst.index = index;
  dst.mask = mask;
  return dst;
}

/// What is written and where conditions hold, statement after statement. Flags are 1 or 0 in x of a
/// register; a flag that is not there holds.
class Lowering {
public:
  Lowering(const std::vector<Statement> &statements, Binder &binder, Reporter &reporter)
      : m_statements(statements), m_reporter(reporter), m_code(binder) {
    for (std::size_t i = 0; i < statements.size(); ++i)
      if (statements[i].isLabel)
        m_places[statements[i].label] = i;
  }

  void run(std::optional<std::uint16_t> start) {
    walk(start ? m_places[*start] : 0);
    m_code.begin(m_statements.empty() ? Span{} : m_statements.back().instruction.span);
    for (const auto &[output, result] : m_results) {
      Destination dst = destination(output, result.mask);
      dst.file = File::Output;
      m_code.write(Opcode::Mov, dst, {temporary(result.index)});
    }
  }

private:
  using Flag = std::optional<std::uint16_t>;

  /// A result is written into a register, which can be read, and moved at the end.
  struct Result {
    std::uint16_t index = 0;
    std::uint8_t mask = 0;
  };

  void walk(std::size_t at);
  void statement(const Statement &statement, std::size_t at);
  void execute(const Statement &statement);
  void kill(const Statement &statement, const Instruction &instruction);
  void write(const Statement &statement, Instruction instruction, std::uint16_t target);
  void update(const Statement &statement, std::uint8_t mask, const Operand &value,
              const std::optional<Operand> &selects);
  void loadAddress(const Statement &statement, Instruction instruction);
  Instruction withBars(const Statement &statement);

  // Flow.
  void flow(const Statement &statement, std::size_t at);
  void branch(const Statement &statement, std::size_t at);
  void call(const Statement &statement);
  void enter(const Statement &statement);
  void turn();
  void arrive(std::uint16_t label);
  void leave(const Flag &lanes);

  [[nodiscard]] std::uint16_t conditionCode(std::uint8_t index);
  [[nodiscard]] Operand passes(const Test &test, std::uint8_t mask);
  [[nodiscard]] Flag passesAny(const Test &test);
  [[nodiscard]] std::optional<Operand> active();
  [[nodiscard]] std::optional<Operand> selector(const Test &test, std::uint8_t mask);
  [[nodiscard]] std::uint16_t flag(const Operand &value);
  [[nodiscard]] std::uint16_t shadowOf(std::uint16_t address);
  [[nodiscard]] std::uint16_t registerFor(const Destination &dst, std::uint8_t mask);

  const std::vector<Statement> &m_statements;
  Reporter &m_reporter;
  Code m_code;
  std::map<std::uint16_t, std::size_t> m_places; ///< of labels
  std::map<std::uint16_t, Result> m_results;     ///< by row of Program::outputs
  std::map<std::uint16_t, std::uint16_t> m_shadows; ///< address registers as floats
  std::array<Flag, 2> m_conditions;

  struct Block {
    Flag outer, inner;
  };
  std::vector<Block> m_blocks;
  Flag m_base;         ///< what has called the subroutine
  Flag m_block;        ///< the IFs that are open, of that
  Flag m_alive;        ///< what has not left by RET or BRA
  bool m_dead = false; ///< all has left
  std::map<std::uint16_t, Flag> m_pending; ///< by label: what arrives there
  std::vector<std::uint16_t> m_calls;
};

/// Until nothing is left to run, or the end.
void Lowering::walk(std::size_t at) {
  for (; at < m_statements.size() && !m_reporter.hasErrors(); ++at) {
    const Statement &next = m_statements[at];
    m_code.begin(next.instruction.span);
    if (next.isLabel)
      arrive(next.label);
    else if (!m_dead)
      statement(next, at);
    else if (m_pending.empty())
      return;
  }
}

void Lowering::statement(const Statement &statement, std::size_t at) {
  if (info(statement.instruction.op).has(ir::Flow))
    flow(statement, at);
  else
    execute(statement);
}

/// The operands, those within bars through ABS.
Instruction Lowering::withBars(const Statement &statement) {
  Instruction instruction = statement.instruction;
  for (std::size_t i = 0; i < 3; ++i) {
    Operand &operand = instruction.src[i];
    if (!(statement.absolute >> i & 1))
      continue;
    const std::uint8_t signs = operand.negate;
    Operand inside = operand;
    if (instruction.op == Opcode::Swz) { // its selectors and signs are outside
      inside.swizzle = ir::kIdentity;
      inside.negate = 0;
      const Operand value = m_code.make(Opcode::Abs, {inside});
      operand = swizzled(value, operand.swizzle);
      operand.negate = signs;
      continue;
    }
    inside.negate = 0;
    operand = m_code.make(Opcode::Abs, {inside});
    if (info(instruction.op).shapes[i] == 'S')
      operand = component(operand, 0);
    operand.negate = signs;
  }
  return instruction;
}

std::uint16_t Lowering::conditionCode(std::uint8_t index) {
  Flag &condition = m_conditions[index];
  if (!condition)
    condition = m_code.temporary(index == 0 ? "CC0" : "CC1");
  return *condition;
}

/// 1 or 0 for each component in \p mask. A comparison with NaN holds for NE alone.
Operand Lowering::passes(const Test &test, std::uint8_t mask) {
  const Operand value = swizzled(temporary(conditionCode(test.condition)), test.swizzle);
  const Operand zero = number(Select::Zero);
  switch (test.rule) {
  case Rule::Eq:
    return m_code.make(Opcode::Seq, {value, zero}, mask);
  case Rule::Ge:
    return m_code.make(Opcode::Sge, {value, zero}, mask);
  case Rule::Gt:
    return m_code.make(Opcode::Slt, {zero, value}, mask);
  case Rule::Le:
    return m_code.make(Opcode::Sge, {zero, value}, mask);
  case Rule::Lt:
    return m_code.make(Opcode::Slt, {value, zero}, mask);
  case Rule::Ne:
    return m_code.make(Opcode::Sne, {value, zero}, mask);
  case Rule::Tr:
    return number(Select::One);
  case Rule::Fl:
    break;
  }
  return zero;
}

/// A flag of its own with that value.
std::uint16_t Lowering::flag(const Operand &value) {
  const std::uint16_t index = m_code.temporary("");
  m_code.write(Opcode::Mov, destination(index, kX), {component(value, 0)});
  return index;
}

/// What branches and IF go by: any of the tested components. Not for TR and FL.
Lowering::Flag Lowering::passesAny(const Test &test) {
  const Operand each = passes(test, kAll);
  const bool alike = std::all_of(test.swizzle.begin(), test.swizzle.end(),
                                 [&](Select select) { return select == test.swizzle[0]; });
  if (alike)
    return flag(each);
  const std::uint16_t index = m_code.temporary("");
  Destination dst = destination(index, kX);
  dst.saturate = true;
  m_code.write(Opcode::Dp4, dst, {each, each});
  return index;
}

/// What runs now, as an operand; none if all does.
std::optional<Operand> Lowering::active() {
  std::optional<Operand> all;
  for (const Flag &part : {m_base, m_block, m_alive}) {
    if (!part)
      continue;
    all = all ? component(m_code.make(Opcode::Mul, {*all, flagOf(*part)}, kX), 0) : flagOf(*part);
  }
  return all;
}

/// What CMP chooses by: below zero where a write happens. None if it happens everywhere.
std::optional<Operand> Lowering::selector(const Test &test, std::uint8_t mask) {
  const std::optional<Operand> runs = active();
  if (test.rule == Rule::Tr)
    return runs ? std::optional(negated(*runs)) : std::nullopt;
  if (!runs && test.rule == Rule::Lt)
    return swizzled(temporary(conditionCode(test.condition)), test.swizzle);
  if (!runs && test.rule == Rule::Gt)
    return negated(swizzled(temporary(conditionCode(test.condition)), test.swizzle));
  const Operand each = passes(test, mask);
  return negated(runs ? m_code.make(Opcode::Mul, {each, *runs}, mask) : each);
}

/// The register that stands for a destination.
std::uint16_t Lowering::registerFor(const Destination &dst, std::uint8_t mask) {
  if (dst.file != File::Output)
    return dst.index;
  const auto [entry, isNew] = m_results.try_emplace(dst.index);
  if (isNew)
    entry->second.index = m_code.temporary("");
  entry->second.mask |= mask;
  return entry->second.index;
}

void Lowering::execute(const Statement &statement) {
  const Opcode op = statement.instruction.op;
  Instruction instruction = withBars(statement);
  if (op == Opcode::Kil)
    return kill(statement, instruction);
  if (op == Opcode::Arl || op == Opcode::Arr || op == Opcode::Ara)
    return loadAddress(statement, instruction);
  instruction.dst.mask = writtenBy(instruction);
  if (instruction.dst.mask == 0)
    return;
  const std::uint16_t target = registerFor(instruction.dst, instruction.dst.mask);
  write(statement, instruction, target);
}

/// The instruction's value, under its condition, into a register and the condition code.
void Lowering::write(const Statement &statement, Instruction instruction, std::uint16_t target) {
  if (statement.test.rule == Rule::Fl)
    return;
  const std::uint8_t mask = instruction.dst.mask;
  const std::optional<Operand> selects = selector(statement.test, mask);
  const bool aside = selects || statement.suffix.signedSaturate;
  Destination dst = aside ? m_code.scratch(mask) : destination(target, mask);
  dst.saturate = instruction.dst.saturate;
  instruction.dst = dst;
  writeInstruction(m_code, instruction);
  Operand value = temporary(dst.index);
  if (statement.suffix.signedSaturate) {
    value = m_code.make(Opcode::Max, {value, negated(number(Select::One))}, mask);
    value = m_code.make(Opcode::Min, {value, number(Select::One)}, mask);
  }
  if (selects)
    m_code.write(Opcode::Cmp, destination(target, mask), {*selects, value, temporary(target)});
  else if (aside)
    m_code.write(Opcode::Mov, destination(target, mask), {value});
  update(statement, mask, value, selects);
}

void Lowering::update(const Statement &statement, std::uint8_t mask, const Operand &value,
                      const std::optional<Operand> &selects) {
  if (statement.suffix.updates == 0)
    return;
  const std::uint16_t index = conditionCode(std::uint8_t(statement.suffix.updates - 1));
  if (selects)
    m_code.write(Opcode::Cmp, destination(index, mask), {*selects, value, temporary(index)});
  else
    m_code.write(Opcode::Mov, destination(index, mask), {value});
}

void Lowering::kill(const Statement &statement, const Instruction &instruction) {
  const std::optional<Operand> runs = active();
  if (statement.tests) {
    if (statement.test.rule == Rule::Fl)
      return;
    // selector() has what runs in it already.
    const std::optional<Operand> selects = selector(statement.test, kAll);
    m_code.write(Opcode::Kil, {}, {selects ? *selects : negated(number(Select::One))});
    return;
  }
  Operand value = instruction.src[0];
  if (runs)
    value = m_code.make(Opcode::Cmp, {negated(*runs), value, number(Select::Zero)});
  m_code.write(Opcode::Kil, {}, {value});
}

std::uint16_t Lowering::shadowOf(std::uint16_t address) {
  const auto [entry, isNew] = m_shadows.try_emplace(address, std::uint16_t(0));
  if (isNew)
    entry->second = m_code.temporary("");
  return entry->second;
}

/// The integers are kept as floats, which can be read and added, and are loaded from there.
void Lowering::loadAddress(const Statement &statement, Instruction instruction) {
  const std::uint16_t address = instruction.dst.index;
  const std::uint8_t mask = instruction.dst.mask;
  const std::uint16_t shadow = shadowOf(address);
  Operand value = instruction.src[0];
  if (instruction.op == Opcode::Ara) {
    const Operand from = temporary(shadowOf(value.index));
    value = m_code.make(Opcode::Add,
                        {swizzled(from, {Select::X, Select::Y, Select::X, Select::Y}),
                         swizzled(from, {Select::Z, Select::W, Select::Z, Select::W})});
  } else {
    value = instruction.op == Opcode::Arr ? rounded(m_code, value)
                                          : m_code.make(Opcode::Flr, {value});
    const Operand number = m_code.make(Opcode::Seq, {value, value}); // NaN is 0
    value = m_code.make(Opcode::Cmp, {negated(number), value, nv::number(Select::Zero)});
  }
  Instruction move;
  move.op = Opcode::Mov;
  move.src[0] = value;
  move.dst = destination(shadow, mask);
  write(statement, move, shadow);
  for (int i = 0; i < 4; ++i) {
    if (!(mask >> i & 1))
      continue;
    Destination dst = destination(std::uint16_t(address + i), kX);
    dst.file = File::Address;
    m_code.write(Opcode::Arl, dst, {component(temporary(shadow), i)});
  }
}

void Lowering::flow(const Statement &statement, std::size_t at) {
  switch (statement.instruction.op) {
  case Opcode::If:
    return enter(statement);
  case Opcode::Else:
    return turn();
  case Opcode::Endif:
    m_block = m_blocks.back().outer;
    m_blocks.pop_back();
    return;
  case Opcode::Bra:
    return branch(statement, at);
  case Opcode::Cal:
    return call(statement);
  default:
    break; // RET
  }
  if (statement.test.rule == Rule::Fl)
    return;
  leave(statement.test.rule == Rule::Tr ? Flag{} : passesAny(statement.test));
}

void Lowering::enter(const Statement &statement) {
  Flag inner = m_block;
  if (statement.test.rule == Rule::Fl) {
    inner = flag(number(Select::Zero));
  } else if (statement.test.rule != Rule::Tr) {
    inner = passesAny(statement.test);
    if (m_block)
      m_code.write(Opcode::Mul, destination(*inner, kX), {flagOf(*inner), flagOf(*m_block)});
  }
  m_blocks.push_back({m_block, inner});
  m_block = inner;
}

/// The outer block's, less what ran until here.
void Lowering::turn() {
  const Block &block = m_blocks.back();
  const Operand outer = block.outer ? flagOf(*block.outer) : number(Select::One);
  const Operand inner = block.inner ? flagOf(*block.inner) : number(Select::One);
  m_block = flag(m_code.make(Opcode::Sub, {outer, inner}, kX));
}

/// Takes \p lanes, of those that run, out until something lets them in again.
void Lowering::leave(const Flag &lanes) {
  if (!lanes && m_blocks.empty()) {
    m_dead = true;
    return;
  }
  const std::optional<Operand> runs = active();
  Operand leaving = lanes ? flagOf(*lanes) : number(Select::One);
  if (runs)
    leaving = component(m_code.make(Opcode::Mul, {leaving, *runs}, kX), 0);
  const Operand before = m_alive ? flagOf(*m_alive) : number(Select::One);
  m_alive = flag(m_code.make(Opcode::Sub, {before, leaving}, kX));
}

void Lowering::branch(const Statement &statement, std::size_t at) {
  if (statement.test.rule == Rule::Fl)
    return;
  if (m_places[statement.label] <= at) {
    m_reporter.error(DiagnosticId::NvFlow, statement.instruction.span,
                     "a branch backwards, a loop, is not offered yet", "write the iterations out");
    return;
  }
  const bool always = statement.test.rule == Rule::Tr;
  const Flag lanes = always ? Flag{} : passesAny(statement.test);
  const std::optional<Operand> runs = active();
  Operand going = lanes ? flagOf(*lanes) : number(Select::One);
  if (runs)
    going = component(m_code.make(Opcode::Mul, {going, *runs}, kX), 0);
  Flag &pending = m_pending[statement.label];
  if (pending)
    going = m_code.make(Opcode::Add, {component(going, 0), flagOf(*pending)}, kX);
  pending = flag(going);
  leave(lanes);
}

void Lowering::arrive(std::uint16_t label) {
  const auto found = m_pending.find(label);
  if (found == m_pending.end())
    return;
  const Operand arriving = flagOf(*found->second);
  if (m_dead)
    m_alive = found->second;
  else if (m_alive)
    m_alive = flag(m_code.make(Opcode::Add, {flagOf(*m_alive), arriving}, kX));
  m_dead = false;
  m_pending.erase(found);
}

/// The subroutine's statements stand here. It begins with what runs here, and what has left by its
/// RETs goes on behind it.
void Lowering::call(const Statement &statement) {
  if (statement.test.rule == Rule::Fl)
    return;
  const bool within =
      std::find(m_calls.begin(), m_calls.end(), statement.label) != m_calls.end();
  if (within || m_calls.size() >= kMostCalls) {
    m_reporter.error(DiagnosticId::NvFlow, statement.instruction.span,
                     within ? "a subroutine calls itself" : "more than 32 calls, one in the other",
                     "no program can be that deep");
    return;
  }
  const auto outside = std::make_tuple(m_base, m_block, m_alive, m_blocks, m_pending);
  const std::optional<Operand> runs = active();
  Flag lanes = runs ? Flag(flag(*runs)) : Flag{};
  if (statement.test.rule != Rule::Tr) {
    lanes = passesAny(statement.test);
    if (runs)
      m_code.write(Opcode::Mul, destination(*lanes, kX), {flagOf(*lanes), *runs});
  }
  m_base = lanes;
  m_block.reset();
  m_alive.reset();
  m_blocks.clear();
  m_pending.clear();
  m_calls.push_back(statement.label);
  walk(m_places[statement.label]);
  m_calls.pop_back();
  std::tie(m_base, m_block, m_alive, m_blocks, m_pending) = outside;
  m_dead = false;
}
} // namespace

void lower(const std::vector<Statement> &statements, std::optional<std::uint16_t> start,
           Binder &binder, Reporter &reporter) {
  Lowering(statements, binder, reporter).run(start);
}

} // namespace arbiter::fp::nv
