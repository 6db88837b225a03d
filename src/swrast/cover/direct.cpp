#include "swrast/cover/direct.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "swrast/cover/emit.h"
#include "swrast/threads.h"

namespace arbiter::swrast {
namespace {

/// With fewer pixels, the work is done before another thread has woken up.
constexpr std::int64_t kParallelPixels = 4096;
/// There are more bands than threads, so that a delayed thread loses only a part of its share.
/// Bands have a minimal size, because the machine code may have a start-up cost for each.
constexpr int kBandsPerThread = 4;
constexpr std::int64_t kBandPixels = 32768;
/// Bands begin at multiples of this, which is a multiple of every block's height.
constexpr int kBandUnit = 4;
/// The unit if clears are pending, because one thread must write a whole tile of a clear.
constexpr int kClearBandUnit = DeferredClear::kTile;
static_assert(kClearBandUnit % kBandUnit == 0);

/// Shades the parts of the shapes in rows [bottom, top). Returns the number of pixels.
std::uint64_t shadeBand(const RasterState &state, const Shading &shading, const Shape *shapes,
                        std::size_t count, int bottom, int top) {
  std::size_t start = 0;
  // Skips the shapes that are hidden by an opaque rectangle across the whole band.
  if (shading.opaque && !state.polygonStipple)
    for (std::size_t s = count; s-- > 1 && start == 0;)
      if (shapes[s].edgeCount == 0 && shapes[s].bottom <= bottom && shapes[s].top >= top &&
          std::all_of(shapes, shapes + s, [&](const Shape &below) {
            return below.left >= shapes[s].left && below.right <= shapes[s].right;
          }))
        start = s;
  Emitter emitter(state, shading);
  for (std::size_t s = start; s < count; ++s)
    emitter.shade(shapes[s], shapes[s].left, bottom, shapes[s].right, top);
  return emitter.pixels();
}

} // namespace

std::uint64_t shadeInBands(const RasterState &state, const Shading &shading, const Shape *shapes,
                           std::size_t count) {
  constexpr int kMax = std::numeric_limits<int>::max(), kLeast = std::numeric_limits<int>::min();
  int bottom = kMax, top = kLeast, left = kMax, right = kLeast;
  std::int64_t area = 0;
  for (std::size_t i = 0; i < count; ++i) {
    bottom = std::min(bottom, shapes[i].bottom);
    top = std::max(top, shapes[i].top);
    left = std::min(left, shapes[i].left);
    right = std::max(right, shapes[i].right);
    area += std::int64_t(shapes[i].right - shapes[i].left) * (shapes[i].top - shapes[i].bottom);
  }
  if (bottom >= top)
    return 0;
  if (area < kParallelPixels) {
    state.clears.reach({left, bottom, right - left, top - bottom});
    return shadeBand(state, shading, shapes, count, bottom, top);
  }
  const int unit = state.clears.count != 0 ? kClearBandUnit : kBandUnit;
  bottom &= ~(unit - 1);
  int height = top - bottom;
  if (const int threads = threadCount(); threads > 1) {
    const std::int64_t bands =
        threads * std::clamp<std::int64_t>(area / kBandPixels / threads, 1, kBandsPerThread);
    height = int((height + bands - 1) / bands + unit - 1) & ~(unit - 1);
  }
  std::atomic<std::uint64_t> pixels{0};
  auto band = [&](std::uint32_t i) {
    const int from = bottom + int(i) * height, to = std::min(top, from + height);
    state.clears.reach({left, from, right - left, to - from});
    pixels.fetch_add(shadeBand(state, shading, shapes, count, from, to), std::memory_order_relaxed);
  };
  parallel(std::uint32_t((top - bottom + height - 1) / height), band);
  return pixels.load(std::memory_order_relaxed);
}

} // namespace arbiter::swrast
