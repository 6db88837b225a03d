#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "fp_compiler/limits.h"
#include "fp_compiler/numerics.h"
#include "state/core/context.h"
#include "state/raster_draw/report.h"
#include "state/report/refusals.h"
#include "util/hash.h"
#include "util/record/live_record.h"

/// What statistics look like as JSON: rows of programs, and a frame around them with places for the
/// counters (util/record/record_text.h). Which counter lies where is here, and nowhere else.
namespace arbiter::state {

/// Places of the record's counters.
enum Counter : unsigned {
  kDraws = 0, ///< by path
  kUntouched = kPathCount,
  kDropped,
  kCopies,
  kPixels,
  kBytes,
  kReadBuffers,
  kKinds,
  kFrames = kKinds + kCopyKindCount,
  kProgramsNotListed,
  kCacheHits,
  kCacheMisses,
  kCacheStored,
  kSoftware,
  kCounterCount = kSoftware + software::kFigureCount,
};
static_assert(kCounterCount <= LiveRecord::kCounters);

struct ContextRow {
  std::uint32_t serial = 0;
  Provider provider = Provider::Glx;
  bool offered = false;
  const char *obstacle = nullptr;
  fp::Numerics numerics = fp::Numerics::Host;
  const Context *live = nullptr;
};

struct ProgramRow {
  std::uint32_t context = 0;
  unsigned name = 0;
  Hash128 hash;
  const char *target = "";
  std::string language;
  bool counted = false;
  fp::ResourceCounts counts;
  fp::ResourceCounts nativeCounts;
  bool underNativeLimits = false;
  std::int32_t errorPosition = -1;
  std::string error;
  Refusal refusal;     ///< where the profile alone is why
  std::string warning; ///< of a program that loaded
};

/// The text before the rows and the one behind them: the process, its contexts, and places for the
/// counters.
struct FrameText {
  std::string before, after;
};
[[nodiscard]] FrameText frameText(const std::vector<ContextRow> &contexts);
/// A row as it stands in the array of programs.
[[nodiscard]] std::string rowText(const ProgramRow &row);

} // namespace arbiter::state
