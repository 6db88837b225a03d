#pragma once
#include <cstdint>
#include <string_view>

#include "fp_compiler/compilation.h"

/// Caches compiled programs on disk (ARBITER_CACHE), beside the host's own cache. A program that
/// any process of the user has compiled before is read, not compiled.
namespace arbiter::state {

/// Does fp::compile() through the cache. The key has the text, the language, all limits and
/// options, the host's GLSL features, and the build of this library. Another build thus finds
/// nothing.
[[nodiscard]] fp::Compilation compileCached(const fp::CompilationInput &input,
                                            std::string_view text);

/// The counters of this process; all zero if the cache is off.
struct ProgramCacheCounters {
  std::uint64_t hits = 0;
  std::uint64_t misses = 0;
  std::uint64_t stored = 0;
};
[[nodiscard]] ProgramCacheCounters programCacheCounters();

} // namespace arbiter::state
