#pragma once
#include <cstdint>

/// What a program leaves for its next start, beside the machine code on disk (ARBITER_CACHE). The
/// first frame would go to the host, as the engine is not there (LLVM is relocated and initialised
/// for some milliseconds) and it is not known whether the rasterizer can draw it as a whole; the
/// host then compiles, or at least translates, what will not be used again. A program that ran
/// before has its engine made while it starts, and its first frame drawn by the code that it left.
namespace arbiter::state::software {

/// Of the same program (util/defaults/program.h) and build, whose code alone is on disk. How it
/// was, not a promise: what turns out otherwise costs time.
enum class LastStart : std::uint8_t {
  Unknown,
  Engine,      ///< the engine was used
  WholeFrames, ///< and the rasterizer could draw frames as a whole
};

/// Reads the disk at the first call of a process.
[[nodiscard]] LastStart lastStart();
/// Has the engine made by the compiling thread, where the last start used it. Only the first call
/// of a process does anything.
void startEngineAsBefore();
/// The engine is there.
void noteEngine();
/// A frame ended that was judged. \param whole it had no turn of the host
void noteFrame(bool whole);

} // namespace arbiter::state::software
