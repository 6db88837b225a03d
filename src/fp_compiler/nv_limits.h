#pragma once
#include <cstddef>

/// Nesting limits of programs under NVIDIA's options. The compiler enforces them, and
/// glGetProgramivARB returns them (NV_fragment_program2, NV_vertex_program2_option).
namespace arbiter::fp::nv {

inline constexpr std::size_t kMaxCalls = 32;
inline constexpr std::size_t kMaxLoops = 32;
inline constexpr std::size_t kMaxBlocks = 256; ///< IF, LOOP and REP together
/// The minimum that the specifications promise: executed instructions, and iterations of one loop.
inline constexpr int kLeastExecuted = 65536, kLeastIterations = 255;

} // namespace arbiter::fp::nv
