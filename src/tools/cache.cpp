#include "util/cache_store.h"

#include <cinttypes>
#include <cstdio>

#include "tools/commands.h"
#include "tools/input.h"
#include "util/flags.h"

namespace arbiter::tools {

int cache(const CacheArguments &arguments) {
  const std::string folder = cacheFolder();
  if (folder.empty()) {
    complain("no cache: neither XDG_CACHE_HOME nor HOME is an absolute path");
    return kExitUsage;
  }
  const std::string programs = folder + "/programs";
  const CacheUsage usage = arguments.clear ? clearCache(programs) : cacheUsage(programs);
  std::printf("folder    %s\nprograms  %" PRIu64 "\nbytes     %" PRIu64 " of %" PRIu64 "%s\n",
              programs.c_str(), usage.files, usage.bytes,
              std::uint64_t(settings().cacheMaxMegabytes) << 20,
              settings().cache ? "" : " (off: ARBITER_CACHE=0)");
  if (!arguments.clear || usage.files == 0)
    return kExitOk;
  complain("some files cannot be removed");
  return kExitUsage;
}

} // namespace arbiter::tools
