#include <cstdio>

#include "tools/commands.h"
#include "tools/input.h"
#include "tools/launch.h"

namespace arbiter::tools {

namespace {

/// For a POSIX shell: 'text' with each ' written '\''.
std::string shellQuoted(const std::string &text) {
  std::string quoted = "'";
  for (const char c : text)
    quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

} // namespace

int run(const RunArguments &arguments) {
  const auto files = findLayer(arguments.layer.library);
  if (!files) {
    complain(files.error().message);
    return kExitUsage;
  }
  const auto environment = layerEnvironment(files.value(), arguments.layer);
  if (!environment) {
    complain(environment.error().message);
    return kExitUsage;
  }
  if (arguments.printEnvironment) {
    if (!arguments.command.empty()) {
      complain(arguments.command[0] + " has no effect with --print-environment");
      return kExitUsage;
    }
    for (const Assignment &assignment : environment.value())
      std::printf("export %s=%s\n", assignment.name.c_str(), shellQuoted(assignment.value).c_str());
    return kExitOk;
  }
  return execute(environment.value(), arguments.command);
}

} // namespace arbiter::tools
