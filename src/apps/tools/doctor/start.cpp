#include <optional>

#include "apps/tools/doctor/elf_file.h"
#include "apps/tools/doctor/finding.h"
#include "apps/tools/input.h"

namespace arbiter::tools::doctor {

namespace {

/// Returns the file that the kernel starts: the program, or a script's interpreter. `env` is
/// replaced by the program that it looks up.
std::string startedFile(const CommandFile &command) {
  if (command.interpreter.empty())
    return command.path;
  const bool byEnv = command.interpreter.front().ends_with("/env");
  return findCommand({command.interpreter[byEnv && command.interpreter.size() > 1 ? 1 : 0]}).path;
}

} // namespace

Examination examineStart(const CommandFile &command, const Surroundings &surroundings) {
  Examination examination;
  if (command.found.empty() || !command.problem.empty())
    return examination; // the kernel reports the problem
  if (examineSandbox(examination, command, surroundings))
    return examination;
  const std::string file = startedFile(command);
  if (const std::optional<ElfFile> elf = readElf(file); elf && elf->executable)
    examineHeader(examination, file, *elf, surroundings);
  return examination;
}

void sayWhatIsInTheWay(const std::vector<std::string> &command, const LayerFiles &files) {
  const Examination examination = examineStart(findCommand(command), surroundingsOf(files));
  for (const Finding &each : examination.findings)
    complain(each.file + ": " + each.what + " " + each.remedy);
}

} // namespace arbiter::tools::doctor
