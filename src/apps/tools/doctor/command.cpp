#include <GL/arbiter.h>
#include <algorithm>
#include <cstdio>

#include "apps/tools/commands.h"
#include "apps/tools/doctor/finding.h"
#include "apps/tools/input.h"
#include "apps/tools/launch/launch.h"
#include "apps/tools/launch/shell_text.h"
#include "util/json.h"

namespace arbiter::tools {

namespace {

using doctor::Examination;
using doctor::Finding;
using doctor::Level;

/// Debian's folders of games, which the PATH of root, of cron and of services lacks.
constexpr std::string_view kGamesFolders[] = {"/usr/games", "/usr/local/games"};

const char *nameOf(Level level) {
  switch (level) {
  case Level::Obstacle:
    return "obstacle";
  case Level::Possible:
    return "possible";
  case Level::Note:
    return "note";
  }
  return "";
}

bool isReached(const Examination &examination) {
  return std::none_of(examination.findings.begin(), examination.findings.end(),
                      [](const Finding &each) { return each.level == Level::Obstacle; });
}

void print(const Examination &examination, const std::string &look, bool ran) {
  for (const Finding &each : examination.findings) {
    std::printf("%s: %s\n", nameOf(each.level), each.what.c_str());
    if (!each.file.empty())
      std::printf("  %s\n", each.file.c_str());
    if (!each.remedy.empty())
      std::printf("  %s\n", each.remedy.c_str());
  }
  if (!isReached(examination))
    return;
  if (ran)
    std::puts(examination.has("refused") ? "Nothing else is in the way."
                                         : "Nothing is in the way.");
  else
    std::printf("Nothing that a look at the files can tell is in the way. To look at a run of it: "
                "`%s`\n",
                look.c_str());
}

void printJson(const Examination &examination, const DoctorArguments &arguments) {
  JsonWriter json;
  json.beginObject().key("schema").value(ARBITER_DOCTOR_SCHEMA);
  json.key("command").beginArray();
  for (const std::string &word : arguments.command)
    json.value(word);
  json.endArray().key("files").beginArray();
  for (const std::string &file : examination.files)
    json.value(file);
  json.endArray();
  json.key("ran").value(arguments.run);
  json.key("reached").value(isReached(examination));
  json.key("findings").beginArray();
  for (const Finding &each : examination.findings) {
    json.beginObject();
    json.key("id").value(each.id);
    json.key("level").value(nameOf(each.level));
    json.key("file").value(each.file);
    json.key("what").value(each.what);
    json.key("remedy").value(each.remedy);
    json.endObject();
  }
  json.endArray().endObject();
  std::fputs(json.take().c_str(), stdout);
}

/// True if there is a program that a run could tell more about.
bool canRun(const Examination &examination) {
  return !examination.has("missing") && !examination.has("not_executable") &&
         !examination.has("unknown_format") && !examination.has("windows_program") &&
         !examination.has("missing_interpreter");
}

/// Returns the command line that looks at a run of the command, with the layer's library if the
/// user named one.
std::string lookAtRun(const DoctorArguments &arguments, const std::vector<std::string> &command) {
  std::vector<std::string> words = {"arbiter", "doctor", "--run"};
  if (!arguments.library.empty())
    words.insert(words.end(), {"--library", arguments.library});
  words.emplace_back("--");
  words.insert(words.end(), command.begin(), command.end());
  return shellLine(words);
}

} // namespace

int diagnose(const DoctorArguments &arguments) {
  const auto files = findLayer(arguments.library);
  if (!files && !arguments.library.empty()) {
    complain(files.error().message);
    return kExitUsage;
  }
  doctor::Surroundings surroundings;
  if (files)
    surroundings = doctor::surroundingsOf(files.value());
  surroundings.root = arguments.root;
  const CommandFile command = findCommand(arguments.command, kGamesFolders);
  surroundings.look = lookAtRun(arguments, command.words);
  Examination examination = doctor::examine(command, surroundings);
  if (!files)
    examination.add({"no_layer",
                     Level::Obstacle,
                     {},
                     "The layer itself is not there.",
                     "Install it, or name its library with --library."});
  if (arguments.root.empty()) {
    doctor::examineHost(examination);
    if (canRun(examination))
      doctor::examineDisplay(examination, command.words);
  }
  if (arguments.run && canRun(examination))
    doctor::runAndLook(examination, command, {arguments.library, arguments.seconds});
  std::stable_sort(examination.findings.begin(), examination.findings.end(),
                   [](const Finding &a, const Finding &b) { return a.level < b.level; });
  if (arguments.json)
    printJson(examination, arguments);
  else
    print(examination, surroundings.look, arguments.run);
  return isReached(examination) ? kExitOk : kExitObstacle;
}

} // namespace arbiter::tools
