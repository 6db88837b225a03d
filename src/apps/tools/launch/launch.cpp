#include "apps/tools/launch/launch.h"

#include <GL/arbiter.h>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include "apps/tools/command_file.h"
#include "apps/tools/input.h"
#include "apps/tools/launch/preload_link.h"
#include "control/address.h"
#include "fp_compiler/hw/profile.h"
#include "util/flags.h"
#include "util/loader_path.h"
#include "util/text/exit_codes.h"

namespace arbiter::tools {

namespace {

namespace fs = std::filesystem;

struct Place {
  fs::path preload;
  /// Contains one library per process width, in folders with the names that the loader inserts for
  /// $LIB.
  fs::path everyWidth;
  /// Folders that contain only the layer's libOSMesa.so.8. An installation's library folder may
  /// also contain the host's.
  std::vector<fs::path> osmesaFolders;
};

Place placeIn(const fs::path &folder) {
  return {folder / ARBITER_PRELOAD_LIBRARY,
          folder / "preload",
          {folder / "osmesa", folder / "arbiter" / "osmesa"}};
}

/// Returns the places to search, the build tree's before the installation's.
std::vector<Place> places() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (error)
    return {};
  const fs::path here = self.parent_path();
  const fs::path tree = here.parent_path().parent_path() / "interposer";
  Place inTree = placeIn(tree);
  inTree.osmesaFolders.push_back(tree);
  // ARBITER_LIBDIR_FROM_BIN is relative, so that an installation can be moved as a whole.
  const fs::path installed = (here / ARBITER_LIBDIR_FROM_BIN).lexically_normal();
  return {inTree, placeIn(installed / "arbiter"), placeIn(installed)};
}

LayerFiles filesAt(const Place &place) {
  std::error_code error;
  LayerFiles files;
  files.preload = fs::absolute(place.preload, error).lexically_normal();
  files.preloaded = files.preloads = files.preload;
  for (const fs::path &folder : place.osmesaFolders)
    if (files.osmesaFolder.empty() && fs::exists(folder / "libOSMesa.so.8", error))
      files.osmesaFolder = fs::absolute(folder, error).lexically_normal();
  const std::string_view lib = ARBITER_LOADER_LIB;
  const fs::path folder = fs::absolute(place.everyWidth, error).lexically_normal();
  if (!lib.empty() && !place.everyWidth.empty() &&
      fs::is_regular_file(folder / lib / ARBITER_PRELOAD_LIBRARY, error)) {
    files.preloaded = folder / "$LIB" / ARBITER_PRELOAD_LIBRARY;
    files.preloads = forEveryWidth(files.preload, lib);
    files.osmesaFolder = forEveryWidth(files.osmesaFolder, lib);
  }
  return files;
}

std::string absolutePath(const std::string &path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  return error ? path : absolute.string();
}

/// Returns "first:rest" with the rest from the environment. Adds no trailing colon, which would add
/// the working folder to the search.
std::string prepended(const std::string &first, const char *variable) {
  const char *rest = std::getenv(variable);
  return rest == nullptr || *rest == '\0' ? first : first + ":" + rest;
}

/// Returns the EGL vendor file for the library. A file with the library's path also works for
/// children that lose LD_PRELOAD. In an installation that was moved, only the file with the
/// library's name is right.
std::string icdFile(const std::string &preload) {
  const fs::path folder = fs::path(preload).parent_path() / "arbiter";
  if (const auto byPath = readInput(folder / "10_arbiter.json"))
    for (const std::string &path : {preload, forEveryWidth(preload, ARBITER_LOADER_LIB)})
      if (byPath.value().find('"' + path + '"') != std::string::npos)
        return folder / "10_arbiter.json";
  std::error_code error;
  const fs::path byName = folder / "11_arbiter.json";
  return fs::exists(byName, error) ? byName.string() : std::string();
}

/// Sets a libglvnd selection. Saves the previous value under `saved`, where the layer finds its
/// host.
void select(std::vector<Assignment> &environment, const Assignment &selection, const char *saved) {
  const char *before = std::getenv(selection.name.c_str());
  if (before != nullptr && *before != '\0' && before != selection.value)
    environment.push_back({saved, before});
  environment.push_back(selection);
}

/// Makes the FILE of LEVEL, FILE or LEVEL:FILE absolute; see flags.def.
std::string absoluteLog(const std::string &log) {
  const std::size_t slash = log.find('/');
  if (slash == std::string::npos && log.find(':') == std::string::npos)
    return log;
  const std::size_t colon = log.find(':');
  if (colon == std::string::npos || (slash != std::string::npos && slash < colon))
    return absolutePath(log);
  return log.substr(0, colon + 1) + absolutePath(log.substr(colon + 1));
}

/// Returns warnings about settings that the layer would ignore, and files that it could not write.
/// The layer itself could only report them in its log, or after the application's end.
std::string whyNotFollowed(const std::vector<Assignment> &environment) {
  std::vector<std::string> warnings;
  const Settings parsed = parseSettings(
      [&](const char *name) -> const char * {
        for (const Assignment &assignment : environment)
          if (assignment.name == name)
            return assignment.value.c_str();
        return nullptr;
      },
      warnings);
  if (!warnings.empty())
    return warnings.front().substr(0, warnings.front().rfind("; ignored"));
  if (parsed.control)
    if (const auto folder = control::socketFolder(); !folder)
      return folder.error().message;
  for (const std::string &path : {parsed.statsPath, parsed.logPath})
    if (!path.empty())
      if (std::string fault = whyNotWritable(path); !fault.empty())
        return fault;
  return {};
}

bool isElf(const std::string &path) {
  std::array<char, 4> start = {};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  return start == std::array{'\x7f', 'E', 'L', 'F'};
}

} // namespace

Result<LayerFiles, LaunchError> findLayer(const std::string &library) {
  std::error_code error;
  if (!library.empty()) {
    if (!fs::is_regular_file(library, error))
      return LaunchError{library + ": no such file"};
    Place place = placeIn(fs::path(library).parent_path());
    place.preload = library;
    place.everyWidth.clear(); // the explicit library must be used as it is
    return filesAt(place);
  }
  std::string looked;
  for (const Place &place : places()) {
    if (fs::is_regular_file(place.preload, error))
      return filesAt(place);
    looked += "\n  " + place.preload.string();
  }
  return LaunchError{"the layer is not there; looked for" + looked +
                     "\nbuild it (./dev build), or name it with --library"};
}

Result<std::vector<Assignment>, LaunchError> layerEnvironment(const LayerFiles &found,
                                                              const LayerArguments &arguments) {
  const auto reached = preloadable(found);
  if (!reached)
    return reached.error();
  const LayerFiles &files = reached.value();
  std::vector<Assignment> environment;
  environment.push_back({"LD_PRELOAD", prepended(files.preloaded, "LD_PRELOAD")});
  // The library selects itself when it is loaded. But some programs have libraries that call GL in
  // constructors, which run before a preloaded library's. The variables cover those programs. The
  // previous selection becomes the host.
  select(environment, {"__GLX_VENDOR_LIBRARY_NAME", "arbiter"}, "ARBITER_SAVED_GLX_VENDOR");
  if (const std::string icd = icdFile(files.preload); !icd.empty())
    select(environment, {"__EGL_VENDOR_LIBRARY_FILENAMES", icd}, "ARBITER_SAVED_EGL_VENDORS");
  if (!files.osmesaFolder.empty())
    environment.push_back({"LD_LIBRARY_PATH", prepended(files.osmesaFolder, "LD_LIBRARY_PATH")});
  if (!arguments.profile.empty()) {
    const auto profile = fp::hw::loadProfile(arguments.profile);
    if (!profile)
      return LaunchError{profile.error().message};
    const bool builtin = fp::hw::findBuiltin(arguments.profile) != nullptr;
    environment.push_back(
        {ARBITER_ENV_PROFILE, builtin ? arguments.profile : absolutePath(arguments.profile)});
  }
  if (!arguments.limits.empty())
    environment.push_back({ARBITER_ENV_LIMITS, arguments.limits});
  if (!arguments.numerics.empty())
    environment.push_back({ARBITER_ENV_NUMERICS, arguments.numerics});
  if (!arguments.backend.empty())
    environment.push_back({ARBITER_ENV_BACKEND, arguments.backend});
  if (!arguments.fixedFunction.empty())
    environment.push_back({ARBITER_ENV_FIXED_FUNCTION, arguments.fixedFunction});
  if (!arguments.attributes.empty())
    environment.push_back({ARBITER_ENV_ATTRIBUTES, arguments.attributes});
  if (!arguments.identity.empty())
    environment.push_back({ARBITER_ENV_IDENTITY, arguments.identity});
  if (!arguments.extensionsMaxYear.empty())
    environment.push_back({ARBITER_ENV_EXTENSIONS_MAX_YEAR, arguments.extensionsMaxYear});
  if (!arguments.extensionsMaxLength.empty())
    environment.push_back({ARBITER_ENV_EXTENSIONS_MAX_LENGTH, arguments.extensionsMaxLength});
  std::string extensions;
  for (const std::string &each : arguments.extensions)
    extensions += (extensions.empty() ? "" : ",") + each;
  if (!extensions.empty())
    environment.push_back({ARBITER_ENV_EXTENSIONS, extensions});
  if (!arguments.stats.empty())
    environment.push_back({ARBITER_ENV_STATS, absolutePath(arguments.stats)});
  if (!arguments.capture.empty())
    environment.push_back({ARBITER_ENV_CAPTURE, absolutePath(arguments.capture)});
  if (!arguments.replace.empty()) {
    std::error_code error;
    if (!fs::is_directory(arguments.replace, error))
      return LaunchError{arguments.replace + ": no such folder"};
    environment.push_back({ARBITER_ENV_REPLACE, absolutePath(arguments.replace)});
  }
  if (arguments.control)
    environment.push_back({ARBITER_ENV_CONTROL, "1"});
  if (!arguments.hud.empty())
    environment.push_back({ARBITER_ENV_HUD, arguments.hud == "true" ? "1" : arguments.hud});
  if (!arguments.log.empty())
    environment.push_back({ARBITER_ENV_LOG, absoluteLog(arguments.log)});
  if (!arguments.debug.empty())
    environment.push_back({ARBITER_ENV_DEBUG, arguments.debug});
  if (!arguments.hostVendor.empty())
    environment.push_back({ARBITER_ENV_HOST_VENDOR, arguments.hostVendor});
  if (std::string fault = whyNotFollowed(environment); !fault.empty())
    return LaunchError{std::move(fault)};
  return environment;
}

int execute(const std::vector<Assignment> &environment, const std::vector<std::string> &command) {
  for (const Assignment &assignment : environment)
    ::setenv(assignment.name.c_str(), assignment.value.c_str(), 1);
  std::vector<char *> argv;
  argv.reserve(command.size() + 1);
  for (const std::string &word : command)
    argv.push_back(const_cast<char *>(word.c_str())); // execvp does not write to the words
  argv.push_back(nullptr);
  // execvp() has a shell read what the kernel does not run. A program of another machine, or of 32
  // bits where the kernel has none (ia32_emulation=off), is no script.
  const std::string file = findCommand(command).found;
  if (isElf(file))
    ::execv(file.c_str(), argv.data());
  else
    ::execvp(argv[0], argv.data());
  const int failure = errno;
  complain(
      command[0] + ": " +
      (failure == ENOEXEC ? "this kernel runs no programs of its kind" : std::strerror(failure)));
  return failure == ENOENT ? kExitNoCommand : kExitNotExecutable;
}

} // namespace arbiter::tools
