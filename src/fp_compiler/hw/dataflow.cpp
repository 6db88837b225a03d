#include "fp_compiler/hw/dataflow.h"

#include <algorithm>

#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::hw {

namespace {

using ir::File;
using ir::Instruction;

/// Calls visit(operand number, component of the operand, register, component of the register) for
/// each temporary component that the instruction reads.
template <typename Visit> void forTemporaryReads(const Instruction &instruction, Visit visit) {
  for (int i = 0; i < info(instruction.op).operandCount(); ++i) {
    const ir::Operand &operand = instruction.src[std::size_t(i)];
    if (operand.file != File::Temporary)
      continue;
    const std::uint8_t reads = operandMask(instruction, i);
    for (std::size_t c = 0; c < 4; ++c)
      if ((reads >> c & 1) && operand.swizzle[c] <= ir::Select::W)
        visit(std::size_t(i), c, operand.index, std::size_t(operand.swizzle[c]));
  }
}

void findWriters(const ir::Program &program, Dataflow &flow) {
  std::array<std::uint32_t, 4> unwritten;
  unwritten.fill(kNoInstruction);
  std::vector<std::array<std::uint32_t, 4>> last(program.temporaries.size(), unwritten);
  flow.writers.resize(program.code.size(), {unwritten, unwritten, unwritten});
  for (std::size_t at = 0; at < program.code.size(); ++at) {
    const Instruction &instruction = program.code[at];
    forTemporaryReads(instruction, [&](std::size_t operand, std::size_t component,
                                       std::uint16_t index, std::size_t from) {
      flow.writers[at][operand][component] = last[index][from];
    });
    const std::uint8_t writes = writeMask(instruction);
    if (instruction.dst.file != File::Temporary)
      continue;
    for (std::size_t c = 0; c < 4; ++c)
      if (writes >> c & 1)
        last[instruction.dst.index][c] = std::uint32_t(at);
  }
}

/// Marks live instructions, walking backwards. An instruction is live if it may discard, if it
/// writes a result component that nothing overwrites, or if a live instruction reads what it
/// writes.
void findLive(const ir::Program &program, Dataflow &flow) {
  flow.live.assign(program.code.size(), false);
  std::vector<std::uint8_t> pending; // components of each result that no later instruction writes
  for (const ir::Output &output : program.outputs)
    pending.push_back(resultMask(output.kind));
  for (std::size_t at = program.code.size(); at-- > 0;) {
    const Instruction &instruction = program.code[at];
    bool live = flow.live[at] || info(instruction.op).has(ir::Kills);
    if (!live && instruction.dst.file == File::Output)
      live = (pending[instruction.dst.index] & writeMask(instruction)) != 0;
    flow.live[at] = live;
    if (!live)
      continue;
    if (instruction.dst.file == File::Output && info(instruction.op).hasDestination())
      pending[instruction.dst.index] &= std::uint8_t(~writeMask(instruction));
    for (const auto &operand : flow.writers[at])
      for (const std::uint32_t writer : operand)
        if (writer != kNoInstruction)
          flow.live[writer] = true;
  }
}

} // namespace

Dataflow dataflowOf(const ir::Program &program) {
  Dataflow flow;
  findWriters(program, flow);
  findLive(program, flow);
  return flow;
}

std::vector<std::uint32_t> longestChain(const ir::Program &program, const Dataflow &flow) {
  struct Step {
    std::uint32_t samples = 0; ///< on the longest path to here, this one included
    std::uint32_t before = kNoInstruction;
  };
  std::vector<Step> steps(program.code.size());
  std::uint32_t best = kNoInstruction;
  for (std::size_t at = 0; at < program.code.size(); ++at) {
    if (!flow.live[at])
      continue;
    Step &step = steps[at];
    for (const auto &operand : flow.writers[at])
      for (const std::uint32_t writer : operand)
        if (writer != kNoInstruction && steps[writer].samples > step.samples)
          step = {steps[writer].samples, writer};
    if (!info(program.code[at].op).has(ir::Texture))
      continue;
    ++step.samples;
    if (best == kNoInstruction || step.samples > steps[best].samples)
      best = std::uint32_t(at);
  }
  std::vector<std::uint32_t> chain;
  if (best == kNoInstruction || steps[best].samples < 2)
    return chain;
  for (std::uint32_t at = best; at != kNoInstruction; at = steps[at].before)
    chain.push_back(at);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

std::uint32_t registersAtOnce(const ir::Program &program, const Dataflow &flow) {
  std::vector<std::uint32_t> firstWrite(program.outputs.size(), kNoInstruction);
  for (std::size_t at = program.code.size(); at-- > 0;) {
    const Instruction &instruction = program.code[at];
    if (flow.live[at] && instruction.dst.file == File::Output && writeMask(instruction) != 0)
      firstWrite[instruction.dst.index] = std::uint32_t(at);
  }
  std::vector<std::uint8_t> live(program.temporaries.size(), 0);
  std::uint32_t temporaries = 0; // registers with any live component
  std::uint32_t most = 0;
  const auto change = [&](std::uint16_t index, std::uint8_t mask) {
    temporaries += std::uint32_t(mask != 0) - std::uint32_t(live[index] != 0);
    live[index] = mask;
  };
  for (std::size_t at = program.code.size(); at-- > 0;) {
    if (!flow.live[at])
      continue;
    const Instruction &instruction = program.code[at];
    const auto results =
        std::uint32_t(std::count_if(firstWrite.begin(), firstWrite.end(), [&](std::uint32_t first) {
          return first <= std::uint32_t(at);
        }));
    most = std::max(most, temporaries + results);
    if (instruction.dst.file == File::Temporary && writeMask(instruction) != 0)
      change(instruction.dst.index,
             std::uint8_t(live[instruction.dst.index] & ~writeMask(instruction)));
    forTemporaryReads(instruction,
                      [&](std::size_t, std::size_t, std::uint16_t index, std::size_t component) {
                        change(index, std::uint8_t(live[index] | 1u << component));
                      });
    const std::uint32_t before =
        results - std::uint32_t(std::count(firstWrite.begin(), firstWrite.end(), at));
    most = std::max(most, temporaries + before);
  }
  return most;
}

} // namespace arbiter::fp::hw
