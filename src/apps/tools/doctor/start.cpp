#include <filesystem>
#include <optional>

#include "apps/tools/doctor/elf_file.h"
#include "apps/tools/doctor/finding.h"
#include "apps/tools/input.h"

namespace arbiter::tools::doctor {

Examination examineStart(const CommandFile &command, const Surroundings &surroundings) {
  Examination examination;
  if (command.found.empty() || !command.problem.empty())
    return examination; // the kernel reports the problem
  if (examineSandbox(examination, command, surroundings))
    return examination;
  Surroundings there = surroundings;
  std::string file = command.path;
  if (!command.interpreter.empty()) {
    if (!examineInterpreter(examination, command))
      return examination;
    file = findCommand({interpreterOf(command)}).path;
  } else if (defaults::isSystemLoader(std::filesystem::path(command.found).filename().native())) {
    const std::optional<GivenToLoader> given = givenToLoader(command);
    if (!given)
      return examination; // the loader itself says that it has no program
    file = given->program.path;
    there.byLoader = true;
  }
  if (const std::optional<ElfFile> elf = readElf(file); elf && elf->executable)
    examineHeader(examination, file, *elf, there);
  return examination;
}

void sayWhatIsInTheWay(const std::vector<std::string> &command, const LayerFiles &files) {
  const Examination examination = examineStart(findCommand(command), surroundingsOf(files));
  for (const Finding &each : examination.findings)
    complain(each.file + ": " + each.what + " " + each.remedy);
}

} // namespace arbiter::tools::doctor
