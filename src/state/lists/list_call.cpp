// Calls lists: their host segments, primitives, and commands of the layer's.
#include "state/lists/list_compiler.h"

#include <cstring>

#include "host/host_table.h"
#include "state/client_pixels/client_image.h"
#include "state/core/control_hooks.h"
#include "state/core/errors.h"
#include "state/host_draw/clip_planes.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/linking/host_assembly.h"
#include "state/host_draw/use_program.h"
#include "state/lists/geometry_call.h"
#include "state/mirror/dirty_bits.h"
#include "state/primitives/geometry.h"
#include "state/programs/variants/point_sprites.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Prepares for a host list with unknown effects.
void beforeHostLists(RasterContext &context) {
  releaseSprites(context);
  if (context.softwarePossible)
    context.software->hostDrawsList();
}

/// Notes a Viewport in the segment, by which an application follows its window's size.
void noteViewport(RasterContext &context, const Effects &effects) {
  if (!context.software || (effects.dirty & dirty::kViewport) == 0)
    return;
  GLint box[4] = {};
  context.host->GetIntegerv(GL_VIEWPORT, box);
  context.software->residency.drawableMayHaveChanged({box[0], box[1], box[2], box[3]});
}

/// Calls a segment that sets state and touches no pixels. The rasterizer may go on drawing after
/// it.
void callStateList(RasterContext &context, GLuint name, const Effects &effects) {
  // RasterPos transforms a vertex with the host's vertex program and its parameters.
  if ((effects.dirty & dirty::kRasterPosition) != 0 && context.attention)
    (void)validate(context);
  if (isObserved(context)) [[unlikely]] {
    const ListHoldsScope holds(ListHolds::State);
    context.host->CallList(name);
  } else {
    context.host->CallList(name);
  }
  context.dirty |= effects.dirty;
  noteViewport(context, effects);
  noteClipPlanesChange(context);
  afterHostList(context);
}

/// Calls a host list that may draw, with the effective program bound. If the program is invalid,
/// the host is made to refuse draws, as the list's other commands must take effect.
void callHostList(RasterContext &context, GLuint name, Primitive primitive = Primitive::AsBefore,
                  const Effects &effects = {}) {
  if (context.insideBeginEnd) {
    context.host->CallList(name);
    context.dirty |= effects.dirty;
    context.insideBeginEnd = primitive != Primitive::Closed;
    return;
  }
  noteClipPlanesOfLists(context);
  if (!effects.pixels)
    return callStateList(context, name, effects);
  beforeHostLists(context);
  if (context.attention && !validate(context)) {
    refuseDraws(context);
    context.host->CallList(name);
    releaseHostState(context);
  } else {
    context.host->CallList(name);
    context.insideBeginEnd = primitive == Primitive::Open;
  }
  context.dirty = dirty::kAll;
  if (context.insideBeginEnd)
    return;
  noteViewport(context, effects);
  afterHostList(context);
}

/// Follows the attribute stack after a list that only the host keeps. It may have popped enables,
/// or called lists that push or pop.
void followAttribStack(RasterContext &context) {
  if (context.insideBeginEnd)
    return;
  context.hostSide.assembly->restoreEnables(context);
  if (!context.group->hostListsNest.load(std::memory_order_relaxed))
    return;
  GLint depth = 0;
  context.host->GetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
  context.attribStack.resize(std::size_t(depth < 0 ? 0 : depth));
}

std::size_t elementSize(GLenum type) {
  switch (type) {
  case GL_2_BYTES:
    return 2;
  case GL_3_BYTES:
    return 3;
  case GL_4_BYTES:
    return 4;
  case GL_HALF_FLOAT: // no type of CallLists
    return 0;
  default:
    return componentBytes(type);
  }
}

template <typename T> T load(const unsigned char *bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// Returns element `i` of CallLists' array (5.4). Signed offsets wrap around ListBase.
GLuint element(GLenum type, const unsigned char *bytes, GLsizei i) {
  const unsigned char *const p = bytes + std::size_t(i) * elementSize(type);
  switch (type) {
  case GL_BYTE:
    return GLuint(GLint(load<GLbyte>(p)));
  case GL_UNSIGNED_BYTE:
    return p[0];
  case GL_SHORT:
    return GLuint(GLint(load<GLshort>(p)));
  case GL_UNSIGNED_SHORT:
    return load<GLushort>(p);
  case GL_FLOAT:
    return GLuint(GLint64(load<GLfloat>(p)));
  case GL_2_BYTES:
    return GLuint(p[0]) << 8 | p[1];
  case GL_3_BYTES:
    return GLuint(p[0]) << 16 | GLuint(p[1]) << 8 | p[2];
  case GL_4_BYTES:
    return GLuint(p[0]) << 24 | GLuint(p[1]) << 16 | GLuint(p[2]) << 8 | p[3];
  default:
    return load<GLuint>(p);
  }
}

/// Returns the early list if the rasterizer may draw it now, or if its draws are observed. Null if
/// the host must call it.
std::shared_ptr<const DisplayList> earlyList(RasterContext &context, GLuint name) {
  if (context.insideBeginEnd || !context.group->lists.hasEarly())
    return nullptr;
  if (isObserved(context))
    return context.group->lists.findEarly(name);
  if (!context.software || !mayDraw(context) || !usesRasterizer(context) ||
      !decideByPath(context).ok())
    return nullptr;
  return context.group->lists.findEarly(name);
}

} // namespace

std::size_t callListsBytes(GLsizei count, GLenum type) {
  return count > 0 ? std::size_t(count) * elementSize(type) : 0;
}

void callList(RasterContext &context, GLuint name) {
  notePrimitiveMode(context, PointSprites::kNoPrimitive); // until the list sets a mode
  const std::shared_ptr<const DisplayList> list = context.group->lists.find(name);
  if (!list) {
    if (const std::shared_ptr<const DisplayList> early = earlyList(context, name)) {
      for (const DisplayList::Item &item : early->items)
        callGeometry(context, *item.geometry);
      return;
    }
    callHostList(context, name);
    return followAttribStack(context);
  }
  if (context.listDepth >= ListCompiler::kMaxDepth)
    return;
  ++context.listDepth;
  for (const DisplayList::Item &item : list->items) {
    if (item.geometry) {
      callGeometry(context, *item.geometry);
    } else if (item.command) {
      context.dirty |= item.effects.dirty;
      execute(context, *item.command);
    } else {
      callHostList(context, item.hostList, item.primitive, item.effects);
    }
  }
  --context.listDepth;
}

void callListIntoHost(RasterContext &context, GLuint name) {
  const std::shared_ptr<const DisplayList> list = context.group->lists.find(name);
  context.dirty = dirty::kAll;
  listCompiler(context).notePixels();
  if (!list)
    return context.host->CallList(name);
  for (const DisplayList::Item &item : list->items) {
    if (item.geometry)
      context.host->Begin(item.geometry->mode); // an error, as in callGeometry()
    if (item.command && (item.command->kind == Command::Kind::EvalPoint ||
                         item.command->kind == Command::Kind::State))
      execute(context, *item.command);
    if (item.hostList == 0)
      continue; // other commands of the layer's are errors between Begin and End
    context.host->CallList(item.hostList);
    if (item.primitive != Primitive::AsBefore)
      context.insideBeginEnd = item.primitive == Primitive::Open;
  }
}

void callLists(RasterContext &context, GLsizei count, GLenum type, const void *lists) {
  const DisplayListTable &known = context.group->lists;
  const bool mayBeEarly = (context.software || isObserved(context)) && known.hasEarly();
  const bool allHosts = known.empty() && !mayBeEarly;
  if (allHosts || count < 0 || elementSize(type) == 0 || !lists) {
    notePrimitiveMode(context, PointSprites::kNoPrimitive);
    if (!context.insideBeginEnd) {
      noteClipPlanesOfLists(context);
      beforeHostLists(context);
    }
    const bool refused = context.attention && !context.insideBeginEnd && !validate(context);
    if (refused)
      refuseDraws(context);
    context.host->CallLists(count, type, lists); // raises errors of the arguments
    context.dirty = dirty::kAll;
    if (refused)
      releaseHostState(context);
    if (!context.insideBeginEnd)
      afterHostList(context);
    return followAttribStack(context);
  }
  GLint base = 0;
  if (!context.insideBeginEnd)
    context.host->GetIntegerv(GL_LIST_BASE, &base);
  for (GLsizei i = 0; i < count; ++i)
    callList(context, GLuint(base) + element(type, static_cast<const unsigned char *>(lists), i));
}

} // namespace arbiter::state
