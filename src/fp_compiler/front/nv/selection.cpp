#include "fp_compiler/front/nv/lowerer.h"

namespace arbiter::fp::nv {

/// True for an IF that has only instructions, and IFs of that kind, up to its ENDIF.
bool Lowerer::selects(const Statement &statement) const {
  if (statement.test.rule == Rule::Tr || statement.test.rule == Rule::Fl)
    return false;
  std::size_t depth = 0;
  for (std::size_t at = std::size_t(&statement - m_statements.data()); at < m_statements.size();
       ++at) {
    const Opcode op = m_statements[at].instruction.op;
    if (m_statements[at].isLabel)
      return false;
    if (op == Opcode::If)
      ++depth;
    else if (op == Opcode::Endif && --depth == 0)
      return true;
    else if (op != Opcode::Else && op != Opcode::Endif && info(op).has(ir::Flow))
      return false;
  }
  return false;
}

/// True if the loop contains a RET of the function.
bool Lowerer::returnsWithin(const Statement &loop) const {
  std::size_t depth = 0;
  for (std::size_t at = std::size_t(&loop - m_statements.data()); at < m_statements.size(); ++at) {
    const Opcode op = m_statements[at].instruction.op;
    if (m_statements[at].isLabel)
      continue;
    depth += op == Opcode::Loop || op == Opcode::Rep ? 1 : 0;
    depth -= op == Opcode::Endloop || op == Opcode::Endrep ? 1 : 0;
    if (op == Opcode::Ret)
      return true;
    if (depth == 0)
      break;
  }
  return false;
}

void Lowerer::beginSelection(const Statement &statement) {
  const Flag holds = passesAny(statement.test);
  m_function.blocks.push_back({m_function.block, m_function.block, true});
  m_selections.push_back({*holds, false, {}});
}

/// Joins the two parts of an IF: each lane takes its part's value of every register that a part
/// wrote.
void Lowerer::endSelection() {
  const Selection selection = m_selections.back();
  m_selections.pop_back();
  const Operand holds = negated(flagOf(selection.holds));
  const auto &[first, second] = selection.parts;
  std::map<std::uint16_t, std::uint8_t> written;
  for (const auto &part : selection.parts)
    for (const auto &[index, aside] : part)
      written[index] |= aside.mask;
  const auto join = [&](std::uint16_t index, std::uint8_t mask, const Aside *a, const Aside *b) {
    if (mask == 0)
      return;
    const Operand old = temporary(current(index));
    m_code.write(Opcode::Cmp, writtenTo(aside(index, mask), mask),
                 {holds, a ? temporary(a->index) : old, b ? temporary(b->index) : old});
  };
  for (const auto &[index, mask] : written) {
    const auto a = first.find(index), b = second.find(index);
    const Aside *const inFirst = a == first.end() ? nullptr : &a->second;
    const Aside *const inSecond = b == second.end() ? nullptr : &b->second;
    const std::uint8_t ofFirst = inFirst ? inFirst->mask : std::uint8_t(0);
    const std::uint8_t ofSecond = inSecond ? inSecond->mask : std::uint8_t(0);
    join(index, ofFirst & ofSecond, inFirst, inSecond);
    join(index, std::uint8_t(ofFirst & ~ofSecond), inFirst, nullptr);
    join(index, std::uint8_t(ofSecond & ~ofFirst), nullptr, inSecond);
  }
}

/// Returns the register that holds the current value of a register.
std::uint16_t Lowerer::current(std::uint16_t index) const {
  for (auto selection = m_selections.rbegin(); selection != m_selections.rend(); ++selection) {
    const auto &part = selection->parts[selection->turned];
    if (const auto found = part.find(index); found != part.end())
      return found->second.index;
  }
  return index;
}

/// Returns the register to write in place of another one: the register itself, or inside a
/// selection the part's own, which starts as a copy.
std::uint16_t Lowerer::aside(std::uint16_t index, std::uint8_t mask) {
  if (m_selections.empty())
    return index;
  const std::uint16_t before = current(index);
  Selection &selection = m_selections.back();
  const auto [entry, isNew] = selection.parts[selection.turned].try_emplace(index);
  if (isNew) {
    entry->second.index = m_code.temporary("");
    m_code.write(Opcode::Mov, writtenTo(entry->second.index, kAll), {temporary(before)});
  }
  entry->second.mask |= mask;
  return entry->second.index;
}

/// Returns active(), without the lanes that belong to the other part of a selection.
std::optional<Operand> Lowerer::activeInSelections() {
  std::optional<Operand> all = active();
  for (const Selection &selection : m_selections) {
    Operand part = flagOf(selection.holds);
    if (selection.turned)
      part = component(m_code.make(Opcode::Sub, {number(Select::One), part}, kX), 0);
    all = all ? component(m_code.make(Opcode::Mul, {*all, part}, kX), 0) : part;
  }
  return all;
}

} // namespace arbiter::fp::nv
