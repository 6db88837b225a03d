#include "apps/tools/capture_index.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "apps/tools/capture_page.h"
#include "apps/tools/commands.h"
#include "apps/tools/doctor/finding.h"
#include "apps/tools/input.h"
#include "apps/tools/launch/in_layer.h"
#include "apps/tools/launch/supervise.h"
#include "apps/tools/shader_test.h"
#include "util/file.h"

namespace arbiter::tools {

namespace {

namespace fs = std::filesystem;

/// Returns the first unused name of COMMAND.capture, COMMAND.capture-2, COMMAND.capture-3, ...
std::string freeFolder(const std::string &command) {
  const std::string base = fs::path(command).filename().string() + ".capture";
  std::error_code error;
  std::string name = base;
  for (int i = 2; fs::exists(fs::symlink_status(name, error)); ++i)
    name = base + "-" + std::to_string(i);
  return name;
}

/// Creates or checks the folder.
/// \returns an empty string, or why texts cannot be captured there.
std::string prepareFolder(const std::string &folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    if (!fs::create_directory(folder, error))
      return folder + ": " + (error ? error.message() : std::string("exists and is no folder"));
    // Texts and command lines are private to their owner.
    fs::permissions(folder, fs::perms::owner_all, error);
    return {};
  }
  const std::vector<std::string> edited = editedTexts(folder);
  if (!edited.empty())
    return edited[0] + " is edited, and a capture would mistake it for the application's text; "
                       "name another folder with -o";
  for (const auto &entry : fs::directory_iterator(folder, error))
    if (const std::string name = entry.path().filename();
        name.starts_with("process-") && name.ends_with(".json"))
      return folder + " holds a capture; name another folder with -o, or remove it";
  return error ? folder + ": " + error.message() : std::string();
}

/// Writes a file that only its owner can read. Complains and returns false if it cannot.
bool write(const std::string &path, const std::string &text) {
  if (replacePrivateFile(path, text))
    return true;
  complain(path + ": " + std::strerror(errno));
  return false;
}

/// Writes the index of the folder's content.
/// \returns false if a file cannot be written.
bool assemble(const std::string &folder) {
  const CaptureIndex index = readCapture(folder);
  for (const std::string &fault : index.faults)
    complain(fault);
  if (index.programs.empty() && index.processes.empty())
    complain("no process made a GL context that the layer saw (docs/driver/debugging.md)");
  bool good = true;
  std::size_t refused = 0;
  for (const CapturedProgram &program : index.programs) {
    refused += program.error.empty() ? 0 : 1;
    std::string reason;
    const std::string test = shaderTest(program, reason);
    if (!test.empty())
      good = write(folder + "/" + program.file() + ".shader_test", test) && good;
  }
  good = write(folder + "/index.json", indexJson(index)) && good;
  good = write(folder + "/index.html", indexPage(index)) && good;
  for (const std::string &missing : whatIsMissing(index))
    complain("cut short: " + missing);
  // This is printed on standard error too, because standard output is the application's.
  if (good)
    complain("programs: " + std::to_string(index.programs.size()) + ", refused: " +
             std::to_string(refused) + ", processes: " + std::to_string(index.processes.size()) +
             "; see " + folder + "/index.html");
  return good;
}

} // namespace

int capture(const CaptureArguments &arguments) {
  std::error_code error;
  if (arguments.indexOnly) {
    if (fs::is_directory(arguments.folder, error))
      return assemble(arguments.folder) ? kExitOk : kExitWrapper;
    complain(arguments.folder + ": no such folder");
    return kExitWrapper;
  }
  LayerArguments layer = arguments.layer;
  layer.capture = arguments.folder.empty() ? freeFolder(arguments.command[0]) : arguments.folder;
  const auto launch = layerLaunch(layer);
  if (!launch) {
    complain(launch.error().message);
    return kExitWrapper;
  }
  if (const std::string fault = prepareFolder(layer.capture); !fault.empty()) {
    complain(fault);
    return kExitWrapper;
  }
  doctor::sayWhatIsInTheWay(arguments.command, launch.value().files);
  const auto nothing = [] {}; // if this process is killed, the folder stays without an index
  const int status = supervise(launch.value().environment, arguments.command, nothing);
  if (status < 0)
    return kExitWrapper;
  if (fs::remove(layer.capture, error)) // only an empty folder can be removed
    complain("nothing was captured: no process made a GL context that the layer saw");
  else if (!assemble(layer.capture))
    return kExitWrapper;
  endAs(status); // as `run` does
}

} // namespace arbiter::tools
