// The commands of fences, vertex array ranges and hints (state/era). If the layer does not offer
// them, the host answers.
#include <utility>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/era/era_state.h"
#include "state/handlers/entry/offered.h"
#include "state/lists/list_compiler.h"
#include "state/programs/program_bind.h"
#include "state/raster_draw/context_state.h"

namespace arbiter::state {

namespace {

bool offers(const Context &context, bool EraOffers::*extension) {
  return context.era && context.era->offered.*extension;
}

void generateFences(Context &context, Fences &fences, GLsizei n, GLuint *names) {
  if (!outsideBeginEnd(context, "GenFences between Begin and End"))
    return;
  if (n < 0)
    return raise(context, GL_INVALID_VALUE, "GenFences: n is negative");
  for (GLsizei i = 0; i < n; ++i)
    names[i] = fences.generate();
}

void deleteFences(Context &context, Fences &fences, GLsizei n, const GLuint *names) {
  if (!outsideBeginEnd(context, "DeleteFences between Begin and End"))
    return;
  if (n < 0)
    return raise(context, GL_INVALID_VALUE, "DeleteFences: n is negative");
  for (GLsizei i = 0; i < n; ++i)
    fences.remove(context, names[i]);
}

/// Records the command in a list, which is the layer's from then on.
void record(Context &context, Command command) {
  noteProgramApiUse(context);
  listCompiler(context).record(context, std::move(command));
}

/// Records SetFence or FinishFence in a list. Section 5.4 of both extensions does not exempt them,
/// except for NV_fence's FinishFenceNV, which is executed at once.
void recordFence(Context &context, Command::Kind kind, FenceOf of, GLuint name,
                 GLenum condition = 0) {
  record(context, {.kind = kind, .target = GLenum(of), .name = name, .format = condition});
}

void issueSet(Context &context, FenceOf of, GLuint name, GLenum condition) {
  if (!outsideBeginEnd(context, "SetFence between Begin and End"))
    return;
  if (context.listMode)
    return recordFence(context, Command::Kind::SetFence, of, name, condition);
  setFence(context, of, name, condition);
}

GLboolean testFence(Context &context, Fences &fences, bool exists, GLuint name) {
  if (exists)
    return fences.test(context, name) ? GL_TRUE : GL_FALSE;
  raise(context, GL_INVALID_OPERATION, "TestFence: no fence of that name");
  return GL_TRUE;
}

/// True if the name is an object of that type, for APPLE_fence's commands on objects other than
/// fences. The layer does not know which commands use an object, so it waits for all.
bool isObject(Context &context, GLenum object, GLuint name) {
  switch (object) {
  case GL_TEXTURE:
    return name == 0 || context.host->IsTexture(name) == GL_TRUE;
  case GL_VERTEX_ARRAY:
    return name == 0 || context.era->vertexArrays.has(name) ||
           (context.caps.vertexArrays && context.host->IsVertexArray(name) == GL_TRUE);
  case GL_DRAW_PIXELS_APPLE:
    return true;
  default:
    return false;
  }
}

void finishAll(Context &context) {
  if (context.software)
    context.software->residency.synchronise("glFinishObjectAPPLE");
  context.host->Finish();
}

VertexArrayRange *rangeOf(Context &context, bool EraOffers::*extension) {
  return offers(context, extension) ? &context.era->client.range : nullptr;
}

void setRange(Context &context, VertexArrayRange &range, GLsizei length, const void *pointer) {
  if (!outsideBeginEnd(context, "VertexArrayRange between Begin and End"))
    return;
  if (length < 0)
    return raise(context, GL_INVALID_VALUE, "VertexArrayRange: length is negative");
  range.length = length;
  range.pointer = pointer;
}

} // namespace

namespace handlers {

void GenFencesNV(Context &context, GLsizei n, GLuint *fences) {
  generateFences(context, context.era->nvFences, n, fences);
}

void GenFencesAPPLE(Context &context, GLsizei n, GLuint *fences) {
  generateFences(context, context.era->appleFences, n, fences);
}

void DeleteFencesNV(Context &context, GLsizei n, const GLuint *fences) {
  deleteFences(context, context.era->nvFences, n, fences);
}

void DeleteFencesAPPLE(Context &context, GLsizei n, const GLuint *fences) {
  deleteFences(context, context.era->appleFences, n, fences);
}

void SetFenceNV(Context &context, GLuint fence, GLenum condition) {
  if (!offered::nvFences(context)) {
    if (context.software && !context.listMode)
      context.software->residency.synchronise("glSetFenceNV");
    return context.host->SetFenceNV(fence, condition);
  }
  issueSet(context, FenceOf::Nv, fence, condition);
}

void SetFenceAPPLE(Context &context, GLuint fence) {
  issueSet(context, FenceOf::Apple, fence, GL_ALL_COMPLETED_NV);
}

GLboolean TestFenceNV(Context &context, GLuint fence) {
  if (!outsideBeginEnd(context, "TestFence between Begin and End"))
    return GL_TRUE;
  Fences &fences = context.era->nvFences;
  return testFence(context, fences, fences.isFence(fence), fence);
}

GLboolean TestFenceAPPLE(Context &context, GLuint fence) {
  if (!outsideBeginEnd(context, "TestFence between Begin and End"))
    return GL_TRUE;
  Fences &fences = context.era->appleFences;
  return testFence(context, fences, fences.isName(fence), fence);
}

void FinishFenceNV(Context &context, GLuint fence) {
  if (outsideBeginEnd(context, "FinishFence between Begin and End"))
    finishFence(context, FenceOf::Nv, fence);
}

void FinishFenceAPPLE(Context &context, GLuint fence) {
  if (!outsideBeginEnd(context, "FinishFence between Begin and End"))
    return;
  if (context.listMode)
    return recordFence(context, Command::Kind::FinishFence, FenceOf::Apple, fence);
  finishFence(context, FenceOf::Apple, fence);
}

GLboolean IsFenceNV(Context &context, GLuint fence) {
  return outsideBeginEnd(context, "IsFence between Begin and End") &&
                 context.era->nvFences.isFence(fence)
             ? GL_TRUE
             : GL_FALSE;
}

GLboolean IsFenceAPPLE(Context &context, GLuint fence) {
  return outsideBeginEnd(context, "IsFence between Begin and End") &&
                 context.era->appleFences.isFence(fence)
             ? GL_TRUE
             : GL_FALSE;
}

void GetFenceivNV(Context &context, GLuint fence, GLenum pname, GLint *params) {
  if (!outsideBeginEnd(context, "GetFenceiv between Begin and End"))
    return;
  Fences &fences = context.era->nvFences;
  if (!fences.isFence(fence))
    return raise(context, GL_INVALID_OPERATION, "GetFenceiv: no fence of that name");
  if (pname == GL_FENCE_STATUS_NV)
    *params = fences.test(context, fence) ? GL_TRUE : GL_FALSE;
  else if (pname == GL_FENCE_CONDITION_NV)
    *params = GL_ALL_COMPLETED_NV;
  else
    raise(context, GL_INVALID_ENUM, "GetFenceiv: pname");
}

GLboolean TestObjectAPPLE(Context &context, GLenum object, GLuint name) {
  if (object == GL_FENCE_APPLE)
    return TestFenceAPPLE(context, name);
  if (!outsideBeginEnd(context, "TestObject between Begin and End"))
    return GL_TRUE;
  if (isObject(context, object, name))
    finishAll(context);
  else
    raise(context, GL_INVALID_OPERATION, "TestObject: no object of that kind and name");
  return GL_TRUE;
}

void FinishObjectAPPLE(Context &context, GLenum object, GLint name) {
  if (object == GL_FENCE_APPLE)
    return FinishFenceAPPLE(context, GLuint(name));
  if (!outsideBeginEnd(context, "FinishObject between Begin and End"))
    return;
  if (!isObject(context, object, GLuint(name)))
    return raise(context, GL_INVALID_OPERATION, "FinishObject: no object of that kind and name");
  finishAll(context);
}

// --- Vertex array ranges, which are never compiled into lists (5.4 of VAR) ---

void VertexArrayRangeNV(Context &context, GLsizei length, const void *pointer) {
  VertexArrayRange *const range = rangeOf(context, &EraOffers::nvRange);
  if (!range)
    return context.host->VertexArrayRangeNV(length, pointer);
  setRange(context, *range, length, pointer);
}

void VertexArrayRangeAPPLE(Context &context, GLsizei length, void *pointer) {
  VertexArrayRange *const range = rangeOf(context, &EraOffers::appleRange);
  if (!range)
    return context.host->VertexArrayRangeAPPLE(length, pointer);
  range->spoken = true;
  setRange(context, *range, length, pointer);
}

void FlushVertexArrayRangeNV(Context &context) {
  if (!rangeOf(context, &EraOffers::nvRange))
    return context.host->FlushVertexArrayRangeNV();
  (void)outsideBeginEnd(context, "FlushVertexArrayRange between Begin and End");
}

void FlushVertexArrayRangeAPPLE(Context &context, GLsizei length, void *pointer) {
  VertexArrayRange *const range = rangeOf(context, &EraOffers::appleRange);
  if (!range)
    return context.host->FlushVertexArrayRangeAPPLE(length, pointer);
  range->spoken = true;
  if (outsideBeginEnd(context, "FlushVertexArrayRange between Begin and End") && length < 0)
    raise(context, GL_INVALID_VALUE, "FlushVertexArrayRange: length is negative");
}

void VertexArrayParameteriAPPLE(Context &context, GLenum pname, GLint param) {
  VertexArrayRange *const range = rangeOf(context, &EraOffers::appleRange);
  if (!range)
    return context.host->VertexArrayParameteriAPPLE(pname, param);
  range->spoken = true;
  if (!outsideBeginEnd(context, "VertexArrayParameter between Begin and End"))
    return;
  const auto hint = GLenum(param);
  if (pname != GL_VERTEX_ARRAY_STORAGE_HINT_APPLE ||
      (hint != GL_STORAGE_CLIENT_APPLE && hint != GL_STORAGE_CACHED_APPLE &&
       hint != GL_STORAGE_SHARED_APPLE))
    return raise(context, GL_INVALID_ENUM, "VertexArrayParameter: pname or param");
  range->storageHint = hint;
}

void GetPointerv(Context &context, GLenum pname, void **params) {
  if (pname != GL_VERTEX_ARRAY_RANGE_POINTER_NV ||
      (!offers(context, &EraOffers::nvRange) && !offers(context, &EraOffers::appleRange)))
    return context.host->GetPointerv(pname, params);
  if (outsideBeginEnd(context, "GetPointerv between Begin and End"))
    *params = const_cast<void *>(context.era->client.range.pointer); // the application's own
                                                                     // pointer
}

// --- Client attributes ---

void PushClientAttrib(Context &context, GLbitfield mask) {
  if (context.era && !context.insideBeginEnd)
    pushEraClient(context, mask);
  context.host->PushClientAttrib(mask);
}

void PushClientAttribDefaultEXT(Context &context, GLbitfield mask) {
  if (context.era && !context.insideBeginEnd) {
    EraClientState &state = context.era->client;
    pushEraClient(context, mask);
    if ((mask & GL_CLIENT_VERTEX_ARRAY_BIT) != 0)
      state.range = {};
    if ((mask & GL_CLIENT_PIXEL_STORE_BIT) != 0)
      state.clientStorage = false;
  }
  context.host->PushClientAttribDefaultEXT(mask);
}

void PopClientAttrib(Context &context) {
  if (context.era && !context.insideBeginEnd)
    popEraClient(context, context.host->PopClientAttrib);
  else
    context.host->PopClientAttrib();
}

// --- Hints ---

void Hint(Context &context, GLenum target, GLenum mode) {
  if (!eraHint(context, target))
    return context.host->Hint(target, mode);
  if (!outsideBeginEnd(context, "Hint between Begin and End"))
    return;
  if (context.listMode)
    return record(context, {.kind = Command::Kind::Hint, .target = target, .name = mode});
  setEraHint(context, target, mode);
}

} // namespace handlers
} // namespace arbiter::state
