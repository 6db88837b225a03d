#include <GL/arbiter.h>
#include <cstdio>
#include <cstdlib>

#include "apps/tools/commands.h"
#include "apps/tools/doctor/finding.h"
#include "apps/tools/input.h"
#include "apps/tools/launch/in_layer.h"
#include "apps/tools/launch/shell_text.h"
#include "apps/tools/launch/supervise.h"
#include "util/record/live_record.h"

namespace arbiter::tools {

namespace {

/// Returns the file pattern for statistics, with %p for process numbers; empty: no statistics.
std::string recordPattern(const std::vector<Assignment> &environment) {
  for (const Assignment &assignment : environment)
    if (assignment.name == ARBITER_ENV_STATS)
      return assignment.value;
  const char *const inherited = std::getenv(ARBITER_ENV_STATS);
  return inherited ? inherited : "";
}

} // namespace

int run(const RunArguments &arguments) {
  const auto launch = layerLaunch(arguments.layer);
  if (!launch) {
    complain(launch.error().message);
    return kExitWrapper;
  }
  const std::vector<Assignment> &environment = launch.value().environment;
  if (arguments.printEnvironment) {
    if (!arguments.command.empty()) {
      complain(arguments.command[0] + " has no effect with --print-environment");
      return kExitWrapper;
    }
    for (const Assignment &assignment : environment)
      std::printf("export %s=%s\n", assignment.name.c_str(), shellQuoted(assignment.value).c_str());
    return kExitOk;
  }
  doctor::sayWhatIsInTheWay(arguments.command, launch.value().files);
  const std::string records = recordPattern(environment);
  if (records.empty())
    return execute(environment, arguments.command);
  // A killed process cannot complete its own statistics, so that this process outlives it.
  const int status = supervise(environment, arguments.command,
                               [&] { static_cast<void>(completeRecords(records)); });
  if (status < 0)
    return kExitWrapper;
  endAs(status);
}

} // namespace arbiter::tools
