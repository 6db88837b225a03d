#include <GL/arbiter.h>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "apps/tools/command_file.h"
#include "apps/tools/commands.h"
#include "apps/tools/input.h"
#include "fp_compiler/hw/profile.h"
#include "util/defaults/choice.h"
#include "util/defaults/folders.h"
#include "util/defaults/report.h"

namespace arbiter::tools {

namespace {

namespace fs = std::filesystem;
using defaults::Choice;
using defaults::Chosen;
using defaults::Entry;
using defaults::Setting;
using defaults::Value;

const char *environment(const char *name) { return std::getenv(name); }

/// Returns the shipped defaults of the build tree, or else of the installation, as the layer does.
std::string shippedFolder() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const fs::path tree =
      self.parent_path().parent_path().parent_path() / "interposer/arbiter/defaults.d";
  if (fs::is_directory(tree, error))
    return tree;
  return (self.parent_path() / ARBITER_DEFAULTS_FROM_BIN).lexically_normal();
}

const char *keyOf(const Value &value) {
  for (const defaults::Key &key : defaults::keys())
    if (key.variable == value.variable)
      return key.name.c_str();
  return "";
}

std::string said(const Value &value) { return value.text.empty() ? "default" : value.text; }

std::string joined(const std::vector<std::string> &words, const char *between) {
  std::string text;
  for (const std::string &word : words)
    text += (text.empty() ? "" : between) + word;
  return text;
}

void printMatch(const char *key, const std::vector<std::string> &patterns) {
  if (!patterns.empty())
    std::printf("  %-9s%s\n", key, joined(patterns, " or ").c_str());
}

void print(const Entry &entry) {
  std::printf("%s\n", entry.title.c_str());
  printMatch("name", entry.match.names);
  printMatch("path", entry.match.paths);
  printMatch("windows", entry.match.windows);
  printMatch("xxh128", entry.match.hashes);
  for (const Value &value : entry.values)
    std::printf("  %-9s%s = %s\n", "sets", keyOf(value), said(value).c_str());
  if (!entry.note.empty())
    std::printf("  %-9s%s\n", "note", entry.note.c_str());
  for (const std::string &source : entry.sources)
    std::printf("  %-9s%s\n", "source", source.c_str());
  std::printf("  %-9s%s:%u\n", "from", entry.file.c_str(), entry.line);
}

/// Reports the same errors as the layer does when it loads the profile.
void checkProfiles(defaults::File &file) {
  for (const Entry &entry : file.entries)
    for (const Value &value : entry.values)
      if (value.variable == Env::Profile && !value.text.empty())
        if (const auto profile = fp::hw::loadProfile(value.text); !profile)
          file.errors.push_back(entry.file + ":" + std::to_string(value.line) + ": " +
                                profile.error().message);
}

bool complainOfAll(const std::vector<defaults::File> &files) {
  bool any = false;
  for (const defaults::File &file : files)
    for (const std::string &error : file.errors) {
      complain(error);
      any = true;
    }
  return any;
}

void writeErrors(JsonWriter &json, const std::vector<defaults::File> &files) {
  json.key("errors").beginArray();
  for (const defaults::File &file : files)
    for (const std::string &error : file.errors)
      json.value(error);
  json.endArray();
}

void print(JsonWriter &json) { std::fputs(json.take().c_str(), stdout); }

void list(const std::vector<defaults::File> &files, bool asJson) {
  if (asJson) {
    JsonWriter json;
    json.beginObject().key("schema").value(ARBITER_DEFAULTS_SCHEMA).key("entries").beginArray();
    for (const defaults::File &file : files)
      for (const Entry &entry : file.entries)
        defaults::writeEntry(json, entry);
    json.endArray();
    writeErrors(json, files);
    json.endObject();
    print(json);
    return;
  }
  for (const defaults::File &file : files)
    for (const Entry &entry : file.entries)
      print(entry);
}

void printProgram(const Choice &choice) {
  const defaults::Program &program = choice.program;
  std::printf("name     %s\npath     %s\n", program.name.c_str(), program.path.c_str());
  if (!program.windows.empty())
    std::printf("windows  %s (%s)\n", program.windows.c_str(),
                program.windowsPath.empty() ? "its file was not found"
                                            : program.windowsPath.c_str());
  const std::string hash = defaults::hashOfFile(program.file());
  std::printf("xxh128   %s\n", hash.empty() ? "the file cannot be read" : hash.c_str());
}

void explain(const Choice &choice, bool asJson) {
  if (asJson) {
    JsonWriter json;
    json.beginObject().key("schema").value(ARBITER_DEFAULTS_SCHEMA).key("choice");
    defaults::writeChoice(json, &choice);
    json.key("xxh128").value(defaults::hashOfFile(choice.program.file()));
    json.endObject();
    print(json);
    return;
  }
  printProgram(choice);
  if (choice.entries.empty())
    std::printf("no entry is for it\n");
  for (const Chosen &chosen : choice.entries)
    std::printf("entry    %s, by %s (%s:%u)\n", chosen.entry->title.c_str(), chosen.why.c_str(),
                chosen.entry->file.c_str(), chosen.entry->line);
  for (const Setting &setting : choice.settings)
    std::printf("%-9s%s = %s (%s)\n", setting.used ? "sets" : "not", setting.key->name.c_str(),
                said(*setting.value).c_str(),
                setting.used
                    ? setting.place().c_str()
                    : (std::string(info(setting.key->variable).name) + " is set in the environment")
                          .c_str());
}

} // namespace

int showDefaults(const DefaultsArguments &arguments) {
  std::vector<defaults::File> files;
  if (!arguments.check.empty()) {
    files.push_back(defaults::readFile(arguments.check));
    checkProfiles(files.front());
  } else {
    files = defaults::readFolders(defaults::folders(shippedFolder(), environment));
  }
  const bool faulty = !arguments.json && complainOfAll(files);
  bool anyError = faulty;
  for (const defaults::File &file : files)
    anyError = anyError || !file.errors.empty();
  if (!arguments.check.empty() && !arguments.json)
    for (const Entry &entry : files.front().entries)
      if (entry.sources.empty())
        complain(entry.file + ":" + std::to_string(entry.line) + ": note: \"" + entry.title +
                 "\" has no source; an entry that is to be shipped needs one");
  if (arguments.command.empty()) {
    list(files, arguments.json);
  } else {
    const CommandFile command = findCommand(arguments.command);
    defaults::Program program = defaults::programOf(factsOf(command));
    if (command.found.empty()) {
      complain(command.problem);
      // Without its loader, a Windows program is still identified by its own name.
      if (program.windows.empty())
        return kExitUsage;
    }
    explain(defaults::choose(std::move(program), std::move(files), environment), arguments.json);
  }
  return anyError && !arguments.check.empty() ? kExitInvalid : kExitOk;
}

} // namespace arbiter::tools
