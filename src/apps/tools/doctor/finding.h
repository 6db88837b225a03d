#pragma once
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "apps/tools/command_file.h"
#include "apps/tools/launch/launch.h"

/// Collects obstacles between a program and the layer.
namespace arbiter::tools::doctor {

/// True if \p name begins with one of the words.
template <std::size_t N>
[[nodiscard]] bool beginsWithOne(std::string_view name, const std::string_view (&words)[N]) {
  return std::any_of(std::begin(words), std::end(words),
                     [&](std::string_view word) { return name.starts_with(word); });
}

enum class Level {
  Obstacle, ///< the layer does not reach the program, or has no effect on it
  Possible, ///< a possible obstacle; running the program shows it
  Note,     ///< information, no obstacle
};

struct Finding {
  std::string id; ///< a stable identifier: "static", "set_user_id"
  Level level = Level::Note;
  std::string file;   ///< the file concerned
  std::string what;   ///< a sentence
  std::string remedy; ///< a sentence; empty: no remedy exists
};

struct ElfFile;

/// The result of examining a command.
struct Examination {
  std::vector<std::string> files; ///< the examined files: the command's, then those that it starts
  std::vector<Finding> findings;

  void add(Finding finding) { findings.push_back(std::move(finding)); }
  [[nodiscard]] bool has(const std::string &id) const {
    for (const Finding &each : findings)
      if (each.id == id)
        return true;
    return false;
  }
};

/// The examiner's data about the layer and the system.
struct Surroundings {
  std::string layer;       ///< the layer's library; empty: not found
  std::string layers;      ///< LayerFiles::preloads
  std::string root;        ///< root of the examined system; empty: this system
  std::string look;        ///< the command line that looks at a run of the command
  bool byLoader = false;   ///< the C library's loader is given the program, not the kernel
  std::string libraryPath; ///< the loader's --library-path; empty: LD_LIBRARY_PATH holds
};
[[nodiscard]] inline Surroundings surroundingsOf(const LayerFiles &files) {
  Surroundings surroundings;
  surroundings.layer = files.preload;
  surroundings.layers = files.preloads;
  return surroundings;
}

/// Returns "Run it: `arbiter doctor --run -- ./game`", the remedy if only a run can tell.
[[nodiscard]] inline std::string runIt(const Surroundings &surroundings,
                                       std::string_view how = "Run it") {
  return std::string(how) + ": `" + surroundings.look + "`";
}

/// The remedy if the 32-bit layer is missing. Its packages come from where the installed ones do:
/// no archive has them.
inline constexpr const char *kRemedyOf32Bits =
    "Install the layer for i386 beside it. First `sudo dpkg --add-architecture i386 && sudo apt "
    "update`. Its packages have the version of those that are installed: `sudo apt install "
    "./libglx-arbiter0_*_i386.deb ./libarbiter-jit0_*_i386.deb`. Who has none makes them from "
    "Arbiter's sources: `./dev package i386` there writes them into out/packages.";

/// The id of the finding that the X server draws the program's contexts.
inline constexpr const char *kIndirect = "indirect";
inline constexpr const char *kDirectRemedy =
    "Unset LIBGL_ALWAYS_INDIRECT, and show it on a display of this machine (ssh -X and its like "
    "make contexts indirect, too).";

/// Examines the command's file, the file that a script starts, and their libraries. Runs nothing.
[[nodiscard]] Examination examine(const CommandFile &command, const Surroundings &surroundings);

/// Examines the loader that an ELF file names (PT_INTERP). The kernel says "No such file" of the
/// program if that is missing (interpreter.cpp).
void examineLoader(Examination &examination, const std::string &path, const ElfFile &elf,
                   const Surroundings &surroundings);
/// Examines the interpreter that a script's first line names.
/// \returns true if it is there
bool examineInterpreter(Examination &examination, const CommandFile &command);
/// Returns the program that runs a script. `env` is replaced by the program that it looks up.
/// \param command a script's
[[nodiscard]] std::string interpreterOf(const CommandFile &command);

/// Adds that no display is named, which a program that opens a window needs (display.cpp).
/// \param command the command's words
void examineDisplay(Examination &examination, const std::vector<std::string> &command);
/// The id of that finding.
inline constexpr const char *kNoDisplay = "no_display";

/// Examines launchers of other programs, such as Wine and Steam (launchers.cpp). True if the
/// command is one.
bool examineLauncher(Examination &examination, const CommandFile &command,
                     const Surroundings &surroundings);

/// Examines the file that a command starts for obstacles that no run can disprove. Recognizes
/// Flatpak and Snap by name, and other programs by their rights and header (start.cpp). Runs
/// nothing.
[[nodiscard]] Examination examineStart(const CommandFile &command,
                                       const Surroundings &surroundings);
/// Prints the obstacles on standard error, one per line.
void sayWhatIsInTheWay(const std::vector<std::string> &command, const LayerFiles &files);

/// Examines `flatpak run` and /snap/bin/NAME, which is a link to snap.
/// \returns true if the command is one of them
bool examineSandbox(Examination &examination, const CommandFile &command,
                    const Surroundings &surroundings);

/// True if the layer has a library for processes of that width and machine (EM_386, ...).
/// \param layers the libraries' path, which may contain $LIB
[[nodiscard]] bool layerServes(const std::string &layers, int bits, int machine);

/// Examines the properties by which kernel and loader treat a program: static linking, rights,
/// width (examine_program.cpp).
/// \returns true if a library can be loaded into the program
bool examineHeader(Examination &examination, const std::string &path, const ElfFile &elf,
                   const Surroundings &surroundings);
/// Examines a program's own file: its header, and the libraries and functions that it uses
/// (examine_program.cpp).
void examineProgram(Examination &examination, const std::string &path,
                    const Surroundings &surroundings);

/// A script's effects on processes (script.cpp).
struct Script {
  std::string starts;         ///< the file that it starts; empty: unknown
  bool clearsPreload = false; ///< LD_PRELOAD is unset or replaced, or the environment is cleared
  bool libraryPath = false;   ///< LD_LIBRARY_PATH is set
  std::string sandbox;        ///< the sandbox that it starts: "flatpak", "snap"
  std::string application;    ///< the application in the sandbox
};
[[nodiscard]] Script readScript(const std::string &path);

/// Returns the application that `flatpak run ...` or `snap run ...` starts; empty: none is named.
[[nodiscard]] std::string sandboxedApplication(const std::vector<std::string> &words);

/// Runs the command under the layer and adds the layer's reports about its processes
/// (run_command.cpp). Removes findings that the run disproves.
struct RunSettings {
  std::string library; ///< the layer's; empty: found as for `arbiter run`
  double seconds = 5;
};
void runAndLook(Examination &examination, const CommandFile &command, const RunSettings &settings);

/// Examines the host's GL in a separate process (host.cpp). A version that is too old is an
/// obstacle.
void examineHost(Examination &examination);

} // namespace arbiter::tools::doctor
