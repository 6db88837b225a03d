#include "util/cache/cache_store.h"

#include <GL/arbiter.h>
#include <cinttypes>
#include <cstdio>
#include <string>
#include <vector>

#include "apps/tools/commands.h"
#include "apps/tools/input.h"
#include "util/flags.h"
#include "util/json.h"

namespace arbiter::tools {

namespace {

/// One kind of cached data; each has its own folder and limit.
struct Kept {
  const char *kind;
  std::string folder;
  CacheUsage usage;
};

std::uint64_t limitBytes() { return std::uint64_t(settings().cacheMaxMegabytes) << 20; }

void printAsText(const std::vector<Kept> &all) {
  for (const Kept &each : all)
    std::printf("%-8s  %s: %" PRIu64 " files, %" PRIu64 " of %" PRIu64 " bytes\n", each.kind,
                each.folder.c_str(), each.usage.files, each.usage.bytes, limitBytes());
  if (!settings().cache)
    std::printf("off: ARBITER_CACHE=0\n");
}

void printAsJson(const std::vector<Kept> &all) {
  JsonWriter json;
  json.beginObject()
      .key("schema")
      .value(ARBITER_CACHE_SCHEMA)
      .key("enabled")
      .value(settings().cache);
  json.key("kinds").beginArray();
  for (const Kept &each : all)
    json.beginObject()
        .key("kind")
        .value(each.kind)
        .key("folder")
        .value(each.folder)
        .key("files")
        .value(each.usage.files)
        .key("bytes")
        .value(each.usage.bytes)
        .key("limit_bytes")
        .value(limitBytes())
        .endObject();
  std::fputs(json.endArray().endObject().take().c_str(), stdout);
}

} // namespace

int cache(const CacheArguments &arguments) {
  const std::string cache = cacheFolder();
  if (cache.empty()) {
    complain("no cache: neither XDG_CACHE_HOME nor HOME is an absolute path");
    return kExitUsage;
  }
  std::vector<Kept> all;
  bool left = false; // true if clearing left files behind
  for (const char *const kind : {"programs", "code"}) {
    const std::string folder = cache + '/' + kind;
    all.push_back({kind, folder, arguments.clear ? clearCache(folder) : cacheUsage(folder)});
    left = left || (arguments.clear && all.back().usage.files != 0);
  }
  arguments.json ? printAsJson(all) : printAsText(all);
  if (!left)
    return kExitOk;
  complain("some files cannot be removed");
  return kExitUsage;
}

} // namespace arbiter::tools
