#include "fp_compiler/back/llvm/fragment/fragment_discards.h"

#include <algorithm>

#include "fp_compiler/analysis/live_values.h"

namespace arbiter::fp::llvm_back {

namespace {

/// Write mask of the component that the alpha test reads.
constexpr std::uint8_t kAlpha = 8;

/// The samples that a program takes. `branches`: one of them selects a level of detail or a cube
/// face, so that its code has several blocks.
struct Samples {
  int count = 0;
  bool branches = false;
};
Samples samplesOf(const ir::Program &program, const abi::FragmentKey &key) {
  const analysis::LiveValues live = analysis::liveOf(program);
  Samples samples;
  for (std::size_t i = 0; i < program.code.size(); ++i) {
    const ir::Instruction &instruction = program.code[i];
    if (live.written[i] == 0 || !ir::info(instruction.op).has(ir::Texture))
      continue;
    const abi::SamplerKey &sampler = key.samplers[instruction.unit];
    ++samples.count;
    samples.branches |= sampler.mip != abi::MipFilter::None || sampler.magnify != sampler.minify ||
                        sampler.dimension == abi::Dimension::Cube;
  }
  return samples;
}

/// Returns the program without outputs that cannot discard fragments.
ir::Program withoutColors(ir::Program program, bool testsAlpha) {
  std::vector<std::uint8_t> kept(program.outputs.size(), 0);
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (testsAlpha && program.outputs[i] == ir::Output{ir::OutputKind::Color, 0})
      kept[i] = kAlpha;
  const auto isOutput = [](const ir::Instruction &instruction) {
    return ir::info(instruction.op).hasDestination() && instruction.dst.file == ir::File::Output;
  };
  for (ir::Instruction &instruction : program.code)
    if (isOutput(instruction))
      instruction.dst.mask &= kept[instruction.dst.index];
  std::erase_if(program.code, [&](const ir::Instruction &instruction) {
    return isOutput(instruction) && instruction.dst.mask == 0;
  });
  return program;
}

} // namespace

std::optional<DiscardProgram> discardProgramOf(const jit::FragmentProgram &program,
                                               const abi::FragmentKey &key) {
  const bool testsAlpha = key.alphaTest != abi::Compare::Always;
  // Coverage changes alpha.
  if ((!testsAlpha && !program.shape().kills) || key.coverage != abi::Coverage::Whole ||
      ir::hasLoops(program.program()))
    return std::nullopt;
  ir::Program part = withoutColors(program.program(), testsAlpha);
  const Samples ofPart = samplesOf(part, key);
  if (ofPart.branches || ofPart.count >= samplesOf(program.program(), key).count)
    return std::nullopt;
  return DiscardProgram(std::move(part), program.shape());
}

} // namespace arbiter::fp::llvm_back
