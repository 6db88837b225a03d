#include "state/software/report.h"

#include "state/context.h"
#include "state/software/functions.h"
#include "util/json.h"

namespace arbiter::state::software {

void Figures::add(const Context &context) {
  if (!context.software)
    return;
  ++contexts;
  drawn += context.software->drawn;
  for (std::size_t i = 0; i < fallbacks.size(); ++i)
    fallbacks[i] += context.software->fallbacks[i];
  const BackOff::Statistics &backOff = context.software->backOff.statistics();
  trials += backOff.trials;
  framesBackedOff += backOff.framesBackedOff;
  const ResidencyStatistics &moved = residencyStatistics(context);
  residency.copiesShared += moved.copiesShared;
  residency.copiesInMemory += moved.copiesInMemory;
  residency.downloads += moved.downloads;
  residency.downloadedBytes += moved.downloadedBytes;
  residency.uploads += moved.uploads;
  residency.uploadedBytes += moved.uploadedBytes;
  residency.shadowBytes += moved.shadowBytes;
}

void write(JsonWriter &json, const Figures &figures) {
  json.beginObject();
  json.key("contexts").value(figures.contexts);
  json.key("drawn").value(figures.drawn);
  json.key("given_to_host").beginObject();
  for (int i = 0; i < kFallbackCount; ++i)
    if (figures.fallbacks[std::size_t(i)] != 0)
      json.key(fallbackName(Fallback(i))).value(figures.fallbacks[std::size_t(i)]);
  json.endObject();
  json.key("back_off").beginObject();
  json.key("trials").value(figures.trials);
  json.key("frames_on_host").value(figures.framesBackedOff);
  json.endObject();
  const ResidencyStatistics &moved = figures.residency;
  json.key("copies_shared").value(moved.copiesShared);
  json.key("copies_in_memory").value(moved.copiesInMemory);
  json.key("downloads").value(moved.downloads);
  json.key("downloaded_bytes").value(moved.downloadedBytes);
  json.key("uploads").value(moved.uploads);
  json.key("uploaded_bytes").value(moved.uploadedBytes);
  json.key("shadow_bytes").value(moved.shadowBytes);
  const CompileStatistics compiled = compileStatistics();
  json.key("machine_code").beginObject();
  json.key("functions").value(compiled.functions);
  json.key("failed").value(compiled.failed);
  json.key("bytes").value(compiled.codeBytes);
  json.key("compile_microseconds").value(std::uint64_t(compiled.milliseconds * 1000.0));
  json.endObject();
  json.endObject();
}

} // namespace arbiter::state::software
