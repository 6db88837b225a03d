#include "mutate.h"

#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/testing/random.h"

namespace arbiter::differential {

using namespace fp::ir;

namespace {
/// Returns another opcode of the same shape, or the same if there is none.
Opcode neighbour(Opcode op) {
  switch (op) {
  case Opcode::Add:
    return Opcode::Sub;
  case Opcode::Sub:
    return Opcode::Add;
  case Opcode::Mul:
    return Opcode::Max;
  case Opcode::Mad:
    return Opcode::Lrp;
  case Opcode::Lrp:
    return Opcode::Mad;
  case Opcode::Max:
    return Opcode::Min;
  case Opcode::Min:
    return Opcode::Max;
  case Opcode::Sge:
    return Opcode::Slt;
  case Opcode::Slt:
    return Opcode::Sge;
  case Opcode::Sin:
    return Opcode::Cos;
  case Opcode::Cos:
    return Opcode::Sin;
  case Opcode::Frc:
    return Opcode::Flr;
  case Opcode::Flr:
    return Opcode::Frc;
  default:
    return op;
  }
}
} // namespace

Program mutant(const Program &program, std::uint64_t seed, fp::Numerics numerics) {
  Program result = program;
  fp::optimise(result, numericsOf(result.language, numerics));
  fp::testing::Random random(seed);
  Instruction &instruction = result.code[std::size_t(random.below(int(result.code.size())))];
  const Opcode other = neighbour(instruction.op);
  if (other == instruction.op)
    instruction.src[0].negate ^= 0xF;
  instruction.op = other;
  return result;
}

} // namespace arbiter::differential
