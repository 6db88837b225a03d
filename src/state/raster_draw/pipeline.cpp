#include "state/raster_draw/pipeline.h"

#include <algorithm>
#include <cstring>
#include <new>

#include "state/core/context.h"
#include "state/host_draw/linked_program.h"
#include "state/raster_draw/context_state.h"
#include "swrast/setup/rectangle.h"

namespace arbiter::state::software {

namespace {

using fp::ir::AttributeKind;

/// GL's modes GL_POINTS to GL_POLYGON are 0 to 9, as Topology's.
static_assert(GL_POLYGON == GLenum(swrast::Topology::Polygon));

/// From so many vertices on primitives are taken to be small: 2x2 quads waste fewer lanes.
constexpr std::uint32_t kManyVertices = 256;

/// The groups that decide about a choice, but for those that VertexState::version and
/// Mirror::obstacle stand for.
constexpr std::uint32_t kChoice = dirty::kTextureBindings | dirty::kTextureParameters |
                                  dirty::kRaster | dirty::kPixelOps | dirty::kFog | dirty::kQueries;
/// Those, and more, where fixed function shades fragments.
constexpr std::uint32_t kFixedChoice = kChoice | dirty::kTexGen | dirty::kLighting;

bool anyFloat(const DrawTargets &targets) {
  return std::any_of(
      std::begin(targets.color), std::end(targets.color),
      [](const swrast::Image *image) { return image && abi::isFloat(image->format.layout); });
}

/// Fixed function's fog, colour sum and some environments clamp where a fragment program's options
/// and instructions do, and must not while colours are unclamped (ARB_color_buffer_float).
bool clampsInside(const fp::ir::Program &fixed) {
  return fixed.options.fog != fp::ir::FogMode::None || fixed.options.colorSum ||
         std::any_of(fixed.code.begin(), fixed.code.end(),
                     [](const fp::ir::Instruction &each) { return each.dst.saturate; });
}

/// The components that a format stores, as a write mask.
unsigned storedMask(const abi::Format &format) {
  unsigned mask = 0;
  for (unsigned i = 0; i < 4; ++i)
    if (format.swizzle[i] != abi::From::Zero && format.swizzle[i] != abi::From::One)
      mask |= 1u << i;
  return mask;
}

/// Alpha alone, or one intensity: hosts blend such buffers by rules of their own.
bool isOneValue(const abi::Format &format) { return format.swizzle[3] == abi::From::C0; }

} // namespace

void Pipeline::takeProgram(Context &context, const std::shared_ptr<const fp::ir::Program> &source) {
  m_program = &m_programs.find(source, m_program);
  if (!m_program->functions)
    m_program->functions = fragmentFunctions(source, context.numerics, m_wait);
}

Outcome Pipeline::makeKey(Context &context, Mirror &mirror) {
  const fp::jit::FragmentShape &shape = m_program->functions->prepared()->shape();
  m_key = mirror.pixelOps;
  m_key.numerics = std::uint8_t(context.numerics);
  abi::DepthStencilKey &depth = m_key.depthStencil;
  depth.layout =
      m_targets->depthStencil ? m_targets->depthStencil->format.layout : abi::Layout::None;
  if (m_targets->depthBits == 0 || depth.layout == abi::Layout::None)
    depth.depthTest = depth.depthWrite = 0;
  if (m_targets->stencilBits == 0 || depth.layout == abi::Layout::None)
    depth.stencilTest = 0;
  if (!depth.depthTest && !depth.stencilTest)
    depth = {};
  for (int i = 0; i < abi::kMaxColorTargets; ++i) {
    abi::ColorTargetKey &target = m_key.targets[std::size_t(i)];
    if (!m_targets->color[i]) {
      target = {};
      continue;
    }
    target.format = m_targets->color[i]->format;
    target.writeMask &= std::uint8_t(storedMask(target.format));
    if (target.blend.enabled && isOneValue(target.format))
      return Fallback::Target;
  }
  if (mirror.clampFixedOnly && m_floatTarget)
    m_key.clampColors = 0;
  if (!m_compiled && !m_key.clampColors && clampsInside(*m_program->source))
    return Fallback::State;
  if (!testsDepth() || context.software->mayTestDepth())
    return m_units.bind(context, mirror, shape, m_key);
  // Last: what the rasterizer lacks is the host's turn in mixed frames too, or else one without a
  // turn would say that the next can be drawn as a whole, and frames would be drawn by turns.
  const Outcome lacking = m_units.judge(context, mirror, shape);
  return lacking.ok() ? Outcome(Fallback::Mixed) : lacking;
}

Pipeline::Basis Pipeline::basisOf(const Context &context, const Mirror &mirror, const Kind &kind) {
  return {context.selections,          context.software->residency.version(),
          mirror.vertex.version,       kind.mode,
          kind.count >= kManyVertices, context.software->mayTestDepth()};
}

Outcome Pipeline::choose(Context &context, const Kind &kind) {
  Mirror &mirror = context.software->mirror;
  mirror.refresh(context.dirty);
  if (mirror.obstacle)
    return fallbackNamed(mirror.obstacle, Fallback::State);
  if (m_chosen) {
    mirror.refreshVertexState(m_floatTarget);
    const std::uint32_t deciding = m_compiled ? kChoice : kFixedChoice;
    if ((mirror.clock.changedSince(m_seen) & deciding) == 0 &&
        (context.dirty & dirty::kFramebuffer) == 0 && basisOf(context, mirror, kind) == m_basis) {
      m_seen = mirror.clock.now();
      return {};
    }
  }
  m_chosen = m_filled = m_prepared[0].ready = m_prepared[1].ready = false;
  const Outcome outcome = chooseAnew(context, mirror, kind);
  if (outcome.ok()) {
    m_chosen = true;
    m_basis = basisOf(context, mirror, kind);
    m_seen = mirror.clock.now();
  }
  return outcome;
}

Outcome Pipeline::chooseAnew(Context &context, Mirror &mirror, const Kind &kind) {
  const bool isBitmap = kind.mode == GL_BITMAP;
  m_topology = isBitmap ? swrast::Topology::Points : swrast::Topology(kind.mode);
  m_many = kind.count >= kManyVertices;
  m_wait = context.software->forced ? Wait::UntilDone : Wait::Briefly;
  if (context.numerics == fp::Numerics::Fp24 || !engine())
    return Fallback::NotCompiled;
  m_compiled = context.linkedProgram ? context.linkedProgram->fragment.compiled : nullptr;
  Outcome outcome;
  const auto fixed = m_compiled ? nullptr : m_fixed.get(context, mirror, outcome);
  if (!outcome.ok())
    return outcome;
  takeProgram(context, m_compiled ? m_compiled->program : fixed);
  const fp::jit::FragmentProgram *const prepared = m_program->functions->prepared();
  if (!prepared)
    return m_program->functions->progress() == Progress::Making ? Fallback::Compiling
                                                                : Fallback::NotCompiled;
  if (!m_program->values)
    m_program->values = std::make_unique<ProgramValues>(prepared->program());
  if (const char *const obstacle = isBitmap ? nullptr : mirror.obstacleOf(m_topology))
    return fallbackNamed(obstacle, Fallback::State);
  const char *reason = nullptr;
  m_targets = context.software->residency.describeTargets(reason);
  if (!m_targets)
    return fallbackNamed(reason, Fallback::Target);
  m_floatTarget = anyFloat(*m_targets);
  if (isBitmap)
    return makeKey(context, mirror);
  const CompiledProgram *const vertexProgram =
      context.linkedProgram ? context.linkedProgram->vertex.compiled : nullptr;
  if (const Outcome vertices =
          m_vertices.choose(context, mirror, vertexProgram, prepared->shape(),
                            mirror.drawsPoints(m_topology), m_floatTarget, m_wait);
      !vertices.ok())
    return vertices;
  return makeKey(context, mirror);
}

abi::ShadeFunction Pipeline::functionFor(abi::Lanes lanes, Fallback &why) {
  m_key.lanes = lanes;
  FragmentFunctions::Slot *slot = nullptr;
  for (const Recent &recent : m_program->recent)
    if (recent.slot && std::memcmp(&recent.key, &m_key, sizeof m_key) == 0)
      slot = recent.slot;
  if (!slot) {
    slot = &m_program->functions->slot(m_key, m_wait);
    m_program->recent[m_program->nextRecent++ % m_program->recent.size()] = {m_key, slot};
  }
  const abi::ShadeFunction function = slot->function.load(std::memory_order_acquire);
  if (!function)
    why = slot->progress.load(std::memory_order_acquire) == Progress::Failed ? Fallback::NotCompiled
                                                                             : Fallback::Compiling;
  return function;
}

Outcome Pipeline::chooseFunctions(const Mirror &mirror, bool affine) {
  const fp::jit::FragmentShape &shape = m_program->functions->prepared()->shape();
  Prepared &prepared = m_prepared[affine ? 1 : 0];
  swrast::Shading &shading = prepared.shading;
  shading = {};
  shading.inputCount = std::uint32_t(shape.inputs.size());
  for (std::size_t i = 0; i < shape.inputs.size(); ++i) {
    const AttributeKind kind = shape.inputs[i].attribute.kind;
    const bool color = kind == AttributeKind::ColorPrimary || kind == AttributeKind::ColorSecondary;
    m_key.inputs[i] = color && mirror.raster.flatShade ? abi::Interpolation::Flat
                      : affine                         ? abi::Interpolation::Linear
                                                       : abi::Interpolation::Perspective;
    shading.interpolation[i] = m_key.inputs[i];
    shading.inputComponents[i] = shape.inputs[i].components;
  }
  const std::uint32_t levels = m_units.levelsMatter();
  const bool quadsOnly = (levels & shape.needsQuads) != 0 || (levels != 0 && !affine);
  Fallback why = Fallback::NotCompiled;
  if (!quadsOnly)
    shading.row = functionFor(abi::Lanes::Row, why);
  if (quadsOnly || m_many)
    shading.quad = functionFor(abi::Lanes::Quad, why);
  if (!shading.row && !shading.quad)
    return why;
  Fallback whyNotPacked = Fallback::NotCompiled;
  const fp::jit::Engine &jit = *engine();
  if (shading.quad && jit.lanes() == 16)
    choosePacked(levels != 0, shading, whyNotPacked);
  prepared.ready = why != Fallback::Compiling && whyNotPacked != Fallback::Compiling;
  shading.lanes = jit.lanes();
  shading.blockWidth = jit.blockWidth();
  shading.blockHeight = jit.blockHeight();
  shading.opaque = isOpaque();
  shading.data = &m_data;
  return {};
}

void Pipeline::choosePacked(bool levels, swrast::Shading &shading, Fallback &why) {
  const fp::jit::FragmentShape &shape = m_program->functions->prepared()->shape();
  if (shape.kills || shape.writesDepth || m_key.alphaTest != abi::Compare::Always ||
      m_key.depthStencil.stencilTest)
    return;
  const abi::DepthStencilKey depth = m_key.depthStencil;
  m_key.depthStencil = {};
  shading.packed = functionFor(abi::Lanes::Packed, why);
  m_key.depthStencil = depth;
  shading.packsQuads = levels;
  if (depth.depthTest)
    shading.depth = {depth.layout, depth.depthCompare, depth.depthWrite != 0};
  shading.replaces = !m_key.logicOpEnabled &&
                     std::none_of(m_key.targets.begin(), m_key.targets.end(),
                                  [](const auto &target) { return target.blend.enabled != 0; });
}

bool Pipeline::isOpaque() const {
  const fp::jit::FragmentShape &shape = m_program->functions->prepared()->shape();
  if (shape.kills || m_key.alphaTest != abi::Compare::Always || m_key.logicOpEnabled ||
      m_key.depthStencil.layout != abi::Layout::None)
    return false;
  return std::all_of(m_key.targets.begin(), m_key.targets.end(), [](const auto &target) {
    return target.format.layout == abi::Layout::None ||
           (!target.blend.enabled && target.writeMask == storedMask(target.format));
  });
}

void Pipeline::fillRaster(const Mirror &mirror) {
  m_raster = mirror.raster;
  m_raster.clip = {0, 0, m_targets->width, m_targets->height};
  if (mirror.scissorEnabled)
    m_raster.clip = swrast::intersect(m_raster.clip, mirror.scissor);
  m_raster.upsideDownHeight = m_targets->isWindow ? m_targets->height : 0;
  // The software host's r is two steps of a depth buffer; passes of both must meet.
  const swrast::Image *const depth = m_targets->depthStencil;
  const bool is32 = depth && depth->format.layout == abi::Layout::Depth32;
  m_raster.depthResolution = 2.0 / (m_targets->depthBits == 16 ? 65535.0
                                    : is32                     ? 4294967295.0
                                                               : 16777215.0);
  const auto &inputs = m_program->functions->prepared()->shape().inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (inputs[i].attribute.kind == AttributeKind::TexCoord && inputs[i].attribute.index < 8 &&
        (mirror.spriteCoords >> inputs[i].attribute.index & 1) != 0)
      m_raster.spriteInputs |= 1u << i;
}

/// All but the parameters.
void Pipeline::fillData(const Mirror &mirror) {
  m_data = mirror.constants;
  m_units.fill(m_data);
  const auto targetOf = [](const swrast::Image *image, int slice = 0) {
    return image ? abi::Target{image->pixel(0, 0, slice), image->rowStride} : abi::Target{};
  };
  for (std::size_t i = 0; i < m_data.targets.size(); ++i)
    m_data.targets[i] = targetOf(m_targets->color[i], m_targets->slice[i]);
  if (m_key.depthStencil.layout != abi::Layout::None)
    m_data.depthStencil = targetOf(m_targets->depthStencil);
  m_data.windowHeight = float(m_targets->height);
}

/// The targets' shadows become valid to write to.
Outcome Pipeline::acquire(Context &context, const IndexRange &indices, std::uint32_t count,
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

Outcome Pipeline::transform(Context &context, const VertexSource &source, const IndexRange &indices,
                            std::uint32_t first, std::uint32_t count, bool later) {
  const Mirror &mirror = context.software->mirror;
  const bool unfilled = mirror.raster.front != swrast::PolygonMode::Fill ||
                        mirror.raster.back != swrast::PolygonMode::Fill;
  const bool indexed = indices.indices != nullptr;
  const std::uint32_t begin = indexed ? indices.minimum : first;
  const std::uint32_t fetched = indexed ? indices.maximum - indices.minimum + 1 : count;
  return m_vertices.run(context, context.software->mirror, source, begin, fetched, unfilled, later);
}

Outcome Pipeline::readyPixels(Context &context, const IndexRange &indices, std::uint32_t count,
                              bool affine, swrast::Topology topology,
                              const swrast::Shading *&shading) {
  const Mirror &mirror = context.software->mirror;
  const Prepared &prepared = m_prepared[affine ? 1 : 0];
  if (!prepared.ready)
    if (const Outcome outcome = chooseFunctions(mirror, affine); !outcome.ok())
      return outcome;

  constexpr std::uint32_t kRasterGroups =
      dirty::kViewport | dirty::kRaster | dirty::kTexGen | dirty::kTextureParameters;
  constexpr std::uint32_t kDataGroups = dirty::kPixelOps | dirty::kFog | dirty::kViewport;
  const std::uint32_t changed = m_filled ? mirror.clock.changedSince(m_filledSeen) : dirty::kAll;
  if ((changed & kRasterGroups) != 0)
    fillRaster(mirror);
  if (const Outcome outcome = acquire(context, indices, count, prepared.shading.opaque, topology);
      !outcome.ok())
    return outcome;
  // Only now: to acquire an image may give it other memory.
  const std::uint64_t images = context.software->residency.version();
  if ((changed & kDataGroups) != 0 || images != m_filledImages)
    fillData(mirror);
  m_filled = true;
  m_filledSeen = mirror.clock.now();
  m_filledImages = images;
  m_program->values->update(context, mirror.clock,
                            m_compiled ? &context.row(m_compiled->target) : nullptr);
  m_data.parameters = m_program->values->data();
  shading = &prepared.shading;
  return {};
}

Outcome Pipeline::rasterize(Context &context, const VertexSource &source, const IndexRange &indices,
                            std::uint32_t count, bool affine, swrast::Topology topology) {
  const swrast::Shading *shading = nullptr;
  if (const Outcome outcome = readyPixels(context, indices, count, affine, topology, shading);
      !outcome.ok())
    return outcome;
  m_raster.secondDiagonal = source.fromList;
  if (swrast::rasterize(m_raster, *shading, topology, m_vertices.vertices(), indices.indices, 0,
                        count)
          .incomplete)
    throw std::bad_alloc();
  return {};
}

Outcome Pipeline::shade(Context &context, const VertexSource &source, const IndexRange &indices,
                        std::uint32_t first, std::uint32_t count) {
  if (const Outcome outcome = transform(context, source, indices, first, count, false);
      !outcome.ok())
    return outcome;
  return rasterize(context, source, indices, count, swrast::isAffine(m_vertices.vertices()),
                   m_topology);
}

Outcome Pipeline::shadePart(Context &context, const VertexSource &source, const IndexRange &indices,
                            std::uint32_t first, std::uint32_t count, swrast::Topology topology) {
  if (const Outcome outcome = transform(context, source, indices, first, count, true);
      !outcome.ok())
    return outcome;
  return rasterize(context, source, indices, count, false, topology);
}

} // namespace arbiter::state::software
