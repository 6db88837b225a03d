#pragma once
#include <cstdint>
#include <string_view>

#include "fp_compiler/compilation.h"

/// Compiled programs on disk (ARBITER_CACHE), beside the host's own cache of what it makes of them:
/// a program that any process of the user compiled before is read instead of compiled.
namespace arbiter::state {

/// fp::compile() by way of the cache. The key holds the text, the language, all limits and options,
/// what the host's GLSL can do, and the build of this library: another build finds nothing.
[[nodiscard]] fp::Compilation compileCached(const fp::CompilationInput &input,
                                            std::string_view text);

/// Of this process; all zero where the cache is off.
struct ProgramCacheCounters {
  std::uint64_t hits = 0;
  std::uint64_t misses = 0;
  std::uint64_t stored = 0;
};
[[nodiscard]] ProgramCacheCounters programCacheCounters();

} // namespace arbiter::state
