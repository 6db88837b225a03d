#include "state/control/draw_observer.h"

#include <utility>

#include "state/capabilities/host_integer.h"
#include "state/control/host_pixels.h"
#include "state/control/tallies.h"
#include "state/core/control_hooks.h"
#include "state/core/host_errors.h"
#include "state/core/memory.h"
#include "state/objects/linked_program.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state::control {

namespace {

using host::HostTable;

/// Names that no application uses.
constexpr GLuint kList = 0xFFFFFFFAu, kQuery = 0xFFFFFFFAu;
/// The most rows of one frame; further draws are only counted.
constexpr std::size_t kMaxRows = 4096;

/// Looks up a function that only this file needs. Every host that counts pixels has it.
template <typename Function> Function functionOf(const HostTable &host, const char *name) {
  return reinterpret_cast<Function>(host.lookup(name));
}

/// Returns the host's table, even if another observer was abandoned in this context.
const HostTable &trueTable(const HostTable &host) {
  return isObservedTable(host) ? static_cast<const ObservedTable &>(host).observer->host() : host;
}

/// Returns the region that an observation needs: a Pick's pixel, or a Hold's 2x2 pixels in which
/// programs are drawn.
Region watchedRegion(const RasterContext &context, const Observation &wish) {
  if (wish.aim != Observation::Aim::Hold)
    return {wish.x, wish.y, 1, 1};
  int width = 0, height = 0;
  (void)drawableSize(context, width, height);
  const int x = wish.x & ~1, y = wish.y & ~1;
  return {x, y, x + 1 < width ? 2 : 1, y + 1 < height ? 2 : 1};
}

/// A colour that no draw produces.
constexpr Vec4 kUncovered = {-0x1.6a09e6p99f, 0x1.bb67aep98f, -0x1.3c6ef4p97f, 0x1.a54ff6p96f};

} // namespace

DrawObserver::DrawObserver(RasterContext &context, Observation wish, Held held)
    : m_context(context), m_wish(std::move(wish)), m_held(std::move(held)),
      m_serial(context.serial), m_host(trueTable(*context.host)),
      m_table(*new ObservedTable(m_host, this)), m_probe(context, m_host),
      m_depths(context, m_host, watchedRegion(context, m_wish)) {
  context.host = &m_table;
  g_observed.store(&context, std::memory_order_relaxed);
}

DrawObserver::~DrawObserver() {
  const CoreContext *own = &m_context;
  g_observed.compare_exchange_strong(own, nullptr, std::memory_order_relaxed);
  static_cast<HostTable &>(m_table) = m_host; // lists that are being recorded may keep the table
  if (m_context.host == &m_table)
    m_context.host = &m_host;
  else if (m_context.trueHost != &m_table)
    return; // another context has this one's address
  const HostErrorScope errors(m_host, m_context.errors.pending);
  if (m_madeList)
    m_host.DeleteLists(kList, 1);
  if (m_madeQuery)
    functionOf<void (*)(GLsizei, const GLuint *)>(m_host, "glDeleteQueries")(1, &kQuery);
}

/// True if the draw can be repeated without the application noticing.
bool DrawObserver::isObservable(GLuint framebuffer) {
  const HostErrorScope errors(m_host, m_context.errors.pending);
  if (m_wish.aim != Observation::Aim::Measure) {
    if (framebuffer != m_wish.framebuffer)
      return false;
    if (hostInteger(m_host, GL_ATTRIB_STACK_DEPTH) >= m_context.caps.maxAttribStackDepth) {
      m_trouble = "the application's attribute stack is full";
      return false;
    }
  }
  if (hostInteger(m_host, GL_RENDER_MODE) != GL_RENDER)
    return false;
  GLint query = 0;
  if (m_context.caps.occlusionQuery)
    m_host.GetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &query);
  if (query == 0)
    return true;
  m_trouble = "an occlusion query of the application's counts its pixels";
  return false;
}

/// True if the pixel exists in the draw's target. The size of a framebuffer object is only known
/// here.
bool DrawObserver::hasPixel() {
  int width = 0, height = 0;
  if (m_wish.framebuffer == 0)
    return true; // the caller has checked it
  if (!targetSize(width, height))
    m_trouble = "the size of the framebuffer is not known";
  else if (m_wish.x >= width || m_wish.y >= height)
    m_trouble = "the framebuffer is " + std::to_string(width) + "x" + std::to_string(height);
  else
    return true;
  return false;
}

/// True if the draw tests the window's depths or stencils. It may write them too.
bool DrawObserver::testsWindow() const {
  if (m_wish.framebuffer != 0 || m_wish.aim == Observation::Aim::Measure)
    return false;
  const HasDepths has(m_host);
  return (has.depth && m_host.IsEnabled(GL_DEPTH_TEST)) ||
         (has.stencil && m_host.IsEnabled(GL_STENCIL_TEST));
}

GLuint DrawObserver::depthsOf(const Region &region) const {
  return m_wish.framebuffer == 0 && m_depths.holds(region) ? m_depths.framebuffer()
                                                           : m_wish.framebuffer;
}

bool DrawObserver::targetSize(int &width, int &height) {
  return m_wish.framebuffer == 0 ? drawableSize(m_context, width, height)
                                 : framebufferSize(m_context, m_host, width, height);
}

ObservedDraw DrawObserver::describe(const char *command) const {
  ObservedDraw draw;
  draw.number = m_count;
  draw.command = command;
  if (!m_context.effective.linkedProgram)
    return draw;
  const auto stages = m_context.effective.linkedProgram->stages();
  if (const CompiledProgram *const vertex = stages[0]->compiled)
    draw.vertex = textFileName(vertex->target, vertex->hash);
  draw.compiled = stages[1]->compiled;
  if (draw.compiled && hasText(*draw.compiled) && !isOfState(draw.compiled->target))
    draw.fragment = textFileName(draw.compiled->target, draw.compiled->hash);
  return draw;
}

void DrawObserver::pick(ObservedDraw draw, const Redraw &redraw) {
  DrawProbe::Wish wish;
  wish.region = {m_wish.x, m_wish.y, 1, 1};
  wish.clear = kUncovered;
  wish.depths = depthsOf(wish.region);
  wish.alphaTest = true;
  const auto drawn = m_probe.draw(redraw, wish);
  if (!drawn)
    m_trouble = drawn.error();
  else if (drawn.value()[0] != kUncovered && m_draws.size() < kMaxRows) {
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
    const HostErrorScope errors(m_host, m_context.errors.pending);
    m_host.Finish();
    if (counts)
      functionOf<void (*)(GLenum, GLuint)>(m_host, "glBeginQuery")(GL_SAMPLES_PASSED, kQuery);
  }
  m_madeQuery |= counts;
  const std::int64_t before = nowNanoseconds();
  redraw(m_host);
  {
    HostErrorScope errors(m_host, m_context.errors.pending);
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
  if (m_draws.size() < kMaxRows)
    m_draws.push_back(std::move(draw));
}

/// Observes a draw. \returns whether the draw was made
bool DrawObserver::look(const char *command, const Redraw &redraw) {
  using Aim = Observation::Aim;
  const auto framebuffer = m_context.caps.framebufferObjects
                               ? GLuint(hostInteger(m_host, GL_DRAW_FRAMEBUFFER_BINDING))
                               : 0u;
  ++m_framebuffers[framebuffer];
  const bool isBehind = m_wish.aim == Aim::Hold && m_count > m_wish.draw;
  if (isBehind || !isObservable(framebuffer))
    return false;
  if (m_wish.aim == Aim::Measure) {
    measure(describe(command), redraw);
    return true;
  }
  if (!hasPixel())
    return false;
  const bool tests = testsWindow();
  if (std::string why = tests ? m_depths.meet() : std::string(); !why.empty()) {
    m_trouble = std::move(why);
    return false;
  }
  if (m_wish.aim == Aim::Pick)
    pick(describe(command), redraw);
  else if (m_count == m_wish.draw)
    hold(describe(command), redraw);
  if (tests && !m_wasHeld)
    m_depths.follow(redraw);
  return false;
}

void DrawObserver::draw(const char *command, const Redraw &redraw) {
  // The host records or refuses the draw, or the context was abandoned (Session::observe()).
  if (m_context.listMode != 0 || m_compiling || m_context.insideBeginEnd ||
      g_observed.load(std::memory_order_relaxed) != &m_context)
    return redraw(m_host);
  ++m_count;
  bool made = false;
  withinMemory(m_context, command, [&] { made = look(command, redraw); });
  if (!made)
    redraw(m_host);
}

void DrawObserver::list(const Redraw &redraw) {
  const bool executes = !m_recording && !m_compiling && m_context.listMode == 0;
  const ListHolds holds = g_listHolds.load(std::memory_order_relaxed);
  if (executes && holds == ListHolds::Vertices)
    return draw("glCallList", redraw);
  if (executes && holds == ListHolds::Anything)
    ++m_lists;
  redraw(m_host);
}

void DrawObserver::newList(GLuint list, GLenum mode) {
  const bool isLegal = list != 0 && (mode == GL_COMPILE || mode == GL_COMPILE_AND_EXECUTE);
  m_compiling |= isLegal && !m_context.insideBeginEnd;
  m_host.NewList(list, mode);
}

void DrawObserver::endList() {
  m_compiling = false;
  m_host.EndList();
}

void DrawObserver::begin(GLenum mode) {
  if (m_context.listMode != 0 || m_compiling || m_recording || mode > GL_POLYGON)
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

} // namespace arbiter::state::control
