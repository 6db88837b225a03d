#include <cmath>

#include "fp_compiler/ir/reads.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/values.h"

namespace arbiter::fp::opt {

namespace {
/// The source that a component was copied from. Zero and One are no registers.
struct Origin {
  bool known = false;
  File file = File::Temporary;
  std::uint16_t index = 0;
  Select select = Select::Zero;
  bool negate = false;
  std::uint32_t version = 0; ///< version of the source temporary at the time of the copy
};

class Copies {
public:
  explicit Copies(ir::Program &program)
      : m_program(program), m_versions(program), m_origins(program.temporaries.size()) {
    // Unwritten registers are zero.
    for (auto &components : m_origins)
      components.fill({true, File::Temporary, 0, Select::Zero, false, 0});
  }

  bool run() {
    bool changed = false;
    for (Instruction &instruction : m_program.code) {
      for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i)
        changed |= rewrite(instruction.src[std::size_t(i)], ir::operandMask(instruction, i),
                           ir::info(instruction.op).shapes[i] == 'S');
      record(instruction);
    }
    return changed;
  }

private:
  /// Returns the origin of an operand component, one copy back.
  Origin originOf(const Operand &operand, int position) const {
    const Select select = operand.swizzle[std::size_t(position)];
    const bool negate = operand.negate >> position & 1;
    Origin direct{true, operand.file, operand.index, select, negate, 0};
    if (select > Select::W)
      return direct;
    if (operand.relative)
      return {}; // a later read would see a different address
    if (operand.file == File::Parameter)
      return constantOrigin(direct);
    if (operand.file != File::Temporary)
      return direct;
    direct.version = m_versions.at(operand.index, int(select));
    Origin copied = m_origins[operand.index][std::size_t(select)];
    if (!copied.known || (copied.select <= Select::W && copied.file == File::Temporary &&
                          copied.version != m_versions.at(copied.index, int(copied.select))))
      return direct;
    copied.negate ^= negate;
    return copied;
  }

  /// Maps 0, 1, -0 and -1 to swizzle selectors, which combine with any register.
  Origin constantOrigin(const Origin &direct) const {
    const ir::Parameter &parameter = m_program.parameters[direct.index];
    if (parameter.kind != ir::ParameterKind::Constant)
      return direct;
    const float value = parameter.constant[std::size_t(direct.select)];
    if (value != 0.0f && value != 1.0f && value != -1.0f)
      return direct;
    Origin result = direct;
    result.select = value == 0.0f ? Select::Zero : Select::One;
    result.negate ^= std::signbit(value);
    return result;
  }

  bool rewrite(Operand &operand, std::uint8_t mask, bool scalar) const {
    if (mask == 0 || operand.file != File::Temporary)
      return false;
    Operand result = operand;
    result.negate = 0;
    bool hasRegister = false;
    for (int i = 0; i < 4; ++i) {
      if (!(mask >> i & 1))
        continue;
      const Origin origin = originOf(operand, i);
      result.swizzle[std::size_t(i)] = origin.select;
      result.negate |= std::uint8_t(origin.negate << i);
      if (origin.select > Select::W)
        continue;
      if (hasRegister && (result.file != origin.file || result.index != origin.index))
        return false; // an operand can read only one register
      hasRegister = true;
      result.file = origin.file;
      result.index = origin.index;
    }
    fillUnused(result, scalar ? std::uint8_t(1) : mask);
    if (sameReads(result, operand, mask))
      return false;
    operand = result;
    return true;
  }

  void record(const Instruction &instruction) {
    const std::uint8_t mask = ir::writeMask(instruction);
    const bool temporary = instruction.dst.file == File::Temporary;
    std::array<Origin, 4> origins = {};
    const bool copies = instruction.op == ir::Opcode::Mov || instruction.op == ir::Opcode::Swz;
    if (copies && !instruction.dst.saturate && temporary)
      for (int i = 0; i < 4; ++i)
        if (mask >> i & 1)
          origins[std::size_t(i)] = originOf(instruction.src[0], i);
    m_versions.write(instruction);
    if (!temporary)
      return;
    for (std::size_t i = 0; i < 4; ++i)
      if (mask >> i & 1)
        m_origins[instruction.dst.index][i] = origins[i];
  }

  ir::Program &m_program;
  Versions m_versions;
  std::vector<std::array<Origin, 4>> m_origins;
};
} // namespace

bool propagateCopies(ir::Program &program) { return Copies(program).run(); }

} // namespace arbiter::fp::opt
