/// Puts the layer's memory, mainly pixels and vertices, between inaccessible pages; it is preloaded
/// before the layer. Machine code, which no sanitizer instruments, then crashes at the first access
/// outside. Freed memory is inaccessible too. GUARD_AT=begin puts blocks directly after such a
/// page, anything else directly before one.
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/shm.h>
#include <unistd.h>

// These are glibc's own functions beneath the ones replaced here; no header declares them.
extern "C" void *__libc_malloc(std::size_t);
extern "C" void *__libc_memalign(std::size_t, std::size_t);
extern "C" void *__libc_realloc(void *, std::size_t);
extern "C" void __libc_free(void *);

namespace {

constexpr std::size_t kPage = 4096;
constexpr std::size_t kAlignment = 64; ///< of all blocks; a larger one only serves speed
constexpr std::size_t kSmallest = 1024;
constexpr std::size_t kArena = std::size_t(1) << 40;
/// Images may be read, but not written, this far beyond their pixels (swrast::Storage).
constexpr std::size_t kReadable = 64;
/// Only images have at least this alignment (storage.cpp): from GCC 14 on, libstdc++ also allocates
/// aligned objects by posix_memalign.
constexpr std::size_t kOfImages = 128;
constexpr std::uint8_t kPattern = 0xA7;

/// A page before each block has the header: [header][guard][pages of the block][guard].
struct Header {
  std::uint8_t *block;
  std::size_t bytes;
  std::size_t pages; ///< of the block
  bool isPixels;
};

std::uint8_t *arena() {
  static std::uint8_t *const s_arena = [] {
    void *const begin =
        mmap(nullptr, kArena, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (begin == MAP_FAILED)
      std::abort();
    return static_cast<std::uint8_t *>(begin);
  }();
  return s_arena;
}
/// Addresses are never reused.
std::atomic<std::size_t> g_used{0};
std::atomic<std::size_t> g_images{0}; ///< number of images so far
const char *g_layer = "libGLX_arbiter.so";

bool isGuardedBlock(const void *address) {
  return std::size_t(static_cast<const std::uint8_t *>(address) - arena()) < kArena;
}

bool isLayer(void *caller) {
  thread_local bool s_asking = false; // dladdr may allocate
  if (s_asking)
    return false;
  s_asking = true;
  Dl_info info{};
  const bool layer =
      dladdr(caller, &info) && info.dli_fname && std::strstr(info.dli_fname, g_layer);
  s_asking = false;
  return layer;
}

Header &headerOf(void *block) {
  const std::size_t page = std::size_t(static_cast<std::uint8_t *>(block) - arena()) / kPage;
  auto &header = *reinterpret_cast<Header *>(arena() + (page - 2) * kPage);
  if (header.block != block)
    std::abort(); // freed twice, or not a block's start
  return header;
}

void open(std::uint8_t *pages, std::size_t bytes) {
  if (mprotect(pages, bytes, PROT_READ | PROT_WRITE) != 0)
    std::abort();
}

void *guarded(std::size_t asked, bool isPixels) {
  static const bool s_atBegin = [] {
    const char *const at = std::getenv("GUARD_AT");
    return at && !std::strcmp(at, "begin");
  }();
  const std::size_t bytes = (asked + kAlignment - 1) / kAlignment * kAlignment;
  const std::size_t pages = (bytes + kPage - 1) / kPage;
  std::uint8_t *const begin = arena() + g_used.fetch_add((pages + 3) * kPage);
  if (begin + (pages + 3) * kPage > arena() + kArena)
    return nullptr;
  open(begin, kPage);
  open(begin + 2 * kPage, pages * kPage);
  std::uint8_t *const block = begin + 2 * kPage + (s_atBegin ? 0 : pages * kPage - bytes);
  std::memset(block, kPattern, bytes);
  *reinterpret_cast<Header *>(begin) = {block, bytes, pages, isPixels};
  return block;
}

bool isUntouched(const std::uint8_t *bytes) {
  for (std::size_t i = 0; i < kReadable; ++i)
    if (bytes[i] != kPattern)
      return false;
  return true;
}

void check(const Header &header) {
  if (!header.isPixels ||
      (isUntouched(header.block) && isUntouched(header.block + header.bytes - kReadable)))
    return;
  std::fprintf(stderr, "guarded memory: written beside an image of %zu bytes\n", header.bytes);
  std::abort();
}

/// Checks at the end what is still allocated, and whether images were recognized at all.
struct AtEnd {
  ~AtEnd() {
    if (g_used.load() > 0 && g_images.load() == 0) {
      std::fprintf(stderr, "guarded memory: no block of the layer's was an image\n");
      std::abort();
    }
    for (std::size_t at = 0; at < g_used.load();) {
      const auto &header = *reinterpret_cast<const Header *>(arena() + at);
      if (header.block)
        check(header);
      at += (header.pages + 3) * kPage;
    }
  }
} g_atEnd;

} // namespace

extern "C" {

__attribute__((visibility("default"))) int posix_memalign(void **out, std::size_t alignment,
                                                          std::size_t bytes) noexcept {
  const bool isImage = alignment >= kOfImages;
  if (isLayer(__builtin_return_address(0))) {
    *out = guarded(bytes, isImage);
    g_images += isImage;
  } else {
    *out = __libc_memalign(alignment, bytes);
  }
  return *out ? 0 : ENOMEM;
}

__attribute__((visibility("default"))) void *aligned_alloc(std::size_t alignment,
                                                           std::size_t bytes) noexcept {
  return isLayer(__builtin_return_address(0)) ? guarded(bytes, false)
                                              : __libc_memalign(alignment, bytes);
}

__attribute__((visibility("default"))) void *malloc(std::size_t bytes) noexcept {
  return bytes >= kSmallest && isLayer(__builtin_return_address(0)) ? guarded(bytes, false)
                                                                    : __libc_malloc(bytes);
}

__attribute__((visibility("default"))) void *realloc(void *block, std::size_t bytes) noexcept {
  const bool isGuarded = block && isGuardedBlock(block);
  if (!isGuarded && !(bytes >= kSmallest && isLayer(__builtin_return_address(0))))
    return __libc_realloc(block, bytes);
  void *const grown = bytes >= kSmallest ? guarded(bytes, false) : __libc_malloc(bytes);
  if (grown && block) {
    const std::size_t had = isGuarded ? headerOf(block).bytes : malloc_usable_size(block);
    std::memcpy(grown, block, had < bytes ? had : bytes);
    free(block);
  }
  return grown;
}

__attribute__((visibility("default"))) void free(void *block) noexcept {
  if (!block || !isGuardedBlock(block)) {
    __libc_free(block);
    return;
  }
  Header &header = headerOf(block);
  check(header);
  header.block = nullptr;
  std::uint8_t *const first = reinterpret_cast<std::uint8_t *>(&header) + 2 * kPage;
  (void)madvise(first, header.pages * kPage, MADV_DONTNEED);
  (void)mprotect(first, header.pages * kPage, PROT_NONE);
}

/// Refuses memory shared with the X server, which cannot be guarded exactly, so that images go to
/// normal memory.
__attribute__((visibility("default"))) int shmget(key_t key, std::size_t bytes,
                                                  int flags) noexcept {
  if (isLayer(__builtin_return_address(0))) {
    errno = ENOSPC;
    return -1;
  }
  using Function = int (*)(key_t, std::size_t, int);
  static const auto s_next = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "shmget"));
  return s_next(key, bytes, flags);
}

} // extern "C"
