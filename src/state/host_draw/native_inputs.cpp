#include "state/host_draw/native_inputs.h"

#include "host/host_table.h"
#include "state/host_draw/variants/array_variants.h"
#include "state/programs/nv/matrix_tracking.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/program_object.h"

namespace arbiter::state {

namespace {

/// The host is asked, as vertex array objects and the client attribute stack change them too.
std::uint32_t enabledArrays(const Context &context) {
  std::uint32_t arrays = 0;
  for (GLuint i = 0; i < NvState::kAttributes && i < GLuint(context.caps.maxVertexAttribs); ++i) {
    GLint enabled = 0;
    if ((ArrayVariants::kBoth >> i & 1u) != 0)
      context.host->GetVertexAttribiv(i, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
    arrays |= enabled != 0 ? 1u << i : 0u;
  }
  return arrays;
}

void refreshArrays(Context &context) {
  NvState &nv = *context.nv;
  const std::uint32_t arrays = nv.immediate ? 0 : enabledArrays(context);
  if (arrays == nv.arrays)
    return;
  nv.arrays = arrays;
  context.attention |= attention::kProgram;
}

/// By a value that the normal does not have. Where the two are one, the generic one's is its own.
bool attributesAreOne(const host::HostTable &host) {
  constexpr GLuint kNormal = 2;
  Vec4 generic = {0.0f, 0.0f, 0.0f, 1.0f}, normal{};
  host.GetVertexAttribfv(kNormal, GL_CURRENT_VERTEX_ATTRIB, generic.data());
  host.GetFloatv(GL_CURRENT_NORMAL, normal.data());
  const Vec4 other = {normal[0] == 0.5f ? 0.25f : 0.5f, 0.0f, 0.0f, 1.0f};
  host.VertexAttrib4fv(kNormal, other.data());
  host.GetFloatv(GL_CURRENT_NORMAL, normal.data());
  host.VertexAttrib4fv(kNormal, generic.data());
  return normal[0] == other[0];
}

/// The rasterizer's attributes are never one: where the host's are, it keeps to conventional ones.
WiderAttributes widerAttributes(Context &context) {
  std::optional<bool> &areOne = context.nv->attributesAreOne;
  if (!areOne && context.listMode != 0)
    return WiderAttributes::Beside; // what the question sets would go into the list
  if (!areOne)
    areOne = attributesAreOne(*context.host);
  if (!*areOne)
    return WiderAttributes::Beside;
  return context.softwarePossible ? WiderAttributes::Nowhere : WiderAttributes::Generic;
}

} // namespace

std::shared_ptr<const CompiledProgram> withItsAttributes(Context &context,
                                                         const CompiledProgram &program) {
  const ArrayVariants &forms = *program.arrays;
  const WiderAttributes wider =
      forms.readsWider() ? widerAttributes(context) : WiderAttributes::Nowhere;
  return forms.of(program, context.nv->arrays, wider);
}

bool nativeInputsMayChange(const Context &context) {
  const ProgramTarget &vertex = context.row(Target::Vertex);
  return context.nv && vertex.enabled && (vertex.tracked != 0 || context.nv->arraysUsed);
}

void refreshNativeInputs(Context &context) {
  if (!nativeInputsMayChange(context))
    return;
  refreshTrackedMatrices(context);
  if (context.nv->arraysUsed)
    refreshArrays(context);
}

ImmediateInputs::ImmediateInputs(Context &context) : m_context(context) {
  if (m_context.nv)
    m_context.nv->immediate = true;
}

ImmediateInputs::~ImmediateInputs() {
  if (m_context.nv)
    m_context.nv->immediate = false;
}

} // namespace arbiter::state
