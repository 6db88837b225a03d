#include "state/raster_draw/pipeline.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>

#include "host/host_table.h"
#include "state/imaging/arithmetic.h"
#include "state/primitives/joined.h"
#include "state/raster_draw/bitmap.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"
#include "swrast/pixels.h"
#include "swrast/setup/rectangle.h"

namespace arbiter::state {

using fp::ir::AttributeKind;

namespace {
/// With fewer lanes, vectors are rarely empty enough for packing to pay.
constexpr int kLeastPackedLanes = 8;

using SpriteThird = swrast::RasterState::SpriteThird;
/// True if point sprites replace the attribute.
bool isSprite(const Mirror &mirror, const fp::ir::Attribute &attribute) {
  return attribute.kind == AttributeKind::TexCoord && attribute.index < 8 &&
         (mirror.spriteCoords >> attribute.index & 1) != 0;
}
} // namespace

abi::ShadeFunction Pipeline::functionFor(abi::Lanes lanes, Fallback &why) {
  m_key.lanes = lanes;
  const FragmentFunctions::Slot &slot =
      m_program->recent.slot(*m_program->functions, m_key, m_wait);
  if (const Outcome outcome = outcomeOf(slot); !outcome.ok())
    why = outcome.reason();
  return slot.function.load(std::memory_order_acquire);
}

Outcome Pipeline::chooseFunctions(const Mirror &mirror, abi::Interpolation inputs) {
  const fp::jit::FragmentShape &shape = m_program->functions->prepared()->shape();
  Prepared &prepared = m_prepared[std::size_t(inputs)];
  swrast::Shading &shading = prepared.shading;
  shading = {};
  const bool affine = inputs != abi::Interpolation::Perspective;
  shading.inputCount = std::uint32_t(shape.inputs.size());
  for (std::size_t i = 0; i < shape.inputs.size(); ++i) {
    const AttributeKind kind = shape.inputs[i].attribute.kind;
    const bool color = kind == AttributeKind::ColorPrimary || kind == AttributeKind::ColorSecondary;
    m_key.inputs[i] = color && mirror.raster.flatShade ? abi::Interpolation::Flat : inputs;
    shading.interpolation[i] = m_key.inputs[i];
    shading.inputComponents[i] = shape.inputs[i].components;
    if (isSprite(mirror, shape.inputs[i].attribute) &&
        mirror.raster.spriteThird != SpriteThird::Zero)
      shading.inputComponents[i] = 0xF; // the vertex's s, r and q
  }
  if (m_key.coverage != abi::Coverage::Whole) {
    const abi::Interpolation how = m_key.coverage == abi::Coverage::Line && !affine
                                       ? abi::Interpolation::Perspective
                                       : abi::Interpolation::Linear;
    m_key.inputs[shading.inputCount] = shading.interpolation[shading.inputCount] = how;
    ++shading.inputCount;
  }
  const std::uint32_t levels = m_units.levelsMatter();
  const bool quadsOnly =
      shape.derivatives || (levels & shape.needsQuads) != 0 || (levels != 0 && !affine);
  Fallback why = Fallback::NotCompiled;
  if (!quadsOnly)
    shading.row = functionFor(abi::Lanes::Row, why);
  if (quadsOnly || m_many)
    shading.quad = functionFor(abi::Lanes::Quad, why);
  if (!shading.row && !shading.quad)
    return why;
  Fallback whyNotPacked = Fallback::NotCompiled;
  const fp::jit::Engine &jit = *engine();
  if (shading.quad && jit.lanes() >= kLeastPackedLanes)
    choosePacked(levels != 0 || shape.derivatives, shading, whyNotPacked);
  prepared.ready = why != Fallback::Compiling && whyNotPacked != Fallback::Compiling;
  shading.lanes = jit.lanes();
  shading.blockWidth = jit.blockWidth();
  shading.blockHeight = jit.blockHeight();
  shading.opaque = isOpaque();
  shading.pixelCost = m_program->functions->pixelCost();
  shading.data = &m_data;
  return {};
}

void Pipeline::choosePacked(bool quads, swrast::Shading &shading, Fallback &why) {
  const fp::jit::FragmentShape &shape = m_program->functions->prepared()->shape();
  if (shape.kills || shape.writesDepth || m_key.alphaTest != abi::Compare::Always ||
      m_key.depthStencil.stencilTest)
    return;
  const abi::DepthStencilKey depth = m_key.depthStencil;
  m_key.depthStencil = {};
  // with this key the function has the type of packed functions
  shading.packed = reinterpret_cast<abi::PackedShadeFunction>(functionFor(abi::Lanes::Packed, why));
  m_key.depthStencil = depth;
  shading.packsQuads = quads;
  if (depth.depthTest)
    shading.depth = {depth.layout, depth.depthCompare, depth.depthWrite != 0};
  shading.replaces = !m_key.logicOpEnabled &&
                     std::none_of(m_key.targets.begin(), m_key.targets.end(),
                                  [](const auto &target) { return target.blend.enabled != 0; });
}

void Pipeline::fillRaster(const Mirror &mirror) {
  m_raster = mirror.raster;
  m_raster.coverage = m_key.coverage;
  m_raster.clip = {0, 0, m_targets->width, m_targets->height};
  if (mirror.scissorEnabled)
    m_raster.clip = swrast::intersect(m_raster.clip, mirror.scissor);
  m_raster.upsideDownHeight = m_targets->isWindow ? m_targets->height : 0;
  // The software host's r is two steps of a depth buffer; passes of both sides must match.
  m_raster.depthResolution =
      2.0 / abi::depthStepsOf(m_targets->depthStencil ? m_targets->depthStencil->format.layout
                                                      : abi::Layout::None);
  const auto &inputs = m_program->functions->prepared()->shape().inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (isSprite(mirror, inputs[i].attribute))
      m_raster.spriteInputs |= 1u << i;
}

/// Fills m_data, except the parameters.
void Pipeline::fillData(const Mirror &mirror) {
  m_data = mirror.constants;
  m_units.fill(m_data.textures);
  const auto targetOf = [](const swrast::Image *image, int slice = 0) {
    return image ? abi::Target{image->placeOf(0, 0, slice), image->rowStride} : abi::Target{};
  };
  for (std::size_t i = 0; i < m_data.targets.size(); ++i)
    m_data.targets[i] = targetOf(m_targets->color[i], m_targets->slice[i]);
  if (m_key.depthStencil.layout != abi::Layout::None)
    m_data.depthStencil = targetOf(m_targets->depthStencil);
  m_data.windowHeight = float(m_targets->height);
  m_data.originY = swrast::planesBegin(m_raster);
}

/// Fills m_use with what m_data refers to, except the parameters.
void Pipeline::describeUse() {
  m_units.describe(m_use);
  std::size_t count = 0;
  for (const swrast::Image *const image : m_targets->color)
    if (image)
      m_written[count++] = image->storage.get();
  if (m_key.depthStencil.layout != abi::Layout::None)
    m_written[count++] = m_targets->depthStencil->storage.get();
  m_use.targets = {m_written.data(), count};
  m_use.functions = m_program->functions;
}

/// Collects the pending clears of the draw's targets.
void Pipeline::takeClears() {
  m_raster.clears = {};
  for (const swrast::Image *const image : m_targets->color)
    if (image)
      m_raster.clears.add(image->storage->pendingClear());
  if (m_key.depthStencil.layout != abi::Layout::None)
    m_raster.clears.add(m_targets->depthStencil->storage->pendingClear());
}

/// Makes the shadows of the targets valid for writing.
Outcome Pipeline::acquire(RasterContext &context, const IndexRange &indices, std::uint32_t count,
                          bool opaque, swrast::Topology topology) {
  const abi::DepthStencilKey &depth = m_key.depthStencil;
  if (context.software->residency.targetsHeld(depth.depthTest != 0 || depth.stencilTest != 0))
    return {};
  swrast::Rect overwritten;
  if (opaque && count != 0)
    overwritten =
        swrast::surelyCovered(m_raster, topology, m_vertices.vertices(), indices.indices, 0, count);
  if (!context.software->residency.acquireTargets(overwritten, depth.depthTest != 0,
                                                  depth.stencilTest != 0))
    return Fallback::Memory;
  return {};
}

Outcome Pipeline::transform(RasterContext &context, const VertexSource &source,
                            const IndexRange &indices, std::uint32_t first, std::uint32_t count,
                            bool later) {
  const Mirror &mirror = context.software->mirror;
  const bool unfilled = mirror.raster.front != swrast::PolygonMode::Fill ||
                        mirror.raster.back != swrast::PolygonMode::Fill;
  const bool indexed = indices.indices != nullptr;
  const std::uint32_t begin = indexed ? indices.minimum : first;
  const std::uint32_t fetched = indexed ? indices.maximum - indices.minimum + 1 : count;
  return m_vertices.run(context, context.software->mirror, source, begin, fetched, unfilled, later);
}

Outcome Pipeline::readyPixels(RasterContext &context, const IndexRange &indices,
                              std::uint32_t count, abi::Interpolation inputs,
                              swrast::Topology topology, const swrast::Shading *&shading) {
  const Mirror &mirror = context.software->mirror;
  const Prepared &prepared = m_prepared[std::size_t(inputs)];
  if (!prepared.ready)
    if (const Outcome outcome = chooseFunctions(mirror, inputs); !outcome.ok())
      return outcome;

  constexpr std::uint32_t kRasterGroups =
      dirty::kViewport | dirty::kRaster | dirty::kTexGen | dirty::kTextureParameters;
  constexpr std::uint32_t kDataGroups = dirty::kPixelOps | dirty::kViewport;
  const std::uint32_t changed = m_filled ? mirror.clock.changedSince(m_filledSeen) : dirty::kAll;
  if ((changed & kRasterGroups) != 0)
    fillRaster(mirror);
  if (const Outcome outcome = acquire(context, indices, count, prepared.shading.opaque, topology);
      !outcome.ok())
    return outcome;
  // After acquire(), which may give an image other memory.
  const std::uint64_t images = context.software->residency.version();
  if ((changed & kDataGroups) != 0 || images != m_filledImages)
    fillData(mirror);
  if (!m_filled || images != m_filledImages)
    describeUse();
  m_filled = true;
  m_filledSeen = mirror.clock.now();
  m_filledImages = images;
  m_program->values->update(context, mirror.clock,
                            m_compiled ? &context.row(m_compiled->target) : nullptr);
  m_data.parameters = m_program->values->data();
  m_use.parameterRows = std::uint32_t(m_program->values->size());
  takeClears();
  shading = &prepared.shading;
  return {};
}

namespace {

/// True if llvmpipe draws with its clipping path. It does so for every primitive while smooth lines
/// or points are enabled, and then lacks polygon offset and two-sidedness of its fast path.
bool takesClippingPath(const Mirror &mirror, bool twoSided) {
  const swrast::RasterState &raster = mirror.raster;
  return (mirror.smoothLines || mirror.smoothPoints) &&
         (raster.offsetFill || raster.offsetLine || raster.offsetPoint || twoSided);
}

bool hasFlatInput(const swrast::Shading &shading) {
  const auto *const end = shading.interpolation + shading.inputCount;
  return std::find(shading.interpolation, end, abi::Interpolation::Flat) != end;
}

/// True if no vertex has a colour of its own. Fixed function's fragments then have no such inputs
/// on hosts.
bool hasOneColor(const VertexSource &source) {
  return !source.arrays[kColor].base && !source.arrays[kSecondary].base;
}

} // namespace

/// True if llvmpipe splits quads from the second corner to the fourth: in lists, with indices, and
/// where the provoking vertex matters.
bool Pipeline::cutsSecondDiagonal(const RasterContext &context, const VertexSource &source,
                                  const IndexRange &indices, const swrast::Shading &shading) const {
  if (source.fromList || indices.indices)
    return true;
  const bool isFixed = !m_compiled && hasFixedVertices();
  const bool isUnlit = !context.software->mirror.vertex.lighting;
  return m_raster.flatShade && hasFlatInput(shading) &&
         !(isFixed && isUnlit && hasOneColor(source));
}

Outcome Pipeline::rasterize(RasterContext &context, const VertexSource &source,
                            const IndexRange &indices, std::uint32_t count,
                            abi::Interpolation inputs, const Joining &primitives) {
  const swrast::Topology topology = primitives.topology;
  const swrast::Shading *shading = nullptr;
  if (const Outcome outcome = readyPixels(context, indices, count, inputs, topology, shading);
      !outcome.ok())
    return outcome;
  m_raster.partsProvokeOtherwise = primitives.provokingIsFirst != m_raster.provokingIsFirst;
  m_raster.secondDiagonal = cutsSecondDiagonal(context, source, indices, *shading);
  m_raster.inClippingPath = takesClippingPath(context.software->mirror, m_vertices.isTwoSided());
  swrast::DrawQueue &draws = context.software->draws;
  if (draws.add(m_raster, *shading, topology, m_vertices.vertices(), indices.indices, 0, count,
                m_use))
    return {};
  draws.finish();
  if (swrast::rasterize(m_raster, *shading, topology, m_vertices.vertices(), indices.indices, 0,
                        count)
          .incomplete)
    throw std::bad_alloc();
  return {};
}

Outcome Pipeline::shade(RasterContext &context, const VertexSource &source,
                        const IndexRange &indices, std::uint32_t first, std::uint32_t count) {
  if (const Outcome outcome = transform(context, source, indices, first, count, false);
      !outcome.ok())
    return outcome;
  return rasterize(context, source, indices, count, swrast::interpolationOf(m_vertices.vertices()),
                   {m_topology, context.software->mirror.raster.provokingIsFirst});
}

Outcome Pipeline::shadeJoined(RasterContext &context, const VertexSource &source,
                              const IndexRange &indices, const Joining &joining) {
  if (const Outcome outcome = transform(context, source, indices, 0, indices.count, false);
      !outcome.ok())
    return outcome;
  return rasterize(context, source, indices, indices.count,
                   swrast::interpolationOf(m_vertices.vertices()), joining);
}

Outcome Pipeline::shadePart(RasterContext &context, const VertexSource &source,
                            const IndexRange &indices, std::uint32_t first, std::uint32_t count,
                            swrast::Topology topology) {
  if (const Outcome outcome = transform(context, source, indices, first, count, true);
      !outcome.ok())
    return outcome;
  return rasterize(context, source, indices, count, abi::Interpolation::Perspective,
                   {topology, context.software->mirror.raster.provokingIsFirst});
}

// --- Fragments at the raster position: bitmaps and pixel rectangles ---

namespace {

/// Returns the slots of the raster position's values that fragments read.
std::uint32_t rasterSlots(const fp::jit::FragmentShape &shape) {
  std::uint32_t slots = 0;
  for (const fp::jit::FragmentInput &input : shape.inputs)
    slots |= 1u << slotOf(input.attribute);
  return slots;
}

/// Rounds as hosts do: images begin at whole pixels.
std::int32_t nearestPixel(float raster) {
  constexpr float kFar = 1 << 20;
  return std::int32_t(std::nearbyint(std::clamp(raster, -kFar, kFar)));
}

/// Rounds as hosts do: they add a little, so that a rounding error does not move a whole position.
std::int32_t pixelAt(float raster, float origin) {
  constexpr float kLittle = 0.0001f, kFar = 1 << 20;
  const float at = std::floor(raster + kLittle - origin);
  return at > -kFar && at < kFar ? std::int32_t(at) : std::int32_t(kFar);
}

} // namespace

Outcome Pipeline::readyFragments(RasterContext &context, const swrast::Shading *&shading,
                                 swrast::BitFragments &fragments) {
  if (const Outcome outcome = chooseFragments(context); !outcome.ok())
    return outcome;
  Mirror &mirror = context.software->mirror;
  const fp::jit::FragmentShape &shape = m_program->functions->prepared()->shape();
  mirror.refreshRasterPosition(context.dirty, rasterSlots(shape));
  if (const Outcome outcome = readyPixels(context, {}, 0, abi::Interpolation::Linear,
                                          swrast::Topology::Points, shading);
      !outcome.ok())
    return outcome;
  const float *const position = mirror.rasterPosition.position;
  // Hosts draw a rectangle in clip space, so depth is converted there and back.
  fragments.z = (position[2] * 2.0f - 1.0f) * 0.5f + 0.5f;
  fragments.inverseW = position[3] != 0.0f ? 1.0f / position[3] : 1.0f;
  for (std::size_t i = 0; i < shape.inputs.size(); ++i) {
    const auto slot = std::size_t(slotOf(shape.inputs[i].attribute));
    for (std::size_t c = 0; c < 4; ++c)
      fragments.inputs[i][c] = mirror.rasterValues[slot][c];
  }
  context.software->draws.finish();
  return {};
}

Outcome Pipeline::shadeBits(RasterContext &context, const PlacedBits &bits) {
  const swrast::Shading *shading = nullptr;
  swrast::BitFragments fragments;
  if (const Outcome outcome = readyFragments(context, shading, fragments); !outcome.ok())
    return outcome;
  const float *const position = context.software->mirror.rasterPosition.position;
  (void)swrast::rasterizeBits(m_raster, *shading, bits.image, pixelAt(position[0], bits.xOrigin),
                              pixelAt(position[1], bits.yOrigin), fragments);
  return {};
}

Outcome Pipeline::shadePixels(RasterContext &context, const imaging::Pixels &pixels) {
  const swrast::Shading *shading = nullptr;
  swrast::BitFragments fragments;
  if (const Outcome outcome = readyFragments(context, shading, fragments); !outcome.ok())
    return outcome;
  const RasterPosition &raster = context.software->mirror.rasterPosition;
  if (!raster.valid)
    return {};
  std::vector<imaging::Rgba> colors = pixels.texels;
  if (m_key.clampColors) // final conversion, 3.6.4
    std::transform(colors.begin(), colors.end(), colors.begin(),
                   [](const imaging::Rgba &color) { return imaging::clamped(color); });
  swrast::PixelImage image;
  image.colors = reinterpret_cast<const float(*)[4]>(colors.data());
  image.width = pixels.width;
  image.height = pixels.height;
  image.x = nearestPixel(raster.position[0]);
  image.y = nearestPixel(raster.position[1]);
  context.host->GetFloatv(GL_ZOOM_X, &image.zoomX);
  context.host->GetFloatv(GL_ZOOM_Y, &image.zoomY);
  const auto &inputs = m_program->functions->prepared()->shape().inputs;
  const auto color = std::find_if(inputs.begin(), inputs.end(), [](const auto &input) {
    return input.attribute.kind == AttributeKind::ColorPrimary;
  });
  swrast::Shading each = *shading;
  const bool levels =
      m_units.levelsMatter() != 0 || m_program->functions->prepared()->shape().derivatives;
  Fallback whyNotPacked = Fallback::NotCompiled;
  if (!each.packed && !levels && engine()->lanes() >= kLeastPackedLanes)
    choosePacked(false, each, whyNotPacked);
  (void)swrast::rasterizePixels(m_raster, each, image, fragments,
                                color != inputs.end() ? int(color - inputs.begin()) : -1);
  return {};
}

} // namespace arbiter::state
