#include <GL/arbiter.h>
#include <algorithm>
#include <cstdio>

#include "apps/tools/commands.h"
#include "apps/tools/doctor/finding.h"
#include "apps/tools/input.h"
#include "apps/tools/launch/launch.h"
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

void print(const Examination &examination, bool ran) {
  for (const Finding &each : examination.findings) {
    std::printf("%s: %s\n", nameOf(each.level), each.what.c_str());
    if (!each.file.empty())
      std::printf("  %s\n", each.file.c_str());
    if (!each.remedy.empty())
      std::printf("  %s\n", each.remedy.c_str());
  }
  if (isReached(examination))
    std::printf(ran ? examination.has("refused") ? "Nothing else is in the way.\n"
                                                 : "Nothing is in the way.\n"
                    : "Nothing that a look at the files can tell is in the way (--run looks at a "
                      "run of it).\n");
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
         !examination.has("unknown_format") && !examination.has("windows_program");
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
  Examination examination = doctor::examine(command, surroundings);
  if (!files)
    examination.add({"no_layer",
                     Level::Obstacle,
                     {},
                     "The layer itself is not there.",
                     "Install it, or name its library with --library."});
  if (arguments.root.empty())
    doctor::examineHost(examination);
  if (arguments.run && canRun(examination))
    doctor::runAndLook(examination, command, {arguments.library, arguments.seconds});
  std::stable_sort(examination.findings.begin(), examination.findings.end(),
                   [](const Finding &a, const Finding &b) { return a.level < b.level; });
  if (arguments.json)
    printJson(examination, arguments);
  else
    print(examination, arguments.run);
  return isReached(examination) ? kExitOk : kExitDiffers;
}

} // namespace arbiter::tools
