#include "util/cache/sealed.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <sys/mman.h>

namespace arbiter {

namespace {

constinit std::atomic<bool> g_writing = false;

bool protect(const void *begin, std::size_t bytes, int rights) {
  return mprotect(const_cast<void *>(begin), bytes, rights) == 0;
}

/// The addresses of sealed pages. A process has few such tables.
constinit std::array<std::atomic<const void *>, 32> g_sealed{};

void remember(const void *begin) {
  for (std::atomic<const void *> &place : g_sealed) {
    const void *known = nullptr;
    if (place.compare_exchange_strong(known, begin) || known == begin)
      return;
  }
}

} // namespace

void sealPages(const void *begin, std::size_t bytes) {
  remember(begin);
  (void)protect(begin, bytes, PROT_READ);
}

bool isSealed(const void *begin) {
  return std::any_of(g_sealed.begin(), g_sealed.end(),
                     [begin](const auto &known) { return known.load() == begin; });
}

UnsealedPages::UnsealedPages(const void *begin, std::size_t bytes)
    : m_begin(begin), m_bytes(bytes) {
  if (g_writing.exchange(true, std::memory_order_acquire))
    return;
  m_open = protect(begin, bytes, PROT_READ | PROT_WRITE);
  if (!m_open)
    g_writing.store(false, std::memory_order_release);
}

UnsealedPages::~UnsealedPages() {
  if (!m_open)
    return;
  sealPages(m_begin, m_bytes);
  g_writing.store(false, std::memory_order_release);
}

} // namespace arbiter
