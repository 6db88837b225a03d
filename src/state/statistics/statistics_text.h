#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "fp_compiler/limits.h"
#include "fp_compiler/numerics.h"
#include "state/raster_draw/raster_context.h"
#include "state/raster_draw/report.h"
#include "state/report/refusals.h"
#include "util/hash.h"
#include "util/record/live_record.h"

/// The JSON form of the statistics: rows of programs, and a frame around them with places for the
/// counters (util/record/record_text.h). Only this file knows which counter lies where.
namespace arbiter::state {

/// The counters' places in the record.
enum Counter : unsigned {
  kDraws = 0, ///< one per path
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
  kCounterCount = kSoftware + kFigureCount,
};
static_assert(kCounterCount <= LiveRecord::kCounters);

struct ContextRow {
  std::uint32_t serial = 0;
  Provider provider = Provider::Glx;
  bool offered = false;
  const char *obstacle = nullptr;
  fp::Numerics numerics = fp::Numerics::Host;
  const RasterContext *live = nullptr;
  /// The rasterizer's figures when the context's own thread gave them last: after a frame, and when
  /// the context ceased to be current. Another thread must not look into its state.
  Figures software;
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
  Refusal refusal;     ///< set if only the profile refuses the program
  std::string warning; ///< for a program that loaded
};

/// The text before and after the rows: the process, its contexts, and places for the counters.
struct FrameText {
  std::string before, after;
};
[[nodiscard]] FrameText frameText(const std::vector<ContextRow> &contexts);
/// Returns a row as an element of the array of programs.
[[nodiscard]] std::string rowText(const ProgramRow &row);

} // namespace arbiter::state
