#include "state/statistics.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <mutex>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "state/active_profile.h"
#include "state/context.h"
#include "state/program_cache.h"
#include "state/software/report.h"
#include "util/file.h"
#include "util/flags.h"
#include "util/hash.h"
#include "util/json.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

/// Programs beyond this are counted and not listed: an application may load them for ever.
constexpr std::size_t kMaxPrograms = 4096;

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
  std::string warning; ///< of a program that loaded
};

/// The counters of a context, or of several.
struct Totals {
  std::array<std::uint64_t, kPathCount> draws{};
  std::array<swrast::FeedbackTracker::Totals, swrast::kCopyKindCount> copies{};
  std::uint64_t frames = 0;
  std::uint64_t readBuffers = 0;
  software::Figures software;

  void add(const Context &context) {
    for (int i = 0; i < kPathCount; ++i)
      draws[std::size_t(i)] += context.draws[std::size_t(i)];
    for (int i = 0; i < swrast::kCopyKindCount; ++i) {
      const auto &from = context.feedback.totals(swrast::CopyKind(i));
      copies[std::size_t(i)].copies += from.copies;
      copies[std::size_t(i)].pixels += from.pixels;
    }
    frames += context.frames;
    readBuffers += context.readBufferCalls;
    software.add(context);
  }
};

struct ContextRow {
  std::uint32_t serial = 0;
  Provider provider = Provider::Glx;
  bool offered = false;
  const char *obstacle = nullptr;
  fp::Numerics numerics = fp::Numerics::Host;
  const Context *live = nullptr;
};

struct Registry {
  std::mutex mutex;
  std::vector<ContextRow> contexts;
  Totals gone;
  std::vector<ProgramRow> programs;
  std::uint64_t programsNotListed = 0;
  std::uint32_t nextSerial = 1;
  pid_t process = getpid();
  timespec began{};
};

/// Never freed: contexts may die after static destructors began.
Registry &registry() {
  static Registry *const s_registry = [] {
    auto *const r = new Registry;
    clock_gettime(CLOCK_REALTIME, &r->began);
    return r;
  }();
  return *s_registry;
}

bool wanted() { return !settings().statsPath.empty(); }

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

/// "!!ARBfp1.0" without the marks: the first word of the text, as far as it is one.
std::string languageOf(std::string_view text) {
  if (text.substr(0, 2) != "!!")
    return "unknown";
  std::string name;
  for (const char c : text.substr(2, 16)) {
    const bool word = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!word && c != '.')
      break;
    name += c;
  }
  return name.empty() ? "unknown" : name;
}

void addProgram(ProgramRow row) {
  Registry &r = registry();
  const std::lock_guard lock(r.mutex);
  if (r.programs.size() < kMaxPrograms)
    r.programs.push_back(std::move(row));
  else
    ++r.programsNotListed;
}

void writeCounts(JsonWriter &json, const char *key, const fp::ResourceCounts &counts) {
  json.key(key).beginObject();
  json.key("instructions").value(counts.instructions);
  json.key("alu").value(counts.aluInstructions);
  json.key("tex").value(counts.texInstructions);
  json.key("indirections").value(counts.texIndirections);
  json.key("temporaries").value(counts.temporaries);
  json.key("parameters").value(counts.parameters);
  json.key("attribs").value(counts.attribs);
  json.key("address_registers").value(counts.addressRegisters);
  json.endObject();
}

void writeProgram(JsonWriter &json, const ProgramRow &row) {
  json.beginObject();
  json.key("context").value(row.context);
  json.key("name").value(row.name);
  json.key("hash").value(toHex(row.hash));
  json.key("target").value(row.target);
  json.key("language").value(row.language);
  if (row.counted) {
    writeCounts(json, "counts", row.counts);
    writeCounts(json, "native_counts", row.nativeCounts);
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
    json.endObject();
  }
  json.endObject();
}

bool isFallback(Path path) {
  return path != Path::HostGlsl && path != Path::Rasterizer && path != Path::Recorded;
}

void writeDraws(JsonWriter &json, const Totals &totals) {
  std::uint64_t untouched = 0;
  for (const Path path : {Path::NoProgram, Path::ApplicationGlsl, Path::ApplicationPipeline,
                          Path::ApplicationStageGlsl, Path::NotOffered})
    untouched += totals.draws[std::size_t(path)];
  const std::uint64_t dropped = totals.draws[std::size_t(Path::InvalidProgram)] +
                                totals.draws[std::size_t(Path::HostRefused)];
  json.key("draws").beginObject();
  json.key("host_glsl").value(totals.draws[std::size_t(Path::HostGlsl)]);
  json.key("rasterizer").value(totals.draws[std::size_t(Path::Rasterizer)]);
  json.key("host_assembly").value(totals.draws[std::size_t(Path::HostAssembly)]);
  json.key("host_untouched").value(untouched);
  json.key("recorded").value(totals.draws[std::size_t(Path::Recorded)]);
  json.key("dropped").value(dropped);
  json.key("reasons").beginObject();
  for (int i = 0; i < kPathCount; ++i)
    if (isFallback(Path(i)) && totals.draws[std::size_t(i)] != 0)
      json.key(pathName(Path(i))).value(totals.draws[std::size_t(i)]);
  json.endObject().endObject();
}

void writeFeedback(JsonWriter &json, const Totals &totals) {
  std::uint64_t copies = 0, pixels = 0;
  for (const auto &kind : totals.copies) {
    copies += kind.copies;
    pixels += kind.pixels;
  }
  json.key("feedback").beginObject();
  json.key("copies").value(copies);
  json.key("pixels").value(pixels);
  // Four bytes a pixel: the format of the copy is the host's own business.
  json.key("bytes").value(pixels * 4);
  json.key("read_buffer_calls").value(totals.readBuffers);
  json.key("kinds").beginObject();
  for (int i = 0; i < swrast::kCopyKindCount; ++i)
    json.key(swrast::copyKindName(swrast::CopyKind(i))).value(totals.copies[std::size_t(i)].copies);
  json.endObject().endObject();
}

/// A file that another process replaced since this one began holds figures of that process.
bool writtenByOther(const char *path, const timespec &began) {
  struct stat info {};
  if (lstat(path, &info) != 0)
    return false;
  return info.st_mtim.tv_sec > began.tv_sec ||
         (info.st_mtim.tv_sec == began.tv_sec && info.st_mtim.tv_nsec > began.tv_nsec);
}

} // namespace

void noteContextCreated(Context &context) {
  Registry &r = registry();
  const std::lock_guard lock(r.mutex);
  context.serial = r.nextSerial++;
  if (!wanted())
    return;
  static bool s_registered = false;
  if (!s_registered)
    s_registered = std::atexit(writeStatistics) == 0;
  ContextRow row;
  row.serial = context.serial;
  row.provider = context.provider;
  row.live = &context;
  r.contexts.push_back(row);
}

void noteContextDestroyed(const Context &context) {
  if (!wanted())
    return;
  Registry &r = registry();
  const std::lock_guard lock(r.mutex);
  r.gone.add(context);
  for (ContextRow &row : r.contexts) {
    if (row.live != &context)
      continue;
    row.live = nullptr;
    row.offered = context.offered;
    row.obstacle = context.caps.obstacle();
    row.numerics = context.numerics;
  }
}

void noteLoadedProgram(const Context &context, const ProgramObject &object, std::string_view text,
                       const fp::CheckResult &result) {
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
  (result.ok() ? row.warning : row.error) = context.errorString;
  addProgram(std::move(row));
}

void noteFragmentShader(const Context &context, const ProgramObject &object,
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
  addProgram(std::move(row));
}

std::string statisticsJson() {
  Registry &r = registry();
  const std::lock_guard lock(r.mutex);
  Totals totals = r.gone;
  JsonWriter json;
  json.beginObject();
  json.key("schema").value(kStatisticsSchema);
  json.key("process").value(std::int64_t(getpid()));
  json.key("profile").value(settings().profile);
  json.key("numerics").value(nameOf(activeNumerics()));
  json.key("identity").value(settings().identityOfProfile ? "profile" : "host");
  json.key("contexts").beginArray();
  for (const ContextRow &row : r.contexts) {
    if (row.live)
      totals.add(*row.live);
    json.beginObject();
    json.key("id").value(row.serial);
    json.key("provider").value(providerName(row.provider));
    json.key("offered").value(row.live ? row.live->offered : row.offered);
    const char *const obstacle = row.live ? row.live->caps.obstacle() : row.obstacle;
    if (obstacle)
      json.key("obstacle").value(obstacle);
    json.key("numerics").value(nameOf(row.live ? row.live->numerics : row.numerics));
    json.key("destroyed").value(row.live == nullptr);
    json.endObject();
  }
  json.endArray();
  json.key("programs").beginArray();
  for (const ProgramRow &row : r.programs)
    writeProgram(json, row);
  json.endArray();
  json.key("programs_not_listed").value(r.programsNotListed);
  const ProgramCacheCounters cache = programCacheCounters();
  json.key("program_cache").beginObject();
  json.key("hits").value(cache.hits);
  json.key("misses").value(cache.misses);
  json.key("stored").value(cache.stored);
  json.endObject();
  writeDraws(json, totals);
  writeFeedback(json, totals);
  json.key("software");
  software::write(json, totals.software);
  json.key("frames").value(totals.frames);
  json.endObject();
  return json.take();
}

void writeStatistics() {
  if (!wanted())
    return;
  const Registry &r = registry();
  const std::string &pattern = settings().statsPath;
  std::string path = expandPid(pattern);
  const bool named = pattern.find("%p") != std::string::npos;
  static bool s_written = false; // our own earlier file may be replaced
  if (!named && (getpid() != r.process || (!s_written && writtenByOther(path.c_str(), r.began))))
    path += "." + std::to_string(getpid());
  if (replacePrivateFile(path, statisticsJson()))
    s_written = true;
  else
    logWarn("state", "cannot write statistics to %s: %s", path.c_str(), std::strerror(errno));
}

} // namespace arbiter::state
