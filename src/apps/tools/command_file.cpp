#include "apps/tools/command_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace arbiter::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFirstLine = 256; // the kernel reads at most this much of a script

bool isExecutable(const fs::path &path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

/// Finds a command as execvp() does. If no executable file has that name, returns another file of
/// that name.
std::string lookUp(const std::string &word) {
  if (word.find('/') != std::string::npos)
    return word;
  const char *const path = std::getenv("PATH");
  std::stringstream folders(path == nullptr ? "/bin:/usr/bin" : path);
  std::string there;
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder.empty() ? "." : folder) / word;
    std::error_code error;
    if (isExecutable(file))
      return file;
    if (there.empty() && fs::is_regular_file(file, error))
      there = file;
  }
  return there;
}

std::vector<std::string> interpreterOf(const std::string &path) {
  std::ifstream stream(path, std::ios::binary);
  char line[kFirstLine] = {};
  stream.read(line, sizeof line - 1);
  if (stream.gcount() < 3 || line[0] != '#' || line[1] != '!')
    return {};
  std::stringstream words(std::string(line + 2, std::strcspn(line + 2, "\n")));
  std::vector<std::string> found;
  std::string interpreter, option;
  if (words >> interpreter)
    found.push_back(interpreter);
  if (std::getline(words >> std::ws, option) && !option.empty())
    found.push_back(option);
  return found;
}

} // namespace

CommandFile findCommand(std::vector<std::string> words, std::span<const std::string_view> further) {
  CommandFile command;
  command.words = std::move(words);
  std::string &word = command.words.front();
  command.found = lookUp(word);
  for (const std::string_view folder : further)
    if (const fs::path file = fs::path(folder) / word;
        command.found.empty() && isExecutable(file)) {
      command.found = word = file;
      command.isBeyondPath = true;
    }
  std::error_code error;
  if (command.found.empty() || !fs::exists(command.found, error)) {
    command.found.clear();
    command.problem =
        word + (word.find('/') == std::string::npos ? ": not found in PATH" : ": no such file");
    return command;
  }
  command.path = fs::canonical(command.found, error);
  if (error)
    command.path = command.found;
  if (fs::is_directory(command.path, error))
    command.problem = command.found + ": is a folder";
  else if (!isExecutable(command.path))
    command.problem = command.found + ": is not executable";
  command.interpreter = interpreterOf(command.path);
  return command;
}

std::optional<GivenToLoader> givenToLoader(const CommandFile &command) {
  if (!defaults::isSystemLoader(fs::path(command.found).filename().native()))
    return std::nullopt;
  const defaults::Facts facts = factsOf(command);
  const std::string program = defaults::programOf(facts).path;
  if (program == facts.executable)
    return std::nullopt;
  GivenToLoader given{findCommand({program}), {}};
  const auto option = std::find(command.words.begin(), command.words.end(), "--library-path");
  if (option != command.words.end() && option + 1 != command.words.end())
    given.libraryPath = option[1];
  return given;
}

defaults::Facts factsOf(const CommandFile &command) {
  defaults::Facts facts;
  facts.environment = [](const char *name) -> const char * { return std::getenv(name); };
  facts.words = command.words;
  facts.executable = command.path;
  const std::string &known = command.found.empty() ? command.words.front() : command.found;
  if (defaults::isLoader(fs::path(known).filename().native())) {
    facts.executable = known; // the name that the user knows; Debian links it to another
    return facts;
  }
  if (command.interpreter.empty())
    return facts;
  std::error_code error;
  const std::string interpreter = fs::canonical(command.interpreter.front(), error);
  facts.executable = error ? command.interpreter.front() : interpreter;
  facts.words.insert(facts.words.begin(), command.interpreter.begin(), command.interpreter.end());
  return facts;
}

} // namespace arbiter::tools
