#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "state/mirror/mirror.h"
#include "state/primitives/material_parts.h"
#include "state/primitives/recorder.h"
#include "state/raster_draw/fallback.h"
#include "state/raster_draw/frames/frame_history.h"
#include "state/residency/residency.h"
#include "swrast/queue/draw_queue.h"

/// The rasterizer's state of a context. RasterContext::software is null if the rasterizer is not
/// used: on a GPU host, with ARBITER_BACKEND=host, or in a context without the layer's program
/// targets.
namespace arbiter::state {
struct RasterContext;
}

namespace arbiter::state {

class Pipeline;

/// A draw of at least this many vertices is assumed to have small primitives.
inline constexpr std::uint32_t kManyVertices = 32;

struct ContextState {
  explicit ContextState(RasterContext &context);
  ~ContextState();
  ContextState(const ContextState &) = delete;
  ContextState &operator=(const ContextState &) = delete;

  Mirror mirror;
  /// declared before the images that it draws to, so that it outlives them
  swrast::DrawQueue draws;
  Residency residency;
  ImmediateRecorder recorder;
  MaterialParts materials;         ///< materials of the primitive being recorded
  std::vector<float> listVertices; ///< scratch memory for a list's primitive
  bool openParts = false; ///< true if parts of the primitive being recorded have been drawn
  std::uint32_t held = 0; ///< number of ended primitives in the recorder (immediate/held.h)
  /// scratch memory for joined primitives (primitives/joined.h)
  std::vector<std::uint32_t> joinedIndices;
  /// Null before the first draw that the rasterizer considers. The deleter comes from decision.cpp,
  /// because this header knows Pipeline by name only.
  std::unique_ptr<Pipeline, void (*)(Pipeline *)> pipeline{nullptr, nullptr};
  /// Makes the next draw look at all state anew.
  void forgetPipeline() { pipeline.reset(); }
  FrameHistory history;
  bool forced = false; ///< ARBITER_BACKEND=swrast: also draws with depth test in mixed frames
  /// `forced`, or ARBITER_DEBUG=steady: waits for machine code and never backs off
  bool steady = false;
  /// The frame that is being drawn. The end of a frame clears it (frames/frame.cpp).
  struct Frame {
    /// Number of times that the host drew something that the rasterizer cannot. Depths of two
    /// rasterizers are not equal to the bit, and passes may compare depths for equality. All of a
    /// frame's depths must therefore come from one side: mayTestDepth().
    std::uint64_t hostTurns = 0;
    std::uint64_t lookTurns = 0; ///< the part of hostTurns whose only reason is a look
    /// True if the host drew something while the engine or a program was still being compiled. It
    /// is then not known whether the rasterizer lacks it.
    bool unjudged = false;
    bool observed = false; ///< true if a client of control observes the frame, which says nothing
    bool hostDrew = false; ///< true if the host drew, for any reason
    /// true if the rasterizer tested depth, so that later draws must match it
    bool depthsTested = false;
  };
  Frame frame;
  /// Counters at the end of the last frame.
  struct Seen {
    std::uint64_t work = 0;      ///< number of draws on either side
    std::uint64_t drawn = 0;     ///< the part of `work` that the rasterizer drew
    std::uint64_t transfers = 0; ///< between host and shadows
  };
  Seen seen;
  /// True if the host drew, in the last frame with draws, something that the rasterizer lacks.
  /// Looks and back-off do not count.
  bool lacked = false;
  /// Habits of the application, which are noted once and for good.
  struct Habits {
    /// True if pixels that were drawn have been read. They may be compared with others, and hosts
    /// round some colors differently, such as those of few bits. One side must then draw from the
    /// start.
    bool readsPixels = false;
    bool drawsPlain = true; ///< true while no program has drawn, but fixed function alone
    bool presents = false;  ///< true once a window was shown
    bool finishes = false;  ///< true once Finish was called before any window was shown
    /// True if kManyVertices were once recorded for one draw. The vertex count of a primitive that
    /// begins is not known. Functions for small primitives would make a first draw wait, perhaps
    /// for nothing.
    bool recordsMany = false;
  };
  Habits habits;
  const void *frameTarget = nullptr; ///< the target whose clears end frames (clearsTarget())
  /// Prepares a draw of the host that makes the frame a mixed one.
  void hostDraws(const char *why) {
    ++frame.hostTurns;
    residency.hostTakesTargets(why);
  }
  /// Prepares a call of a list of the host's, which may do anything.
  void hostDrawsList() {
    ++frame.hostTurns;
    fellBack(Fallback::List);
    residency.hostDoesAnything("glCallList");
  }
  /// Prepares a draw of the host in a list that is executed while it is compiled.
  void hostDrawsAsCompiled() {
    fellBack(Fallback::List);
    frame.hostDrew = true;
    hostDraws("glNewList");
  }
  /// True if a draw need not wait for machine code, because the host can draw it and the frame may
  /// stay unjudged. The number of such frames in a row is limited, because an application that
  /// makes programs in each frame would otherwise never be judged.
  [[nodiscard]] bool mayGoUnjudged(bool isPlain = false) const {
    return !habits.readsPixels && !history.waitsForCode && !history.look.isRasterizers() &&
           history.unjudgedFrames < (isPlain ? kMaxUnjudgedPlain : kMaxUnjudged);
  }
  static constexpr int kMaxUnjudged = 2, kMaxUnjudgedPlain = 20;
  /// True if the rasterizer may test depth or stencil now. If it has a context's looks, the first
  /// frames count as whole ones, even if the host began them for lack of code. The host's depths
  /// are then nearly always those that the rasterizer would have made.
  [[nodiscard]] bool mayTestDepth() const {
    return forced ||
           (frame.hostTurns == 0 && ((history.wholeFrames && !frame.hostDrew) || isFirstOfLook()));
  }
  [[nodiscard]] bool isFirstOfLook() const {
    return !history.judged && history.look.isRasterizers();
  }
  std::uint64_t drawn = 0;
  std::array<std::uint64_t, kFallbackCount> fallbacks{};
  void fellBack(Fallback reason) { ++fallbacks[std::size_t(reason)]; }
};

/// Creates RasterContext::software once, if it may be used. This happens when a fragment program
/// first becomes effective, or, unless ARBITER_FIXED_FUNCTION is `programs`, at the first draw of
/// fixed function. Until then the rasterizer costs nothing.
void engage(RasterContext &context);
/// True if the settings and the host allow RasterContext::software to be created.
[[nodiscard]] bool mayBeUsed(const RasterContext &context);
/// Starts to prepare what the context's draws will need, in the background, when it first becomes
/// current.
void expect(const RasterContext &context);
/// True if lists compiled now keep their primitives for the rasterizer. It must be in use, or must
/// be allowed and programs must exist already. Clients of control can look into these lists only.
[[nodiscard]] bool keepsLists(const RasterContext &context);
/// An application that loads programs after its lists has done so within this many frames.
inline constexpr std::uint64_t kEarlyFrames = 8;
/// True if keepsLists() is false but programs may still be made. Lists of primitives alone are then
/// kept beside the host's.
[[nodiscard]] bool keepsEarlyLists(const RasterContext &context);

} // namespace arbiter::state
