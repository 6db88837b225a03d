#include "state/lists/list_compiler.h"

#include <algorithm>
#include <utility>

#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/core/memory.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/prepare_draw.h"
#include "state/mirror/dirty_bits.h"
#include "state/programs/program_bind.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/immediate/replay.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Removes the groups of commands that are executed at once even in a list (5.4).
std::uint32_t recordable(std::uint32_t dirty) {
  using namespace dirty;
  return dirty == kAll ? dirty : dirty & ~kArrays;
}

/// Appends a command to the last one of its kind. Binds of one target take four bytes each, as a
/// list may hold millions. None is left out: each creates its object and may be an error. Commands
/// of register combiners and texture shaders come by the dozen and are joined too.
bool join(DisplayList::Item &last, const Command &command, std::uint32_t dirty) {
  if (!last.command || last.command->kind != command.kind)
    return false;
  // The command belongs to this unfinished list, and record() made it non-const.
  std::string &bytes = const_cast<Command &>(*last.command).bytes;
  if (command.kind == Command::Kind::BindProgram && last.command->target == command.target &&
      command.target != infoOf(Target::AtiApi).name &&
      command.target != infoOf(Target::VertexShader).name)
    bytes.append(reinterpret_cast<const char *>(&command.name), sizeof command.name);
  else if (command.kind == Command::Kind::Combiners ||
           command.kind == Command::Kind::TextureShaders || command.kind == Command::Kind::State)
    bytes += command.bytes;
  else
    return false;
  last.effects.dirty |= dirty;
  return true;
}

/// True if the list is compiled again while the context is left to the host. Such a list may be
/// recompiled in each frame, and stays the host's.
bool changesAlone(RasterContext &context, GLuint name) {
  if (context.software || !context.leftAlone)
    return false;
  if (const auto list = context.group->lists.find(name))
    return !list->items.empty();
  return context.host->IsList(name) == GL_TRUE;
}

/// Reserves room for more items, so that adding them cannot fail half-way.
void makeRoom(std::vector<DisplayList::Item> &items, std::size_t more) {
  if (items.capacity() - items.size() < more)
    items.reserve(std::max(items.size() + more, 2 * items.capacity()));
}

} // namespace

void ListCompiler::begin(RasterContext &context, GLuint name, GLenum mode) {
  // COMPILE_AND_EXECUTE needs its program bound now, as the layer must not call the host while it
  // records. COMPILE must not find the layer's program bound.
  if (mode == GL_COMPILE_AND_EXECUTE) {
    validateForList(context);
  } else {
    releaseHostState(context);
    invalidateProgram(context);
  }
  m_name = name;
  m_segment = 0;
  m_items.clear();
  m_pushes.clear();
  m_primitive = Primitive::AsBefore;
  m_open = m_begun = m_endsFirst = m_recording = m_pixels = false;
  m_geometry.reset();
  m_known.forget();
  m_dirty = 0;
  m_kind = Kind::None;
  m_arraysDirty = true;
  m_mode = std::uint16_t(mode);
  m_keeps = keepsLists(context) && !changesAlone(context, name);
  context.listIsExecuted = executes();
  if (m_keeps) {
    context.softwareListens = true;
    return resume(context);
  }
  setMode(context, m_mode);
  m_segment = name;
  context.host->NewList(name, mode);
  if (mode == GL_COMPILE && keepsEarlyLists(context))
    beginEarly(context);
}

/// Sets the list mode; 0 while commands of the layer run and nothing is compiled.
void ListCompiler::setMode(RasterContext &context, std::uint16_t mode) {
  context.listMode = mode;
  if (mode == 0) {
    context.attention &= ~attention::kList;
    return;
  }
  context.attention |= attention::kList;
  if (mode == GL_COMPILE)
    context.drawCounter = &context.counters.draws[std::size_t(Path::Recorded)];
}

/// Makes an item of the segment, which the host has closed. Also adds an item for each push in it
/// that has no entry of the layer's yet.
void ListCompiler::finishSegment() {
  DisplayList::Item item;
  item.hostList = std::exchange(m_segment, 0);
  item.primitive = std::exchange(m_primitive, Primitive::AsBefore);
  makeRoom(m_items, 1 + m_pushes.size());
  m_items.push_back(std::move(item));
  for (Push &push : m_pushes)
    if (!push.noted) {
      DisplayList::Item pushed;
      pushed.command = std::make_unique<const Command>(
          Command{.kind = Command::Kind::AttribPushed, .name = push.mask});
      pushed.effects.dirty = 0;
      m_items.push_back(std::move(pushed));
      push.noted = true;
    }
}

void ListCompiler::finishGeometry() {
  if (!m_geometry)
    return;
  makeRoom(m_items, 1);
  DisplayList::Item item;
  item.geometry = std::move(m_geometry);
  m_items.push_back(std::move(item));
}

/// Closes the segment, so that the layer can call the host normally.
void ListCompiler::closeSegment(RasterContext &context) {
  if (m_early)
    leaveEarly(context);
  leavePrimitive(context);
  if (m_segment != 0) {
    context.host->EndList();
    const std::size_t at = m_items.size();
    withinMemory(context, "NewList", [&] { finishSegment(); });
    if (m_keeps && m_items.size() > at)
      m_items[at].effects = {recordable(context.dirty), std::exchange(m_pixels, false)};
  } else {
    context.host = context.trueHost;
    context.recorder = nullptr;
    withinMemory(context, "NewList", [&] { finishGeometry(); });
  }
  context.dirty |= std::exchange(m_dirty, 0);
  setMode(context, 0);
}

/// Goes on after closeSegment(). Opens the next segment; if the list keeps primitives, only when
/// the host is called.
void ListCompiler::resume(CoreContext &lower) {
  RasterContext &context = rasterStep(lower);
  context.trueHost = context.host;
  const bool executes = m_mode == GL_COMPILE_AND_EXECUTE;
  if ((!m_keeps || executes) && context.softwarePossible)
    // The layer's commands may have deferred a copy.
    withinMemory(context, "NewList",
                 [&] { context.software->residency.hostDoesAnything("glNewList"); });
  if (!m_keeps)
    return openSegment(context);
  m_dirty = std::exchange(context.dirty, 0);
  setMode(context, m_mode);
  context.host = &kRecordingHost;
}

/// Validates state that changed since the list began. Changes by the command that opens the segment
/// stay the segment's.
void ListCompiler::validateSegment(RasterContext &context) {
  const std::uint32_t ofSegment = context.dirty;
  context.dirty |= m_dirty;
  validateForList(context);
  if (m_keeps)
    m_dirty = std::exchange(context.dirty, ofSegment);
}

/// Opens a segment, which the host compiles. If the list keeps primitives, this ends the use of
/// resume()'s table.
void ListCompiler::openSegment(RasterContext &context) {
  m_known.forget();
  context.host = context.trueHost;
  context.recorder = nullptr;
  setMode(context, 0);
  // The first segment has the list's own name: a list with nothing else is the host's too. So has
  // one for which there is no memory: its contents are undefined, but the list exists.
  GLuint segment = m_name;
  withinMemory(context, "NewList", [&] {
    finishGeometry();
    if (m_mode == GL_COMPILE_AND_EXECUTE)
      validateSegment(context);
    if (!m_items.empty())
      segment = context.group->lists.takeSegmentName(*context.host);
  });
  m_segment = segment;
  setMode(context, m_mode);
  context.host->NewList(m_segment, m_mode);
}

void ListCompiler::record(CoreContext &lower, Command command) {
  RasterContext &context = rasterStep(lower);
  noteProgramApiUse(context);
  m_known.forget();
  if (command.kind == Command::Kind::CallList || command.kind == Command::Kind::CallLists)
    m_kind = Kind::None;
  if (m_early)
    leaveEarly(context);
  if (follows() && join(m_items.back(), command, recordable(context.dirty)))
    return;
  makeRoom(m_items, 4 + m_pushes.size()); // a primitive, a segment, its pushes, the command
  leavePrimitive(context);
  DisplayList::Item item;
  item.effects.dirty =
      m_keeps ? recordable(context.dirty) : 0; // what the command's entry point has marked
  item.command = std::make_unique<Command>(std::move(command)); // join() may change it
  const Command &reference = *item.command;
  closeSegment(context);
  m_items.push_back(std::move(item));
  if (m_mode == GL_COMPILE_AND_EXECUTE)
    withinMemory(context, "a command of a list", [&] { execute(context, reference); });
  resume(context);
}

void ListCompiler::recordState(RasterContext &context, const StateCommand &state,
                               std::uint32_t dirty) {
  if (!m_known.set(state))
    return;
  Command command{.kind = Command::Kind::State};
  command.bytes.assign(reinterpret_cast<const char *>(&state), sizeof state);
  if (follows() && join(m_items.back(), command, dirty))
    return;
  makeRoom(m_items, 2); // a primitive, the command
  DisplayList::Item item;
  item.effects.dirty = dirty;
  item.command = std::make_unique<Command>(std::move(command)); // join() may change it
  closeSegment(context);
  m_items.push_back(std::move(item));
  resume(context);
}

bool ListCompiler::beginPrimitive(CoreContext &lower, GLenum mode) {
  RasterContext &context = rasterStep(lower);
  if (!keeps() || m_recording || m_open || mode > GL_POLYGON)
    return false;
  if (m_early) {
    takeOutsideAttributes(context);
  } else if (m_segment != 0) {
    closeSegment(context);
    resume(context);
  }
  m_recording = true;
  m_recorder.begin(mode, {});
  if (m_early)
    limitPrimitive(context);
  context.recorder = &m_recorder;
  ++*context.drawCounter;
  context.insideBeginEnd = executes();
  return true;
}

void ListCompiler::endPrimitive(CoreContext &lower, bool fromArrays) {
  RasterContext &context = rasterStep(lower);
  stopPrimitive(context);
  if (m_early)
    return endEarlyPrimitive(context, fromArrays);
  if (executes() && !fromArrays)
    executePrimitive(context);
  keepPrimitive(fromArrays);
}

/// Draws the primitive. Sends all components: in Mesa 22.3.6, components that a shorter command
/// leaves at their defaults may be those of the previous primitive.
void ListCompiler::executePrimitive(RasterContext &context) {
  if (beginExecuted(context, m_recorder.mode())) {
    sendOpen(*context.host, m_recorder);
    context.host->End();
  } else {
    setTouched(*context.host, m_recorder);
  }
  endExecuted(context);
}

bool ListCompiler::beginExecuted(CoreContext &lower, GLenum mode) {
  RasterContext &context = rasterStep(lower);
  context.host = context.trueHost;
  setMode(context, 0);
  context.dirty |= std::exchange(m_dirty, 0);
  if (context.software)
    context.software->hostDrawsAsCompiled();
  return !context.attention || prepareDraw(context, mode);
}

void ListCompiler::endExecuted(CoreContext &lower) {
  RasterContext &context = rasterStep(lower);
  context.dirty |= dirty::kCurrent;
  resume(context);
}

void ListCompiler::keepPrimitive(bool fromArrays) {
  if (fromArrays || (m_recorder.touched() >> kColor & 1u) != 0)
    m_known.forgetMaterials();
  if (m_geometry && append(*m_geometry, m_recorder, fromArrays))
    return;
  finishGeometry();
  m_geometry = geometryOf(m_recorder, fromArrays);
}

void ListCompiler::stopPrimitive(RasterContext &context) {
  m_recording = false;
  context.recorder = nullptr;
  context.insideBeginEnd = false;
  if (m_recorder.failed())
    raise(context, GL_OUT_OF_MEMORY, "NewList: no memory for the list's vertices");
}

void ListCompiler::interruptPrimitive(RasterContext &context) {
  if (m_early)
    return leaveEarly(context);
  if (executes())
    return givePrimitive(context);
  stopPrimitive(context);
  m_open = m_begun = true;
  withinMemory(context, "NewList", [&] {
    finishGeometry();
    m_geometry = geometryOf(m_recorder);
    m_geometry->open = true;
    finishGeometry();
  });
}

void ListCompiler::givePrimitive(RasterContext &context) {
  if (m_early)
    return leaveEarly(context);
  stopPrimitive(context);
  openSegment(context);
  sendOpen(*context.host, m_recorder);
  notePixels();
  notePrimitive(Primitive::Open);
  context.insideBeginEnd = executes();
}

bool ListCompiler::takeArraysDirty(CoreContext &lower) {
  RasterContext &context = rasterStep(lower);
  // Arrays are set at once. Their dirty bit applies after the list, and is no effect of a segment.
  const std::uint32_t bit = context.dirty & dirty::kArrays;
  context.dirty &= ~bit;
  m_dirty |= bit;
  return std::exchange(m_arraysDirty, false) || bit != 0;
}

void ListCompiler::end(RasterContext &context) {
  std::shared_ptr<DisplayList> made, list, early;
  withinMemory(context, "EndList", [&] {
    made = std::make_shared<DisplayList>();
    makeRoom(m_items, 3 + m_pushes.size());
    if (m_early)
      early = endEarly(context);
  });
  if (m_early) // without memory
    leaveEarly(context);
  if (m_keeps) {
    closeSegment(context);
    list = made;
  } else {
    // The layer keeps items for a list that moves the attribute stack or leaves a primitive open.
    const bool watched =
        m_primitive == Primitive::Open || m_endsFirst || !m_items.empty() ||
        std::any_of(m_pushes.begin(), m_pushes.end(), [](const Push &push) { return !push.noted; });
    context.host->EndList();
    if (watched) {
      withinMemory(context, "EndList", [&] { finishSegment(); });
      list = made;
    }
    context.dirty |= std::exchange(m_dirty, 0);
    setMode(context, 0);
  }
  if (list)
    list->items = std::exchange(m_items, {});
  withinMemory(context, "EndList", [&] {
    define(context, std::move(list));
    context.group->lists.replaceEarly(*context.host, m_name, std::move(early));
  });
  m_name = 0;
  m_segment = 0;
  m_recorder = {};
  m_outside = {};
  m_keeps = context.listIsExecuted = false;
  context.softwareListens = context.softwarePossible;
  invalidateProgram(context);
  context.attention &= ~attention::kList;
}

void ListCompiler::define(RasterContext &context, std::shared_ptr<const DisplayList> list) {
  const bool hostHasPart =
      !m_keeps || !list ||
      std::any_of(list->items.begin(), list->items.end(),
                  [&](const DisplayList::Item &i) { return i.hostList == m_name; });
  if (!hostHasPart) {
    context.host->NewList(m_name, GL_COMPILE); // the host knows the name, and nothing else of the
                                               // list
    context.host->EndList();
  }
  if (list || !context.group->lists.empty())
    context.group->lists.replace(*context.host, m_name, std::move(list));
}

bool ListCompiler::notePop() {
  if (m_pushes.empty())
    return true; // it may pop enables that were pushed outside
  const bool noted = m_pushes.back().noted;
  m_pushes.pop_back();
  return noted;
}

} // namespace arbiter::state
