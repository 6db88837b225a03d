// Lists from before the share group's first program: the host compiles them, whole, and what is
// recorded is kept beside it. While that is so the table of the host's functions is the one that
// stands in for it, so that any command that is neither a primitive nor an attribute is noticed:
// the list is the host's alone then.
#include <utility>

#include "host/host_table.h"
#include "state/core/context.h"
#include "state/core/memory.h"
#include "state/lists/list_compiler.h"
#include "state/raster_draw/immediate/replay.h"

namespace arbiter::state {

namespace {

/// Vertices of an early list; of more the host alone has them, as a list of that size costs too
/// much twice.
constexpr std::uint32_t kMostEarly = 1u << 18;

} // namespace

void ListCompiler::beginEarly(Context &context) {
  m_early = true;
  m_earlyVertices = 0;
  context.trueHost = context.host;
  context.host = &software::kRecordingHost;
  context.softwareListens = true;
  context.recorder = &m_outside;
  recordOutsideAttributes(context);
}

/// Attributes; a vertex there is one of a primitive that another list, or none, begins.
void ListCompiler::recordOutsideAttributes(Context &context) {
  m_outside.begin(GL_POINTS, {});
  m_outside.limit(0, leaveFull, &context);
}

/// Attributes that were set since the last primitive go to the host, and are an item.
void ListCompiler::takeOutsideAttributes(Context &context) {
  if (m_outside.touched() == 0)
    return;
  software::setTouched(*context.trueHost, m_outside);
  auto geometry = software::geometryOf(m_outside);
  geometry->onlyValues = true;
  recordOutsideAttributes(context);
  finishGeometry();
  m_geometry = std::move(geometry);
  finishGeometry();
}

bool ListCompiler::hasRoom(GLsizei count) const { return !m_early || count <= GLsizei(kMostEarly); }

/// The primitive that was recorded is the host's too; of arrays it has been told already.
void ListCompiler::endEarlyPrimitive(Context &context, bool fromArrays) {
  context.recorder = &m_outside;
  if (!fromArrays)
    software::sendWhole(*context.trueHost, m_recorder);
  notePrimitive(Primitive::Open);
  notePrimitive(Primitive::Closed);
  m_earlyVertices += m_recorder.count();
  if (m_earlyVertices > kMostEarly || m_recorder.failed() ||
      !withinMemory(context, "NewList", [&] { keepPrimitive(fromArrays); }))
    leaveEarly(context);
}

void ListCompiler::leaveEarly(Context &context) {
  m_early = false;
  m_items.clear();
  m_geometry.reset();
  context.host = context.trueHost;
  context.recorder = nullptr;
  context.softwareListens = context.softwarePossible;
  const bool recorded = std::exchange(m_recording, false);
  if (recorded) {
    software::sendOpen(*context.host, m_recorder);
    notePrimitive(Primitive::Open);
  } else {
    software::setTouched(*context.host, m_outside);
  }
  m_outside.begin(GL_POINTS, {});
}

/// There is a vertex more than an early list has, in a primitive or outside: this one and those
/// before are sent, and what follows is the host's.
bool ListCompiler::leaveFull(void *owner, const float position[4]) {
  auto &context = *static_cast<Context *>(owner);
  listCompiler(context).leaveEarly(context);
  software::setAttribute(*context.host, software::kPosition, position);
  return false;
}

void ListCompiler::limitPrimitive(Context &context) {
  m_recorder.limit(kMostEarly, leaveFull, &context);
}

/// What the list holds, and the host has been told of all of it. Null where that is nothing.
std::shared_ptr<DisplayList> ListCompiler::endEarly(Context &context) {
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
