#include "state/control/draw_observer.h"

#include <utility>

#include "state/control/tallies.h"
#include "state/core/context.h"
#include "state/core/control_hooks.h"
#include "state/core/host_errors.h"
#include "state/core/memory.h"
#include "state/host_draw/linked_program.h"

namespace arbiter::state::remote {

namespace {

using host::HostTable;

/// Names that no application makes.
constexpr GLuint kList = 0xFFFFFFFAu, kQuery = 0xFFFFFFFAu;
/// Rows of one frame; those behind are counted alone.
constexpr std::size_t kMostRows = 4096;

/// Of the thread's current context, whose table was called; that is not its first one while it
/// records a list or a primitive.
void drawArrays(GLenum mode, GLint first, GLsizei count);
DrawObserver &observer() {
  const auto &context = static_cast<const Context &>(*t_current);
  const bool isFirst = context.host->DrawArrays == drawArrays;
  const HostTable *const table = isFirst ? context.host : context.trueHost;
  return *static_cast<const ObservedTable *>(table)->observer;
}

// --- The functions that draw, in the order of what they take ---

void drawArrays(GLenum mode, GLint first, GLsizei count) {
  observer().draw("glDrawArrays",
                  [=](const HostTable &host) { host.DrawArrays(mode, first, count); });
}

void drawElements(GLenum mode, GLsizei count, GLenum type, const void *indices) {
  observer().draw("glDrawElements",
                  [=](const HostTable &host) { host.DrawElements(mode, count, type, indices); });
}

void drawRangeElements(GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                       const void *indices) {
  observer().draw("glDrawRangeElements", [=](const HostTable &host) {
    host.DrawRangeElements(mode, start, end, count, type, indices);
  });
}

void drawElementsBaseVertex(GLenum mode, GLsizei count, GLenum type, const void *indices,
                            GLint base) {
  observer().draw("glDrawElementsBaseVertex", [=](const HostTable &host) {
    host.DrawElementsBaseVertex(mode, count, type, indices, base);
  });
}

void drawRangeElementsBaseVertex(GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                                 const void *indices, GLint base) {
  observer().draw("glDrawRangeElementsBaseVertex", [=](const HostTable &host) {
    host.DrawRangeElementsBaseVertex(mode, start, end, count, type, indices, base);
  });
}

void drawArraysInstanced(GLenum mode, GLint first, GLsizei count, GLsizei instances) {
  observer().draw("glDrawArraysInstanced", [=](const HostTable &host) {
    host.DrawArraysInstanced(mode, first, count, instances);
  });
}

void drawElementsInstanced(GLenum mode, GLsizei count, GLenum type, const void *indices,
                           GLsizei instances) {
  observer().draw("glDrawElementsInstanced", [=](const HostTable &host) {
    host.DrawElementsInstanced(mode, count, type, indices, instances);
  });
}

void multiDrawArrays(GLenum mode, const GLint *first, const GLsizei *count, GLsizei draws) {
  observer().draw("glMultiDrawArrays",
                  [=](const HostTable &host) { host.MultiDrawArrays(mode, first, count, draws); });
}

void multiDrawElements(GLenum mode, const GLsizei *count, GLenum type, const void *const *indices,
                       GLsizei draws) {
  observer().draw("glMultiDrawElements", [=](const HostTable &host) {
    host.MultiDrawElements(mode, count, type, indices, draws);
  });
}

void rectf(GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2) {
  observer().draw("glRectf", [=](const HostTable &host) { host.Rectf(x1, y1, x2, y2); });
}

void recti(GLint x1, GLint y1, GLint x2, GLint y2) {
  observer().draw("glRecti", [=](const HostTable &host) { host.Recti(x1, y1, x2, y2); });
}

void callList(GLuint list) {
  observer().list([=](const HostTable &host) { host.CallList(list); });
}

void callLists(GLsizei count, GLenum type, const void *lists) {
  observer().list([=](const HostTable &host) { host.CallLists(count, type, lists); });
}

void begin(GLenum mode) { observer().begin(mode); }
void end() { observer().end(); }

void setFunctions(HostTable &table) {
  table.DrawArrays = drawArrays;
  table.DrawElements = drawElements;
  table.DrawRangeElements = drawRangeElements;
  table.DrawElementsBaseVertex = drawElementsBaseVertex;
  table.DrawRangeElementsBaseVertex = drawRangeElementsBaseVertex;
  table.DrawArraysInstanced = drawArraysInstanced;
  table.DrawElementsInstanced = drawElementsInstanced;
  table.MultiDrawArrays = multiDrawArrays;
  table.MultiDrawElements = multiDrawElements;
  table.Rectf = rectf;
  table.Recti = recti;
  table.CallList = callList;
  table.CallLists = callLists;
  table.Begin = begin;
  table.End = end;
}

/// One that the layer has no other use for. Every host that counts pixels has it.
template <typename Function> Function functionOf(const HostTable &host, const char *name) {
  return reinterpret_cast<Function>(host.lookup(name));
}

/// Of a context that another observer was given up in, what that one had.
const HostTable &trueTable(const HostTable &host) {
  return host.DrawArrays == drawArrays ? static_cast<const ObservedTable &>(host).observer->host()
                                       : host;
}

GLint get(const HostTable &host, GLenum name) {
  GLint value = 0;
  host.GetIntegerv(name, &value);
  return value;
}

/// What nothing draws.
constexpr Vec4 kUncovered = {-0x1.6a09e6p99f, 0x1.bb67aep98f, -0x1.3c6ef4p97f, 0x1.a54ff6p96f};

} // namespace

DrawObserver::DrawObserver(Context &context, Observation wish, Held held)
    : m_context(context), m_wish(std::move(wish)), m_held(std::move(held)),
      m_host(trueTable(*context.host)), m_table(*new ObservedTable{m_host, this}),
      m_probe(context, m_host) {
  setFunctions(m_table);
  context.host = &m_table;
  g_observed.store(&context, std::memory_order_relaxed);
}

DrawObserver::~DrawObserver() {
  const Context *own = &m_context;
  g_observed.compare_exchange_strong(own, nullptr, std::memory_order_relaxed);
  static_cast<HostTable &>(m_table) = m_host; // for what keeps it, as a list that is recorded
  if (m_context.host == &m_table)
    m_context.host = &m_host;
  else if (m_context.trueHost != &m_table)
    return; // another context lies where this one was
  const HostErrorScope errors(m_host, m_context.pendingError);
  if (m_madeList)
    m_host.DeleteLists(kList, 1);
  if (m_madeQuery)
    functionOf<void (*)(GLsizei, const GLuint *)>(m_host, "glDeleteQueries")(1, &kQuery);
}

/// The draw can be made again, and more often, without the application's seeing it.
bool DrawObserver::isObservable() {
  const HostErrorScope errors(m_host, m_context.pendingError);
  if (m_wish.aim != Observation::Aim::Measure && get(m_host, GL_DRAW_FRAMEBUFFER_BINDING) != 0)
    return false; // not of the window
  if (get(m_host, GL_RENDER_MODE) != GL_RENDER)
    return false;
  GLint query = 0;
  if (m_context.caps.occlusionQuery)
    m_host.GetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &query);
  if (query == 0)
    return true;
  m_trouble = "an occlusion query of the application's counts its pixels";
  return false;
}

ObservedDraw DrawObserver::describe(const char *command) const {
  ObservedDraw draw;
  draw.number = m_count;
  draw.command = command;
  if (!m_context.linkedProgram)
    return draw;
  const auto stages = m_context.linkedProgram->stages();
  if (const CompiledProgram *const vertex = stages[0]->compiled)
    draw.vertex = textFileName(vertex->target, vertex->hash);
  draw.compiled = stages[1]->compiled;
  if (draw.compiled && *infoOf(draw.compiled->target).extension != '\0')
    draw.fragment = textFileName(draw.compiled->target, draw.compiled->hash);
  return draw;
}

void DrawObserver::pick(ObservedDraw draw, const Redraw &redraw) {
  DrawProbe::Wish wish;
  wish.region = {m_wish.x, m_wish.y, 1, 1};
  wish.clear = kUncovered;
  wish.alphaTest = true;
  const auto drawn = m_probe.draw(redraw, wish);
  if (!drawn)
    m_trouble = drawn.error();
  else if (drawn.value()[0] != kUncovered && m_draws.size() < kMostRows) {
    draw.color = drawn.value()[0];
    m_draws.push_back(std::move(draw));
  }
}

void DrawObserver::hold(const ObservedDraw &draw, const Redraw &redraw) {
  if (!draw.compiled)
    m_trouble = "no program of the layer's shades it";
  else if (!m_wish.fragment.empty() && draw.fragment != m_wish.fragment)
    m_trouble = "it is drawn with another program now";
  else {
    m_wasHeld = true;
    m_held(*this, draw, redraw);
  }
}

void DrawObserver::measure(ObservedDraw draw, const Redraw &redraw) {
  const bool counts = m_context.caps.occlusionQuery && m_host.lookup &&
                      m_host.lookup("glBeginQuery") && m_host.lookup("glGetQueryObjectuiv");
  {
    const HostErrorScope errors(m_host, m_context.pendingError);
    m_host.Finish();
    if (counts)
      functionOf<void (*)(GLenum, GLuint)>(m_host, "glBeginQuery")(GL_SAMPLES_PASSED, kQuery);
  }
  m_madeQuery |= counts;
  const std::int64_t before = nowNanoseconds();
  redraw(m_host);
  {
    HostErrorScope errors(m_host, m_context.pendingError);
    GLuint pixels = 0;
    if (counts)
      functionOf<void (*)(GLenum)>(m_host, "glEndQuery")(GL_SAMPLES_PASSED);
    m_host.Finish();
    draw.nanoseconds = nowNanoseconds() - before;
    if (counts)
      functionOf<void (*)(GLuint, GLenum, GLuint *)>(m_host, "glGetQueryObjectuiv")(
          kQuery, GL_QUERY_RESULT, &pixels);
    if (counts && !errors.failed())
      draw.pixels = pixels;
  }
  if (m_draws.size() < kMostRows)
    m_draws.push_back(std::move(draw));
}

void DrawObserver::draw(const char *command, const Redraw &redraw) {
  // The host's to record, or to refuse; or of a context that was given up (Session::observe()).
  if (m_context.listMode != 0 || m_context.insideBeginEnd ||
      g_observed.load(std::memory_order_relaxed) != &m_context)
    return redraw(m_host);
  ++m_count;
  using Aim = Observation::Aim;
  bool made = false;
  withinMemory(m_context, command, [&] {
    if (!isObservable())
      return;
    if (m_wish.aim == Aim::Pick)
      return pick(describe(command), redraw);
    if (m_wish.aim == Aim::Hold && m_count == m_wish.draw)
      return hold(describe(command), redraw);
    if (m_wish.aim == Aim::Measure) {
      made = true;
      measure(describe(command), redraw);
    }
  });
  if (!made)
    redraw(m_host);
}

void DrawObserver::list(const Redraw &redraw) {
  if (!m_recording && m_context.listMode == 0)
    ++m_lists;
  redraw(m_host);
}

void DrawObserver::begin(GLenum mode) {
  if (m_context.listMode != 0 || m_recording || mode > GL_POLYGON)
    return m_host.Begin(mode);
  m_host.NewList(kList, GL_COMPILE);
  m_recording = m_madeList = true;
  m_host.Begin(mode);
}

void DrawObserver::end() {
  m_host.End();
  if (!std::exchange(m_recording, false))
    return;
  m_host.EndList();
  const bool inside = std::exchange(m_context.insideBeginEnd, false);
  draw("glBegin", [](const HostTable &host) { host.CallList(kList); });
  m_context.insideBeginEnd = inside;
}

} // namespace arbiter::state::remote
