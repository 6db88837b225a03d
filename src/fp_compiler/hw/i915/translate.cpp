#include <algorithm>

#include "fp_compiler/hw/dataflow.h"
#include "fp_compiler/hw/i915/i915.h"
#include "fp_compiler/hw/reasons.h"
#include "fp_compiler/hw/slot_writer.h"

namespace arbiter::fp::hw::i915 {

namespace {

using ir::File;
using ir::Instruction;
using ir::Opcode;

/// Rows of constants that the driver loads for an opcode. They are bits, so that each row counts
/// once.
enum OwnRows : unsigned { kSinRows = 1, kSinSeriesRow = 2, kCosSeriesRow = 4 };

class Translator : SlotWriter {
public:
  explicit Translator(const ir::Program &program)
      : SlotWriter(program), m_touched(program.temporaries.size()),
        m_used(program.temporaries.size(), false) {}

  SlotProgram run() {
    findLiveAfter();
    for (std::size_t i = 0; i < m_program.code.size(); ++i)
      translate(std::uint16_t(i));
    options();
    m_code.phases = m_phase + 1;
    m_code.ownConstants += ((m_rows & kSinRows) ? 2 : 0) + ((m_rows & kSinSeriesRow) ? 1 : 0) +
                           ((m_rows & kCosSeriesRow) ? 1 : 0);
    countRows();
    const auto declared = std::uint32_t(std::count(m_used.begin(), m_used.end(), true));
    m_code.temporaries = std::max(declared, m_withScratch);
    m_code.scratch = m_code.temporaries - declared;
    return std::move(m_code);
  }

private:
  void translate(std::uint16_t at) {
    const Instruction &instruction = m_program.code[at];
    use(instruction);
    for (int i = 0; i < info(instruction.op).operandCount(); ++i)
      if (reads(instruction, i, File::Temporary))
        m_used[instruction.src[std::size_t(i)].index] = true;
    if (info(instruction.op).has(ir::Texture) || info(instruction.op).has(ir::Kills))
      sample(at, instruction);
    else
      arithmetic(at, instruction);
  }

  /// Adds the moves for constants. An instruction reads one constant register; the others are moved
  /// to a register first.
  void constants(std::uint16_t at, std::uint32_t registers) {
    if (registers > 1)
      alu(at, SlotCause::Constant, registers - 1);
  }

  /// Adds the slots of an opcode, and the moves for the constants that they read.
  void arithmetic(std::uint16_t at, const Instruction &instruction) {
    const auto among = [&](Operands operands) {
      return different(instruction, File::Parameter, operands);
    };
    std::uint32_t slots = 1;
    switch (instruction.op) {
    case Opcode::Sin:
    case Opcode::Cos:
      slots = 9;
      m_rows |= kSinRows;
      constants(at, among(kAll) + 2); // the range reduction reads both rows
      break;
    case Opcode::Scs:
      slots = scs(instruction);
      break;
    case Opcode::Lit:
      slots = 5;
      break;
    case Opcode::Lrp: // a*b + c, then -c*a + the first result
      slots = 2;
      constants(at, among(kAll));
      constants(at, among(0b101));
      break;
    case Opcode::Pow: // LG2, MUL, EX2
      slots = 3;
      break;
    case Opcode::Xpd:
      slots = 2;
      constants(at, among(kAll));
      constants(at, among(kAll));
      break;
    default:
      constants(at, among(kAll));
      break;
    }
    alu(at, SlotCause::Instruction, slots);
    wrote(at, instruction);
  }

  /// Returns the slots of SCS: two for powers, then two each for the sine and the cosine.
  std::uint32_t scs(const Instruction &instruction) {
    const bool cosine = instruction.dst.mask & 1, sine = instruction.dst.mask & 2;
    m_rows |= (sine ? kSinSeriesRow : 0u) | (cosine ? kCosSeriesRow : 0u);
    return 2 + (sine ? 2 : 0) + (cosine ? 2 : 0);
  }

  /// True if the coordinate is a plain register or interpolant. The texture unit has no swizzle and
  /// no constants.
  [[nodiscard]] bool plain(const Instruction &instruction) const {
    const ir::Operand &coordinate = instruction.src[0];
    if (coordinate.file == File::Parameter)
      return false;
    if (coordinate.file == File::Attribute) {
      // These attributes have only some components, so the rest needs a swizzle.
      const ir::AttributeKind kind = m_program.attributes[coordinate.index].kind;
      if (kind == ir::AttributeKind::FogCoord || kind == ir::AttributeKind::ColorSecondary)
        return false;
    }
    return coordinate.swizzle == ir::kIdentity && coordinate.negate == 0;
  }

  void sample(std::uint16_t at, const Instruction &instruction) {
    const bool kills = info(instruction.op).has(ir::Kills);
    const ir::Operand &coordinate = instruction.src[0];
    const bool inPlace = plain(instruction);
    if (!inPlace) {
      alu(at, SlotCause::Coordinate);
      m_withScratch = std::max(m_withScratch, m_liveAfter[at] + 1);
    }
    const bool masked = !kills && instruction.dst.mask != 0xF;
    if (!kills && !masked && instruction.dst.file == File::Output)
      begin(at, kWholeProgram); // the new phase also separates it from the writer of its coordinate
    else if (!inPlace)
      begin(at, at); // the move is in this phase
    else if (coordinate.file == File::Temporary && m_touched[coordinate.index].phase == m_phase + 1)
      begin(at, m_touched[coordinate.index].writer);
    put({.texture = true,
         .origin = at,
         .interpolated = coordinate.file == File::Attribute,
         .phase = m_phase});
    if (kills)
      return;
    if (masked)
      alu(at, SlotCause::Result);
    wrote(at, instruction);
  }

  void begin(std::uint16_t sample, std::uint16_t writer) {
    ++m_phase;
    m_code.starts.push_back({sample, writer});
  }

  void wrote(std::uint16_t at, const Instruction &instruction) {
    if (instruction.dst.file != File::Temporary)
      return;
    m_touched[instruction.dst.index] = {m_phase + 1, at};
    m_used[instruction.dst.index] = true;
  }

  /// Finds the registers whose value a later instruction reads. A moved coordinate must not
  /// overwrite them.
  void findLiveAfter() {
    m_liveAfter.assign(m_program.code.size(), 0);
    std::vector<std::uint8_t> live(m_program.temporaries.size(), 0);
    for (std::size_t at = m_program.code.size(); at-- > 0;) {
      const Instruction &instruction = m_program.code[at];
      if (instruction.dst.file == File::Temporary && writeMask(instruction) != 0)
        live[instruction.dst.index] &= std::uint8_t(~writeMask(instruction));
      for (int i = 0; i < info(instruction.op).operandCount(); ++i)
        if (reads(instruction, i, File::Temporary))
          live[instruction.src[std::size_t(i)].index] |= registerMask(instruction, i);
      m_liveAfter[at] =
          std::uint32_t(live.size()) - std::uint32_t(std::count(live.begin(), live.end(), 0));
    }
  }

  /// Adds fog and the colour sum as instructions (LRP is two slots), and the move of the depth.
  void options() {
    if (addOptions())
      alu(kWholeProgram, SlotCause::Fog, 3);
    for (const ir::Output &output : m_program.outputs)
      if (output.kind == ir::OutputKind::Depth)
        alu(kWholeProgram, SlotCause::Depth);
  }

  /// The last writer of a register, and its phase from 1. A phase of 0 means no writer.
  struct Touched {
    std::uint32_t phase = 0;
    std::uint16_t writer = 0;
  };
  std::vector<Touched> m_touched;
  std::vector<bool> m_used;
  std::vector<std::uint32_t> m_liveAfter;
  std::uint32_t m_withScratch = 0;
  unsigned m_rows = 0;
};

} // namespace

SlotProgram translate(const ir::Program &program) { return Translator(program).run(); }

const char *expansionOf(ir::Opcode op) {
  return op == Opcode::Lit ? "LIT is MAX, LG2, MUL, EX2 and CMP" : commonExpansionOf(op);
}

} // namespace arbiter::fp::hw::i915
