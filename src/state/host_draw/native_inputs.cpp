#include "state/host_draw/native_inputs.h"

#include "host/host_table.h"
#include "state/host_draw/variants/array_variants.h"
#include "state/programs/nv/matrix_tracking.h"
#include "state/programs/nv/nv_state.h"

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

} // namespace

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
