#include <cmath>
#include <optional>
#include <vector>

#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/values.h"

namespace arbiter::fp::opt {

namespace {
/// Returns the row that a relative operand reads at a known address, as a plain operand. Out of
/// range, the result reads zero.
Operand rowOf(const ir::Program &program, const Operand &operand, float address) {
  const std::vector<std::uint16_t> &rows = program.arrays[operand.index].rows;
  const float at = address + float(operand.offset);
  Operand row = operand;
  row.relative = false;
  row.address = 0;
  row.offset = 0;
  if (at >= 0.0f && at < float(rows.size())) {
    row.index = rows[std::size_t(at)];
    return row;
  }
  for (ir::Select &select : row.swizzle)
    if (select != ir::Select::One)
      select = ir::Select::Zero;
  row.file = File::Temporary;
  row.index = 0;
  return row;
}
} // namespace

bool resolveAddresses(ir::Program &program, Numerics numerics) {
  // Addresses below this bound are exact as floats.
  constexpr float kFurthest = 1 << 20;
  std::vector<std::optional<float>> addresses(program.addresses.size(), 0.0f);
  bool changed = false;
  for (Instruction &instruction : program.code) {
    for (Operand &operand : instruction.src) {
      if (!operand.relative || !addresses[operand.address])
        continue;
      operand = rowOf(program, operand, *addresses[operand.address]);
      changed = true;
    }
    if (instruction.dst.file != File::Address)
      continue;
    std::optional<float> &address = addresses[instruction.dst.index];
    address = constantAt(program, instruction.src[0], 0, numerics);
    if (address && !(std::fabs(*address) < kFurthest))
      address.reset();
    else if (address)
      address = std::floor(*address);
  }
  return changed;
}

} // namespace arbiter::fp::opt
