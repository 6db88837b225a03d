#include <GL/arbiter.h>
#include <cstdio>
#include <filesystem>
#include <set>

#include "apps/tools/commands.h"
#include "apps/tools/input.h"
#include "apps/tools/stats/sum.h"
#include "util/json.h"
#include "util/record/live_record.h"

namespace arbiter::tools {

namespace {

using stats::Figures;

struct Named {
  std::string path;
  stats::Report report;
};

/// The reports of one FILE.
struct OfFile {
  std::string file;
  int made = 0;       ///< reports of killed processes
  bool found = false; ///< there are files, though they may be no reports
  std::vector<Named> reports;
};

/// Completes the statistics of one FILE, and reads all that are there.
/// \param seen paths that an earlier FILE stands for too
/// \returns false after a complaint that there is no such folder
bool look(OfFile &of, std::set<std::string> &seen) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(of.file, error);
  if (error || !std::filesystem::is_directory(absolute.parent_path(), error)) {
    complain(of.file + ": no such folder");
    return false;
  }
  const std::filesystem::path pattern = absolute.lexically_normal();
  of.made = completeRecords(pattern);
  for (const std::string &path : reportsOf(pattern)) {
    of.found = true;
    if (!seen.insert(path).second)
      continue;
    if (auto report = stats::readReport(path))
      of.reports.push_back({path, std::move(report.value())});
    else
      complain(report.error());
  }
  return true;
}

void print(const std::vector<OfFile> &all, int made, const Figures &sum) {
  if (made != 0)
    std::printf("made of what killed processes left: %d\n", made);
  for (const OfFile &of : all)
    for (const auto &[path, report] : of.reports)
      std::printf("%s%s: %s\n", std::filesystem::path(path).filename().c_str(),
                  report.program.empty() ? "" : (" (" + report.program + ")").c_str(),
                  report.figures.line().c_str());
  if (sum.files > 1)
    std::printf("sum of %llu: %s\n", static_cast<unsigned long long>(sum.files),
                sum.line().c_str());
  if (const std::string reasons = sum.reasonsLine(); !reasons.empty())
    std::printf("given to the host: %s\n", reasons.c_str());
}

void printJson(const std::vector<OfFile> &all, int made, const Figures &sum) {
  JsonWriter json;
  json.beginObject()
      .key("schema")
      .value(ARBITER_STATS_SUM_SCHEMA)
      .key("file")
      .value(all.front().file);
  json.key("made").value(made).key("files").beginArray();
  for (const OfFile &of : all) {
    json.beginObject().key("file").value(of.file).key("made").value(of.made);
    json.key("reports").beginArray();
    for (const auto &[path, report] : of.reports) {
      json.beginObject().key("path").value(path).key("program").value(report.program);
      report.figures.write(json);
      json.endObject();
    }
    json.endArray().endObject();
  }
  json.endArray().key("sum").beginObject().key("files").value(sum.files);
  sum.write(json);
  std::fputs(json.endObject().endObject().take().c_str(), stdout);
}

} // namespace

int sumStatistics(const StatsArguments &arguments) {
  std::vector<OfFile> all;
  std::set<std::string> seen;
  Figures sum;
  int made = 0;
  for (const std::string &file : arguments.files) {
    all.push_back({file, 0, false, {}});
    if (!look(all.back(), seen))
      return kExitUsage;
    made += all.back().made;
    for (const Named &each : all.back().reports)
      sum.add(each.report.figures);
  }
  for (const OfFile &of : all)
    if (!of.found)
      complain("no statistics in " + of.file +
               ": a process writes them when it ends, and none that was killed left a record");
  if (sum.files == 0)
    return kExitUsage;
  if (arguments.json)
    printJson(all, made, sum);
  else
    print(all, made, sum);
  return kExitOk;
}

} // namespace arbiter::tools
