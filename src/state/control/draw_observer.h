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

namespace arbiter::state::remote {

namespace wire = arbiter::control;

/// What a client wants to know of one frame's draws.
struct Observation {
  enum class Aim : std::uint8_t {
    Pick,    ///< which draws give a pixel its colour
    Hold,    ///< the application stops before one of them
    Measure, ///< each draw's pixels and time
  };
  Aim aim = Aim::Pick;
  int x = 0, y = 0;       ///< of Pick and Hold: pixels of the framebuffer, y up
  GLuint framebuffer = 0; ///< of Pick and Hold: the application's name; 0: the window
  std::int64_t draw = 0;  ///< of Hold: its number in the frame, from 1
  std::string fragment;   ///< of Hold: whose program it is to be drawn with; empty: any
  wire::ClientId client = 0;
  wire::Json id; ///< of the request that is answered when the frame has ended
  bool wantsAnswer = true;
};

/// A draw of the frame that is observed.
struct ObservedDraw {
  std::int64_t number = 0; ///< in the frame, from 1
  const char *command = "";
  std::string fragment, vertex; ///< names of texts' files; empty: fixed function, or GLSL
  const CompiledProgram *compiled = nullptr; ///< of `fragment`
  Vec4 color{};                              ///< of Pick
  std::optional<std::uint64_t> pixels;       ///< of Measure; none: the host cannot count them
  std::int64_t nanoseconds = 0;
};

/// Between two ends of frames of one context: its draws go through here. ContextHot::host is a
/// table whose functions that draw come here first; the rasterizer leaves all draws to the host.
/// The context's thread alone uses it.
class DrawObserver {
public:
  /// At a frame's end, where the context defers nothing (Context::trueHost). `held` is called
  /// before the draw that a Hold is for.
  using Held = std::function<void(DrawObserver &, const ObservedDraw &, const Redraw &)>;
  DrawObserver(Context &context, Observation wish, Held held);
  /// At the next: the context is as it was. It is current.
  ~DrawObserver();
  DrawObserver(const DrawObserver &) = delete;
  DrawObserver &operator=(const DrawObserver &) = delete;

  [[nodiscard]] const Observation &wish() const { return m_wish; }
  [[nodiscard]] Context &context() { return m_context; }
  /// As Context::serial was: another context may lie where the observed one was.
  [[nodiscard]] std::uint32_t serial() const { return m_serial; }
  [[nodiscard]] DrawProbe &probe() { return m_probe; }
  /// Of a Hold: the framebuffer that has the depths and stencils which its draw finds there.
  [[nodiscard]] GLuint depthsOf(const Region &region) const;
  /// Of what the Hold's draw draws to, within the hold. False: it is not known.
  [[nodiscard]] bool targetSize(int &width, int &height);
  /// The functions that draw.
  [[nodiscard]] const host::HostTable &host() const { return m_host; }
  /// Of what the frame had: of Pick those that write the pixel, of Measure all.
  [[nodiscard]] const std::vector<ObservedDraw> &draws() const { return m_draws; }
  /// Calls of lists that may hold anything, and cannot be repeated.
  [[nodiscard]] std::int64_t lists() const { return m_lists; }
  /// How many draws went to which framebuffer, by the application's names.
  [[nodiscard]] const std::map<GLuint, std::int64_t> &framebuffers() const {
    return m_framebuffers;
  }
  [[nodiscard]] std::int64_t count() const { return m_count; }
  /// The Hold's draw came, and its request has been answered.
  [[nodiscard]] bool wasHeld() const { return m_wasHeld; }
  /// The last reason for which a draw could not be looked at; empty: none.
  [[nodiscard]] const std::string &trouble() const { return m_trouble; }

  // --- What the table calls ---

  /// A draw of the application's: looked at, and made.
  void draw(const char *command, const Redraw &redraw);
  void list(const Redraw &redraw);
  /// The host compiles, for the application or for the layer.
  void newList(GLuint list, GLenum mode);
  void endList();
  /// A primitive is kept in a list of the layer's until its end is there.
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

  Context &m_context;
  const Observation m_wish;
  const Held m_held;
  const std::uint32_t m_serial;
  const host::HostTable &m_host; ///< the true one
  /// Never freed: what is made in the frame may keep it. From the frame's end it is as m_host.
  ObservedTable &m_table;
  DrawProbe m_probe;
  DepthReplica m_depths;
  std::map<GLuint, std::int64_t> m_framebuffers;
  std::vector<ObservedDraw> m_draws;
  std::int64_t m_count = 0, m_lists = 0;
  bool m_wasHeld = false, m_madeList = false, m_madeQuery = false;
  bool m_recording = false; ///< a primitive, to a list of the layer's
  bool m_compiling = false;
  std::string m_trouble;
};

} // namespace arbiter::state::remote
