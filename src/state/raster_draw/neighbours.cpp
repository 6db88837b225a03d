#include "state/raster_draw/neighbours.h"

#include <algorithm>
#include <mutex>
#include <vector>

#include "state/core/context.h"
#include "state/raster_draw/context_state.h"
#include "state/share/share_group.h"

namespace arbiter::state::software {

namespace {

void forgetImagesOf(Context &context) {
  if (context.software)
    context.software->residency.forget();
}

} // namespace

/// All contexts of the process. Its lock is taken by make-current, and when contexts are made and
/// freed.
class NeighbourTable {
public:
  void add(Context &context) {
    const std::lock_guard lock(m_mutex);
    m_all.push_back(&context);
    count(context);
  }

  void remove(Context &context) {
    const std::lock_guard lock(m_mutex);
    context.neighbours.m_current = false;
    std::erase(m_all, &context);
    for (Context *other : m_all)
      count(*other);
  }

  void become(Context &context, const Drawable &drawable) {
    const std::lock_guard lock(m_mutex);
    context.drawable = drawable; // other contexts read it under the lock
    context.neighbours.m_current = true;
    for (Context *other : m_all) {
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
    for (Context *other : m_all)
      count(*other);
  }

  void cease(Context &context) {
    const std::lock_guard lock(m_mutex);
    for (Context *other : m_all)
      if (other != &context && other->neighbours.m_current && areNeighbours(*other, context))
        advance(*other);
    context.neighbours.m_current = false;
    for (Context *other : m_all)
      count(*other);
  }

  void escape() {
    const std::lock_guard lock(m_mutex);
    m_escaped = true;
    for (Context *context : m_all)
      count(*context);
  }

private:
  static bool areNeighbours(const Context &a, const Context &b) {
    return a.group == b.group || (a.neighbours.m_current && b.neighbours.m_current &&
                                  isSameDrawable(a.drawable, b.drawable));
  }

  static void advance(Context &context) { set(context, context.neighbours.epoch() + 2); }

  /// Updates the lowest bit of the context's epoch, which tells whether a neighbour is current.
  void count(Context &context) {
    const auto crowds = [&](const Context *other) {
      return other != &context && other->neighbours.m_current && areNeighbours(*other, context);
    };
    const bool crowded = m_escaped || std::any_of(m_all.begin(), m_all.end(), crowds);
    const std::uint64_t epoch = context.neighbours.epoch();
    if (crowded != NeighbourEpoch::isCrowded(epoch))
      set(context, epoch + 1);
  }

  static void set(Context &context, std::uint64_t epoch) {
    context.neighbours.m_epoch.store(epoch, std::memory_order_relaxed);
  }

  std::mutex m_mutex;
  std::vector<Context *> m_all;
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

void addNeighbour(Context &context) { table().add(context); }
void removeNeighbour(Context &context) { table().remove(context); }
void becomesCurrent(Context &context, const Drawable &drawable) {
  table().become(context, drawable);
}
void ceasesToBeCurrent(Context &context) { table().cease(context); }

} // namespace arbiter::state::software

namespace arbiter::state {

void imagesEscape() { software::table().escape(); }

} // namespace arbiter::state
