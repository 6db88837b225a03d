#include <filesystem>

#include "apps/tools/doctor/finding.h"
#include "apps/tools/launch/shell_text.h"

namespace arbiter::tools::doctor {

namespace {

namespace fs = std::filesystem;

constexpr int kMaxSteps = 4; // limit for scripts that start scripts

/// Interpreters whose programs load GL at run time, so that the interpreter's file tells nothing.
constexpr std::string_view kInterpreters[] = {"python", "perl", "ruby", "java",
                                              "mono",   "lua",  "node", "pypy"};
constexpr std::string_view kShells[] = {"sh", "bash", "dash", "ksh", "zsh", "busybox"};

bool isShell(const std::string &name) {
  for (const std::string_view word : kShells)
    if (name == word)
      return true;
  return false;
}

/// Returns the remedy for Flatpak: the extension brings the layer into each sandbox. A sandbox
/// cannot share files below /usr, where the package installs the layer.
std::string remedyInFlatpak(const std::string &application, const std::string &layer) {
  const std::string name = application.empty() ? "APPLICATION" : application;
  std::string text = "Install Arbiter's extension for Flatpak (./dev flatpak), then: flatpak run "
                     "--command=/usr/lib/extensions/vulkan/Arbiter/bin/arbiter " +
                     name + " run -- PROGRAM.";
  if (!layer.empty() && !layer.starts_with("/usr/"))
    text += " Or lend the sandbox the layer: flatpak run --filesystem=" +
            fs::path(layer).parent_path().string() + ":ro --env=LD_PRELOAD=" + layer + " " + name +
            ".";
  return text;
}

void addSandbox(Examination &examination, const std::string &kind, const std::string &application,
                const std::string &file, const Surroundings &surroundings) {
  const std::string name = application.empty() ? "an application" : application;
  if (kind == "flatpak")
    examination.add({"flatpak", Level::Obstacle, file,
                     "Flatpak runs " + name +
                         " in a sandbox with libraries of its own, where the layer's file is not.",
                     remedyInFlatpak(application, surroundings.layer)});
  else
    examination.add({"snap", Level::Obstacle, file,
                     "Snap runs " + name +
                         " in a sandbox with libraries of its own, and takes LD_PRELOAD away.",
                     "Run a build of it that is installed outside of Snap."});
}

} // namespace

bool examineSandbox(Examination &examination, const CommandFile &command,
                    const Surroundings &surroundings) {
  const std::string called = fs::path(command.found).filename();
  const std::string real = fs::path(command.path).filename();
  if (real != "flatpak" && real != "snap")
    return false;
  const std::string application = called == real ? sandboxedApplication(command.words) : called;
  addSandbox(examination, real, application, command.found, surroundings);
  return true;
}

namespace {

void examineFile(Examination &examination, const CommandFile &command,
                 const Surroundings &surroundings, int step);

void examineScript(Examination &examination, const CommandFile &command,
                   const Surroundings &surroundings, int step) {
  if (!examineInterpreter(examination, command))
    return;
  const std::string interpreter = fs::path(interpreterOf(command)).filename();
  if (!isShell(interpreter)) {
    examination.add({"interpreter", Level::Possible, command.path,
                     "It is a program for " + interpreter +
                         ", which loads GL by itself, if at all: its file does not tell.",
                     runIt(surroundings) + "."});
    return;
  }
  const Script script = readScript(command.path);
  if (script.clearsPreload)
    examination.add({"preload_cleared", Level::Obstacle, command.path,
                     "It is a script that takes LD_PRELOAD away, or sets it anew.",
                     "Change the script so that it keeps what LD_PRELOAD holds, or run the program "
                     "that it starts yourself."});
  if (!script.sandbox.empty()) {
    addSandbox(examination, script.sandbox, script.application, command.path, surroundings);
    return;
  }
  if (script.starts.empty()) {
    examination.add({"launcher", Level::Possible, command.path,
                     "It is a script, and which program it starts its text does not tell.",
                     runIt(surroundings, "Run it, to see which processes draw") + "."});
    return;
  }
  examination.add({"launcher",
                   Level::Note,
                   command.path,
                   "It is a script that starts " + script.starts + "; the layer goes with it.",
                   {}});
  if (script.libraryPath)
    examination.add({"library_path", Level::Possible, command.path,
                     "The script sets LD_LIBRARY_PATH: the program may get other libraries of GL "
                     "than are looked at here.",
                     runIt(surroundings) + "."});
  if (step < kMaxSteps)
    examineFile(examination, findCommand({script.starts}), surroundings, step + 1);
}

void examineFile(Examination &examination, const CommandFile &command,
                 const Surroundings &surroundings, int step) {
  if (command.found.empty()) {
    examination.add({"missing", Level::Obstacle, command.words.front(), command.problem + ".",
                     "Look at how the name is written, and whether its folder is in PATH."});
    return;
  }
  examination.files.push_back(command.path);
  if (!command.problem.empty()) {
    examination.add({"not_executable", Level::Obstacle, command.path, command.problem + ".",
                     "Give it the right to be executed (chmod +x), or name the program itself."});
    return;
  }
  if (examineSandbox(examination, command, surroundings) ||
      examineLauncher(examination, command, surroundings))
    return;
  if (!command.interpreter.empty()) {
    examineScript(examination, command, surroundings, step);
    return;
  }
  if (const auto given = givenToLoader(command); given && step < kMaxSteps) {
    Surroundings there = surroundings;
    there.byLoader = true;
    there.libraryPath = given->libraryPath;
    examineFile(examination, given->program, there, step + 1);
    return;
  }
  examineProgram(examination, command.path, surroundings);
  const std::string name = fs::path(command.path).filename();
  if (beginsWithOne(name, kInterpreters) || isShell(name) || defaults::isLoader(name)) {
    std::erase_if(examination.findings, [&](const Finding &each) {
      return each.id == "no_gl" || each.id == "vulkan_only" || each.id == "gl_unsure" ||
             (each.id == "static" && defaults::isSystemLoader(name));
    });
    examination.add({"interpreter", Level::Possible, command.path,
                     "It runs other programs, which load GL by themselves, if at all.",
                     runIt(surroundings) + "."});
  }
}

} // namespace

Examination examine(const CommandFile &command, const Surroundings &surroundings) {
  Examination examination;
  if (command.isBeyondPath)
    examination.add(
        {"beyond_path", Level::Note, command.found,
         "It lies in " + fs::path(command.found).parent_path().string() +
             ", which PATH does not have.",
         "Name it with its folder: `arbiter run -- " + shellLine(command.words) + "`."});
  examineFile(examination, command, surroundings, 0);
  return examination;
}

} // namespace arbiter::tools::doctor
