#include "fp_compiler/back/llvm/engine/budget.h"

#include <bit>

namespace arbiter::fp::llvm_back {

namespace {

/// Returns the expected time for one sample. Its code is long, but does not interact with other
/// code.
double sampleMilliseconds(const abi::SamplerKey &sampler) {
  const double face =
      (sampler.dimension == abi::Dimension::Cube ? 1.2 : 1) * (sampler.format.srgb != 0 ? 1.4 : 1);
  if (sampler.mip != abi::MipFilter::None)
    return (sampler.anisotropic ? 15 : 12) * face;
  const bool filtered =
      sampler.magnify == abi::Filter::Linear || sampler.minify == abi::Filter::Linear;
  return (filtered ? 8 : 5) * face;
}

/// Returns the work of one instruction in scalar operations: a vec4's ADD is 4.
double workOf(const ir::Instruction &instruction) {
  using ir::Opcode;
  const auto components = double(std::popcount(unsigned(instruction.dst.mask)));
  switch (instruction.op) {
  case Opcode::Sin:
  case Opcode::Cos:
  case Opcode::Scs:
  case Opcode::Pow:
  case Opcode::Lit:
  case Opcode::Log:
  case Opcode::Exp:
  case Opcode::Pk2h:
  case Opcode::Pk4b:
  case Opcode::Pk4ub:
    return 24;
  case Opcode::Ex2:
  case Opcode::Lg2:
  case Opcode::Rsq:
  case Opcode::Rcp:
  case Opcode::Pk2us:
  case Opcode::Up2h:
  case Opcode::Up2us:
  case Opcode::Up4b:
  case Opcode::Up4ub:
    return 10;
  case Opcode::Mad:
  case Opcode::Cmp:
  case Opcode::Frc:
    return 2 * components;
  case Opcode::Lrp:
    return 3 * components;
  case Opcode::Dp3:
  case Opcode::Dp4:
  case Opcode::Dph:
    return 7;
  case Opcode::Xpd:
    return 9;
  case Opcode::Kil:
    return 8;
  default:
    return components;
  }
}

} // namespace

double expectedMilliseconds(const ir::Program &program, const SamplerKeys *samplers) {
  double work = 0, sampling = 0;
  for (const ir::Instruction &instruction : program.code) {
    work += workOf(instruction);
    if (samplers && ir::info(instruction.op).has(ir::Texture))
      sampling += sampleMilliseconds((*samplers)[instruction.unit]);
  }
  constexpr double kBase = 5, kEach = 0.035, kSquare = 10e-6;
  return kBase + sampling + kEach * work + kSquare * work * work;
}

} // namespace arbiter::fp::llvm_back
