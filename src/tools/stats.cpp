#include <cstdio>
#include <filesystem>

#include "tools/commands.h"
#include "tools/input.h"
#include "util/json.h"
#include "util/record/live_record.h"

namespace arbiter::tools {

int stats(const StatsArguments &arguments) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(arguments.file, error);
  if (error || !std::filesystem::is_directory(absolute.parent_path(), error)) {
    complain(arguments.file + ": no such folder");
    return kExitUsage;
  }
  const int made = completeRecords(absolute.lexically_normal());
  if (made == 0) {
    complain("no process that was killed left a record of " + arguments.file);
    return kExitUsage;
  }
  if (arguments.json) {
    JsonWriter json;
    json.beginObject().key("schema").value(1).key("file").value(arguments.file);
    std::fputs(json.key("made").value(made).endObject().take().c_str(), stdout);
  } else {
    std::printf("%d\n", made);
  }
  return kExitOk;
}

} // namespace arbiter::tools
