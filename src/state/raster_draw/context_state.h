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

/// What a context keeps for the rasterizer; null in Context::software where it is not
/// used (a GPU host, ARBITER_BACKEND=host, a context without the layer's program targets).
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

class Pipeline;

/// From so many vertices on a draw's primitives are taken to be small.
inline constexpr std::uint32_t kManyVertices = 32;

struct ContextState {
  explicit ContextState(Context &context);
  ~ContextState();
  ContextState(const ContextState &) = delete;
  ContextState &operator=(const ContextState &) = delete;

  Mirror mirror;
  swrast::DrawQueue draws; ///< outlives the images that it draws to
  Residency residency;
  ImmediateRecorder recorder;
  MaterialParts materials;         ///< of what is recorded
  std::vector<float> listVertices; ///< of a primitive of a list, made whole: scratch memory
  bool openParts = false;          ///< of the primitive that is recorded: some have been drawn
  std::uint32_t held = 0; ///< primitives in the recorder that have ended (immediate/held.h)
  /// So many vertices were once recorded for one draw: of a primitive that begins it is not known
  /// how many there will be, and functions for small ones would keep a first draw waiting for
  /// nothing.
  bool recordsMany = false;
  std::vector<std::uint32_t> joinedIndices; ///< of them (primitives/joined.h): scratch memory
  /// Null before the first draw that is looked at. Who makes it (decision.cpp) knows how it is
  /// destroyed: all that uses it includes this header.
  std::unique_ptr<Pipeline, void (*)(Pipeline *)> pipeline{nullptr, nullptr};
  /// The next draw looks at all state anew.
  void forgetPipeline() { pipeline.reset(); }
  FrameHistory history;
  bool forced = false; ///< ARBITER_BACKEND=swrast: depths too, whoever draws beside it
  bool steady = false; ///< that, or ARBITER_DEBUG=steady: wait for machine code, never back off
  /// Turns of the host in this frame that draw what the rasterizer cannot. Depths of two
  /// rasterizers are not equal to the bit, and passes that compare them for equality meet only if
  /// one of the two draws all: mayTestDepth().
  std::uint64_t hostTurns = 0;
  std::uint64_t lookTurns = 0; ///< of those, the ones that are the host's for their look alone
  /// The last frame in which something was drawn had turns of the host's for what the rasterizer
  /// lacks, and is no matter of looks or of which side is the faster one.
  bool lacked = false;
  /// The host drew something in this frame of which it is not known whether the rasterizer lacks
  /// it, as the engine or a program is still being made.
  bool unjudged = false;
  /// The application has read pixels that were drawn, and may compare them with others: those of
  /// textures with few bits, for one, are rounded otherwise by hosts, so that it is to be drawn by
  /// one of the two from the start.
  bool readsPixels = false;
  bool observed = false;     ///< a client looks at this frame, which says nothing for that reason
  bool hostDrew = false;     ///< in this frame, for whatever reason
  bool depthsTested = false; ///< in this frame, by the rasterizer: what follows must meet them
  bool drawsPlain = true;    ///< fixed function alone: never a program
  /// Before a draw of the host's that says that the frame is a mixed one.
  void hostDraws(const char *why) {
    ++hostTurns;
    residency.hostTakesTargets(why);
  }
  /// Before the host runs a list of its own, which may draw and do anything else.
  void hostDrawsList() {
    ++hostTurns;
    fellBack(Fallback::List);
    residency.hostDoesAnything("glCallList");
  }
  /// Before a draw of the host's that a list keeps, which is executed as it is compiled.
  void hostDrawsAsCompiled() {
    fellBack(Fallback::List);
    hostDrew = true;
    hostDraws("glNewList");
  }
  /// Of a draw that the host can do as well: whether it may go without a judgement, so that nothing
  /// waits for machine code. An application that makes programs in each frame would never be
  /// judged.
  [[nodiscard]] bool mayGoUnjudged(bool isPlain = false) const {
    return !readsPixels && !history.waitsForCode && !history.look.isRasterizers() &&
           history.unjudgedFrames < (isPlain ? kMostUnjudgedPlain : kMostUnjudged);
  }
  static constexpr int kMostUnjudged = 2, kMostUnjudgedPlain = 20;
  /// Whether the rasterizer may test depth or stencil now. Where it is the one to draw a look, the
  /// first frames are taken for whole ones, though the host has begun them while there was no code:
  /// of what it drew the depths are nearly always those that the rasterizer would have made.
  [[nodiscard]] bool mayTestDepth() const {
    return forced || (hostTurns == 0 && ((history.wholeFrames && !hostDrew) || isFirstOfLook()));
  }
  [[nodiscard]] bool isFirstOfLook() const {
    return !history.judged && history.look.isRasterizers();
  }
  std::uint64_t workSeen = 0;        ///< draws, at the end of the last frame
  std::uint64_t drawnSeen = 0;       ///< of those, the rasterizer's
  bool presents = false;             ///< a window was shown
  bool finishes = false;             ///< Finish was called, and no window shown
  const void *frameTarget = nullptr; ///< whose clears are the frames' ends (clearsTarget())
  std::uint64_t transfersSeen = 0;   ///< between host and shadows, at the end of the last frame
  std::uint64_t drawn = 0;
  std::array<std::uint64_t, kFallbackCount> fallbacks{};
  void fellBack(Fallback reason) { ++fallbacks[std::size_t(reason)]; }
};

/// Makes Context::software where it is to be, once: when a fragment program first becomes
/// effective, or, unless ARBITER_FIXED_FUNCTION is programs, at the first draw of fixed function.
/// Until then the rasterizer costs nothing.
void engage(Context &context);
/// True if Context::software may come to be made, by the settings and by what host this is.
[[nodiscard]] bool mayBeUsed(const Context &context);
/// When the context first becomes current: what its draws will need may be made aside.
void expect(const Context &context);
/// Lists that are compiled now keep their primitives for the rasterizer: it is used here, or will
/// be where a fragment program of the layer's becomes effective, and programs are made already.
/// Clients of control look into lists that are kept, and into no others.
[[nodiscard]] bool keepsLists(const Context &context);
/// An application that loads its programs after its lists has done so after so many frames.
inline constexpr std::uint64_t kEarlyFrames = 8;
/// Where keepsLists() is false: lists of primitives alone are kept beside the host's, as programs
/// may be made yet.
[[nodiscard]] bool keepsEarlyLists(const Context &context);

} // namespace arbiter::state::software
