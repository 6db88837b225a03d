// Examines what the kernel runs a file by: the loader of an ELF file, and a script's interpreter.
#include <algorithm>
#include <array>
#include <elf.h>
#include <filesystem>

#include "apps/tools/doctor/elf_file.h"
#include "apps/tools/doctor/finding.h"

namespace arbiter::tools::doctor {

namespace {

namespace fs = std::filesystem;

#if defined(__x86_64__)
constexpr std::uint16_t kOwnMachine = EM_X86_64;
#elif defined(__i386__)
constexpr std::uint16_t kOwnMachine = EM_386;
#elif defined(__aarch64__)
constexpr std::uint16_t kOwnMachine = EM_AARCH64;
#else
constexpr std::uint16_t kOwnMachine = EM_NONE;
#endif

/// Returns Debian's name of a machine, or "".
std::string architectureOf(std::uint16_t machine) {
  switch (machine) {
  case EM_X86_64:
    return "amd64";
  case EM_386:
    return "i386";
  case EM_AARCH64:
    return "arm64";
  case EM_ARM:
    return "armhf";
  default:
    return {};
  }
}

bool isX86(std::uint16_t machine) { return machine == EM_X86_64 || machine == EM_386; }

std::string remedyOf(const std::string &path, const ElfFile &elf) {
  const std::string name = fs::path(elf.interpreter).filename();
  const std::string architecture = architectureOf(elf.machine);
  if (isX86(elf.machine) != isX86(kOwnMachine) || elf.machine == EM_NONE || architecture.empty())
    return "Run it on a machine of that kind, or by an emulator.";
  if (name.starts_with("ld-lsb")) { // the Linux Standard Base's name for the C library's loader
    const std::string real = elf.bits == 32 ? "ld-linux.so.2" : "ld-linux-x86-64.so.2";
    return "It is another name of the C library's loader: `sudo ln -s " + real + " " +
           elf.interpreter + "`.";
  }
  if (name == "ld-linux.so.1")
    return "It is a program of the nineties, for libc 5, which Debian no longer has. Look for "
           "another build of " +
           fs::path(path).filename().string() + ".";
  constexpr std::array<std::string_view, 4> kLoaders = {
      "ld-linux.so.2", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1", "ld-linux-armhf.so.3"};
  if (std::find(kLoaders.begin(), kLoaders.end(), name) == kLoaders.end())
    return "Install what has that file, for " + architecture + ", or look for another build of " +
           fs::path(path).filename().string() + ".";
  const std::string install = "sudo apt install libc6:" + architecture;
  if (elf.machine == kOwnMachine)
    return "Debian's package libc6 has it: `" + install + "`.";
  return "Debian's package libc6 of the foreign architecture " + architecture +
         " has it: `sudo dpkg --add-architecture " + architecture + " && sudo apt update && " +
         install + "`.";
}

} // namespace

void examineLoader(Examination &examination, const std::string &path, const ElfFile &elf,
                   const Surroundings &surroundings) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(surroundings.root + elf.interpreter, error);
  const bool dangles = surroundings.root.empty() && !fs::exists(elf.interpreter, error);
  if (surroundings.byLoader || (fs::exists(status) && !dangles))
    return;
  examination.add({"missing_interpreter", Level::Obstacle, path,
                   "It does not start: it is a " + std::to_string(elf.bits) + "-bit (" +
                       machineName(elf.machine) + ") program, and its loader " + elf.interpreter +
                       " is not on this system.",
                   remedyOf(path, elf)});
}

std::string interpreterOf(const CommandFile &command) {
  const std::vector<std::string> &words = command.interpreter;
  const bool byEnv =
      words.front().ends_with("/env") && words.size() > 1 && !words[1].starts_with("-");
  return words[byEnv ? 1 : 0];
}

bool examineInterpreter(Examination &examination, const CommandFile &command) {
  const std::string interpreter = interpreterOf(command);
  if (!findCommand({interpreter}).found.empty())
    return true;
  examination.add(
      {"missing_interpreter", Level::Obstacle, command.path,
       "It does not start: its first line names " + interpreter + ", which is not on this system.",
       "Install what has it, or change that line."});
  return false;
}

} // namespace arbiter::tools::doctor
