#include "state/statistics/statistics.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <mutex>
#include <pthread.h>
#include <vector>

#include "fp_compiler/compiler.h"
#include "state/core/context_hot.h"
#include "state/programs/program_cache.h"
#include "state/raster_draw/raster_context.h"
#include "state/raster_draw/report.h"
#include "state/statistics/statistics_text.h"
#include "util/exit_lock.h"
#include "util/file.h"
#include "util/flags.h"
#include "util/hash.h"
#include "util/log.h"
#include "util/record/live_record.h"
#include "util/text/letters.h"

namespace arbiter::state {

namespace {

/// Sums of the counters of contexts.
struct Totals {
  std::array<std::uint64_t, kPathCount> draws{};
  std::array<FeedbackTracker::Totals, kCopyKindCount> copies{};
  std::uint64_t frames = 0;
  std::uint64_t readBuffers = 0;
  Figures software;

  void add(const ContextRow &row) {
    const RasterContext &context = *row.live;
    for (int i = 0; i < kPathCount; ++i)
      draws[std::size_t(i)] += context.counters.draws[std::size_t(i)];
    for (int i = 0; i < kCopyKindCount; ++i) {
      const auto &from = context.counters.feedback.totals(CopyKind(i));
      copies[std::size_t(i)].copies += from.copies;
      copies[std::size_t(i)].pixels += from.pixels;
    }
    frames += context.counters.frames;
    readBuffers += context.counters.readBufferCalls;
    software.add(row.software);
  }
};

struct Registry {
  std::mutex mutex;
  std::vector<ContextRow> contexts;
  Totals gone;
  LiveRecord *record = nullptr; ///< made with the first context
  std::uint32_t nextSerial = 1;
};

/// Returns the registry. Never freed: contexts may be destroyed after static destructors began.
Registry &registry() {
  static Registry *const s_registry = new Registry;
  return *s_registry;
}

bool wanted() { return !settings().statsPath.empty(); }

/// Returns a text's language: "!!ARBfp1.0" without the marks, up to the end of its version.
std::string languageOf(std::string_view text) {
  if (text.substr(0, 2) != "!!")
    return "unknown";
  std::string name;
  for (const char c : text.substr(2, 16)) {
    const bool versioned = name.find('.') != name.npos;
    if ((!isLetterOrDigit(c) && c != '.') || (versioned && !isDigit(c)))
      break; // a word may follow the version directly: "!!ARBfp1.0TEMP r;"
    name += c;
  }
  return name.empty() ? "unknown" : name;
}

void renewFrame(Registry &r) {
  const FrameText text = frameText(r.contexts);
  r.record->setFrame(text.before, text.after);
}

/// Updates the record's counters. Allocates nothing, as it runs at exit too.
void renewCounters(Registry &r) {
  Totals totals = r.gone;
  for (const ContextRow &row : r.contexts)
    if (row.live)
      totals.add(row);
  std::uint64_t *const to = r.record->counters();
  const auto draws = [&](Path path) { return totals.draws[std::size_t(path)]; };
  std::copy(totals.draws.begin(), totals.draws.end(), to + kDraws);
  to[kUntouched] = draws(Path::NoProgram) + draws(Path::ApplicationGlsl) +
                   draws(Path::ApplicationPipeline) + draws(Path::ApplicationStageGlsl) +
                   draws(Path::NotOffered);
  to[kDropped] = draws(Path::InvalidProgram) + draws(Path::HostRefused);
  to[kCopies] = to[kPixels] = 0;
  for (int i = 0; i < kCopyKindCount; ++i) {
    to[kKinds + unsigned(i)] = totals.copies[std::size_t(i)].copies;
    to[kCopies] += totals.copies[std::size_t(i)].copies;
    to[kPixels] += totals.copies[std::size_t(i)].pixels;
  }
  to[kBytes] = to[kPixels] * 4; // the host knows the real format of the copy
  to[kReadBuffers] = totals.readBuffers;
  to[kFrames] = totals.frames;
  const ProgramCacheCounters cache = programCacheCounters();
  to[kCacheHits] = cache.hits;
  to[kCacheMisses] = cache.misses;
  to[kCacheStored] = cache.stored;
  std::uint64_t figures[kFigureCount];
  store(totals.software, figures);
  std::copy(std::begin(figures), std::end(figures), to + kSoftware);
}

void addProgram(const ProgramRow &row) {
  const std::string text = rowText(row);
  Registry &r = registry();
  const std::lock_guard lock(r.mutex);
  if (!r.record)
    return;
  if (!r.record->addRow(text))
    ++r.record->counters()[kProgramsNotListed];
  renewCounters(r);
}

/// Returns the context's row, or null. Contexts that were made last are looked at first.
ContextRow *rowOf(Registry &r, const ContextHot *context) {
  const auto row = std::find_if(r.contexts.rbegin(), r.contexts.rend(),
                                [&](const ContextRow &each) { return each.live == context; });
  return row == r.contexts.rend() ? nullptr : &*row;
}

/// Updates what became known about a context since it was made, and its figures. Called by the
/// context's own thread. \return true if something became known
bool renewContext(ContextRow &row) {
  const RasterContext &context = *row.live;
  row.software = {};
  row.software.add(context);
  if (row.offered == context.offered && row.numerics == context.numerics &&
      row.obstacle == context.caps.obstacle())
    return false;
  row.offered = context.offered;
  row.numerics = context.numerics;
  row.obstacle = context.caps.obstacle();
  return true;
}

/// Updates the calling thread's context.
void renewCurrent(Registry &r) {
  if (ContextRow *const row = rowOf(r, t_current))
    renewContext(*row);
}

/// Makes the record, with the first context, and registers what happens to it at exit and in a
/// child.
void begin(Registry &r) {
  const std::string &pattern = settings().statsPath;
  r.record = LiveRecord::make(expandPid(pattern), pattern.find("%p") != std::string::npos);
  if (!r.record)
    return;
  std::atexit(writeStatistics);
  pthread_atfork(nullptr, nullptr, [] {
    if (registry().record)
      registry().record->afterFork();
  });
}

} // namespace

void noteContextCreated(RasterContext &context) {
  Registry &r = registry();
  const std::lock_guard lock(r.mutex);
  context.serial = r.nextSerial++;
  if (!wanted())
    return;
  try {
    if (!r.record)
      begin(r);
    if (!r.record)
      return;
    ContextRow row;
    row.serial = context.serial;
    row.provider = context.provider;
    row.live = &context;
    r.contexts.push_back(row);
    renewFrame(r);
  } catch (const std::exception &) { // a context is made even if its statistics fail
  }
}

void noteContextDestroyed(const RasterContext &context) {
  if (!wanted())
    return;
  Registry &r = registry();
  const std::lock_guard lock(r.mutex);
  if (!r.record)
    return;
  if (ContextRow *const row = rowOf(r, &context)) {
    renewContext(*row);
    r.gone.add(*row);
    row->live = nullptr; // before anything that may find no memory
  }
  renewFrame(r);
  renewCounters(r);
}

void noteProgress(const RasterContext &context) {
  if (!wanted())
    return;
  Registry &r = registry();
  const std::lock_guard lock(r.mutex);
  if (!r.record)
    return;
  ContextRow *const row = rowOf(r, &context);
  if (row && renewContext(*row))
    renewFrame(r);
  renewCounters(r);
}

void noteLoadedProgram(const CoreContext &context, const ProgramObject &object,
                       std::string_view text, const fp::CheckResult &result,
                       const Refusal &refusal) {
  if (!wanted())
    return;
  ProgramRow row;
  row.context = context.serial;
  row.name = object.name;
  row.hash = hashBytes(text);
  row.target = infoOf(object.target).word;
  row.language = languageOf(text);
  row.counted = result.ok();
  row.counts = result.counts;
  row.nativeCounts = result.nativeCounts;
  row.underNativeLimits = result.underNativeLimits;
  row.errorPosition = result.errorPosition();
  row.refusal = refusal;
  (result.ok() ? row.warning : row.error) = context.errors.text;
  addProgram(row);
}

void noteFragmentShader(const CoreContext &context, const ProgramObject &object,
                        const CompiledProgram *compiled, std::string_view error) {
  if (!wanted())
    return;
  ProgramRow row;
  row.context = context.serial;
  row.name = object.name;
  row.target = infoOf(object.target).word;
  if (compiled)
    row.hash = compiled->hash;
  row.error = error;
  addProgram(row);
}

std::string statisticsJson() {
  Registry &r = registry();
  const std::lock_guard lock(r.mutex);
  std::string text;
  if (!r.record)
    r.record = LiveRecord::inMemory();
  if (!r.record)
    return text;
  renewCurrent(r);
  renewFrame(r);
  renewCounters(r);
  r.record->write({&text, [](void *to, const char *bytes, std::size_t size) {
                     static_cast<std::string *>(to)->append(bytes, size);
                     return true;
                   }});
  return text;
}

void writeStatistics() {
  Registry &r = registry();
  if (!wanted() || !r.record)
    return;
  // A function below on the stack may hold the lock, if a signal handler called exit(). The
  // counters then are those of the last frame.
  if (const std::unique_lock lock = lockAtExit(r.mutex)) {
    renewCurrent(r);
    renewCounters(r);
  }
  if (!r.record->finish())
    logWarn("state", "cannot write statistics to %s: %s", settings().statsPath.c_str(),
            std::strerror(errno));
}

} // namespace arbiter::state
