#pragma once
#include <cstdint>

#include <GL/gl.h>

#include "state/mirror/attributes.h"
#include "state/raster_draw/outcome.h"

/// Whose a draw is: the rasterizer's, or the host's for a reason. Arrays, called lists and
/// primitives between Begin and End are all decided, counted and handed to the host here.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

class Pipeline;

/// A list is compiled, or a primitive is open: the command is the host's to record, or to refuse.
/// In a list it is noted that pixels may change.
[[nodiscard]] bool isHosts(Context &context);
/// Programs are valid, and the rasterizer is used: decide() is to be asked. Where false nothing has
/// been prepared for the host.
[[nodiscard]] bool usesRasterizer(Context &context);
/// The same of a command, which is executed now.
[[nodiscard]] inline bool isCandidate(Context &context) {
  return !isHosts(context) && usesRasterizer(context);
}

/// What keeps any draw of now with the host, as far as that is known without looking at state: the
/// path, lists, neighbours, and how the rasterizer has fared. Requires: usesRasterizer().
Outcome decideByPath(Context &context);
/// The same, and what fragments at the raster position are drawn with (Pipeline::chooseFragments).
/// The rasterizer takes those that hosts draw with fewer values in the host's frames, too.
Outcome decideFragments(Context &context);
/// Looks at all state that decides about a draw of `count` vertices (0: not known yet), and has its
/// functions made: ok where the rasterizer draws it, with what pipelineOf() has chosen and with the
/// current values that its vertices read, else the reason why the host does. Nothing is written.
/// Requires: usesRasterizer().
/// \param materials parts that vary from vertex to vertex
Outcome decide(Context &context, GLenum mode, std::uint32_t count, MaterialMask materials = 0);
/// Of a draw that was decided about, and of which that turns out later: others vary.
Outcome decideAgain(Context &context, GLenum mode, MaterialMask materials);

/// True where the outcome is that machine code is still being made, but the host cannot draw the
/// same: the draw must meet depths that the rasterizer wrote in this frame, looks of the context
/// are the rasterizer's, or its fragments have values of the raster position. The code has been
/// waited for, and the draw is to be tried again. What takes longer than a part of a second is not
/// in the making (fp_compiler's budget).
[[nodiscard]] bool waitsForCode(Context &context, const Outcome &outcome);
/// What a draw comes to: `attempt`, again while it waits for code.
template <typename Attempt> Outcome outcomeOf(Context &context, Attempt attempt) {
  Outcome outcome = attempt();
  // A program is prepared, then its vertex and its fragment function are made: one after the other.
  for (int step = 0; step < 4 && waitsForCode(context, outcome); ++step)
    outcome = attempt();
  return outcome;
}

/// Counts a draw as the rasterizer's, or brings the host up to date for it and counts why.
/// \return whether it is drawn
bool conclude(Context &context, const Outcome &outcome);
/// The two halves of conclude(), for a primitive that is open for longer than one call.
void noteDrawn(Context &context, std::uint32_t draws = 1);
void giveToHost(Context &context, Fallback reason);

/// The context's; made at the first draw that is looked at. Requires: Context::software.
[[nodiscard]] Pipeline &pipelineOf(Context &context);

} // namespace arbiter::state::software
