#pragma once
#include <array>
#include <cstdint>

#include "state/software/context_state.h"
#include "state/software/residency.h"

/// The rasterizer's figures for --stats.
namespace arbiter {
class JsonWriter;
}

namespace arbiter::state::software {

/// Of one context, or of several.
struct Figures {
  std::uint64_t contexts = 0; ///< that drew, or tried to
  std::uint64_t drawn = 0;
  std::array<std::uint64_t, kFallbackCount> fallbacks{};
  std::uint64_t trials = 0, framesBackedOff = 0;
  ResidencyStatistics residency;

  void add(const Context &context);
};

/// The value of the key "software".
void write(JsonWriter &json, const Figures &figures);

} // namespace arbiter::state::software
