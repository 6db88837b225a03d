#include "state/program_cache.h"

#include <atomic>
#include <cstring>
#include <link.h>
#include <string>

#include "util/cache_store.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

std::atomic<std::uint64_t> g_hits{0}, g_misses{0}, g_stored{0};

struct BuildId {
  std::uintptr_t inside; ///< an address in the object whose build is asked for
  std::string bytes;
};

/// The note of type NT_GNU_BUILD_ID named "GNU", if the segment holds it.
std::string findNote(const char *at, std::size_t size) {
  while (size >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, at, sizeof note);
    const std::size_t name = (note.n_namesz + 3u) & ~std::size_t(3);
    const std::size_t whole = sizeof note + name + ((note.n_descsz + 3u) & ~std::size_t(3));
    if (whole > size)
      break;
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 &&
        std::memcmp(at + sizeof note, "GNU", 4) == 0)
      return {at + sizeof note + name, note.n_descsz};
    at += whole;
    size -= whole;
  }
  return {};
}

int lookInObject(dl_phdr_info *object, std::size_t, void *data) {
  auto &id = *static_cast<BuildId *>(data);
  bool here = false;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr) &segment = object->dlpi_phdr[i];
    here |= segment.p_type == PT_LOAD &&
            id.inside - object->dlpi_addr - segment.p_vaddr < segment.p_memsz;
  }
  if (!here)
    return 0;
  for (int i = 0; i < object->dlpi_phnum && id.bytes.empty(); ++i)
    if (object->dlpi_phdr[i].p_type == PT_NOTE)
      id.bytes =
          findNote(reinterpret_cast<const char *>(object->dlpi_addr + object->dlpi_phdr[i].p_vaddr),
                   object->dlpi_phdr[i].p_memsz);
  return 1;
}

/// What the linker wrote about the library's content: it changes with any change of the compiler.
/// Empty if it was built without.
std::string buildId() {
  BuildId id{reinterpret_cast<std::uintptr_t>(&lookInObject), {}};
  dl_iterate_phdr(lookInObject, &id);
  return id.bytes;
}

struct Cache {
  CacheStore store;
  std::string build;
};

/// Null: off. Never destroyed, as an application's last GL calls may come from destructors.
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
  // A text over the limit is refused at a glance, and need not be kept to be refused again.
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
