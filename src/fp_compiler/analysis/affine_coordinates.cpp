#include "fp_compiler/analysis/affine_coordinates.h"

#include <algorithm>
#include <array>

#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::analysis {

using ir::File;
using ir::Instruction;
using ir::Opcode;
using ir::Operand;

namespace {
using Dependence4 = std::array<Dependence, 4>;
constexpr Dependence4 kUniform4 = {};

Dependence sum(Dependence a, Dependence b) { return std::max(a, b); }
Dependence product(Dependence a, Dependence b) {
  if (a == Dependence::Uniform || b == Dependence::Uniform)
    return std::max(a, b);
  return Dependence::Other;
}
/// Returns the dependence of the result of any non-linear function of \p a.
Dependence function(Dependence a) {
  return a == Dependence::Uniform ? Dependence::Uniform : Dependence::Other;
}

class Follower {
public:
  explicit Follower(const ir::Program &program)
      : m_program(program), m_straight(!ir::hasLoops(program)),
        m_temporaries(program.temporaries.size(), kUniform4) {}

  /// Updates the registers' dependences for \p instruction. Returns true if it samples a texture at
  /// a curved coordinate.
  bool step(const Instruction &instruction) {
    const ir::OpInfo &row = ir::info(instruction.op);
    if (row.has(ir::Kills) || row.has(ir::Flow))
      return false;
    bool curved = false;
    Dependence4 result;
    if (row.has(ir::Texture)) {
      curved = isCurved(instruction);
      result.fill(Dependence::Other);
    } else {
      result = compute(instruction);
    }
    if (instruction.dst.file == File::Temporary)
      for (std::size_t i = 0; i < 4; ++i)
        if (instruction.dst.mask >> i & 1)
          m_temporaries[instruction.dst.index][i] =
              instruction.dst.saturate ? function(result[i]) : result[i];
    return curved;
  }

private:
  [[nodiscard]] Dependence component(const Operand &operand, std::size_t position) const {
    const ir::Select select = operand.swizzle[position];
    if (select > ir::Select::W)
      return Dependence::Uniform;
    switch (operand.file) {
    case File::Temporary:
      return m_temporaries[operand.index][std::size_t(select)];
    case File::Attribute:
      return m_program.attributes[operand.index].kind == ir::AttributeKind::Facing
                 ? Dependence::Other
                 : Dependence::Affine;
    case File::Parameter:
      return operand.relative ? Dependence::Other : Dependence::Uniform;
    case File::Output:
    case File::Address:
      break;
    }
    return Dependence::Other;
  }

  [[nodiscard]] Dependence4 of(const Operand &operand) const {
    return {component(operand, 0), component(operand, 1), component(operand, 2),
            component(operand, 3)};
  }

  [[nodiscard]] bool isCurved(const Instruction &instruction) const {
    if (instruction.op == Opcode::Txl || instruction.op == Opcode::Txd)
      return false; // the instruction gives the level of detail
    if (!m_straight)
      return true;
    if (instruction.target == ir::TexTarget::Cube)
      return true;
    const Operand &coordinate = instruction.src[0];
    std::uint8_t mask = ir::coordinateMask(instruction.target);
    if (ir::isShadow(instruction.target))
      mask = std::uint8_t(mask & ~4); // the level of detail does not depend on the reference value
    if (instruction.op == Opcode::Txp && component(coordinate, 3) != Dependence::Uniform)
      return true;
    for (std::size_t i = 0; i < 3; ++i)
      if ((mask >> i & 1) && component(coordinate, i) == Dependence::Other)
        return true;
    return false;
  }

  [[nodiscard]] Dependence4 compute(const Instruction &instruction) const {
    const Dependence4 a = of(instruction.src[0]);
    const int count = ir::info(instruction.op).operandCount();
    const Dependence4 b = count > 1 ? of(instruction.src[1]) : kUniform4;
    const Dependence4 c = count > 2 ? of(instruction.src[2]) : kUniform4;
    const auto each = [](auto f) { return Dependence4{f(0u), f(1u), f(2u), f(3u)}; };
    const auto dot = [&](std::size_t terms) {
      Dependence all = Dependence::Uniform;
      for (std::size_t i = 0; i < terms; ++i)
        all = sum(all, product(a[i], b[i]));
      return all;
    };
    switch (instruction.op) {
    case Opcode::Mov:
    case Opcode::Swz:
      return a;
    case Opcode::Add:
    case Opcode::Sub:
      return each([&](std::size_t i) { return sum(a[i], b[i]); });
    case Opcode::Mul:
      return each([&](std::size_t i) { return product(a[i], b[i]); });
    case Opcode::Mad:
      return each([&](std::size_t i) { return sum(product(a[i], b[i]), c[i]); });
    case Opcode::Lrp:
      return each([&](std::size_t i) { return sum(product(a[i], b[i]), product(a[i], c[i])); });
    case Opcode::Dp3:
      return each([&](std::size_t) { return dot(3); });
    case Opcode::Dp4:
      return each([&](std::size_t) { return dot(4); });
    case Opcode::Dph:
      return each([&](std::size_t) { return sum(dot(3), b[3]); });
    default:
      break;
    }
    Dependence all = Dependence::Uniform;
    for (const Dependence4 &operand : {a, b, c})
      for (const Dependence value : operand)
        all = sum(all, function(value));
    return each([&](std::size_t) { return all; });
  }

  const ir::Program &m_program;
  const bool m_straight; ///< false: the program has loops, and its registers are not tracked
  std::vector<Dependence4> m_temporaries;
};
} // namespace

std::vector<bool> samplesCurved(const ir::Program &program) {
  Follower follower(program);
  std::vector<bool> result;
  for (const Instruction &instruction : program.code)
    result.push_back(follower.step(instruction));
  return result;
}

} // namespace arbiter::fp::analysis
