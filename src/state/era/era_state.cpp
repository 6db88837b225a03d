#include "state/era/era_state.h"

#include "host/host_table.h"
#include "state/core/core_context.h"
#include "state/core/errors.h"

namespace arbiter::state {

void EraClientStack::push(const CoreContext &context, Entry entry) {
  if (m_maxDepth < 0) {
    context.host->GetIntegerv(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, &m_maxDepth);
    m_entries.reserve(std::size_t(m_maxDepth > 0 ? m_maxDepth : 0)); // so that pushes never
                                                                     // allocate
  }
  if (m_entries.size() >= std::size_t(m_maxDepth))
    return; // the host raises the error
  m_entries.push_back(entry);
}

std::optional<EraClientStack::Entry> EraClientStack::pop() {
  if (m_entries.empty())
    return {};
  const Entry entry = m_entries.back();
  m_entries.pop_back();
  return entry;
}

namespace {
/// Returns Apple's vertex array object that the host's default object holds; nothing if another
/// object is bound.
std::optional<GLuint> inHostsDefault(const CoreContext &context) {
  GLint bound = 0;
  if (!context.era->offered.vertexArrayObject)
    return {};
  context.host->GetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
  return bound == 0 ? std::optional(context.era->vertexArrays.resident()) : std::nullopt;
}
} // namespace

void pushEraClient(CoreContext &context, GLbitfield mask) {
  const EraClientState &state = context.era->client;
  EraClientStack::Entry entry;
  if ((mask & GL_CLIENT_VERTEX_ARRAY_BIT) != 0) {
    entry.range = state.range;
    entry.vertexArray = inHostsDefault(context);
  }
  if ((mask & GL_CLIENT_PIXEL_STORE_BIT) != 0)
    entry.clientStorage = state.clientStorage;
  context.era->clientStack.push(context, entry);
}

void popEraClient(CoreContext &context, void (*hostPop)()) {
  EraState &era = *context.era;
  const std::optional<EraClientStack::Entry> entry = era.clientStack.pop();
  if (entry && entry->vertexArray)
    era.vertexArrays.prepareRestore(context, era.client.range, *entry->vertexArray);
  hostPop();
  if (!entry)
    return;
  if (entry->vertexArray)
    era.vertexArrays.restored(context, *entry->vertexArray);
  if (entry->range)
    era.client.range = *entry->range;
  if (entry->clientStorage)
    era.client.clientStorage = *entry->clientStorage;
}

GLenum *eraHint(CoreContext &context, GLenum target) {
  if (!context.era)
    return nullptr;
  EraState &era = *context.era;
  if (target == GL_TRANSFORM_HINT_APPLE && era.offered.transformHint)
    return &era.hints.transform;
  if (target == GL_MULTISAMPLE_FILTER_HINT_NV && era.offered.multisampleFilterHint)
    return &era.hints.multisampleFilter;
  return nullptr;
}

void setEraHint(CoreContext &context, GLenum target, GLenum mode) {
  GLenum *const hint = eraHint(context, target);
  if (!hint || (mode != GL_FASTEST && mode != GL_NICEST && mode != GL_DONT_CARE))
    return raise(context, GL_INVALID_ENUM, "Hint");
  *hint = mode;
}

bool setClientStorage(CoreContext &context, GLenum pname, bool value) {
  if (pname != GL_UNPACK_CLIENT_STORAGE_APPLE || !context.era ||
      !context.era->offered.clientStorage)
    return false;
  if (outsideBeginEnd(context, "PixelStore between Begin and End"))
    context.era->client.clientStorage = value;
  return true;
}

bool eraValue(CoreContext &context, GLenum pname, GLint &value) {
  if (const GLenum *const hint = eraHint(context, pname)) {
    value = GLint(*hint);
    return true;
  }
  if (!context.era)
    return false;
  const EraOffers &offered = context.era->offered;
  const EraClientState &client = context.era->client;
  const bool hasRange = offered.nvRange || offered.appleRange;
  switch (pname) {
  case GL_VERTEX_ARRAY_RANGE_NV:
    value = client.range.enabled ? 1 : 0;
    return hasRange;
  case GL_VERTEX_ARRAY_RANGE_LENGTH_NV:
    value = client.range.length;
    return hasRange;
  case GL_VERTEX_ARRAY_RANGE_VALID_NV: // Apple's storage hint has the same value
    value = !offered.nvRange || (offered.appleRange && client.range.spoken)
                ? GLint(client.range.storageHint)
                : GLint(isValid(context, client.range));
    return hasRange;
  case GL_MAX_VERTEX_ARRAY_RANGE_ELEMENT_NV:
    value = kMaxVertexArrayRangeElement;
    return hasRange;
  case GL_POINT_SPRITE_R_MODE_NV:
    value = GLint(context.era->sprites.rMode);
    return offered.pointSprite;
  case GL_UNPACK_CLIENT_STORAGE_APPLE:
    value = client.clientStorage ? 1 : 0;
    return offered.clientStorage;
  case GL_VERTEX_ARRAY_BINDING: // Apple's name has the same value
    if (!offered.vertexArrayObject || context.era->vertexArrays.resident() == 0)
      return false;
    context.host->GetIntegerv(GL_VERTEX_ARRAY_BINDING, &value);
    if (value == 0)
      value = GLint(context.era->vertexArrays.resident());
    return true;
  default:
    return false;
  }
}

namespace {
Fences &fencesOf(EraState &era, FenceOf of) {
  return of == FenceOf::Nv ? era.nvFences : era.appleFences;
}
} // namespace

void setFence(CoreContext &context, FenceOf of, GLuint name, GLenum condition) {
  if (condition != GL_ALL_COMPLETED_NV)
    return raise(context, GL_INVALID_ENUM, "SetFence: condition");
  if (context.era)
    fencesOf(*context.era, of).set(context, name);
}

void finishFence(CoreContext &context, FenceOf of, GLuint name) {
  if (!context.era)
    return;
  Fences &fences = fencesOf(*context.era, of);
  // APPLE_fence: a name that was generated and never set acts as a finished fence.
  if (of == FenceOf::Apple ? !fences.isName(name) : !fences.isFence(name))
    return raise(context, GL_INVALID_OPERATION, "FinishFence: no fence of that name");
  fences.finish(context, name);
}

} // namespace arbiter::state
