#include "state/raster_draw/report.h"

#include <vector>

#include "state/raster_draw/context_state.h"
#include "state/raster_draw/frames/leave.h"
#include "state/raster_draw/functions/functions.h"
#include "state/raster_draw/raster_context.h"
#include "swrast/image/storage.h"
#include "util/json.h"
#include "util/record/record_text.h"

namespace arbiter::state {

namespace {

Figures figuresOf(const ContextState &state) {
  Figures figures;
  figures.drawn = state.drawn;
  figures.fallbacks = state.fallbacks;
  const BackOff::Statistics &backOff = state.history.backOff.statistics();
  figures.trials = backOff.trials;
  figures.framesBackedOff = backOff.framesBackedOff;
  figures.residency = state.residency.statistics();
  return figures;
}

} // namespace

void Figures::add(const RasterContext &context) {
  if (context.software || context.leftAlone)
    ++contexts;
  if (context.software)
    add(figuresOf(*context.software));
  if (context.leftAlone)
    add(context.leftAlone->figures);
}

void Figures::add(const Figures &others) {
  drawn += others.drawn;
  for (std::size_t i = 0; i < fallbacks.size(); ++i)
    fallbacks[i] += others.fallbacks[i];
  trials += others.trials;
  framesBackedOff += others.framesBackedOff;
  const ResidencyStatistics &moved = others.residency;
  residency.copiesShared += moved.copiesShared;
  residency.copiesInMemory += moved.copiesInMemory;
  residency.downloads += moved.downloads;
  residency.downloadedBytes += moved.downloadedBytes;
  residency.uploads += moved.uploads;
  residency.uploadedBytes += moved.uploadedBytes;
}

namespace {
/// Indices of the figures among the counters, after those of the reasons.
enum Figure : unsigned {
  Contexts = kFallbackCount,
  Drawn,
  Trials,
  FramesBackedOff,
  CopiesShared,
  CopiesInMemory,
  Downloads,
  DownloadedBytes,
  Uploads,
  UploadedBytes,
  ShadowBytes,
  Functions,
  FunctionsFailed,
  CodeBytes,
  CompileMicroseconds,
  FigureCount,
};
static_assert(FigureCount == kFigureCount);
} // namespace

void store(const Figures &figures, std::uint64_t (&counters)[kFigureCount]) {
  for (std::size_t i = 0; i < figures.fallbacks.size(); ++i)
    counters[i] = figures.fallbacks[i];
  counters[Contexts] = figures.contexts;
  counters[Drawn] = figures.drawn;
  counters[Trials] = figures.trials;
  counters[FramesBackedOff] = figures.framesBackedOff;
  const ResidencyStatistics &moved = figures.residency;
  counters[CopiesShared] = moved.copiesShared;
  counters[CopiesInMemory] = moved.copiesInMemory;
  counters[Downloads] = moved.downloads;
  counters[DownloadedBytes] = moved.downloadedBytes;
  counters[Uploads] = moved.uploads;
  counters[UploadedBytes] = moved.uploadedBytes;
  counters[ShadowBytes] = swrast::Storage::totalBytes();
  const CompileStatistics compiled = compileStatistics();
  counters[Functions] = compiled.functions;
  counters[FunctionsFailed] = compiled.failed;
  counters[CodeBytes] = compiled.codeBytes;
  counters[CompileMicroseconds] = std::uint64_t(compiled.milliseconds * 1000.0);
}

void write(JsonWriter &json, unsigned first) {
  const auto counter = [&](const char *key, Figure slot) {
    json.key(key).raw(counterPlace(first + slot));
  };
  json.beginObject();
  counter("contexts", Contexts);
  counter("drawn", Drawn);
  std::vector<NamedCounter> reasons;
  reasons.reserve(kFallbackCount);
  for (int i = 0; i < kFallbackCount; ++i)
    reasons.push_back({fallbackName(Fallback(i)), first + unsigned(i)});
  json.key("given_to_host").raw(nonZeroPlace(reasons, 3));
  json.key("back_off").beginObject();
  counter("trials", Trials);
  counter("frames_on_host", FramesBackedOff);
  json.endObject();
  counter("copies_shared", CopiesShared);
  counter("copies_in_memory", CopiesInMemory);
  counter("downloads", Downloads);
  counter("downloaded_bytes", DownloadedBytes);
  counter("uploads", Uploads);
  counter("uploaded_bytes", UploadedBytes);
  counter("shadow_bytes", ShadowBytes);
  json.key("machine_code").beginObject();
  counter("functions", Functions);
  counter("failed", FunctionsFailed);
  counter("bytes", CodeBytes);
  counter("compile_microseconds", CompileMicroseconds);
  json.endObject();
  json.endObject();
}

} // namespace arbiter::state
