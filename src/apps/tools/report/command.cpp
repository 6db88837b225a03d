
#include "apps/tools/commands.h"
#include "apps/tools/input.h"
#include "apps/tools/report/json.h"
#include "apps/tools/report/page.h"
#include "util/flags.h"

namespace arbiter::tools {

namespace {

/// Returns the requested profile. Without one it is the capture's profile, so that the report
/// matches what the application could query, or else the user's.
std::string profileName(const ReportArguments &arguments) {
  if (!arguments.profile.empty())
    return arguments.profile;
  if (arguments.operands.size() == 1 && isCapture(arguments.operands[0]))
    return readCapture(arguments.operands[0]).profile;
  return settings().profile;
}

bool write(const std::string &name, const std::string &text) {
  const std::string fault = writeOutput(name, text);
  if (!fault.empty())
    complain(fault);
  return fault.empty();
}

} // namespace

int report(const ReportArguments &arguments) {
  if (arguments.json && arguments.output == "-") {
    complain("the page and the JSON cannot both go to standard output");
    return kExitUsage;
  }
  for (const std::string &operand : arguments.operands)
    if (arguments.output != "-" && isSameFile(arguments.output, operand)) {
      complain(arguments.output + ": is one of the programs");
      return kExitUsage;
    }
  const auto profile = fp::hw::loadProfile(profileName(arguments));
  if (!profile) {
    complain(profile.error().message);
    return kExitUsage;
  }
  const ProgramSet set = readPrograms(arguments.operands, profile.value());
  for (const std::string &fault : set.faults)
    complain(fault);
  if (set.programs.empty())
    return kExitUsage;
  bool good = write(arguments.output, reportPage(set));
  if (arguments.json)
    good = write("-", reportJson(set)) && good;
  if (good)
    complain("programs: " + std::to_string(set.programs.size()) +
             ", fit: " + std::to_string(set.count(Verdict::Fits)) +
             ", do not fit: " + std::to_string(set.count(Verdict::Over)) + ", invalid: " +
             std::to_string(set.count(Verdict::Invalid)) + "; see " + arguments.output);
  return good && set.faults.empty() ? kExitOk : kExitUsage;
}

} // namespace arbiter::tools
