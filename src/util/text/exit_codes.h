#pragma once
#include <initializer_list>
#include <string>

/// The exit codes of all commands. A code means one thing, whichever verb ends with it. The help of
/// each verb, the manual pages and the list of the interface take them from here.
namespace arbiter {

enum ExitCode : int {
  kExitOk = 0,
  kExitUsage = 1,
  kExitInvalid = 2,
  kExitOverNative = 3,
  kExitNoGl = 4,
  kExitDiffers = 5,
  kExitInternal = 6,
  kExitObstacle = 7,
  kExitStopped = 8,
  kExitWrapper = 125, ///< as of `env` and `timeout`, so that other codes are COMMAND's
  kExitNotExecutable = 126,
  kExitNoCommand = 127,
};

struct ExitCodeRow {
  ExitCode code;
  const char *meaning;
};
inline constexpr ExitCodeRow kExitCodes[] = {
    {kExitOk, "it was done, and nothing is wrong"},
    {kExitUsage, "it cannot be done as asked: the usage is wrong, or what is named cannot be "
                 "found, read or written"},
    {kExitInvalid, "a program, or a file of settings, is not valid"},
    {kExitOverNative, "a program is valid, but over the card's native limits"},
    {kExitNoGl, "there is no GL that can draw"},
    {kExitDiffers, "a comparison found a difference"},
    {kExitInternal, "a fault of Arbiter's own"},
    {kExitObstacle, "something is in the layer's way"},
    {kExitStopped, "--break stopped at a row"},
    {kExitWrapper, "Arbiter cannot start COMMAND, or cannot write what it makes of it"},
    {kExitNotExecutable, "COMMAND cannot be executed"},
    {kExitNoCommand, "there is no such COMMAND"},
};

/// Returns "0 it was done; 1 ..." for the help of a verb that ends with these codes.
[[nodiscard]] inline std::string meaningsOf(std::initializer_list<ExitCode> codes) {
  std::string text;
  for (const ExitCodeRow &row : kExitCodes)
    for (const ExitCode code : codes)
      if (code == row.code)
        text += (text.empty() ? "" : "; ") + std::to_string(code) + " " + row.meaning;
  return text;
}

} // namespace arbiter
