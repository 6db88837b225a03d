#include "state/raster_draw/frames/looks.h"

#include <algorithm>

#include "state/raster_draw/units.h"

namespace arbiter::state {

namespace {

/// True if a bitmap's fragments take this value from the raster position. Hosts give them another
/// value.
bool isRasterValue(const fp::ir::Attribute &attribute) {
  return attribute.kind == fp::ir::AttributeKind::TexCoord ||
         attribute.kind == fp::ir::AttributeKind::FogCoord ||
         attribute.kind == fp::ir::AttributeKind::ColorSecondary;
}

bool samplesAlongAxis(const LookedAt &draw) {
  return std::any_of(draw.fragments.samplers.begin(), draw.fragments.samplers.end(),
                     [&](const fp::jit::Sampler &each) {
                       const auto dimension = std::size_t(fp::jit::dimensionOf(each.target));
                       return draw.mirror.samplers[each.unit][dimension].key.anisotropic != 0;
                     });
}

bool stencilHasSides(const abi::DepthStencilKey &key, const abi::FragmentData &values) {
  return key.stencilTest != 0 &&
         (!(key.front == key.back) || values.stencilReference[0] != values.stencilReference[1] ||
          values.stencilCompareMask[0] != values.stencilCompareMask[1] ||
          values.stencilWriteMask[0] != values.stencilWriteMask[1]);
}

} // namespace

LookBasis lookBasisOf(const fp::ir::Program &fragments, bool isFixed) {
  LookBasis basis = {{}, fragments.options, isFixed, false};
  for (const fp::ir::Instruction &each : fragments.code)
    if (fp::ir::info(each.op).has(fp::ir::Texture) &&
        std::none_of(basis.samplers.begin(), basis.samplers.end(),
                     [&](const fp::jit::Sampler &known) { return known.unit == each.unit; }))
      basis.samplers.push_back({each.unit, each.target});
  basis.readsRasterValues =
      fragments.options.fog != fp::ir::FogMode::None || fragments.options.colorSum ||
      std::any_of(fragments.attributes.begin(), fragments.attributes.end(), isRasterValue);
  return basis;
}

Looks looksOf(const LookedAt &draw) {
  const Mirror &mirror = draw.mirror;
  Looks looks = 0;
  if (samplesAlongAxis(draw))
    looks |= bitOf(Look::Anisotropy);
  const fp::ir::Options &options = draw.fragments.options;
  if (draw.fragments.isFixed && options.colorSum && options.fog != fp::ir::FogMode::None)
    looks |= bitOf(Look::SumInFog);
  if (draw.isBitmap)
    return looks;
  if (mirror.raster.lineStippleFactor != 0 && mirror.drawsLines(draw.topology))
    looks |= bitOf(Look::StippledLines);
  if (stencilHasSides(mirror.pixelOps.depthStencil, mirror.constants) &&
      mirror.coverageOf(draw.topology) != abi::Coverage::Whole)
    looks |= bitOf(Look::StencilOfStrokes);
  return looks;
}

Looks looksOf(abi::Layout target) {
  const bool isFew = target == abi::Layout::Bits565 || target == abi::Layout::Bits4444 ||
                     target == abi::Layout::Bits5551;
  return isFew ? bitOf(Look::FewBits) : 0;
}

} // namespace arbiter::state
