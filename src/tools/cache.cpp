#include "util/cache/cache_store.h"

#include <cinttypes>
#include <cstdio>

#include "tools/commands.h"
#include "tools/input.h"
#include "util/flags.h"

namespace arbiter::tools {

namespace {

/// One kind of what is kept, each in a folder with a limit of its own. False: something that was to
/// go is still there.
bool show(const std::string &cache, const char *kind, bool clear) {
  const std::string folder = cache + '/' + kind;
  const CacheUsage usage = clear ? clearCache(folder) : cacheUsage(folder);
  std::printf("%-8s  %s: %" PRIu64 " files, %" PRIu64 " of %" PRIu64 " bytes\n", kind,
              folder.c_str(), usage.files, usage.bytes,
              std::uint64_t(settings().cacheMaxMegabytes) << 20);
  return !clear || usage.files == 0;
}

} // namespace

int cache(const CacheArguments &arguments) {
  const std::string folder = cacheFolder();
  if (folder.empty()) {
    complain("no cache: neither XDG_CACHE_HOME nor HOME is an absolute path");
    return kExitUsage;
  }
  const bool programs = show(folder, "programs", arguments.clear);
  const bool code = show(folder, "code", arguments.clear);
  if (!settings().cache)
    std::printf("off: ARBITER_CACHE=0\n");
  if (programs && code)
    return kExitOk;
  complain("some files cannot be removed");
  return kExitUsage;
}

} // namespace arbiter::tools
