#include "fp_compiler/back/assembly/assembly.h"

#include <algorithm>
#include <cassert>

#include "fp_compiler/back/assembly/constants.h"
#include "fp_compiler/back/assembly/names.h"
#include "fp_compiler/ir/fog.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp {

using assembly::isExtended;
using ir::Instruction;
using ir::Opcode;
using ir::Operand;
using ir::Select;

namespace {
constexpr const char *kLetters = "xyzw01";

std::string options(const ir::Options &o, bool vertex) {
  constexpr const char *kHint[] = {"", "ARB_precision_hint_fastest", "ARB_precision_hint_nicest"};
  std::string text;
  const auto option = [&](bool given, const char *name) {
    if (given)
      text += std::string("OPTION ") + name + ";\n";
  };
  option(o.fog != ir::FogMode::None, ir::rowOf(o.fog).option);
  option(o.precision != ir::Precision::Unspecified, kHint[std::size_t(o.precision)]);
  // The ARB languages have no texture samples in vertex programs. Only NV_vertex_program3 has, and
  // does not need the option.
  option(o.shadow && !vertex, "ARB_fragment_program_shadow");
  option(o.drawBuffers, "ARB_draw_buffers");
  option(o.originUpperLeft, "ARB_fragment_coord_origin_upper_left");
  option(o.pixelCenterInteger, "ARB_fragment_coord_pixel_center_integer");
  option(o.positionInvariant, "ARB_position_invariant");
  return text;
}

std::string masked(const std::string &name, std::uint8_t mask) {
  if (mask == 0xF)
    return name;
  std::string text = name + ".";
  for (int i = 0; i < 4; ++i)
    if (mask >> i & 1)
      text += kLetters[i];
  return text;
}

class Writer {
public:
  Writer(const ir::Program &program, PartlyWritten parts)
      : m_program(program), m_names(program), m_parts(parts) {}

  std::string run() {
    assert(m_program.language != ir::Language::AtiFragment && !m_program.options.colorSum);
    zeros();
    for (const Instruction &instruction : m_program.code)
      statement(instruction);
    const bool vertex = m_program.language == ir::Language::ArbVertex;
    return std::string(vertex ? "!!ARBvp1.0\n" : "!!ARBfp1.0\n") +
           options(m_program.options, vertex) + m_names.declarations(m_scratch) + m_code + "END\n";
  }

  /// True if the text that run() wrote is within the limits.
  [[nodiscard]] bool isWithin(const AssemblyLimits &most) const {
    return m_instructions <= most.instructions &&
           m_names.temporaryCount() + m_scratch <= most.temporaries;
  }

private:
  void add(const std::string &instruction) {
    m_code += instruction + ";\n";
    ++m_instructions;
  }

  /// Emits initial values that the specification leaves undefined but this project defines.
  void zeros() {
    const std::vector<bool> temporaries = ir::readsUnwritten(m_program);
    for (std::size_t i = 0; i < temporaries.size(); ++i)
      if (temporaries[i])
        add("MOV t" + std::to_string(i) + ", {0, 0, 0, 0}");
    for (const std::uint8_t address : addressesReadUnwritten())
      add("ARL a" + std::to_string(address) + ".x, {0, 0, 0, 0}.x");
    if (m_parts == PartlyWritten::Zero || m_program.language != ir::Language::ArbVertex)
      zeroResults();
  }

  std::vector<std::uint8_t> addressesReadUnwritten() const {
    std::vector<bool> known(m_program.addresses.size(), false);
    std::vector<std::uint8_t> result;
    for (const Instruction &instruction : m_program.code) {
      for (const Operand &operand : instruction.src)
        if (operand.relative && !known[operand.address]) {
          known[operand.address] = true;
          result.push_back(operand.address);
        }
      if (instruction.op == Opcode::Arl)
        known[instruction.dst.index] = true;
    }
    return result;
  }

  void zeroResults() {
    std::vector<std::uint8_t> written(m_program.outputs.size(), 0);
    for (const Instruction &instruction : m_program.code)
      if (ir::writeMask(instruction) && instruction.dst.file == ir::File::Output)
        written[instruction.dst.index] |= instruction.dst.mask;
    for (std::size_t i = 0; i < written.size(); ++i) {
      const std::uint8_t wanted = ir::resultMask(m_program.outputs[i].kind);
      const auto missing = std::uint8_t(wanted & ~written[i]);
      // A result without any write does not exist, and an unwritten depth is the fragment's own.
      if (missing == 0 || missing == wanted || m_program.outputs[i].kind == ir::OutputKind::Depth)
        continue;
      ir::Destination dst;
      dst.file = ir::File::Output;
      dst.index = std::uint16_t(i);
      add("MOV " + masked(m_names.destination(dst), missing) + ", {0, 0, 0, 0}");
    }
  }

  std::string extended(const Operand &operand) const {
    std::string text = m_names.source(operand);
    for (int i = 0; i < 4; ++i)
      text += std::string(", ") + (operand.negate >> i & 1 ? "-" : "") +
              kLetters[int(operand.swizzle[std::size_t(i)])];
    return text;
  }

  /// Returns the text of an operand. If it has none, a SWZ into a scratch temporary comes first.
  /// \param scratch number of scratch temporaries of the instruction
  std::string source(const Operand &operand, bool scalar, int &scratch) {
    if (isExtended(operand)) {
      const std::string name = "s" + std::to_string(scratch++);
      m_scratch = std::max(m_scratch, scratch);
      add("SWZ " + name + ", " + extended(operand));
      return scalar ? name + ".x" : name;
    }
    std::string text = (operand.negate ? "-" : "") + m_names.source(operand);
    if (scalar)
      return text + "." + kLetters[int(operand.swizzle[0])];
    if (operand.swizzle == ir::kIdentity)
      return text;
    text += '.';
    const bool one = std::all_of(operand.swizzle.begin(), operand.swizzle.end(),
                                 [&](Select select) { return select == operand.swizzle[0]; });
    for (std::size_t i = 0; i < (one ? 1u : 4u); ++i)
      text += kLetters[int(operand.swizzle[i])];
    return text;
  }

  void statement(const Instruction &instruction) {
    const ir::OpInfo &row = ir::info(instruction.op);
    // A MOV of an extended operand is a SWZ.
    const bool swizzles = instruction.op == Opcode::Swz ||
                          (instruction.op == Opcode::Mov && isExtended(instruction.src[0]));
    std::string text = swizzles ? "SWZ" : row.mnemonic;
    if (!row.has(ir::Kills))
      text += (instruction.dst.saturate ? "_SAT " : " ") +
              masked(m_names.destination(instruction.dst), instruction.dst.mask) + ",";
    int scratch = 0;
    for (int i = 0; i < row.operandCount(); ++i) {
      const Operand &operand = instruction.src[std::size_t(i)];
      text += (i ? ", " : " ") +
              (swizzles ? extended(operand) : source(operand, row.shapes[i] == 'S', scratch));
    }
    if (row.has(ir::Texture))
      text += ", texture[" + std::to_string(instruction.unit) + "], " +
              ir::targetText(instruction.target);
    add(text);
  }

  const ir::Program &m_program;
  assembly::Names m_names;
  PartlyWritten m_parts;
  std::string m_code;
  int m_scratch = 0, m_instructions = 0;
};
} // namespace

std::string emitAssembly(const ir::Program &program, PartlyWritten parts) {
  const ir::Program plain = assembly::withPlainConstants(program);
  return Writer(plain, parts).run();
}

std::string emitAssembly(const ir::Program &program, PartlyWritten parts,
                         const AssemblyLimits &most) {
  const ir::Program plain = assembly::withPlainConstants(program);
  Writer writer(plain, parts);
  std::string text = writer.run();
  return writer.isWithin(most) ? text : std::string();
}

} // namespace arbiter::fp
