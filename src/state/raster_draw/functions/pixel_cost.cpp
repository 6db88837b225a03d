#include "state/raster_draw/functions/pixel_cost.h"

#include <algorithm>

namespace arbiter::state {
namespace {

// In tenths of a nanosecond, with eight lanes.
constexpr std::uint32_t kArithmetic = 4, kFunction = 15;
constexpr std::uint32_t kSample = 50, kSampleOfThree = 150;

std::uint32_t costOf(const fp::ir::Instruction &instruction) {
  const fp::ir::OpInfo &op = fp::ir::info(instruction.op);
  if (op.has(fp::ir::Texture))
    return instruction.target == fp::ir::TexTarget::Cube ||
                   instruction.target == fp::ir::TexTarget::Tex3D
               ? kSampleOfThree
               : kSample;
  const bool isFunction = op.operandCount() != 0 && op.shapes[0] == 'S';
  return isFunction ? kFunction : kArithmetic;
}

} // namespace

std::uint32_t pixelCost(const fp::ir::Program &program) {
  std::uint32_t tenths = 0;
  for (const fp::ir::Instruction &instruction : program.code)
    tenths += costOf(instruction);
  return std::max(tenths / 10, 1u);
}

} // namespace arbiter::state
