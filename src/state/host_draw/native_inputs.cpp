#include "state/host_draw/native_inputs.h"

#include "host/host_table.h"
#include "state/host_draw/draw_context.h"
#include "state/mirror/attribute_aliases.h"
#include "state/objects/program_object.h"
#include "state/programs/nv/matrix_tracking.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/variants/array_variants.h"
#include "util/flags.h"

namespace arbiter::state {

std::uint32_t enabledArrays(const DrawContext &context, const host::HostTable &host) {
  std::uint32_t arrays = 0;
  for (unsigned i = 0; i < 16 && i < unsigned(context.caps.maxVertexAttribs); ++i) {
    GLint enabled = 0;
    if (isAliasedRegister(i))
      host.GetVertexAttribiv(i, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
    arrays |= enabled != 0 ? 1u << i : 0u;
  }
  return arrays;
}

namespace {

void refreshArrays(DrawContext &context) {
  AttributeAliases &aliases = *context.aliases;
  const std::uint32_t arrays = aliases.immediate ? 0 : enabledArrays(context, *context.host);
  if (arrays == aliases.arrays)
    return;
  aliases.arrays = arrays;
  context.attention |= attention::kProgram;
}

/// Returns where a program finds components that only VertexAttribNV sets. Programs of NVIDIA's own
/// languages always read them. ARB programs do once there are any, because most of them read a w
/// that nobody has set. The rasterizer never aliases, so if the host does, the rasterizer keeps to
/// conventional attributes.
WiderAttributes widerAttributes(const DrawContext &context, const CompiledProgram &program) {
  const bool isNative = program.native.language != fp::ir::NativeLanguage::None;
  if (!isNative && !context.aliases->widerGiven)
    return WiderAttributes::Nowhere;
  if (!context.aliases->areOne)
    return WiderAttributes::Beside;
  return context.softwarePossible ? WiderAttributes::Nowhere : WiderAttributes::Generic;
}

} // namespace

void noteGenericArray(DrawContext &context, GLuint index, bool enabled) {
  if (!isAliasedRegister(index) || index >= GLuint(context.caps.maxVertexAttribs))
    return;
  if (enabled)
    context.aliases->arraysUsed |= 1u << index;
  context.aliases->ofProgramsAlone &= ~(1u << index);
  context.attention |= attention::kState; // makes the next draw look
}

std::shared_ptr<const CompiledProgram> withItsAttributes(DrawContext &context,
                                                         const CompiledProgram &program) {
  const ArrayVariants &forms = *program.arrays;
  const WiderAttributes wider =
      forms.readsWider() ? widerAttributes(context, program) : WiderAttributes::Nowhere;
  return forms.of(program, context.aliases->arrays, wider);
}

bool nativeInputsMayChange(const DrawContext &context) {
  const ProgramTarget &vertex = context.row(Target::Vertex);
  return (context.nv && vertex.enabled && vertex.tracked != 0) ||
         (context.aliases && context.aliases->arraysUsed != 0 &&
          (vertex.enabled || context.attributesAlias));
}

void refreshNativeInputs(DrawContext &context) {
  if (!context.row(Target::Vertex).enabled)
    return;
  if (context.nv)
    refreshTrackedMatrices(context);
  if (context.aliases->arraysUsed != 0)
    refreshArrays(context);
}

ImmediateInputs::ImmediateInputs(DrawContext &context) : m_context(context) {
  if (m_context.aliases)
    m_context.aliases->immediate = true;
}

ImmediateInputs::~ImmediateInputs() {
  if (m_context.aliases)
    m_context.aliases->immediate = false;
}

} // namespace arbiter::state
