// The entry points of display lists (5.4). Lists without commands of the layer's are whole and the
// host's.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/core/memory.h"
#include "state/host_draw/kept_letters.h"
#include "state/lists/list_compiler.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/context_state.h"
#include "state/share/share_group.h"

namespace arbiter::state::handlers {

namespace {

/// True if the layer records a nested call. It does so once the group uses programs, as the called
/// lists may hold its commands when the outer list is executed. Before that lists stay whole and
/// the host's, and only their effect on the attribute stack is queried after each call.
bool recordsCalls(Context &context) {
  if (context.listMode == 0)
    return false;
  const ShareGroup &group = *context.group;
  if (group.programApiUsed.load(std::memory_order_relaxed) || !group.lists.empty())
    return true;
  context.group->hostListsNest.store(true, std::memory_order_relaxed);
  return false;
}

} // namespace

void NewList(Context &context, GLuint list, GLenum mode) {
  const bool legal =
      context.executesNow() && list != 0 && (mode == GL_COMPILE || mode == GL_COMPILE_AND_EXECUTE);
  if (!legal)
    return context.host->NewList(list, mode); // raises the error
  if ((context.attention & attention::kLetters) != 0)
    drawKeptLetters(context); // the list may be executed while it is compiled
  // The rasterizer does not draw in COMPILE_AND_EXECUTE. COMPILE leaves pixels alone, except for
  // commands that are executed at once.
  if (context.softwarePossible && mode == GL_COMPILE_AND_EXECUTE)
    context.software->residency.hostDoesAnything("glNewList");
  else if (context.softwarePossible)
    context.software->residency.synchronise("glNewList");
  listCompiler(context).begin(context, list, mode);
}

void EndList(Context &context) {
  listCompiler(context).leavePrimitive(context);
  if (context.listMode == 0 || context.insideBeginEnd)
    return context.host->EndList();
  listCompiler(context).end(context);
}

void CallList(Context &context, GLuint list) {
  listCompiler(context).leavePrimitive(context);
  if (recordsCalls(context) && !context.insideBeginEnd)
    return listCompiler(context).record(context, {.kind = Command::Kind::CallList, .name = list});
  if (context.listMode)
    return callListIntoHost(context, list);
  callList(context, list);
  noteLettersOfLists(context);
}

void CallLists(Context &context, GLsizei n, GLenum type, const void *lists) {
  listCompiler(context).leavePrimitive(context);
  const std::size_t bytes = callListsBytes(n, type);
  if (recordsCalls(context) && !context.insideBeginEnd && bytes > 0 && lists) {
    Command command{.kind = Command::Kind::CallLists, .target = type};
    command.count = n;
    command.bytes.assign(static_cast<const char *>(lists), bytes);
    return listCompiler(context).record(context, std::move(command));
  }
  if (context.listMode) {
    listCompiler(context).notePixels();
    context.dirty = dirty::kAll;
    return context.host->CallLists(n, type, lists);
  }
  callLists(context, n, type, lists);
  noteLettersOfLists(context);
}

namespace {

/// An application that generates more names than this will fill them.
constexpr GLsizei kMaxKnownEmpty = 4096;

GLuint generateLists(Context &context, GLsizei range) {
  DisplayListTable &lists = context.group->lists;
  if (context.insideBeginEnd || range <= 0 || !lists.hasSegments())
    return context.host->GenLists(range);
  GLuint first = 0;
  if (context.listMode)
    listCompiler(context).outside(context, [&] { first = lists.generate(*context.host, range); });
  else
    first = lists.generate(*context.host, range);
  return first;
}

} // namespace

GLuint GenLists(Context &context, GLsizei range) {
  const GLuint first = generateLists(context, range);
  if (first != 0 && range <= kMaxKnownEmpty && keepsLists(context))
    withinMemory(context, "GenLists", [&] { context.group->lists.noteEmpty(first, range); });
  return first;
}

void DeleteLists(Context &context, GLuint list, GLsizei range) {
  DisplayListTable &lists = context.group->lists;
  if (!context.insideBeginEnd && range > 0 && lists.hasEarly())
    lists.forgetEarly(*context.host, list, GLuint(range));
  if (context.insideBeginEnd || range < 0 || lists.empty())
    return context.host->DeleteLists(list, range);
  for (const GLuint name : lists.namesIn(list, range))
    lists.replace(*context.host, name, nullptr);
  const std::vector<GLuint> kept = lists.segmentsIn(list, range);
  if (kept.empty())
    return context.host->DeleteLists(list, range);
  // The application cannot delete segments, even in this range.
  for (GLsizei i = 0; i < range; ++i)
    if (!lists.isSegment(list + GLuint(i)))
      context.host->DeleteLists(list + GLuint(i), 1);
}

GLboolean IsList(Context &context, GLuint list) {
  if (!context.insideBeginEnd && !context.group->lists.empty() &&
      context.group->lists.isSegment(list))
    return GL_FALSE;
  return context.host->IsList(list);
}

} // namespace arbiter::state::handlers
