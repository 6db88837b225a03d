// Chooses what a draw is drawn with: the fragment program, the targets, the vertex function, and
// the key for pixels' functions.
#include <algorithm>

#include "fp_compiler/ir/ir.h"
#include "host/host_table.h"
#include "state/objects/linked_program.h"
#include "state/programs/variants/point_sprites.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/pipeline.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

/// GL_POINTS to GL_POLYGON are 0 to 9, in Topology's order.
static_assert(GL_POLYGON == GLenum(swrast::Topology::Polygon));

/// True if primitives are assumed to be small, so that 2x2 quads waste fewer lanes.
bool isMany(const RasterContext &context, std::uint32_t vertices) {
  return vertices == 0 ? context.software->habits.recordsMany : vertices >= kManyVertices;
}

/// The groups of state that decide about a choice. VertexState::version and Mirror::obstacle stand
/// for others.
constexpr std::uint32_t kChoice = dirty::kTextureBindings | dirty::kTextureParameters |
                                  dirty::kRaster | dirty::kPixelOps | dirty::kFog | dirty::kQueries;
/// The groups if fixed function shades fragments.
constexpr std::uint32_t kFixedChoice = kChoice | dirty::kTexGen | dirty::kLighting;

bool anyFloat(const DrawTargets &targets) {
  return std::any_of(
      std::begin(targets.color), std::end(targets.color),
      [](const swrast::Image *image) { return image && abi::isFloat(image->format.layout); });
}

bool testsAny(const abi::DepthStencilKey &depth) {
  return depth.depthTest != 0 || depth.stencilTest != 0;
}

/// True if draws with this key test depth or stencil of these targets.
bool testsAny(const abi::DepthStencilKey &depth, const DrawTargets &targets) {
  return targets.depthStencil && targets.depthStencil->format.layout != abi::Layout::None &&
         ((depth.depthTest != 0 && targets.depthBits != 0) ||
          (depth.stencilTest != 0 && targets.stencilBits != 0));
}

/// Updates the kept look before a draw that has a look. In a mixed frame, a draw that needs a whole
/// frame gives looks to the host.
const KeptLook &keepsLook(RasterContext &context, bool needsWhole) {
  ContextState &state = *context.software;
  KeptLook &look = state.history.look;
  look.meets(state.history.backOff.followsHost());
  if (needsWhole && !state.mayTestDepth())
    look.becomesHosts();
  return look;
}

/// Returns the looks of draws to the bound framebuffer object. Windows are not asked, because that
/// may require measuring their size.
Looks looksOfObject(RasterContext &context) {
  GLint bound = 0;
  context.host->GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  const char *reason = nullptr;
  const DrawTargets *const targets =
      bound != 0 ? context.software->residency.describeTargets(reason) : nullptr;
  Looks looks = 0;
  for (int i = 0; targets && i < abi::kMaxColorTargets; ++i)
    if (targets->color[i])
      looks |= looksOf(targets->color[i]->format.layout);
  return looks;
}

using SpriteThird = swrast::RasterState::SpriteThird;
SpriteThird spriteThirdNow(const RasterContext &context) {
  const GLenum mode = spriteMode(context);
  return mode == GL_S ? SpriteThird::S : mode == GL_R ? SpriteThird::R : SpriteThird::Zero;
}

/// True if fixed function's code clamps colours inside: fog, colour sum and some environments do.
/// This is wrong while colours are unclamped (ARB_color_buffer_float).
bool clampsInside(const fp::ir::Program &fixed) {
  return fixed.options.fog != fp::ir::FogMode::None || fixed.options.colorSum ||
         std::any_of(fixed.code.begin(), fixed.code.end(),
                     [](const fp::ir::Instruction &each) { return each.dst.saturate; });
}

/// Returns the components that a format stores, as a write mask.
unsigned storedMask(const abi::Format &format) {
  unsigned mask = 0;
  for (unsigned i = 0; i < 4; ++i)
    if (format.swizzle[i] != abi::From::Zero && format.swizzle[i] != abi::From::One)
      mask |= 1u << i;
  return mask;
}

/// True for alpha or intensity formats, which hosts blend by rules of their own.
bool isOneValue(const abi::Format &format) { return format.swizzle[3] == abi::From::C0; }

} // namespace

Outcome Pipeline::makeKey(RasterContext &context, Mirror &mirror, abi::Coverage coverage,
                          bool hasVertices) {
  const fp::jit::FragmentShape &shape = m_program->functions->prepared()->shape();
  m_key = mirror.pixelOps;
  if (coverage != abi::Coverage::Whole && shape.inputs.size() == m_key.inputs.size())
    return Fallback::State; // no room for the coverage input
  m_key.coverage = coverage;
  m_key.numerics = std::uint8_t(fp::ofInstructions(context.numerics));
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
    m_looks |= looksOf(target.format.layout);
  }
  if (keepsLooks(*context.software) &&
      keepsLook(context, needsWhole(*context.software, false)).isHosts())
    return Fallback::Look;
  if (mirror.clampFixedOnly && m_floatTarget)
    m_key.clampColors = 0;
  if (!m_compiled && !m_key.clampColors && clampsInside(*m_program->source))
    return Fallback::State;
  if (!isMixed(*context.software, testsDepth())) {
    const Outcome bound = m_units.bind(context, mirror, shape.samplers, m_key.samplers);
    return bound.ok() && hasVertices ? m_vertices.bindTextures(context, mirror, m_wait) : bound;
  }
  // Judged last. In mixed frames too, what the rasterizer lacks must count for the frame. Otherwise
  // a mixed frame would look whole, the next one would be tried, and frames would alternate.
  Outcome lacking = m_units.judge(context, mirror, shape.samplers);
  if (lacking.ok() && hasVertices)
    lacking = m_vertices.judgeTextures(context, mirror);
  return lacking.ok() ? Outcome(Fallback::Mixed) : lacking;
}

Pipeline::Basis Pipeline::basisOf(const RasterContext &context, const Mirror &mirror,
                                  const Kind *vertices) {
  Basis basis = {context.effective.selections, context.software->residency.version(),
                 context.software->mayTestDepth(), context.software->history.mixesInVain,
                 context.software->history.look.side()};
  if (vertices) {
    basis.vertices = true;
    basis.vertexState = mirror.vertex.version;
    basis.mode = vertices->mode;
    basis.many = isMany(context, vertices->count);
    basis.materials = vertices->materials;
  }
  return basis;
}

Outcome Pipeline::chooseFor(RasterContext &context, const Kind *vertices) {
  Mirror &mirror = context.software->mirror;
  releaseSprites(context); // the mirror queries the application's own state
  mirror.refresh(context.dirty);
  mirror.raster.spriteThird = spriteThirdNow(context);
  if (mirror.obstacle)
    return fallbackNamed(mirror.obstacle, Fallback::State);
  if (m_chosen || m_isHosts) {
    mirror.refreshVertexState(m_floatTarget);
    const std::uint32_t deciding = m_compiled ? kChoice : kFixedChoice;
    if ((mirror.clock.changedSince(m_seen) & deciding) == 0 &&
        (context.dirty & dirty::kFramebuffer) == 0 &&
        basisOf(context, mirror, vertices) == m_basis) {
      m_seen = mirror.clock.now();
      return m_isHosts ? Outcome(*m_isHosts) : Outcome();
    }
  }
  m_chosen = m_filled = false;
  m_isHosts.reset();
  for (Prepared &prepared : m_prepared)
    prepared.ready = false;
  const Outcome outcome = chooseAnew(context, mirror, vertices);
  m_chosen = outcome.ok();
  if (!outcome.ok() && (outcome.reason() == Fallback::Mixed || outcome.reason() == Fallback::Look))
    m_isHosts = outcome.reason();
  if (!outcome.ok() && outcome.reason() == Fallback::Compiling) {
    ContextState &state = *context.software;
    if (m_wait == Wait::Not || m_wait == Wait::ForDisk)
      state.frame.unjudged = true;
    // The last start's code on disk does not cover all, so the rest of the frame does not wait.
    if (m_wait == Wait::ForDisk)
      state.history.waitsForCode = false;
  }
  if (m_chosen || m_isHosts) {
    m_basis = basisOf(context, mirror, vertices);
    m_seen = mirror.clock.now();
  }
  return outcome;
}

Outcome Pipeline::chooseAnew(RasterContext &context, Mirror &mirror, const Kind *vertices) {
  m_many = false;
  if (const Outcome outcome = choosePixels(context, mirror, vertices); !outcome.ok())
    return outcome;
  if (vertices)
    if (const Outcome outcome = chooseVertices(context, mirror, *vertices); !outcome.ok())
      return outcome;
  return makeKey(context, mirror, vertices ? mirror.coverageOf(m_topology) : abi::Coverage::Whole,
                 vertices != nullptr);
}

bool Pipeline::keepsLooks(const ContextState &state) const {
  return m_looks != 0 && !state.forced && !m_readsRasterValues;
}

bool Pipeline::needsWhole(const ContextState &state, bool testsDepths) const {
  return testsDepths || (!m_compiled && state.history.mixesInVain);
}

bool Pipeline::isMixed(const ContextState &state, bool testsDepths) const {
  return needsWhole(state, testsDepths) && !state.mayTestDepth() && !m_readsRasterValues;
}

Outcome Pipeline::chooseSide(RasterContext &context, Mirror &mirror, const Kind *vertices) {
  ContextState &state = *context.software;
  if (!m_program->looks)
    m_program->looks = lookBasisOf(*m_program->source, !m_compiled);
  m_units.refresh(context, mirror, m_program->looks->samplers);
  m_readsRasterValues = !vertices && m_program->looks->readsRasterValues;
  m_looks = looksOf({mirror, *m_program->looks, vertices == nullptr,
                     vertices ? swrast::Topology(vertices->mode) : swrast::Topology::Points});
  const bool testsDepths = testsAny(mirror.pixelOps.depthStencil);
  if (!m_program->functions || !m_program->functions->prepared())
    m_looks |= looksOfObject(context); // a draw whose code is not ready gets no key
  const bool keeps = keepsLooks(state);
  if (keeps && keepsLook(context, needsWhole(state, testsDepths)).isHosts())
    return Fallback::Look;
  const bool isPlain = state.habits.drawsPlain && !context.effective.linkedProgram;
  const bool mayWait = isMixed(state, testsDepths) || isPlain;
  m_wait = state.steady || keeps || m_readsRasterValues             ? Wait::UntilDone
           : mayWait && state.mayGoUnjudged(isPlain)                ? Wait::Not
           : (testsDepths || isPlain) && state.history.waitsForCode ? Wait::ForDisk
                                                                    : Wait::Briefly;
  return {};
}

Outcome Pipeline::choosePixels(RasterContext &context, Mirror &mirror, const Kind *vertices) {
  if (context.numerics == fp::Numerics::Fp24)
    return Fallback::NotCompiled;
  m_compiled = context.effective.linkedProgram ? context.effective.linkedProgram->fragment.compiled
                                               : nullptr;
  Outcome outcome;
  const auto fixed = m_compiled ? nullptr : m_fixed.get(context, mirror, outcome);
  if (!outcome.ok())
    return outcome;
  m_program = &m_programs.find(m_compiled ? m_compiled->program : fixed, m_program);
  if (outcome = chooseSide(context, mirror, vertices); !outcome.ok())
    return outcome;
  if (m_wait == Wait::Not && awaitsEngine())
    return Fallback::Compiling;
  if (!engine())
    return Fallback::NotCompiled;
  if (!m_program->functions)
    m_program->functions = fragmentFunctions(m_program->source, context.numerics, m_wait);
  const fp::jit::FragmentProgram *const prepared = m_program->functions->prepared();
  if (!prepared)
    return m_program->functions->progress() == Progress::Making ? Fallback::Compiling
                                                                : Fallback::NotCompiled;
  if (!m_program->values)
    m_program->values = std::make_unique<ProgramValues>(prepared->program());
  // Measuring a window that the host draws to needs reads in each frame. It is avoided for a draw
  // that will be the host's whatever the size (makeKey()).
  Residency &residency = context.software->residency;
  const abi::DepthStencilKey &depth = mirror.pixelOps.depthStencil;
  const bool mixed = isMixed(*context.software, testsAny(depth));
  m_targets = mixed ? residency.targetsBefore() : nullptr;
  if (!m_targets || !testsAny(depth, *m_targets)) {
    const char *reason = nullptr;
    m_targets = residency.describeTargets(reason);
    if (!m_targets)
      return fallbackNamed(reason, Fallback::Target);
  }
  m_floatTarget = anyFloat(*m_targets);
  return {};
}

Outcome Pipeline::chooseVertices(RasterContext &context, Mirror &mirror, const Kind &kind) {
  m_topology = swrast::Topology(kind.mode);
  m_many = isMany(context, kind.count);
  if (const char *const obstacle = mirror.obstacleOf(m_topology))
    return fallbackNamed(obstacle, Fallback::State);
  const CompiledProgram *const vertexProgram =
      context.effective.linkedProgram ? context.effective.linkedProgram->vertex.compiled : nullptr;
  return m_vertices.choose(context, mirror, vertexProgram,
                           m_program->functions->prepared()->shape(),
                           {mirror.drawsPoints(m_topology), kind.materials}, m_floatTarget, m_wait);
}

bool Pipeline::isOpaque() const {
  const fp::jit::FragmentShape &shape = m_program->functions->prepared()->shape();
  if (shape.kills || m_key.coverage == abi::Coverage::Disc ||
      m_key.alphaTest != abi::Compare::Always || m_key.logicOpEnabled ||
      m_key.depthStencil.layout != abi::Layout::None)
    return false;
  return std::all_of(m_key.targets.begin(), m_key.targets.end(), [](const auto &target) {
    return target.format.layout == abi::Layout::None ||
           (!target.blend.enabled && target.writeMask == storedMask(target.format));
  });
}

} // namespace arbiter::state
