#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/opt/known.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/values.h"

namespace arbiter::fp::opt {

namespace {
constexpr std::uint8_t kX = 1, kAll = 0xF;
/// Maximum number of instructions that the loops may become. The lower limit holds if values decide
/// some BRK: a real loop could then exit early, but the rewritten code cannot.
constexpr std::size_t kMaxDecided = 1024, kMaxSelected = 192;
/// Maximum number of steps. A loop that needs more is kept.
constexpr std::size_t kMaxSteps = 8192;

Operand temporary(std::uint16_t index) {
  Operand operand;
  operand.index = index;
  return operand;
}

Operand firstOf(std::uint16_t index) {
  Operand operand = temporary(index);
  operand.swizzle.fill(Select::X);
  return operand;
}

/// Executes a program symbolically with its known constants, and records the instructions on the
/// path. After a BRK that constants do not decide, writes go to fresh registers. At the end of the
/// loop, selects restore the values of the invocations that left at the BRK.
class Follower {
public:
  Follower(ir::Program &program, Numerics numerics)
      : m_program(program), m_rows(program),
        m_known(program, ir::numericsOf(program.language, numerics)) {
    for (const Instruction &instruction : program.code)
      m_kills |= instruction.op == Opcode::Kil;
  }

  bool run() {
    const std::size_t registers = m_program.temporaries.size(), rows = m_program.parameters.size();
    findEnds();
    bool done = true;
    std::size_t steps = 0;
    for (std::size_t at = 0; done && at < m_program.code.size(); ++steps)
      done = steps < m_outside + kMaxSteps && step(at) &&
             m_made.size() <= m_outside + (m_selected ? kMaxSelected : kMaxDecided);
    if (!done) {
      m_program.temporaries.resize(registers);
      m_program.parameters.resize(rows);
      return false;
    }
    m_program.code = std::move(m_made);
    return true;
  }

private:
  struct Aside {
    std::uint16_t index = 0;
    std::uint8_t mask = 0;
  };
  /// The code after a BRK at which some invocations may have left the loop.
  struct Scope {
    std::uint16_t goesOn = 0; ///< register whose x is 1 for invocations still in the loop
    std::map<std::uint16_t, Aside> asides;
  };
  struct Loop {
    std::size_t begin = 0, end = 0; ///< of its body; of its ENDREP
    std::uint64_t left = 0;         ///< iterations after this one
    std::size_t scopes = 0;         ///< number of scopes open outside the loop
  };

  void findEnds() {
    std::vector<std::size_t> open;
    for (std::size_t at = 0; at < m_program.code.size(); ++at) {
      if (m_program.code[at].op == Opcode::Rep)
        open.push_back(at);
      m_outside += open.empty() ? 1 : 0;
      if (m_program.code[at].op != Opcode::Endrep)
        continue;
      m_ends[open.back()] = at;
      open.pop_back();
    }
  }

  bool step(std::size_t &at) {
    Instruction instruction = m_program.code[at];
    const int operands = ir::info(instruction.op).operandCount();
    for (int i = 0; i < operands; ++i) {
      Operand &operand = instruction.src[std::size_t(i)];
      if (operand.file == File::Temporary)
        operand.index = current(operand.index);
    }
    switch (instruction.op) {
    case Opcode::Rep:
      return begin(instruction, at);
    case Opcode::Endrep:
      if (m_loops.back().left != 0) {
        --m_loops.back().left;
        at = m_loops.back().begin;
      } else {
        leave(at);
      }
      return true;
    case Opcode::Brk:
      return leaves(instruction, at);
    default:
      ++at;
      return pass(instruction);
    }
  }

  bool begin(const Instruction &instruction, std::size_t &at) {
    const std::optional<float> count = m_known.at(instruction.src[0], 0);
    if (!count)
      return false;
    const std::uint64_t times = ir::iterations(*count);
    const std::size_t end = m_ends.at(at);
    if (times == 0) {
      at = end + 1;
      return true;
    }
    m_loops.push_back({at + 1, end, times - 1, m_scopes.size()});
    ++at;
    return true;
  }

  bool leaves(const Instruction &instruction, std::size_t &at) {
    const std::optional<float> value = m_known.at(instruction.src[0], 0);
    if (value) {
      if (*value == 0.0f)
        ++at;
      else
        leave(at);
      return true;
    }
    m_selected = true;
    Scope scope;
    scope.goesOn = fresh();
    Operand zero;
    zero.swizzle.fill(Select::Zero);
    append(Opcode::Seq, scope.goesOn, kX, {instruction.src[0], zero, {}}, instruction);
    if (m_kills && !m_scopes.empty())
      append(Opcode::Mul, scope.goesOn, kX,
             {firstOf(scope.goesOn), firstOf(m_scopes.back().goesOn), {}}, instruction);
    m_scopes.push_back(std::move(scope));
    ++at;
    return true;
  }

  /// Closes the innermost loop and continues after it.
  void leave(std::size_t &at) {
    const Loop loop = m_loops.back();
    m_loops.pop_back();
    at = loop.end + 1;
    while (m_scopes.size() > loop.scopes) {
      const Scope scope = std::move(m_scopes.back());
      m_scopes.pop_back();
      for (const auto &[index, aside] : scope.asides) {
        Operand goesOn = firstOf(scope.goesOn);
        goesOn.negate = 0xF;
        const Operand old = temporary(current(index));
        const std::uint16_t target = targetOf(index, aside.mask, m_program.code[loop.end]);
        append(Opcode::Cmp, target, aside.mask, {goesOn, temporary(aside.index), old},
               m_program.code[loop.end]);
      }
    }
  }

  /// Appends an instruction that is not flow control.
  bool pass(Instruction instruction) {
    if (!m_scopes.empty() && !mayStandInScope(instruction))
      return false;
    if (instruction.op == Opcode::Kil && !m_scopes.empty()) {
      Operand goesOn = firstOf(m_scopes.back().goesOn), zero;
      goesOn.negate = 0xF;
      zero.swizzle.fill(Select::Zero);
      const std::uint16_t value = fresh();
      append(Opcode::Cmp, value, kAll, {goesOn, instruction.src[0], zero}, instruction);
      instruction.src[0] = temporary(value);
    }
    if (ir::info(instruction.op).hasDestination() && instruction.dst.file == File::Temporary)
      instruction.dst.index = targetOf(instruction.dst.index, instruction.dst.mask, instruction);
    m_made.push_back(instruction);
    note(instruction);
    return true;
  }

  /// True if the instruction may stand in a scope. Instructions that read neighbours may not,
  /// because those may have left the loop. Other writes than to temporaries may not, because they
  /// have no fresh register.
  static bool mayStandInScope(const Instruction &instruction) {
    switch (instruction.op) {
    case Opcode::Tex:
    case Opcode::Txp:
    case Opcode::Txb:
    case Opcode::Ddx:
    case Opcode::Ddy:
      return false;
    case Opcode::Kil:
      return true;
    default:
      return instruction.dst.file == File::Temporary;
    }
  }

  std::uint16_t current(std::uint16_t index) const {
    for (auto scope = m_scopes.rbegin(); scope != m_scopes.rend(); ++scope)
      if (const auto found = scope->asides.find(index); found != scope->asides.end())
        return found->second.index;
    return index;
  }

  /// Returns the register to write in place of \p index. In a scope this is a fresh register that
  /// starts as a copy.
  std::uint16_t targetOf(std::uint16_t index, std::uint8_t mask, const Instruction &at) {
    if (m_scopes.empty())
      return index;
    const std::uint16_t before = current(index);
    const auto [entry, isNew] = m_scopes.back().asides.try_emplace(index);
    if (isNew) {
      entry->second.index = fresh();
      append(Opcode::Mov, entry->second.index, kAll, {temporary(before), {}, {}}, at);
    }
    entry->second.mask |= mask;
    return entry->second.index;
  }

  std::uint16_t fresh() {
    m_program.temporaries.emplace_back();
    m_known.addTemporary();
    return std::uint16_t(m_program.temporaries.size() - 1);
  }

  void append(Opcode op, std::uint16_t target, std::uint8_t mask,
              const std::array<Operand, 3> &operands, const Instruction &at) {
    Instruction instruction;
    instruction.op = op;
    instruction.dst.index = target;
    instruction.dst.mask = mask;
    instruction.src = operands;
    instruction.span = instruction.dst.span = at.span;
    for (Operand &operand : instruction.src)
      operand.span = at.span;
    m_made.push_back(instruction);
    note(instruction);
  }

  /// Updates the known values with the result of the instruction.
  void note(const Instruction &instruction) {
    if (!ir::info(instruction.op).hasDestination() || instruction.dst.file != File::Temporary)
      return;
    const KnownValues::Components result = m_known.results(instruction);
    shorten(m_made.back(), result);
    m_known.set(instruction.dst, result);
  }

  /// Turns a known result into a constant, and a CMP with known outcome into a copy. The later
  /// passes would otherwise need one round for each link of a chain.
  void shorten(Instruction &made, const KnownValues::Components &result) {
    const std::uint8_t mask = made.dst.mask;
    ir::Vec4 value = {};
    std::uint8_t known = 0, first = 0, second = 0;
    for (int i = 0; i < 4; ++i) {
      if (!(mask >> i & 1))
        continue;
      const auto bit = std::uint8_t(1 << i);
      if (const auto &each = result[std::size_t(i)]; each && std::isfinite(*each)) {
        value[std::size_t(i)] = *each;
        known |= bit;
      }
      if (made.op == Opcode::Cmp && !made.dst.saturate)
        if (const std::optional<float> chooses = m_known.at(made.src[0], i))
          (*chooses < 0.0f ? first : second) |= bit;
    }
    if (known == mask && m_rows.hasRoom())
      made.src = {m_rows.operand(value, made.span), {}, {}};
    else if (first == mask || second == mask)
      made.src = {made.src[first == mask ? 1 : 2], {}, {}};
    else
      return;
    made.op = Opcode::Mov;
    made.dst.saturate = false;
  }

  ir::Program &m_program;
  ConstantRows m_rows;
  std::size_t m_outside = 0; ///< number of instructions outside loops
  bool m_kills = false;
  bool m_selected = false;                   ///< a BRK occurred that constants do not decide
  std::map<std::size_t, std::size_t> m_ends; ///< maps each REP to its ENDREP
  KnownValues m_known;
  std::vector<Loop> m_loops;
  std::vector<Scope> m_scopes;
  std::vector<Instruction> m_made;
};
} // namespace

bool followLoops(ir::Program &program, Numerics numerics) {
  return ir::hasLoops(program) && Follower(program, numerics).run();
}

} // namespace arbiter::fp::opt
