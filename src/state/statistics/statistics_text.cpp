#include "state/statistics/statistics_text.h"

#include <GL/arbiter.h>
#include <algorithm>
#include <unistd.h>

#include "fp_compiler/resources.h"
#include "state/identity/active_profile.h"
#include "state/statistics/statistics.h"
#include "util/defaults/report.h"
#include "util/flags.h"
#include "util/json.h"
#include "util/record/record_text.h"

namespace arbiter::state {

namespace {

/// The number of contexts that are listed, the last ones. Earlier ones are counted, as an
/// application may keep on making contexts.
constexpr std::size_t kMaxContexts = 256;

const char *providerName(Provider provider) {
  switch (provider) {
  case Provider::Glx:
    return "glx";
  case Provider::Egl:
    return "egl";
  case Provider::OsMesa:
    return "osmesa";
  }
  return "";
}

void writeProgram(JsonWriter &json, const ProgramRow &row) {
  json.beginObject();
  json.key("context").value(row.context);
  json.key("name").value(row.name);
  json.key("hash").value(toHex(row.hash));
  json.key("target").value(row.target);
  json.key("language").value(row.language);
  if (row.counted) {
    fp::writeCounts(json, "counts", row.counts);
    fp::writeCounts(json, "native_counts", row.nativeCounts);
    json.key("under_native_limits").value(row.underNativeLimits);
  }
  if (row.error.empty()) {
    json.key("error").null();
    if (!row.warning.empty())
      json.key("warning").value(row.warning);
  } else {
    json.key("error").beginObject();
    json.key("position").value(row.errorPosition);
    json.key("text").value(row.error);
    if (!row.refusal.reason.empty()) {
      json.key("refused_by_profile").beginObject();
      json.key("reason").value(row.refusal.reason);
      json.key("remedy").value(row.refusal.remedy());
      json.endObject();
    }
    json.endObject();
  }
  json.endObject();
}

bool isFallback(Path path) {
  return path != Path::HostGlsl && path != Path::HostAssembly && path != Path::Rasterizer &&
         path != Path::Recorded;
}

void writeDraws(JsonWriter &json) {
  const auto path = [&](Path of) {
    json.key(pathName(of)).raw(counterPlace(kDraws + unsigned(of)));
  };
  json.key("draws").beginObject();
  path(Path::HostGlsl);
  path(Path::Rasterizer);
  path(Path::HostAssembly);
  json.key("host_untouched").raw(counterPlace(kUntouched));
  path(Path::Recorded);
  json.key("dropped").raw(counterPlace(kDropped));
  std::vector<NamedCounter> reasons;
  for (int i = 0; i < kPathCount; ++i)
    if (isFallback(Path(i)))
      reasons.push_back({pathName(Path(i)), kDraws + unsigned(i)});
  json.key("reasons").raw(nonZeroPlace(reasons, 3));
  json.endObject();
}

void writeFeedback(JsonWriter &json) {
  json.key("feedback").beginObject();
  json.key("copies").raw(counterPlace(kCopies));
  json.key("pixels").raw(counterPlace(kPixels));
  json.key("bytes").raw(counterPlace(kBytes));
  json.key("read_buffer_calls").raw(counterPlace(kReadBuffers));
  json.key("kinds").beginObject();
  for (int i = 0; i < kCopyKindCount; ++i)
    json.key(copyKindName(CopyKind(i))).raw(counterPlace(kKinds + unsigned(i)));
  json.endObject().endObject();
}

void writeContext(JsonWriter &json, const ContextRow &row) {
  json.beginObject();
  json.key("id").value(row.serial);
  json.key("provider").value(providerName(row.provider));
  json.key("offered").value(row.offered);
  if (row.obstacle)
    json.key("obstacle").value(row.obstacle);
  json.key("numerics").value(nameOf(row.numerics));
  json.key("destroyed").value(row.live == nullptr);
  json.endObject();
}

} // namespace

FrameText frameText(const std::vector<ContextRow> &contexts) {
  constexpr std::string_view kRows = "\x05";
  JsonWriter json;
  json.beginObject();
  json.key("schema").value(ARBITER_STATS_SCHEMA);
  json.key("pid").value(std::int64_t(getpid()));
  json.key("profile").value(settings().profile);
  json.key("numerics").value(nameOf(activeNumerics()));
  json.key("identity").value(settings().identityOfProfile ? "profile" : "host");
  json.key("defaults");
  defaults::writeChoice(json, defaults::ownChoiceIfRead());
  json.key("contexts").beginArray();
  // Lists the last ones, as an application may keep on making contexts.
  const std::size_t first = contexts.size() - std::min(contexts.size(), kMaxContexts);
  for (std::size_t i = first; i < contexts.size(); ++i)
    writeContext(json, contexts[i]);
  json.endArray();
  json.key("contexts_not_listed").value(std::uint64_t(first));
  json.key("programs").raw("[" + std::string(kRows) + "]");
  json.key("programs_not_listed").raw(counterPlace(kProgramsNotListed));
  json.key("program_cache").beginObject();
  json.key("hits").raw(counterPlace(kCacheHits));
  json.key("misses").raw(counterPlace(kCacheMisses));
  json.key("stored").raw(counterPlace(kCacheStored));
  json.endObject();
  writeDraws(json);
  writeFeedback(json);
  json.key("software");
  write(json, kSoftware);
  json.key("frames").raw(counterPlace(kFrames));
  json.endObject();
  const std::string text = json.take();
  const std::size_t rows = text.find(kRows);
  return {text.substr(0, rows), text.substr(rows + kRows.size())};
}

std::string rowText(const ProgramRow &row) {
  JsonWriter json;
  writeProgram(json, row);
  std::string text;
  for (const char c : json.take()) {
    text += c;
    if (c == '\n')
      text += "    ";
  }
  text.resize(text.find_last_of('}') + 1);
  return text;
}

} // namespace arbiter::state
