// Rewrites relative addressing for ARB_vertex_program, which defines only reads within an array and
// no NaN.
#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "fp_compiler/back/assembly/assembly.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp {

using ir::File;
using ir::Instruction;
using ir::Opcode;
using ir::Operand;

namespace {
/// Range of the offset that the grammar allows beside an address (ARB_vertex_program 2.14.2).
constexpr int kLeastOffset = -64, kMaxOffset = 63;
/// Constants that the rewrite adds: zero, and the two bounds of addresses.
constexpr int kConstants = 3;
/// Number of clamps between value and address: !!VP2.0 clamps addresses with MAX and MIN.
constexpr int kMaxSteps = 2;

Operand temporary(std::size_t index) {
  Operand operand;
  operand.index = std::uint16_t(index);
  return operand;
}

class Addresses {
public:
  Addresses(ir::Program &program, const AssemblyLimits &most) : m_program(program), m_most(most) {}

  bool run() {
    if (!measure())
      return true; // no operand is relative
    if (addresses() > m_most.addresses || !enlarge())
      return false;
    const std::vector<Instruction> code = std::move(m_program.code);
    m_program.code.clear();
    m_low = constant(float(-m_last - 1));
    m_high = constant(float(m_size - m_first));
    for (std::size_t i = 0; i < code.size(); ++i)
      write(code, i);
    return true;
  }

private:
  /// Finds the range of offsets and the longest array. Returns false if no operand is relative.
  bool measure() {
    bool any = false;
    for (const Instruction &instruction : m_program.code)
      for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i) {
        const Operand &operand = instruction.src[std::size_t(i)];
        if (!operand.relative)
          continue;
        m_first = any ? std::min(m_first, int(operand.offset)) : operand.offset;
        m_last = any ? std::max(m_last, int(operand.offset)) : operand.offset;
        m_size = std::max(m_size, int(m_program.arrays[operand.index].rows.size()));
        any = true;
      }
    return any;
  }

  /// Returns the number of address registers that are loaded or read.
  [[nodiscard]] int addresses() const {
    std::set<std::size_t> used;
    for (const Instruction &instruction : m_program.code) {
      if (instruction.op == Opcode::Arl)
        used.insert(instruction.dst.index);
      for (const Operand &operand : instruction.src)
        if (operand.relative)
          used.insert(operand.address);
    }
    return int(used.size());
  }

  /// Pads each array with zeros on both sides, as far as an address clamped to [m_low, m_high] can
  /// reach. Returns false if the text would exceed a limit.
  bool enlarge() {
    const int margin = m_last - m_first + 1, size = m_size + 2 * margin;
    if (m_first + margin < kLeastOffset || m_last + margin > kMaxOffset ||
        size * int(m_program.arrays.size()) + int(m_program.parameters.size()) + kConstants >
            m_most.parameters)
      return false;
    m_zero = constant(0.0f);
    for (ir::ParameterArray &array : m_program.arrays) {
      array.rows.insert(array.rows.begin(), std::size_t(margin), m_zero);
      array.rows.resize(std::size_t(size), m_zero);
    }
    for (Instruction &instruction : m_program.code)
      for (Operand &operand : instruction.src)
        if (operand.relative)
          operand.offset = std::int16_t(operand.offset + margin);
    return true;
  }

  std::uint16_t constant(float value) {
    ir::Parameter row;
    row.kind = ir::ParameterKind::Constant;
    row.constant = {value, value, value, value};
    m_program.parameters.push_back(row);
    return std::uint16_t(m_program.parameters.size() - 1);
  }

  static Operand parameter(std::uint16_t index) {
    Operand operand;
    operand.file = File::Parameter;
    operand.index = index;
    return operand;
  }

  /// Returns one of the added temporaries. Only the instructions right after a write read it, so
  /// that all addresses can share them.
  std::uint16_t scratch(std::size_t which) {
    std::optional<std::uint16_t> &known = m_scratch.at(which);
    if (!known) {
      m_program.temporaries.emplace_back();
      known = std::uint16_t(m_program.temporaries.size() - 1);
    }
    return *known;
  }

  void add(Opcode op, std::uint16_t to, std::uint8_t mask, const Operand &a, const Operand &b) {
    Instruction instruction;
    instruction.op = op;
    instruction.dst.index = to;
    instruction.dst.mask = mask;
    instruction.src = {a, b, {}};
    m_program.code.push_back(instruction);
  }

  /// Clamps a value to the index range of the padded arrays. MAX returns its second operand if the
  /// first is NaN (2.14.5.17).
  void hold(std::uint16_t to, std::uint8_t mask, const Operand &value) {
    add(Opcode::Max, to, mask, value, parameter(m_low));
    add(Opcode::Min, to, mask, temporary(to), parameter(m_high));
  }

  void write(const std::vector<Instruction> &code, std::size_t at) {
    Instruction instruction = code[at];
    if (isFlagOfZeroedNan(code, at))
      return; // nothing reads it any more
    if (isZeroedNan(code, at)) {
      const Operand value = instruction.src[1];
      const std::uint8_t mask = instruction.dst.mask;
      const std::uint16_t held = scratch(0), number = scratch(1), other = scratch(2);
      // The number is 1, or 0 for NaN.
      add(Opcode::Slt, number, mask, value, parameter(m_zero));
      add(Opcode::Sge, other, mask, value, parameter(m_zero));
      add(Opcode::Add, number, mask, temporary(number), temporary(other));
      hold(held, mask, value);
      add(Opcode::Mul, instruction.dst.index, mask, temporary(held), temporary(number));
      return;
    }
    if (instruction.op == Opcode::Arl && !isHeld(code, at)) {
      const std::uint16_t held = scratch(0);
      hold(held, 1, instruction.src[0]);
      instruction.src[0] = temporary(held);
      instruction.src[0].swizzle = {ir::Select::X, ir::Select::X, ir::Select::X, ir::Select::X};
    }
    m_program.code.push_back(instruction);
  }

  /// True if the address is loaded from a value that write() has clamped already.
  bool isHeld(const std::vector<Instruction> &code, std::size_t at) const {
    const Operand &source = code[at].src[0];
    if (source.file != File::Temporary || source.negate != 0 || source.relative || m_last < -1 ||
        m_first > m_size)
      return false;
    const std::uint8_t component = ir::registerMask(code[at], 0);
    for (std::size_t i = at; i-- > 0;)
      if (writes(code[i], source.index) && (ir::writeMask(code[i]) & component) != 0)
        return isZeroedNan(code, i);
    return false;
  }

  static bool writes(const Instruction &instruction, std::uint16_t index) {
    return ir::writeMask(instruction) != 0 && instruction.dst.file == File::Temporary &&
           instruction.dst.index == index;
  }

  static bool reads(const Instruction &instruction, std::uint16_t index, std::uint8_t components) {
    for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i) {
      const Operand &operand = instruction.src[std::size_t(i)];
      if (operand.file == File::Temporary && operand.index == index &&
          (ir::registerMask(instruction, i) & components) != 0)
        return true;
    }
    return false;
  }

  /// Returns the instructions that read the result of the one at \p at, until its temporary is
  /// overwritten.
  static std::vector<std::size_t> readersOf(const std::vector<Instruction> &code, std::size_t at) {
    const std::uint16_t index = code[at].dst.index;
    std::uint8_t components = ir::writeMask(code[at]);
    std::vector<std::size_t> readers;
    for (std::size_t i = at + 1; i < code.size() && components != 0; ++i) {
      if (reads(code[i], index, components))
        readers.push_back(i);
      if (writes(code[i], index))
        components &= std::uint8_t(~ir::writeMask(code[i]));
    }
    return readers;
  }

  /// True for a SEQ that only a pattern of isZeroedNan() reads.
  bool isFlagOfZeroedNan(const std::vector<Instruction> &code, std::size_t at) const {
    if (code[at].op != Opcode::Seq || code[at].dst.file != File::Temporary)
      return false;
    const std::vector<std::size_t> readers = readersOf(code, at);
    return readers.size() == 1 && isZeroedNan(code, readers[0]);
  }

  /// True for `SEQ f, v, v; CMP r, -f, v, 0;` where only address loads read r. The front end emits
  /// this for addresses in NVIDIA's languages.
  bool isZeroedNan(const std::vector<Instruction> &code, std::size_t at) const {
    const Instruction &choice = code[at];
    if (choice.op != Opcode::Cmp || choice.dst.file != File::Temporary || choice.dst.saturate)
      return false;
    const Operand &flag = choice.src[0], &value = choice.src[1], &zero = choice.src[2];
    if (flag.file != File::Temporary || flag.negate != 0xF || value.file != File::Temporary ||
        value.negate != 0 || value.index == choice.dst.index || value.index == flag.index)
      return false;
    std::size_t last = at;
    while (last-- > 0)
      if (writes(code[last], flag.index) || writes(code[last], value.index))
        break;
    if (last >= at || !isCompared(code[last], flag, value) ||
        readersOf(code, last) != std::vector<std::size_t>{at})
      return false;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!(choice.dst.mask >> i & 1))
        continue;
      const auto from = std::size_t(flag.swizzle[i]);
      if (from > 3 || !(code[last].dst.mask >> from & 1) ||
          code[last].src[0].swizzle[from] != value.swizzle[i] ||
          zero.swizzle[i] != ir::Select::Zero)
        return false;
    }
    return loadsOnly(code, at, kMaxSteps);
  }

  /// True for `SEQ flag, value, value`.
  static bool isCompared(const Instruction &instruction, const Operand &flag,
                         const Operand &value) {
    const Operand &source = instruction.src[0];
    return instruction.op == Opcode::Seq && source == instruction.src[1] && source.negate == 0 &&
           source.file == File::Temporary && source.index == value.index &&
           writes(instruction, flag.index);
  }

  /// True if only address loads read the result, either directly or after a clamp. An earlier clamp
  /// gives the same address.
  bool loadsOnly(const std::vector<Instruction> &code, std::size_t at, int steps) const {
    const std::vector<std::size_t> readers = readersOf(code, at);
    return std::all_of(readers.begin(), readers.end(), [&](std::size_t reader) {
      const Instruction &each = code[reader];
      if (each.op == Opcode::Arl)
        return true;
      const Operand &bound = each.src[1];
      return (each.op == Opcode::Max || each.op == Opcode::Min) && steps > 0 &&
             each.dst.file == File::Temporary && each.dst.index != code[at].dst.index &&
             bound.file == File::Parameter && !bound.relative &&
             m_program.parameters[bound.index].kind == ir::ParameterKind::Constant &&
             loadsOnly(code, reader, steps - 1);
    });
  }

  ir::Program &m_program;
  AssemblyLimits m_most;
  int m_first = 0, m_last = 0, m_size = 0;
  std::uint16_t m_zero = 0, m_low = 0, m_high = 0;
  std::array<std::optional<std::uint16_t>, 3> m_scratch;
};
} // namespace

bool defineAddresses(ir::Program &program, const AssemblyLimits &most) {
  return Addresses(program, most).run();
}

} // namespace arbiter::fp
