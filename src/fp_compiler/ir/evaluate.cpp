#include "fp_compiler/ir/evaluate.h"

#include <algorithm>

#include "fp_compiler/ir/machine.h"

namespace arbiter::fp::ir {

Evaluation evaluate(const Program &program, const Inputs &inputs) {
  return Machine(program, inputs).run();
}

namespace {
using Quad = std::array<Machine, 4>;

/// Sets the derivative that DDX or DDY at \p index gives. All four fragments must be there.
void setDerivatives(Quad &lanes, std::size_t index, Opcode op,
                    const std::array<Inputs, 4> &inputs) {
  std::array<Vec4, 4> value;
  for (std::size_t lane = 0; lane < 4; ++lane)
    value[lane] = lanes[lane].operandOf(index);
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const std::size_t low = op == Opcode::Ddx ? lane & 2 : lane & 1;
    const std::size_t high = low + (op == Opcode::Ddx ? 1 : 2);
    lanes[lane].setDerivative(apply(Opcode::Sub, {value[high], value[low]}, inputs[lane].numerics));
  }
}

/// Runs one instruction for the fragments that are furthest behind. A fragment that has left a loop
/// waits for those still in it. While any waits, the others have no derivatives.
void advance(Quad &lanes, const Program &program, const std::array<Inputs, 4> &inputs) {
  std::size_t index = lanes[0].at();
  for (const Machine &lane : lanes)
    index = std::min(index, lane.at());
  const auto isThere = [&](const Machine &lane) { return lane.at() == index; };
  const Opcode op = program.code[index].op;
  if ((op == Opcode::Ddx || op == Opcode::Ddy) && std::all_of(lanes.begin(), lanes.end(), isThere))
    setDerivatives(lanes, index, op, inputs);
  else
    for (Machine &lane : lanes)
      lane.setDerivative({});
  for (Machine &lane : lanes)
    if (lane.at() == index)
      lane.advance();
}
} // namespace

std::array<Evaluation, 4> evaluateQuad(const Program &program,
                                       const std::array<Inputs, 4> &inputs) {
  // A discarded fragment keeps running, because its neighbours need its values.
  std::array<Inputs, 4> helped = inputs;
  for (Inputs &lane : helped)
    lane.pastKill = true;
  Quad lanes = {Machine(program, helped[0]), Machine(program, helped[1]),
                Machine(program, helped[2]), Machine(program, helped[3])};
  const auto runs = [&](const Machine &lane) { return lane.at() < program.code.size(); };
  while (std::any_of(lanes.begin(), lanes.end(), runs))
    advance(lanes, program, inputs);
  std::array<Evaluation, 4> results;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    results[lane] = lanes[lane].finish();
    if (!results[lane].killed || inputs[lane].pastKill)
      continue;
    results[lane].outputs.assign(program.outputs.size(), Vec4{});
    results[lane].depth.reset();
  }
  return results;
}

} // namespace arbiter::fp::ir
