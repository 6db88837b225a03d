#include "fp_compiler/front/nv/lowering.h"

#include "fp_compiler/front/nv/lowerer.h"
#include "fp_compiler/front/nv/words_code.h"

namespace arbiter::fp::nv {

Lowerer::Lowerer(const std::vector<Statement> &statements, const Sequences &sequences,
                 Binder &binder, Reporter &reporter, const NativeRules &rules)
    : m_statements(statements), m_sequences(sequences), m_rules(rules), m_reporter(reporter),
      m_code(binder) {
  for (std::size_t i = 0; i < statements.size(); ++i)
    if (statements[i].isLabel)
      m_places[statements[i].label] = i;
}

void Lowerer::run(std::optional<std::uint16_t> start) {
  if (m_rules.vertex || m_rules.language != ir::NativeLanguage::None)
    beginResults();
  function(start ? m_places[*start] : 0);
  m_code.begin(m_statements.empty() ? Span{} : m_statements.back().instruction.span);
  for (const auto &[output, result] : m_results) {
    Destination dst = writtenTo(output, result.mask);
    dst.file = File::Output;
    m_code.write(Opcode::Mov, dst, {temporary(result.index)});
  }
}

/// Returns the statement's instruction with operands that the IR can have.
Instruction Lowerer::instructionOf(const Statement &statement) {
  Instruction instruction = statement.instruction;
  const bool extended =
      instruction.op == Opcode::Swz; // its selectors and signs are outside of bars
  for (std::size_t i = 0; i < 3; ++i) {
    Operand &operand = instruction.src[i];
    if (statement.indexed[i])
      operand = indexed(*statement.indexed[i], operand);
    if (operand.file == File::Temporary)
      operand.index = current(operand.index);
    if (!m_rules.rows.empty() && operand.file == File::Parameter)
      operand = written(operand);
    if (!(statement.absolute >> i & 1))
      continue;
    Operand inside = operand;
    inside.negate = 0;
    if (extended)
      inside.swizzle = ir::kIdentity;
    const Operand value = m_code.make(Opcode::Abs, {inside});
    const std::uint8_t signs = operand.negate;
    const bool scalar = info(instruction.op).shapes[i] == 'S' && instruction.op != Opcode::Arl;
    operand = extended ? swizzled(value, operand.swizzle) : scalar ? component(value, 0) : value;
    operand.negate = signs;
  }
  return instruction;
}

/// Returns the address that an index uses. A0 of a fragment program is at least zero.
Operand Lowerer::indexValue(const Indexed &indexed) {
  const Operand offset = m_code.constant(float(indexed.offset));
  const std::uint16_t first = std::uint16_t(indexed.address & ~3);
  Operand address = number(Select::Zero);
  if (const auto shadow = m_shadows.find(first); shadow != m_shadows.end())
    address = component(temporary(shadow->second), indexed.address & 3);
  for (auto loop = m_loops.rbegin(); loop != m_loops.rend(); ++loop)
    if (loop->counts) {
      address = component(temporary(loop->index), 0);
      address = component(m_code.make(Opcode::Max, {address, number(Select::Zero)}, kX), 0);
      break;
    }
  return component(m_code.make(Opcode::Add, {address, offset}, kX), 0);
}

/// Returns the row of the sequence that the address selects; zero if there is none.
Operand Lowerer::indexed(const Indexed &indexed, const Operand &operand) {
  const Operand at = indexValue(indexed);
  const Destination dst = m_code.scratch();
  const Operand chosen = temporary(dst.index);
  m_code.write(Opcode::Mov, dst, {number(Select::Zero)});
  const std::vector<std::uint16_t> &rows = m_sequences[indexed.sequence];
  const Operand is = temporary(m_code.scratch(kX).index);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    m_code.write(Opcode::Seq, writtenTo(is.index, kX), {at, m_code.constant(float(i))});
    m_code.write(Opcode::Cmp, dst,
                 {negated(component(is, 0)), registerOf(File::Attribute, rows[i]), chosen});
  }
  Operand result = swizzled(chosen, operand.swizzle);
  result.negate = operand.negate;
  return result;
}

std::uint16_t Lowerer::conditionCode(std::uint8_t index) {
  Flag &condition = m_conditions[index];
  if (!condition)
    condition = m_code.temporary(index == 0 ? "CC0" : "CC1");
  return *condition;
}

/// Returns 1 or 0 for each component in \p mask. A comparison with NaN holds only for NE.
Operand Lowerer::passes(const Test &test, std::uint8_t mask) {
  const Operand value = swizzled(temporary(current(conditionCode(test.condition))), test.swizzle);
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

/// Returns the operand that CMP selects by: below zero where the write happens. Returns nothing if
/// it happens everywhere.
std::optional<Operand> Lowerer::selector(const Test &test, std::uint8_t mask) {
  const std::optional<Operand> runs = active();
  if (test.rule == Rule::Tr)
    return runs ? std::optional(negated(*runs)) : std::nullopt;
  const bool direct = !runs && (test.rule == Rule::Lt || test.rule == Rule::Gt);
  if (direct) {
    const Operand value = swizzled(temporary(current(conditionCode(test.condition))), test.swizzle);
    return test.rule == Rule::Lt ? value : negated(value);
  }
  const Operand each = passes(test, mask);
  return negated(runs ? m_code.make(Opcode::Mul, {each, *runs}, mask) : each);
}

/// Returns the register that stands for a result.
std::uint16_t Lowerer::registerFor(std::uint16_t output, std::uint8_t mask) {
  const auto [entry, isNew] = m_results.try_emplace(output);
  if (isNew)
    entry->second.index = m_code.temporary("");
  entry->second.mask |= mask;
  return entry->second.index;
}

void Lowerer::execute(const Statement &statement) {
  const Opcode op = statement.instruction.op;
  Instruction instruction = instructionOf(statement);
  if (op == Opcode::Kil)
    return kill(statement, instruction);
  if (op == Opcode::Arl || op == Opcode::Arr || op == Opcode::Ara)
    return loadAddress(statement, instruction);
  instruction.dst.mask = writtenBy(instruction);
  if (instruction.dst.mask == 0)
    return;
  if (statement.indexedResult)
    return writeIndexed(statement, instruction);
  const Destination &dst = instruction.dst;
  write(statement, instruction,
        dst.file == File::Output ? registerFor(dst.index, dst.mask) : dst.index);
}

/// Writes a result that an address selects. Every result of the sequence gets its old value or the
/// new one.
void Lowerer::writeIndexed(const Statement &statement, const Instruction &instruction) {
  const Operand at = indexValue(*statement.indexedResult);
  const std::uint8_t mask = instruction.dst.mask;
  const std::uint16_t value = m_code.scratch(mask).index;
  if (statement.test.rule == Rule::Fl)
    return;
  const std::optional<Operand> selects = selector(statement.test, mask);
  Instruction computed = instruction;
  computed.dst = writtenTo(value, mask);
  computed.dst.saturate = instruction.dst.saturate;
  compute(statement, computed);
  const std::vector<std::uint16_t> &rows = m_sequences[statement.indexedResult->sequence];
  const Operand is = temporary(m_code.scratch(kX).index);
  const Operand mixed = temporary(m_code.scratch(mask).index);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::uint16_t target = aside(registerFor(rows[i], mask), mask);
    m_code.write(Opcode::Seq, writtenTo(is.index, kX), {at, m_code.constant(float(i))});
    m_code.write(Opcode::Cmp, writtenTo(mixed.index, mask),
                 {negated(component(is, 0)), temporary(value), temporary(target)});
    if (selects)
      m_code.write(Opcode::Cmp, writtenTo(target, mask), {*selects, mixed, temporary(target)});
    else
      m_code.write(Opcode::Mov, writtenTo(target, mask), {mixed});
  }
  update(statement, mask, temporary(value), selects);
}

/// Writes the instruction's value to a register and to the condition code, under its condition.
void Lowerer::write(const Statement &statement, Instruction instruction, std::uint16_t target) {
  if (statement.test.rule == Rule::Fl)
    return;
  const std::uint8_t mask = instruction.dst.mask;
  const std::optional<Operand> selects = selector(statement.test, mask);
  target = aside(target, mask);
  const bool later = selects || statement.suffix.signedSaturate;
  Destination dst = later ? m_code.scratch(mask) : writtenTo(target, mask);
  dst.saturate = instruction.dst.saturate;
  instruction.dst = dst;
  compute(statement, instruction);
  Operand value = temporary(dst.index);
  if (statement.suffix.signedSaturate) {
    value = m_code.make(Opcode::Max, {value, negated(number(Select::One))}, mask);
    value = m_code.make(Opcode::Min, {value, number(Select::One)}, mask);
  }
  if (selects)
    m_code.write(Opcode::Cmp, writtenTo(target, mask), {*selects, value, temporary(target)});
  else if (later)
    m_code.write(Opcode::Mov, writtenTo(target, mask), {value});
  update(statement, mask, value, selects);
}

void Lowerer::update(const Statement &statement, std::uint8_t mask, const Operand &value,
                     const std::optional<Operand> &selects) {
  if (statement.suffix.updates == 0)
    return;
  const std::uint16_t index =
      aside(conditionCode(std::uint8_t(statement.suffix.updates - 1)), mask);
  if (selects)
    m_code.write(Opcode::Cmp, writtenTo(index, mask), {*selects, value, temporary(index)});
  else
    m_code.write(Opcode::Mov, writtenTo(index, mask), {value});
}

void Lowerer::kill(const Statement &statement, const Instruction &instruction) {
  Operand value = instruction.src[0];
  if (statement.tests) {
    if (statement.test.rule == Rule::Fl)
      return;
    const std::optional<Operand> selects = selector(statement.test, kAll);
    value = selects ? *selects : negated(number(Select::One));
  }
  // A test already includes which lanes run, except for selections.
  if (const std::optional<Operand> runs =
          statement.tests && m_selections.empty() ? std::nullopt : activeInSelections())
    value = m_code.make(Opcode::Cmp, {negated(*runs), value, number(Select::Zero)});
  m_code.write(Opcode::Kil, {}, {value});
}

std::uint16_t Lowerer::shadowOf(std::uint16_t address) {
  const auto [entry, isNew] = m_shadows.try_emplace(address, std::uint16_t(0));
  if (isNew)
    entry->second = m_code.temporary("");
  return entry->second;
}

/// Returns the value that ARL, ARR or ARA loads: integers, as floats. NaN gives 0. !!VP2.0 clamps
/// them to the range of an address register (NV_vertex_program2 2.14.1.10).
Operand Lowerer::addressValue(const Instruction &instruction) {
  const Operand &source = instruction.src[0];
  if (instruction.op == Opcode::Ara) {
    const Operand from = temporary(shadowOf(source.index));
    return kept(
        m_code.make(Opcode::Add, {swizzled(from, {Select::X, Select::Y, Select::X, Select::Y}),
                                  swizzled(from, {Select::Z, Select::W, Select::Z, Select::W})}));
  }
  const Operand value =
      instruction.op == Opcode::Arr ? rounded(m_code, source) : m_code.make(Opcode::Flr, {source});
  const Operand isNumber = m_code.make(Opcode::Seq, {value, value});
  return kept(m_code.make(Opcode::Cmp, {negated(isNumber), value, number(Select::Zero)}));
}

/// Loads an address register. A float copy is kept, because it can be read and added.
void Lowerer::loadAddress(const Statement &statement, const Instruction &instruction) {
  Instruction move;
  move.op = Opcode::Mov;
  move.src[0] = addressValue(instruction);
  move.dst.mask = instruction.dst.mask;
  fillAddress(statement, move, instruction.dst.index);
}

void Lowerer::fillAddress(const Statement &statement, const Instruction &move,
                          std::uint16_t address) {
  const std::uint16_t shadow = shadowOf(address);
  const std::uint8_t mask = move.dst.mask;
  write(statement, move, shadow);
  for (int i = 0; i < 4; ++i) {
    if (!(mask >> i & 1))
      continue;
    Destination dst = writtenTo(std::uint16_t(address + i), kX);
    dst.file = File::Address;
    m_code.write(Opcode::Arl, dst, {component(temporary(shadow), i)});
  }
}

/// Pushes an address. Every place of the stack gets its old value, and the first free one the
/// address.
void Lowerer::push(const Statement &statement) {
  const Operand value = temporary(shadowOf(statement.instruction.src[0].index));
  const std::optional<Operand> runs = active();
  if (!m_depth)
    m_depth = m_code.temporary("");
  const Operand depth = component(temporary(*m_depth), 0);
  for (std::size_t i = 0; i < m_stack.size(); ++i) {
    if (!m_stack[i])
      m_stack[i] = m_code.temporary("");
    const Operand place = temporary(*m_stack[i]);
    Operand here = component(m_code.make(Opcode::Seq, {depth, m_code.constant(float(i))}, kX), 0);
    if (runs)
      here = component(m_code.make(Opcode::Mul, {here, *runs}, kX), 0);
    m_code.write(Opcode::Cmp, writtenTo(*m_stack[i], kAll), {negated(here), value, place});
  }
  m_code.write(Opcode::Add, writtenTo(*m_depth, kX), {depth, runs ? *runs : number(Select::One)});
}

/// Pops the last value of the stack; zero if it is empty.
void Lowerer::pop(const Statement &statement) {
  const std::optional<Operand> runs = active();
  if (!m_depth)
    m_depth = m_code.temporary("");
  const Operand depth = component(temporary(*m_depth), 0);
  m_code.write(Opcode::Sub, writtenTo(*m_depth, kX), {depth, runs ? *runs : number(Select::One)});
  const Destination dst = m_code.scratch();
  m_code.write(Opcode::Mov, dst, {number(Select::Zero)});
  for (std::size_t i = 0; i < m_stack.size(); ++i) {
    if (!m_stack[i])
      continue;
    const Operand here =
        component(m_code.make(Opcode::Seq, {depth, m_code.constant(float(i))}, kX), 0);
    m_code.write(Opcode::Cmp, dst, {negated(here), temporary(*m_stack[i]), temporary(dst.index)});
  }
  Instruction move;
  move.op = Opcode::Mov;
  move.src[0] = temporary(dst.index);
  fillAddress(statement, move, statement.instruction.dst.index);
}

void lower(const std::vector<Statement> &statements, std::optional<std::uint16_t> start,
           const Sequences &sequences, Binder &binder, Reporter &reporter,
           const NativeRules &rules) {
  Lowerer(statements, sequences, binder, reporter, rules).run(start);
}

} // namespace arbiter::fp::nv
