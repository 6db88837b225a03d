#pragma once
#include <cstdint>

namespace arbiter::state {

/// The reasons why the host drew: rows of reasons.def.
enum class Fallback : std::uint8_t {
#define ARBITER_FALLBACK(Enumerator, key, doc) Enumerator,
#include "state/raster_draw/reasons.def"
#undef ARBITER_FALLBACK
};
inline constexpr int kFallbackCount = [] {
  int count = 0;
#define ARBITER_FALLBACK(...) ++count;
#include "state/raster_draw/reasons.def"
#undef ARBITER_FALLBACK
  return count;
}();
[[nodiscard]] const char *fallbackName(Fallback reason);
/// Returns the reason that a key of the mirror or of residency names, or `otherwise`.
[[nodiscard]] Fallback fallbackNamed(const char *key, Fallback otherwise);

} // namespace arbiter::state
