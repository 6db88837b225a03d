#include "state/raster_draw/vertices/buffer_copies.h"

#include <atomic>
#include <new>

#include "state/mirror/generation_counter.h"

namespace arbiter::state {

namespace {

std::atomic<bool> g_stopped{false};

} // namespace

void BufferCopies::stop() { g_stopped.store(true, std::memory_order_relaxed); }

BufferCopies::Contents BufferCopies::find(const GenerationCounter &clock, GLuint buffer) {
  const bool changed = (clock.changedSince(m_seen) & dirty::kBuffers) != 0;
  m_seen = clock.now();
  if (changed) {
    m_copies.clear();
    m_bytes = 0;
    return {};
  }
  const auto found = m_copies.find(buffer);
  if (found == m_copies.end() || found->second.empty())
    return {};
  return {found->second.data(), found->second.size()};
}

void BufferCopies::drawnFrom(GLuint buffer, const Contents &contents) {
  if (contents.bytes > kMaxBytes || g_stopped.load(std::memory_order_relaxed))
    return;
  try {
    // Copies in use are never replaced by others.
    if (m_bytes + contents.bytes > kAllBytes ||
        (m_copies.size() >= kMaxBuffers && !m_copies.contains(buffer)))
      return;
    const auto [copy, first] = m_copies.try_emplace(buffer);
    if (first)
      return;
    copy->second.assign(contents.data, contents.data + contents.bytes);
    m_bytes += contents.bytes;
  } catch (const std::bad_alloc &) {
    // The next draw maps the buffer again.
  }
}

} // namespace arbiter::state
