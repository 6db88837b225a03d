#pragma once
#include <cstddef>

/// How deep blocks of a program under NVIDIA's options may lie in one another: what the compiler
/// holds, and what glGetProgramivARB answers (NV_fragment_program2, NV_vertex_program2_option).
namespace arbiter::fp::nv {

inline constexpr std::size_t kMostCalls = 32;
inline constexpr std::size_t kMostLoops = 32;
inline constexpr std::size_t kMostBlocks = 256; ///< IF, LOOP and REP together
/// What the specifications promise at least: executed instructions, and iterations of one loop.
inline constexpr int kLeastExecuted = 65536, kLeastIterations = 255;

} // namespace arbiter::fp::nv
