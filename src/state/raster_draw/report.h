#pragma once
#include <array>
#include <cstdint>

#include "state/raster_draw/context_state.h"

/// The rasterizer's figures for --stats.
namespace arbiter {
class JsonWriter;
}

namespace arbiter::state {

/// The figures of one context, or the sum of several.
struct Figures {
  std::uint64_t contexts = 0; ///< contexts that drew, or tried to
  std::uint64_t drawn = 0;
  std::array<std::uint64_t, kFallbackCount> fallbacks{};
  std::uint64_t trials = 0, framesBackedOff = 0;
  ResidencyStatistics residency;

  /// Adds the figures of a context, including those from before it was left alone (frames/leave.h).
  void add(const RasterContext &context);
  void add(const Figures &others);
};

/// Number of counters that hold the figures, including machine code's.
inline constexpr unsigned kFigureCount = kFallbackCount + 15;
void store(const Figures &figures, std::uint64_t (&counters)[kFigureCount]);
/// Writes the value of the key "software", with placeholders for the counters from `first` on
/// (util/record/record_text.h).
void write(JsonWriter &json, unsigned first);

} // namespace arbiter::state
