#include "state/raster_draw/vertices/vertex_stage.h"

#include <algorithm>

#include "state/objects/linked_program.h"
#include "state/raster_draw/raster_context.h"
#include "swrast/threads.h"

namespace arbiter::state {

namespace {

using fp::ir::AttributeKind;
using fp::ir::OutputKind;

/// Most vertices that one call of the program's machine code transforms. The results of so few stay
/// in the cache.
constexpr std::uint32_t kStretch = swrast::Vertices::kStretch;

/// Returns the results that the program of fixed function must compute.
VertexNeeds needsOf(const fp::jit::FragmentShape &fragments, const VertexStage::Use &use) {
  VertexNeeds needs;
  needs.pointSize = use.points;
  needs.frontMaterials = std::uint8_t(use.materials & kFrontMaterial);
  needs.backMaterials = std::uint8_t(use.materials >> kMaterialParts);
  for (const fp::jit::FragmentInput &input : fragments.inputs) {
    switch (input.attribute.kind) {
    case AttributeKind::ColorPrimary:
      needs.primary = true;
      break;
    case AttributeKind::ColorSecondary:
      needs.secondary = true;
      break;
    case AttributeKind::FogCoord:
      needs.fogCoord = true;
      break;
    case AttributeKind::TexCoord:
      needs.texCoords |= std::uint8_t(1u << input.attribute.index);
      break;
    case AttributeKind::Position:
    case AttributeKind::Normal:
    case AttributeKind::Generic:
    case AttributeKind::Facing:
      break; // no vertex result is interpolated for these
    }
  }
  return needs;
}

/// Returns the vertex result that a fragment attribute interpolates. `back` selects the colours of
/// back faces.
fp::ir::Output resultOf(const fp::ir::Attribute &attribute, bool back) {
  switch (attribute.kind) {
  case AttributeKind::ColorPrimary:
    return {back ? OutputKind::BackPrimary : OutputKind::FrontPrimary, 0};
  case AttributeKind::ColorSecondary:
    return {back ? OutputKind::BackSecondary : OutputKind::FrontSecondary, 0};
  case AttributeKind::FogCoord:
    return {OutputKind::FogCoord, 0};
  default:
    return {OutputKind::TexCoord, attribute.index};
  }
}

bool isColor(const fp::ir::Attribute &attribute) {
  return attribute.kind == AttributeKind::ColorPrimary ||
         attribute.kind == AttributeKind::ColorSecondary;
}

} // namespace

void VertexStage::selectProgram(RasterContext &context,
                                const std::shared_ptr<const fp::ir::Program> &source, Wait wait) {
  m_program = &m_programs.find(source, m_program);
  if (!m_program->functions)
    m_program->functions = vertexFunctions(source, context.numerics, wait);
}

Outcome VertexStage::choose(RasterContext &context, Mirror &mirror, const CompiledProgram *compiled,
                            const fp::jit::FragmentShape &fragments, const Use &use,
                            bool floatTarget, Wait wait) {
  m_compiled = compiled;
  m_fragments = &fragments;
  mirror.refreshVertexState(floatTarget);
  m_clipPlanes = mirror.vertex.clipPlanes;
  if (!compiled) {
    selectProgram(context, m_fixed.get(mirror.vertex, needsOf(fragments, use)), wait);
    m_twoSided = mirror.vertex.lighting && mirror.vertex.twoSided;
    m_pointSize = use.points && mirror.vertex.pointAttenuation;
  } else {
    selectProgram(context,
                  m_extended.get(compiled->program, m_clipPlanes, mirror.vertex.clampColors), wait);
    m_twoSided = mirror.twoSidedColor;
    m_pointSize = use.points && mirror.pointSizeFromProgram;
  }
  const fp::jit::VertexProgram *const prepared = m_program->functions->prepared();
  if (!prepared)
    return m_program->functions->progress() == Progress::Making ? Fallback::Compiling
                                                                : Fallback::NotCompiled;
  if (!m_program->values)
    m_program->values = std::make_unique<ProgramValues>(prepared->program());
  m_shape = &prepared->shape();
  m_slots = slotsOf(m_shape->inputs);
  m_connected = false;
  findUnwritten(context);
  return {};
}

Outcome VertexStage::judgeTextures(RasterContext &context, Mirror &mirror) {
  return m_units.judge(context, mirror, m_shape->samplers);
}

Outcome VertexStage::bindTextures(RasterContext &context, Mirror &mirror, Wait wait) {
  if (m_shape->samplers.empty()) [[likely]] {
    m_function = m_program->functions->function();
    return {};
  }
  abi::VertexKey key{};
  if (const Outcome outcome = m_units.bind(context, mirror, m_shape->samplers, key.samplers);
      !outcome.ok())
    return outcome;
  m_units.fill(m_textures);
  const VertexFunctions::Slot &slot = m_program->recent.slot(*m_program->functions, key, wait);
  const Outcome outcome = outcomeOf(slot);
  m_function = slot.function.load(std::memory_order_acquire);
  return outcome;
}

void VertexStage::findUnwritten(const RasterContext &context) {
  m_unwritten.clear();
  if (!m_compiled || context.effective.linkedProgram->fragment.compiled)
    return; // only a program's vertices with the fragments of fixed function need them
  const auto &results = m_shape->outputs;
  for (std::size_t i = 0; i < m_fragments->inputs.size(); ++i) {
    const fp::ir::Attribute &attribute = m_fragments->inputs[i].attribute;
    if (std::find(results.begin(), results.end(), resultOf(attribute, false)) == results.end())
      m_unwritten.push_back({std::uint8_t(i), std::uint8_t(slotOf(attribute))});
  }
}

bool VertexStage::connectUnwritten(const Mirror &mirror) {
  for (const Unwritten &each : m_unwritten) {
    if (!m_fetcher.fetchCurrent(mirror.current[each.slot], each.slot))
      return false;
    for (int c = 0; c < 4; ++c)
      m_vertices.inputs[each.input][c] = m_fetcher.component(each.slot, c);
  }
  return true;
}

std::uint32_t VertexStage::currentSlots() const {
  auto slots = std::uint32_t(m_slots);
  for (const Unwritten &each : m_unwritten)
    slots |= 1u << each.slot;
  return slots;
}

void VertexStage::transformStretch(std::uint32_t begin, std::uint32_t end) const {
  m_fetcher.convert(begin, end);
  // The pointers lie on the stack, because several threads transform stretches at a time.
  constexpr std::size_t kMax = 4 * 64; // components of 64 attributes or results, more than exist
  const float *inputs[kMax];
  float *results[kMax];
  const std::size_t inputCount = m_shape->inputs.size(), outputCount = m_shape->outputs.size();
  for (std::size_t i = 0; i < 4 * inputCount; ++i)
    inputs[i] = m_data.inputs[i] ? m_data.inputs[i] + begin : nullptr;
  for (std::size_t i = 0; i < 4 * outputCount; ++i)
    results[i] = m_data.outputs[i] + begin;
  const abi::VertexData part{m_data.parameters, inputs, results, m_data.textures};
  m_function(&part, end - begin);
}

void VertexStage::transformAll(std::uint32_t count) const {
  auto work = [&](std::uint32_t stretch) {
    transformStretch(stretch * kStretch, std::min(count, (stretch + 1) * kStretch));
  };
  swrast::parallel((count + kStretch - 1) / kStretch, work);
}

Outcome VertexStage::run(RasterContext &context, Mirror &mirror, const VertexSource &source,
                         std::uint32_t first, std::uint32_t count, bool edgeFlags, bool later) {
  const SlotMask slots = m_slots | (edgeFlags ? 1u << kEdgeFlag : 0u);
  const bool many = count > 2 * kStretch;
  if (!(many ? m_fetcher.open(source, mirror.current, slots, first, count)
             : m_fetcher.fetch(source, mirror.current, slots, first, count)))
    return Fallback::Vertices;
  float *const *const outputs = m_fetcher.outputs(m_shape->outputs.size());
  if (!outputs)
    return Fallback::Memory;
  m_program->values->update(context, mirror.clock,
                            m_compiled ? &context.row(m_compiled->target) : nullptr);
  m_data = {m_program->values->data(), m_fetcher.inputs(m_shape->inputs), outputs,
            m_textures.data()};
  if (!m_shape->samplers.empty()) [[unlikely]]
    m_units.settle();
  later = later && many && !edgeFlags;
  if (!many)
    m_function(&m_data, count);
  else if (!later)
    transformAll(count);
  if (!m_connected || m_connectedTo != m_fetcher.outputsVersion()) {
    connect(outputs);
    m_connected = true;
    m_connectedTo = m_fetcher.outputsVersion();
  }
  if (!m_unwritten.empty() && !connectUnwritten(mirror)) [[unlikely]]
    return Fallback::Memory;
  m_vertices.count = count;
  m_vertices.edgeFlags = edgeFlags ? m_fetcher.edgeFlags() : nullptr;
  m_vertices.make = nullptr;
  if (later) {
    m_vertices.maker = this;
    m_vertices.make = [](const void *maker, std::uint32_t begin, std::uint32_t end) {
      static_cast<const VertexStage *>(maker)->transformStretch(begin, end);
    };
  }
  return {};
}

void VertexStage::connect(float *const *outputs) {
  swrast::Vertices &out = m_vertices;
  out = {};
  const auto find = [&](const fp::ir::Output &wanted) -> float *const * {
    const auto &results = m_shape->outputs;
    const auto found = std::find(results.begin(), results.end(), wanted);
    return found == results.end() ? nullptr : outputs + 4 * (found - results.begin());
  };
  if (float *const *const position = find({OutputKind::Position, 0}))
    std::copy_n(position, 4, out.position);
  for (std::size_t i = 0; i < m_fragments->inputs.size(); ++i) {
    const fp::ir::Attribute &attribute = m_fragments->inputs[i].attribute;
    const bool fog = attribute.kind == AttributeKind::FogCoord;
    const int components = fog ? 1 : 4; // fragment.fogcoord is (f, 0, 0, 1)
    if (float *const *const front = find(resultOf(attribute, false)))
      std::copy_n(front, components, out.inputs[i]);
    if (m_twoSided && isColor(attribute))
      if (float *const *const back = find(resultOf(attribute, true)))
        std::copy_n(back, 4, out.backInputs[i]);
  }
  if (m_pointSize)
    if (float *const *const size = find({OutputKind::PointSize, 0}))
      out.pointSize = size[0];
  for (std::uint8_t plane = 0; plane < 8; ++plane) {
    if ((m_clipPlanes >> plane & 1u) == 0)
      continue;
    // The layer passes its own clip distances in texture coordinates that no application has. They
    // come first, because a position-invariant program may write result.clip too.
    if (float *const *const distances =
            find({OutputKind::TexCoord, std::uint8_t(kClipDistanceOutput + plane / 4)}))
      out.clipDistance[plane] = distances[plane % 4];
    else if (float *const *const own = find({OutputKind::ClipDistance, plane}))
      out.clipDistance[plane] = own[0];
  }
}

} // namespace arbiter::state
