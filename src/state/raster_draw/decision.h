#pragma once
#include <cstdint>

#include <GL/gl.h>

#include "state/mirror/attributes.h"
#include "state/raster_draw/outcome.h"

/// Decides whether the rasterizer draws or the host, and for what reason. Array draws, called lists
/// and primitives between Begin and End are all decided and counted here.
namespace arbiter::state {
struct RasterContext;
}

namespace arbiter::state {

class Pipeline;

/// True if programs are valid and the rasterizer is in use, so that decide() may be called. If
/// false, nothing has been prepared for the host.
[[nodiscard]] bool usesRasterizer(RasterContext &context);
/// True if a command is executed now and the rasterizer may do it.
[[nodiscard]] bool isCandidate(RasterContext &context);

/// Returns why the host must do any draw now, or ok, without looking at state: the path, lists,
/// neighbours and back-off decide. Requires usesRasterizer().
Outcome decideByPath(RasterContext &context);
/// Decides about fragments at the raster position, and chooses what to draw them with
/// (Pipeline::chooseFragments()). Those that hosts draw with fewer values are the rasterizer's even
/// while back-off keeps the host.
Outcome decideFragments(RasterContext &context);
/// Decides about a draw of `count` vertices (0: not known yet), and has its functions compiled. If
/// the outcome is ok, the rasterizer draws it with what pipelineOf() has chosen, and the current
/// values that its vertices read are up to date. No pixel is written yet. Requires
/// usesRasterizer().
/// \param materials parts of the material that vary from vertex to vertex
Outcome decide(RasterContext &context, GLenum mode, std::uint32_t count,
               MaterialMask materials = 0);
/// Decides again about a draw when it turns out later which material parts vary.
Outcome decideAgain(RasterContext &context, GLenum mode, MaterialMask materials);

/// True if the draw must be tried again. This is so if machine code was still being compiled and
/// the host cannot draw the same: the draw must match the rasterizer's depths, the rasterizer has
/// the context's looks, or fragments read values of the raster position. The function has then
/// waited for the code. Compiling never takes longer than a part of a second (fp_compiler's
/// budget).
[[nodiscard]] bool waitsForCode(RasterContext &context, const Outcome &outcome);
/// Calls `attempt`, again each time it has waited for code, and returns its outcome.
template <typename Attempt> Outcome outcomeOf(RasterContext &context, Attempt attempt) {
  Outcome outcome = attempt();
  // The program, its vertex function and its fragment function are compiled one after the other.
  for (int step = 0; step < 4 && waitsForCode(context, outcome); ++step)
    outcome = attempt();
  return outcome;
}

/// Counts a draw for the rasterizer, or counts the reason and brings the host up to date.
/// \return true if the draw is done
bool conclude(RasterContext &context, const Outcome &outcome);
/// The two halves of conclude(), for a primitive that stays open during several calls.
void noteDrawn(RasterContext &context, std::uint32_t draws = 1);
void giveToHost(RasterContext &context, Fallback reason);

/// Returns the context's pipeline, and creates it at the first call. Requires
/// RasterContext::software.
[[nodiscard]] Pipeline &pipelineOf(RasterContext &context);

} // namespace arbiter::state
