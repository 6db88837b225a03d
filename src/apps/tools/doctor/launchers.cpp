// Examines launchers of other programs: Wine, and game managers.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <elf.h>
#include <filesystem>
#include <memory>
#include <optional>

#include "apps/tools/doctor/finding.h"
#include "util/defaults/program.h"

namespace arbiter::tools::doctor {

namespace {

namespace fs = std::filesystem;

/// A game manager, and its setting for a game's command line.
struct Manager {
  std::string_view command, name, setting, value;
};
constexpr Manager kManagers[] = {
    {"steam", "Steam", "Properties, Launch Options", "arbiter run -- %command%"},
    {"lutris", "Lutris", "Configure, System options, Command prefix", "arbiter run --"},
    {"heroic", "Heroic", "Settings, Advanced, Wrapper command", "arbiter run --"},
};

struct FileCloser {
  void operator()(FILE *file) const { std::fclose(file); }
};

/// Returns the width of a Windows program from its PE header (PE format, COFF File Header,
/// Machine). Returns nothing for processors on which the layer does not run.
std::optional<int> bitsOfWindowsProgram(const std::string &path) {
  const std::unique_ptr<FILE, FileCloser> file(std::fopen(path.c_str(), "rbe"));
  constexpr long kHeaderOffset = 0x3C;
  std::array<unsigned char, 4> offset{};
  std::array<unsigned char, 6> header{}; // "PE\0\0", then Machine
  if (!file || std::fseek(file.get(), kHeaderOffset, SEEK_SET) != 0 ||
      std::fread(offset.data(), 1, offset.size(), file.get()) != offset.size())
    return std::nullopt;
  const std::uint32_t at = std::uint32_t(offset[0]) | std::uint32_t(offset[1]) << 8 |
                           std::uint32_t(offset[2]) << 16 | std::uint32_t(offset[3]) << 24;
  if (std::fseek(file.get(), long(at), SEEK_SET) != 0 ||
      std::fread(header.data(), 1, header.size(), file.get()) != header.size() ||
      std::memcmp(header.data(), "PE\0\0", 4) != 0)
    return std::nullopt;
  switch (header[4] | header[5] << 8) {
  case 0x014C: // I386
    return 32;
  case 0x8664: // AMD64
    return 64;
  default:
    return std::nullopt;
  }
}

void examineWine(Examination &examination, const CommandFile &command,
                 const Surroundings &surroundings) {
  const std::string program = defaults::programOf(factsOf(command)).windowsPath;
  const std::optional<int> bits = bitsOfWindowsProgram(program);
  if (!bits) {
    examination.add({"wine", Level::Possible, command.found,
                     "Wine runs a program for Windows, whose width its command line does not tell.",
                     runIt(surroundings) + "."});
    return;
  }
  examination.files.push_back(program);
  const std::string width = std::to_string(*bits) + "-bit";
  if (surroundings.layer.empty() ||
      layerServes(surroundings.layers, *bits, *bits == 32 ? EM_386 : EM_X86_64))
    examination.add(
        {"wine", Level::Note, program, "Wine runs this " + width + " program for Windows.", {}});
  else
    examination.add({"wine", Level::Possible, program,
                     "It is a " + width + " program for Windows. Wine draws it by " + width +
                         " libraries, unless it was built to draw all by those of 64 bits, and the "
                         "layer for " +
                         width + " is not here.",
                     *bits == 32 ? kRemedyOf32Bits : "Install or build the layer for x86-64."});
}

} // namespace

bool examineLauncher(Examination &examination, const CommandFile &command,
                     const Surroundings &surroundings) {
  const std::string name = fs::path(command.found).filename();
  if (defaults::isWine(name)) {
    examineWine(examination, command, surroundings);
    return true;
  }
  for (const Manager &manager : kManagers)
    if (name == manager.command) {
      const std::string title(manager.name);
      examination.add({"game_launcher", Level::Possible, command.found,
                       title + " starts games itself, often from a process that is there already: "
                               "the layer goes with them only where it is set for each.",
                       "In " + title + " set for the game: " + std::string(manager.setting) +
                           ": `" + std::string(manager.value) + "`."});
      return true;
    }
  return false;
}

} // namespace arbiter::tools::doctor
