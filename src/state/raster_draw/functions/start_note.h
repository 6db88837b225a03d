#pragma once
#include <cstdint>

/// A note on disk for the program's next start, beside its machine code (ARBITER_CACHE). Without
/// it, the host would draw the first frame: loading LLVM takes some milliseconds, and it is not
/// known whether the rasterizer can draw the whole frame. The host would then compile what is never
/// used again. With the note, the engine is created while the program starts, and the code on disk
/// draws its first frame.
namespace arbiter::state {

/// The note's account of the last start by the same program (util/defaults/program.h) and the same
/// build. A wrong note costs time only.
enum class LastStart : std::uint8_t {
  Unknown,
  Engine,      ///< the engine was used
  WholeFrames, ///< the engine was used, and the rasterizer drew whole frames
};

/// Returns the note. The process's first call reads the disk.
[[nodiscard]] LastStart lastStart();
/// Starts to create the engine on the compiling thread if the last start used it. Only the
/// process's first call has an effect.
void startEngineAsBefore();
/// Notes that the engine is in use.
void noteEngine();
/// Notes a frame that was judged. \param whole true if it was a whole frame
void noteFrame(bool whole);

} // namespace arbiter::state
