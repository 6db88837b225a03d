#pragma once
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "tools/command_file.h"
#include "tools/launch/launch.h"

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
  std::string layer;  ///< the layer's library; empty: none was found
  std::string layers; ///< LayerFiles::preloads
  std::string root;   ///< of the system that is looked at; empty: this one
};
[[nodiscard]] inline Surroundings surroundingsOf(const LayerFiles &files) {
  return {.layer = files.preload, .layers = files.preloads, .root = {}};
}

/// What to do where the layer of 32 bits is missing.
inline constexpr const char *kRemedyOf32Bits =
    "Install the layer for i386 beside it (libglx-arbiter0:i386 and libarbiter-jit0:i386): "
    "sudo dpkg --add-architecture i386 && sudo apt update; ./dev package i386 makes the packages; "
    "sudo apt install ./out/packages/*_i386.deb.";

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

/// What the file that a command starts tells at once, of what no run can disprove: Flatpak and Snap
/// by their names, the rest by its rights and its header (start.cpp). Runs nothing.
[[nodiscard]] Examination examineStart(const CommandFile &command,
                                       const Surroundings &surroundings);
/// Says it on standard error, a line each.
void sayWhatIsInTheWay(const std::vector<std::string> &command, const LayerFiles &files);

/// `flatpak run`, /snap/bin/NAME, which is a link to snap. \returns it is one
bool examineSandbox(Examination &examination, const CommandFile &command,
                    const Surroundings &surroundings);

/// True if there is a library of the layer for processes of that width and machine (EM_386, ...).
/// \param layers the libraries' path, which may have $LIB in it
[[nodiscard]] bool layerServes(const std::string &layers, int bits, int machine);

struct ElfFile;
/// Looks at what the kernel and the loader decide a program by: a static one, its rights, its width
/// (examine_program.cpp). \returns something can be loaded into it
bool examineHeader(Examination &examination, const std::string &path, const ElfFile &elf,
                   const Surroundings &surroundings);
/// Looks at a program's own file: its header, and what it needs and uses (examine_program.cpp).
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
