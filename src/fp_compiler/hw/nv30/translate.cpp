#include "fp_compiler/hw/dataflow.h"
#include "fp_compiler/hw/nv30/nv30.h"
#include "fp_compiler/hw/slot_writer.h"

namespace arbiter::fp::hw::nv30 {

namespace {

using ir::File;
using ir::Instruction;
using ir::Opcode;

/// Returns the slots of the instruction itself. Opcodes that are not listed are instructions of the
/// chip, or a MOV of |a| for ABS. Listed are those that NV_fragment_program lacks: CMP, DPH, SCS,
/// SWZ, XPD and KIL with an operand.
std::uint32_t slotsOf(const Instruction &instruction) {
  switch (instruction.op) {
  case Opcode::Cmp:
    return 3;       // condition code from a; MOV c if it is not below zero, MOV b if it is
  case Opcode::Dph: // DP3, ADD of w
  case Opcode::Xpd: // MUL, MAD
    return 2;
  case Opcode::Scs:
    return std::uint32_t((instruction.dst.mask & 1) + (instruction.dst.mask >> 1 & 1));
  default:
    return 1;
  }
}

/// True if the used components select 0 or 1, or have different signs. An operand of the chip has
/// one sign, and selects only components of its register.
bool needsConstants(const Instruction &instruction, int operand) {
  const ir::Operand &source = instruction.src[std::size_t(operand)];
  const std::uint8_t used = operandMask(instruction, operand);
  bool numbers = false;
  for (std::size_t c = 0; c < 4; ++c)
    numbers |= (used >> c & 1) && source.swizzle[c] > ir::Select::W;
  const std::uint8_t signs = source.negate & used;
  return numbers || (signs != 0 && signs != used);
}

class Translator : SlotWriter {
public:
  explicit Translator(const ir::Program &program)
      : SlotWriter(program), m_flow(dataflowOf(program)) {}

  SlotProgram run() {
    for (std::size_t i = 0; i < m_program.code.size(); ++i) {
      m_code.gone[i] = !m_flow.live[i];
      if (m_flow.live[i])
        translate(std::uint16_t(i));
    }
    options();
    m_code.ownConstants += m_zeroAndOne ? 1 : 0;
    countRows();
    const std::uint32_t registers = registersAtOnce(m_program, m_flow);
    m_code.halves = m_program.options.precision == ir::Precision::Fastest;
    m_code.temporaries = m_code.halves ? (registers + 1) / 2 : registers;
    return std::move(m_code);
  }

private:
  void translate(std::uint16_t at) {
    const Instruction &instruction = m_program.code[at];
    use(instruction);
    operands(at, instruction);
    const bool texture = info(instruction.op).has(ir::Texture);
    const bool kills = info(instruction.op).has(ir::Kills);
    if (kills)
      alu(at, SlotCause::Instruction); // sets the condition code that KIL tests
    if (texture || kills) {
      put({.texture = true,
           .origin = at,
           .interpolated = texture && instruction.src[0].file == File::Attribute});
      return;
    }
    for (std::uint32_t i = slotsOf(instruction); i-- > 0;)
      put({.origin = at, .passes = passesOf(instruction.op)});
  }

  /// Adds the moves for attributes and constants. An instruction reads one attribute and one
  /// constant, however often; others are moved to a register first. CMP's slots read one operand
  /// each.
  void operands(std::uint16_t at, const Instruction &instruction) {
    const int count = info(instruction.op).operandCount();
    bool constants = false;
    for (int i = 0; i < count; ++i) {
      const ir::Operand &operand = instruction.src[std::size_t(i)];
      if (needsConstants(instruction, i)) {
        constants = true;
        // SWZ itself is the MAD. Other opcodes need a MAD before them.
        if (instruction.op != Opcode::Swz)
          alu(at, SlotCause::Swizzle);
        if (reads(instruction, i, File::Parameter)) // the numbers already use the one constant
          alu(at, SlotCause::Constant);
      }
      if (operand.file == File::Attribute &&
          m_program.attributes[operand.index].kind == ir::AttributeKind::FogCoord &&
          (registerMask(instruction, i) & 8)) {
        alu(at, SlotCause::FogCoordinate);
        constants = true;
      }
    }
    m_zeroAndOne |= constants;
    if (instruction.op == Opcode::Cmp)
      return;
    const auto beyondFirst = [&](File file) {
      const std::uint32_t registers = different(instruction, file);
      return registers > 1 ? registers - 1 : 0;
    };
    alu(at, SlotCause::Attribute, beyondFirst(File::Attribute));
    alu(at, SlotCause::Constant, beyondFirst(File::Parameter));
  }

  /// Adds the slots of the options. The chip's own fog stage is off while a program runs
  /// (NV_fragment_program 3.11), so slots compute fog's factor, blend, and keep alpha.
  void options() {
    if (!addOptions())
      return;
    put({.cause = SlotCause::Fog, .passes = passesOf(Opcode::Lrp)});
    alu(kWholeProgram, SlotCause::Fog);
  }

  Dataflow m_flow;
  bool m_zeroAndOne = false; ///< true if swizzles need the row (0, 1, -1, .)
};

} // namespace

SlotProgram translate(const ir::Program &program) { return Translator(program).run(); }

const char *expansionOf(ir::Opcode op) {
  switch (op) {
  case Opcode::Cmp:
    return "CMP is a condition code and two conditional moves";
  case Opcode::Dph:
    return "DPH is a DP3 and an ADD";
  case Opcode::Xpd:
    return "XPD is a MUL and a MAD";
  case Opcode::Scs:
    return "SCS is a COS and a SIN";
  case Opcode::Kil:
    return "KIL tests a condition code, which another instruction sets";
  default:
    return nullptr;
  }
}

std::uint8_t passesOf(ir::Opcode op) {
  switch (op) {
  case Opcode::Lrp:
  case Opcode::Rsq:
  case Opcode::Lit:
  case Opcode::Pow:
    return 2;
  default:
    return 1;
  }
}

} // namespace arbiter::fp::hw::nv30
