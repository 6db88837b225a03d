#include <cstdio>
#include <filesystem>
#include <numeric>

#include "apps/tools/commands.h"
#include "apps/tools/input.h"
#include "util/json.h"
#include "util/record/live_record.h"

namespace arbiter::tools {

namespace {

/// Completes the statistics of one FILE.
/// \returns the number of completed statistics, or below 0 after a complaint
int makeOf(const std::string &file) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(file, error);
  if (error || !std::filesystem::is_directory(absolute.parent_path(), error)) {
    complain(file + ": no such folder");
    return -1;
  }
  return completeRecords(absolute.lexically_normal());
}

void print(const std::vector<std::string> &files, const std::vector<int> &made, int all) {
  JsonWriter json;
  json.beginObject().key("schema").value(1).key("file").value(files.front());
  json.key("made").value(all).key("files").beginArray();
  for (std::size_t i = 0; i < files.size(); ++i)
    json.beginObject().key("file").value(files[i]).key("made").value(made[i]).endObject();
  std::fputs(json.endArray().endObject().take().c_str(), stdout);
}

} // namespace

int stats(const StatsArguments &arguments) {
  std::vector<int> made;
  for (const std::string &file : arguments.files) {
    made.push_back(makeOf(file));
    if (made.back() < 0)
      return kExitUsage;
  }
  const int all = std::accumulate(made.begin(), made.end(), 0);
  if (all == 0) {
    for (const std::string &file : arguments.files)
      complain("no process that was killed left a record of " + file);
    return kExitUsage;
  }
  if (arguments.json)
    print(arguments.files, made, all);
  else
    std::printf("%d\n", all);
  return kExitOk;
}

} // namespace arbiter::tools
