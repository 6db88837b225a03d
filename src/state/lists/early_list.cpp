// Early lists, compiled before the share group's first program. The host compiles them whole, and
// the layer keeps a recording beside. Meanwhile the recording table stands in for the host's
// functions, which reveals any command other than primitives and attributes. Such a command makes
// the list the host's alone.
#include <utility>

#include "host/host_table.h"
#include "state/core/memory.h"
#include "state/lists/list_compiler.h"
#include "state/raster_draw/immediate/replay.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

/// The most vertices of an early list. A larger list is kept by the host alone, as it is too costly
/// to have twice.
constexpr std::uint32_t kMaxEarly = 1u << 18;

} // namespace

void ListCompiler::beginEarly(RasterContext &context) {
  m_early = true;
  m_earlyVertices = 0;
  context.trueHost = context.host;
  context.host = &kRecordingHost;
  context.softwareListens = true;
  context.recorder = &m_outside;
  recordOutsideAttributes(context);
}

/// Records attributes. A vertex here belongs to a primitive that another list began, or none.
void ListCompiler::recordOutsideAttributes(RasterContext &context) {
  m_outside.begin(GL_POINTS, {});
  m_outside.limit(0, leaveFull, &context);
}

/// Sends attributes that were set since the last primitive to the host, and makes them an item.
void ListCompiler::takeOutsideAttributes(RasterContext &context) {
  if (m_outside.touched() == 0)
    return;
  setTouched(*context.trueHost, m_outside);
  auto geometry = geometryOf(m_outside);
  geometry->onlyValues = true;
  recordOutsideAttributes(context);
  finishGeometry();
  m_geometry = std::move(geometry);
  finishGeometry();
}

bool ListCompiler::hasRoom(GLsizei count) const { return !m_early || count <= GLsizei(kMaxEarly); }

/// Sends the recorded primitive to the host, unless it came from arrays and was sent already.
void ListCompiler::endEarlyPrimitive(RasterContext &context, bool fromArrays) {
  context.recorder = &m_outside;
  if (!fromArrays)
    sendWhole(*context.trueHost, m_recorder);
  notePrimitive(Primitive::Open);
  notePrimitive(Primitive::Closed);
  m_earlyVertices += m_recorder.count();
  if (m_earlyVertices > kMaxEarly || m_recorder.failed() ||
      !withinMemory(context, "NewList", [&] { keepPrimitive(fromArrays); }))
    leaveEarly(context);
}

void ListCompiler::leaveEarly(RasterContext &context) {
  m_early = false;
  m_items.clear();
  m_geometry.reset();
  context.host = context.trueHost;
  context.recorder = nullptr;
  context.softwareListens = context.softwarePossible;
  const bool recorded = std::exchange(m_recording, false);
  if (recorded) {
    sendOpen(*context.host, m_recorder);
    notePrimitive(Primitive::Open);
  } else {
    setTouched(*context.host, m_outside);
  }
  m_outside.begin(GL_POINTS, {});
}

/// Ends the early list at the first vertex beyond the limit, in a primitive or outside. Sends it
/// after those before; the host alone keeps what follows.
bool ListCompiler::leaveFull(void *owner, const float position[4]) {
  auto &context = *static_cast<RasterContext *>(owner);
  listCompiler(context).leaveEarly(context);
  setAttribute(*context.host, kPosition, position);
  return false;
}

void ListCompiler::limitPrimitive(RasterContext &context) {
  m_recorder.limit(kMaxEarly, leaveFull, &context);
}

/// Returns the recorded items, which the host has too; null if there are none.
std::shared_ptr<DisplayList> ListCompiler::endEarly(RasterContext &context) {
  if (m_recording)
    return nullptr;
  takeOutsideAttributes(context);
  finishGeometry();
  auto list = std::make_shared<DisplayList>();
  list->items = std::exchange(m_items, {});
  leaveEarly(context);
  return list->items.empty() ? nullptr : list;
}

} // namespace arbiter::state
