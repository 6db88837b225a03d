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
  std::string layer;  ///< the layer's library; empty: not found
  std::string layers; ///< LayerFiles::preloads
  std::string root;   ///< root of the examined system; empty: this system
};
[[nodiscard]] inline Surroundings surroundingsOf(const LayerFiles &files) {
  return {.layer = files.preload, .layers = files.preloads, .root = {}};
}

/// The remedy if the 32-bit layer is missing.
inline constexpr const char *kRemedyOf32Bits =
    "Install the layer for i386 beside it (libglx-arbiter0:i386 and libarbiter-jit0:i386). "
    "Allow such packages: `sudo dpkg --add-architecture i386 && sudo apt update`. "
    "Make them in Arbiter's source tree: `./dev package i386`. "
    "Install them: `sudo apt install ./out/packages/*_i386.deb`.";

/// The id of the finding that the X server draws the program's contexts.
inline constexpr const char *kIndirect = "indirect";
inline constexpr const char *kDirectRemedy =
    "Unset LIBGL_ALWAYS_INDIRECT, and show it on a display of this machine (ssh -X and its like "
    "make contexts indirect, too).";

/// Examines the command's file, the file that a script starts, and their libraries. Runs nothing.
[[nodiscard]] Examination examine(const CommandFile &command, const Surroundings &surroundings);

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

struct ElfFile;
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
