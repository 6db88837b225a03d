#include "state/raster_draw/neighbours.h"

#include <algorithm>
#include <mutex>
#include <vector>

#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

void forgetImagesOf(RasterContext &context) {
  if (context.software)
    context.software->residency.forget();
}

} // namespace

/// All contexts of the process. Its lock is taken by make-current, and when contexts are made and
/// freed.
class NeighbourTable {
public:
  void add(RasterContext &context) {
    const std::lock_guard lock(m_mutex);
    m_all.push_back(&context);
    count(context);
  }

  void remove(RasterContext &context) {
    const std::lock_guard lock(m_mutex);
    context.neighbours.m_current = false;
    std::erase(m_all, &context);
    for (RasterContext *other : m_all)
      count(*other);
  }

  void become(RasterContext &context, const Drawable &drawable) {
    const std::lock_guard lock(m_mutex);
    context.drawable = drawable; // other contexts read it under the lock
    context.neighbours.m_current = true;
    for (RasterContext *other : m_all) {
      if (other != &context && !other->neighbours.m_current && other->software &&
          isSameDrawable(other->drawable, drawable))
        other->software->residency.forgetWindow();
      if (other == &context || !areNeighbours(*other, context))
        continue;
      advance(*other);
      // Its images are stale, and its own thread will not free them.
      if (!other->neighbours.m_current)
        forgetImagesOf(*other);
    }
    for (RasterContext *other : m_all)
      count(*other);
  }

  void cease(RasterContext &context) {
    const std::lock_guard lock(m_mutex);
    for (RasterContext *other : m_all)
      if (other != &context && other->neighbours.m_current && areNeighbours(*other, context))
        advance(*other);
    context.neighbours.m_current = false;
    for (RasterContext *other : m_all)
      count(*other);
  }

  void escape() {
    const std::lock_guard lock(m_mutex);
    m_escaped = true;
    for (RasterContext *context : m_all)
      count(*context);
  }

private:
  static bool areNeighbours(const RasterContext &a, const RasterContext &b) {
    return a.group == b.group || (a.neighbours.m_current && b.neighbours.m_current &&
                                  isSameDrawable(a.drawable, b.drawable));
  }

  static void advance(RasterContext &context) { set(context, context.neighbours.epoch() + 2); }

  /// Updates the lowest bit of the context's epoch, which tells whether a neighbour is current.
  void count(RasterContext &context) {
    const auto crowds = [&](const RasterContext *other) {
      return other != &context && other->neighbours.m_current && areNeighbours(*other, context);
    };
    const bool crowded = m_escaped || std::any_of(m_all.begin(), m_all.end(), crowds);
    const std::uint64_t epoch = context.neighbours.epoch();
    if (crowded != NeighbourEpoch::isCrowded(epoch))
      set(context, epoch + 1);
  }

  static void set(RasterContext &context, std::uint64_t epoch) {
    context.neighbours.m_epoch.store(epoch, std::memory_order_relaxed);
  }

  std::mutex m_mutex;
  std::vector<RasterContext *> m_all;
  bool m_escaped = false; ///< draws act as if every context had a current neighbour, for good
};

namespace {

/// Returns the table. It is never freed: threads of the application may outlive the library's
/// destructors.
NeighbourTable &table() {
  static NeighbourTable *const s_table = new NeighbourTable;
  return *s_table;
}

} // namespace

void addNeighbour(RasterContext &context) { table().add(context); }
void removeNeighbour(RasterContext &context) { table().remove(context); }
void becomesCurrent(RasterContext &context, const Drawable &drawable) {
  table().become(context, drawable);
}
void ceasesToBeCurrent(RasterContext &context) { table().cease(context); }

} // namespace arbiter::state

namespace arbiter::state {

void imagesEscape() { table().escape(); }

} // namespace arbiter::state
