#include "state/programs/program_cache.h"

#include <atomic>
#include <string>

#include "util/build_id.h"
#include "util/cache/cache_store.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

std::atomic<std::uint64_t> g_hits{0}, g_misses{0}, g_stored{0};

struct Cache {
  CacheStore store;
  std::string build;
};

/// Returns the cache, or null if it is off. Never destroyed, because destructors of an application
/// may make its last GL calls.
const Cache *cache() {
  static const Cache *const s_cache = []() -> const Cache * {
    if (!settings().cache)
      return nullptr;
    const std::string folder = cacheFolder();
    std::string build = buildId();
    if (folder.empty() || build.empty()) {
      logInfo("state", "no program cache: %s",
              folder.empty() ? "neither XDG_CACHE_HOME nor HOME is an absolute path"
                             : "the library has no build id");
      return nullptr;
    }
    const auto *const made =
        new Cache{{folder + "/programs", std::uint64_t(settings().cacheMaxMegabytes) << 20},
                  std::move(build)};
    logInfo("state", "program cache: %s/programs%s", folder.c_str(),
            made->store.usable() ? "" : " cannot be used");
    return made->store.usable() ? made : nullptr;
  }();
  return s_cache;
}

} // namespace

fp::Compilation compileCached(const fp::CompilationInput &input, std::string_view text) {
  const Cache *const c = cache();
  // A text over the limit is refused quickly, so caching the refusal would be useless.
  if (!c || text.size() > fp::kMaxTextBytes)
    return fp::compile(input, text);
  const std::string key = c->build + fp::cacheKey(input, text);
  if (const auto bytes = c->store.find(key)) {
    if (auto found = fp::deserialise(*bytes)) {
      g_hits.fetch_add(1, std::memory_order_relaxed);
      return std::move(*found);
    }
  }
  g_misses.fetch_add(1, std::memory_order_relaxed);
  fp::Compilation compilation = fp::compile(input, text);
  if (c->store.store(key, fp::serialise(compilation)))
    g_stored.fetch_add(1, std::memory_order_relaxed);
  return compilation;
}

ProgramCacheCounters programCacheCounters() { return {g_hits, g_misses, g_stored}; }

} // namespace arbiter::state
