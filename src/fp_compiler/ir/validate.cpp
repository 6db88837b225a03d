#include "fp_compiler/ir/validate.h"

#include <array>
#include <optional>

namespace arbiter::fp::ir {

namespace {
class Validator {
public:
  explicit Validator(const Program &program) : m_program(program) {}

  std::vector<std::string> run() {
    for (std::size_t i = 0; i < m_program.outputs.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (m_program.outputs[i] == m_program.outputs[j])
          m_problems.push_back("outputs " + std::to_string(j) + " and " + std::to_string(i) +
                               " are the same");
    for (const ParameterArray &array : m_program.arrays)
      for (const std::uint16_t row : array.rows)
        if (row >= m_program.parameters.size())
          m_problems.push_back("array " + array.name + ": row out of range");
    for (m_at = 0; m_at < m_program.code.size(); ++m_at)
      check(m_program.code[m_at]);
    if (m_loops != 0)
      m_problems.emplace_back("a loop without its end");
    return std::move(m_problems);
  }

private:
  void report(const std::string &problem) {
    m_problems.push_back("instruction " + std::to_string(m_at) + ": " + problem);
  }

  static bool isOfVertices(const OpInfo &row) {
    return row.has(OfV2) || row.has(OfV3) || row.has(Flow) || &row == &info(Opcode::Cmp);
  }

  std::size_t sizeOf(File file) const {
    switch (file) {
    case File::Temporary:
      return m_program.temporaries.size();
    case File::Attribute:
      return m_program.attributes.size();
    case File::Parameter:
      return m_program.parameters.size();
    case File::Output:
      return m_program.outputs.size();
    case File::Address:
      return m_program.addresses.size();
    }
    return 0;
  }

  void check(const Instruction &instruction) {
    if (int(instruction.op) >= kCodeOpcodeCount)
      return report("opcode out of range");
    const OpInfo &row = info(instruction.op);
    const bool nv = m_program.options.nv != NvOption::None;
    if (int(instruction.op) >= kOpcodeCount && !nv)
      report("an opcode of NVIDIA's options in a program without one");
    // Conditional writes of NVIDIA's options become CMP, also in vertex programs.
    const bool vertex = m_program.language == Language::ArbVertex;
    if (row.has(vertex ? FragmentOnly : VertexOnly) && !(vertex && nv && isOfVertices(row)))
      report("not an opcode of the program's language");
    for (int i = 0; i < row.operandCount(); ++i)
      checkOperand(instruction.src[std::size_t(i)], row.shapes[i] == 'S');
    if (row.hasDestination())
      checkDestination(instruction);
    if (row.has(Flow))
      checkFlow(instruction);
    if (row.has(Texture))
      checkTexture(instruction);
  }

  void checkOperand(const Operand &operand, bool scalar) {
    if (operand.file == File::Output || operand.file == File::Address)
      report("reads an output or an address register");
    if (operand.relative)
      checkRelative(operand);
    else if (operand.index >= sizeOf(operand.file))
      report("operand index out of range");
    if (operand.negate > 0xF)
      report("negate has more than four bits");
    for (const Select select : operand.swizzle)
      if (select > Select::One)
        report("swizzle out of range");
    if (!scalar)
      return;
    for (const Select select : operand.swizzle)
      if (select != operand.swizzle[0])
        return report("scalar operand with more than one component");
    if (operand.negate != 0 && operand.negate != 0xF)
      report("scalar operand with more than one sign");
  }

  void checkRelative(const Operand &operand) {
    if (operand.file != File::Parameter)
      report("relative operand of a file without arrays");
    if (operand.index >= m_program.arrays.size())
      report("array index out of range");
    if (operand.address >= m_program.addresses.size())
      report("address register out of range");
  }

  void checkDestination(const Instruction &instruction) {
    const Destination &dst = instruction.dst;
    const bool address = dst.file == File::Address;
    if (address != (instruction.op == Opcode::Arl))
      return report("ARL, and only ARL, writes an address register");
    if (address && (dst.mask != 1 || dst.saturate))
      return report("an address register has one component, x");
    if (!address && dst.file != File::Temporary && dst.file != File::Output)
      report("writes a register that is read-only");
    if (dst.index >= sizeOf(dst.file))
      report("destination index out of range");
    if (dst.mask == 0 || dst.mask > 0xF)
      report("write mask out of range");
  }

  void checkFlow(const Instruction &instruction) {
    if (instruction.op != Opcode::Rep && m_loops == 0)
      return report("the end of a loop, or a break, outside of one");
    m_loops += instruction.op == Opcode::Rep ? 1 : instruction.op == Opcode::Endrep ? -1 : 0;
  }

  void checkTexture(const Instruction &instruction) {
    if (instruction.target > TexTarget::ShadowRect)
      return report("texture target out of range");
    if (instruction.unit >= m_targets.size())
      return report("texture image unit out of range");
    std::optional<TexTarget> &target = m_targets[instruction.unit];
    if (target && *target != instruction.target)
      report("two targets on one texture image unit");
    target = instruction.target;
    if (instruction.target >= TexTarget::Shadow1D && !m_program.options.shadow)
      report("shadow target without ARB_fragment_program_shadow");
  }

  const Program &m_program;
  std::vector<std::string> m_problems;
  std::array<std::optional<TexTarget>, 32> m_targets;
  std::size_t m_at = 0;
  int m_loops = 0;
};
} // namespace

std::vector<std::string> validate(const Program &program) { return Validator(program).run(); }

} // namespace arbiter::fp::ir
