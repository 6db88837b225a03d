// Fragments that no vertices give: those of bitmaps.
#include <bit>
#include <cmath>

#include "state/core/context.h"
#include "state/raster_draw/bitmap.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/pipeline.h"

namespace arbiter::state::software {

namespace {

/// The values that the raster position has for fragment inputs, as slots.
std::uint32_t rasterSlots(const fp::jit::FragmentShape &shape) {
  std::uint32_t slots = 0;
  for (const fp::jit::FragmentInput &input : shape.inputs)
    slots |= 1u << slotOf(input.attribute);
  return slots;
}

/// Hosts add a little, so that a position that is whole but for a rounding error is whole.
std::int32_t pixelAt(float raster, float origin) {
  constexpr float kLittle = 0.0001f, kFar = 1 << 20;
  const float at = std::floor(raster + kLittle - origin);
  return at > -kFar && at < kFar ? std::int32_t(at) : std::int32_t(kFar);
}

} // namespace

Outcome Pipeline::shadeBits(Context &context, const PlacedBits &bits) {
  if (const Outcome outcome = choose(context, {GL_BITMAP, 0}); !outcome.ok())
    return outcome;
  Mirror &mirror = context.software->mirror;
  const fp::jit::FragmentShape &shape = m_program->functions->prepared()->shape();
  mirror.refreshRasterPosition(context.dirty, rasterSlots(shape));
  const swrast::Shading *shading = nullptr;
  if (const Outcome outcome = readyPixels(context, {}, 0, true, swrast::Topology::Points, shading);
      !outcome.ok())
    return outcome;
  swrast::BitFragments fragments;
  const float *const position = mirror.rasterPosition.position;
  // As a host has it, which draws a rectangle in clip space: there and back.
  fragments.z = (position[2] * 2.0f - 1.0f) * 0.5f + 0.5f;
  fragments.inverseW = position[3] != 0.0f ? 1.0f / position[3] : 1.0f;
  for (std::size_t i = 0; i < shape.inputs.size(); ++i) {
    const auto slot = std::size_t(slotOf(shape.inputs[i].attribute));
    for (std::size_t c = 0; c < 4; ++c)
      fragments.inputs[i][c] = mirror.rasterValues[slot][c];
  }
  (void)swrast::rasterizeBits(m_raster, *shading, bits.image, pixelAt(position[0], bits.xOrigin),
                              pixelAt(position[1], bits.yOrigin), fragments);
  return {};
}

} // namespace arbiter::state::software
