#include "apps/tools/machine_code.h"

#include <filesystem>

#include "apps/tools/launch/launch.h"
#include "fp_compiler/ir/reads.h"
#include "util/flags.h"

namespace arbiter::tools {

namespace {
void fillSamplers(const std::vector<fp::jit::Sampler> &units,
                  std::array<abi::SamplerKey, abi::kMaxUnits> &samplers) {
  for (const fp::jit::Sampler &used : units) {
    abi::SamplerKey &sampler = samplers[used.unit];
    sampler.dimension = fp::jit::dimensionOf(used.target);
    sampler.shadow = isShadow(used.target);
    sampler.format.layout = sampler.shadow ? abi::Layout::Depth24Stencil8 : abi::Layout::U8x4;
    sampler.wrap.fill(abi::Wrap::ClampToEdge);
  }
}

abi::FragmentKey plainKey(const fp::jit::FragmentShape &shape, fp::Numerics numerics) {
  abi::FragmentKey key{};
  key.numerics = std::uint8_t(fp::ofInstructions(numerics));
  key.inputs.fill(abi::Interpolation::Linear);
  for (std::size_t i = 0; i < key.targets.size(); ++i)
    if (shape.colorOutputs >> i & 1)
      key.targets[i].format.layout = abi::Layout::U8x4;
  fillSamplers(shape.samplers, key.samplers);
  return key;
}

abi::VertexKey plainKey(const fp::jit::VertexShape &shape) {
  abi::VertexKey key{};
  fillSamplers(shape.samplers, key.samplers);
  return key;
}

MachineCodeError notOffered() { return {"the rasterizer has no code for such a program"}; }
} // namespace

Result<std::string, MachineCodeError> machineCode(const fp::ir::Program &program,
                                                  fp::Numerics numerics, fp::jit::Listing what) {
  fp::jit::EngineOptions options;
  options.cpu = settings().cpu;
  if (const auto layer = findLayer({}))
    options.folder = std::filesystem::path(layer.value().preload).parent_path();
  std::string reason;
  const auto engine = fp::jit::makeEngine(options, reason);
  if (!engine)
    return MachineCodeError{reason};
  std::string text;
  if (program.language == fp::ir::Language::ArbVertex) {
    const auto prepared = engine->prepareVertex(program, numerics);
    if (!prepared)
      return notOffered();
    text = engine->listing(*prepared, plainKey(prepared->shape()), what, reason);
  } else {
    const auto prepared = engine->prepareFragment(program, numerics);
    if (!prepared)
      return notOffered();
    text = engine->listing(*prepared, plainKey(prepared->shape(), numerics), what, reason);
  }
  if (text.empty())
    return MachineCodeError{reason};
  return text;
}

} // namespace arbiter::tools
