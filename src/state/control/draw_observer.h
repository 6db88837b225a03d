#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "control/server.h"
#include "state/control/depth_replica.h"
#include "state/control/draw_probe.h"
#include "state/control/observed_table.h"

namespace arbiter::state::control {

namespace wire = arbiter::control;

/// A client's question about one frame's draws.
struct Observation {
  enum class Aim : std::uint8_t {
    Pick,    ///< lists the draws that give a pixel its colour
    Hold,    ///< stops the application before a draw
    Measure, ///< counts each draw's pixels and time
  };
  Aim aim = Aim::Pick;
  int x = 0, y = 0;       ///< for Pick and Hold: pixels of the framebuffer, y up
  GLuint framebuffer = 0; ///< for Pick and Hold: the application's name; 0: the window
  std::int64_t draw = 0;  ///< for Hold: the draw's number in the frame, from 1
  std::string fragment;   ///< for Hold: the program that it must use; empty: any
  wire::ClientId client = 0;
  wire::Json id; ///< of the request, which is answered after the frame
  bool wantsAnswer = true;
};

/// A draw of the observed frame.
struct ObservedDraw {
  std::int64_t number = 0; ///< in the frame, from 1
  const char *command = "";
  std::string fragment, vertex; ///< file names of the texts; empty: fixed function, or GLSL
  const CompiledProgram *compiled = nullptr; ///< the program of `fragment`
  Vec4 color{};                              ///< for Pick
  std::optional<std::uint64_t> pixels;       ///< for Measure; none: the host cannot count them
  std::int64_t nanoseconds = 0;
};

/// Observes the draws of one context's frame. ContextHot::host is a table whose drawing functions
/// come here first, and the rasterizer leaves all draws to the host. Only the context's thread uses
/// it.
class DrawObserver {
public:
  /// Starts the observation at a frame's end, where the context defers nothing
  /// (CoreContext::trueHost). `held` is called before a Hold's draw.
  using Held = std::function<void(DrawObserver &, const ObservedDraw &, const Redraw &)>;
  DrawObserver(RasterContext &context, Observation wish, Held held);
  /// Ends the observation at the next frame's end and restores the context, which is current.
  ~DrawObserver();
  DrawObserver(const DrawObserver &) = delete;
  DrawObserver &operator=(const DrawObserver &) = delete;

  [[nodiscard]] const Observation &wish() const { return m_wish; }
  [[nodiscard]] RasterContext &context() { return m_context; }
  /// Returns the context's serial number. Another context may have the address of a freed one.
  [[nodiscard]] std::uint32_t serial() const { return m_serial; }
  [[nodiscard]] DrawProbe &probe() { return m_probe; }
  /// Returns the framebuffer with the depths and stencils that a Hold's draw finds.
  [[nodiscard]] GLuint depthsOf(const Region &region) const;
  /// Gets the size of the Hold's target, during the hold. Returns false if it is not known.
  [[nodiscard]] bool targetSize(int &width, int &height);
  /// Returns the functions that draw without being observed.
  [[nodiscard]] const host::HostTable &host() const { return m_host; }
  /// Returns the frame's draws: those that write the pixel for a Pick, all for Measure.
  [[nodiscard]] const std::vector<ObservedDraw> &draws() const { return m_draws; }
  /// Returns the calls of lists with unknown contents, which cannot be repeated.
  [[nodiscard]] std::int64_t lists() const { return m_lists; }
  /// Returns the draws per framebuffer, by the application's names.
  [[nodiscard]] const std::map<GLuint, std::int64_t> &framebuffers() const {
    return m_framebuffers;
  }
  [[nodiscard]] std::int64_t count() const { return m_count; }
  /// True if the Hold's draw came and its request was answered.
  [[nodiscard]] bool wasHeld() const { return m_wasHeld; }
  /// Returns the last reason why a draw could not be observed; empty if there was none.
  [[nodiscard]] const std::string &trouble() const { return m_trouble; }

  // --- Called by the table ---

  /// Observes and makes a draw of the application's.
  void draw(const char *command, const Redraw &redraw);
  void list(const Redraw &redraw);
  /// Follow lists that the host compiles, for the application or for the layer.
  void newList(GLuint list, GLenum mode);
  void endList();
  /// Record a primitive in a list of the layer's, until it ends.
  void begin(GLenum mode);
  void end();

private:
  [[nodiscard]] bool isObservable(GLuint framebuffer);
  [[nodiscard]] bool hasPixel();
  [[nodiscard]] bool testsWindow() const;
  [[nodiscard]] bool look(const char *command, const Redraw &redraw);
  [[nodiscard]] ObservedDraw describe(const char *command) const;
  void pick(ObservedDraw draw, const Redraw &redraw);
  void hold(const ObservedDraw &draw, const Redraw &redraw);
  void measure(ObservedDraw draw, const Redraw &redraw);

  RasterContext &m_context;
  const Observation m_wish;
  const Held m_held;
  const std::uint32_t m_serial;
  const host::HostTable &m_host; ///< the real table
  /// Never freed, as objects made in the frame may keep it. After the frame it equals m_host.
  ObservedTable &m_table;
  DrawProbe m_probe;
  DepthReplica m_depths;
  std::map<GLuint, std::int64_t> m_framebuffers;
  std::vector<ObservedDraw> m_draws;
  std::int64_t m_count = 0, m_lists = 0;
  bool m_wasHeld = false, m_madeList = false, m_madeQuery = false;
  bool m_recording = false; ///< a primitive is being recorded in a list of the layer's
  bool m_compiling = false;
  std::string m_trouble;
};

} // namespace arbiter::state::control
