// Completes a word of a command line, using the definitions that parse it. The scripts of the
// shells (src/apps/tools/complete) print the result.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "apps/tools/complete/candidates.h"
#include "apps/tools/options/options.h"
#include "apps/tools/options/verb.h"

namespace arbiter::tools {

namespace {

using complete::Candidate;
using complete::Candidates;
using Words = std::vector<std::string>;

constexpr const char *kFiles = ":files";
constexpr std::string_view kHint = ":hint ";

/// Returns the help up to its first ";" or line end: "write a picture of the window".
std::string shortHelp(const std::string &help) { return help.substr(0, help.find_first_of(";\n")); }

bool takesValue(const CLI::Option &option) { return option.get_items_expected_max() != 0; }

/// Returns the words that the option's validator accepts; help shows them as {a,b}.
Candidates wordsOf(const CLI::Option &option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{'), end = type.find('}');
  Candidates found;
  if (begin == std::string::npos || end == std::string::npos)
    return found;
  for (const std::string &word : CLI::detail::split(type.substr(begin + 1, end - begin - 1), ','))
    found.push_back({word, ""});
  return found;
}

/// True if the value is a number or a form such as X,Y, so that neither files nor known words can
/// complete it.
bool isOfOwnForm(const CLI::Option &option) {
  const std::string type = option.get_type_name();
  return type.starts_with("INT") || type.starts_with("FLOAT") ||
         type.find(" to ") != std::string::npos ||
         !saidPlaceholder(option.get_description()).empty();
}

/// Returns the start of the part of a value to complete: after the "0=" of a texture.
std::size_t partBegin(const CLI::Option &option, const std::string &typed) {
  const std::size_t mark = option.get_name() == "--texture" ? typed.find('=') : std::string::npos;
  return mark == std::string::npos ? 0 : mark + 1;
}

/// The parsed part of the command line, before the word to complete.
struct Line {
  const CLI::App *verb = nullptr;
  const CLI::Option *valueOf = nullptr; ///< set if the word is this option's value
  Words operands;                       ///< of the verb
  std::size_t command = 0;              ///< the word at which another command line begins; 0: none
  int process = 0;                      ///< the value of --pid
};

const CLI::Option *optionOf(const CLI::App &verb, const std::string &word) {
  for (const CLI::Option *option : verb.get_options())
    if (option->nonpositional() && option->check_name(word))
      return option;
  return nullptr;
}

Line readLine(const CLI::App &verb, const Words &words, bool withCommand) {
  Line line;
  line.verb = &verb;
  for (std::size_t i = 1; i + 1 < words.size(); ++i) {
    const std::string &word = words[i];
    if (withCommand && (word == "--" || !word.starts_with("-"))) {
      line.command = word == "--" ? i + 1 : i;
      return line;
    }
    if (word.size() < 2 || word[0] != '-') {
      line.operands.push_back(word);
      continue;
    }
    const CLI::Option *const option = optionOf(verb, word);
    if (!option || !takesValue(*option))
      continue;
    if (i + 2 == words.size())
      line.valueOf = option;
    else if (++i; option->get_name() == "--pid")
      line.process = std::atoi(words[i].c_str());
  }
  return line;
}

Candidates optionsOf(const CLI::App &verb) {
  Candidates found;
  for (const CLI::Option *option : verb.get_options()) {
    if (!option->nonpositional() || !isShown(*option))
      continue;
    for (const std::string &name : option->get_lnames())
      found.push_back({"--" + name, shortHelp(option->get_description())});
    for (const std::string &name : option->get_snames())
      found.push_back({"-" + name, shortHelp(option->get_description())});
  }
  return found;
}

Candidates verbsOf(const CLI::App &app) {
  Candidates found;
  for (const CLI::App *verb : app.get_subcommands({}))
    if (!verb->get_group().empty())
      found.push_back({verb->get_name(), shortHelp(verb->get_description())});
  return found;
}

/// Returns the possible values of an option. \param part from partBegin()
Candidates valuesOf(const CLI::Option &option, std::size_t part) {
  Candidates found = wordsOf(option);
  const std::string &name = option.get_name();
  if (name == "--pid")
    return complete::processes();
  if (name == "--profile")
    found = complete::profiles();
  if (name == "--texture" && part != 0)
    found = complete::images();
  if (option.get_description().find("; all: ") != std::string::npos)
    found.push_back({"all", "every card"});
  if (found.empty() && isOfOwnForm(option))
    return {{std::string(kHint) + shortHelp(option.get_description()), ""}};
  const bool orFile =
      option.get_type_name().ends_with(" OR FILE") || name == "--profile" || name == "--texture";
  if (found.empty() || orFile)
    found.push_back({kFiles, ""});
  return found;
}

Candidates operandsOf(const CLI::App &app, const Line &line) {
  const std::string verb = line.verb->get_name();
  if (verb == kHelpVerb)
    return line.operands.empty() ? verbsOf(app) : Candidates();
  if (verb == "profiles" && line.operands.empty()) {
    Candidates found = complete::profiles();
    found.push_back({kFiles, ""});
    return found;
  }
  if (verb == "ctl") {
    if (line.operands.empty())
      return complete::actions();
    const std::string operand = complete::operandOf(line.operands[0], line.operands.size() - 1);
    if (operand == "ID")
      return complete::programs(line.process);
    return operand.starts_with("F") ? Candidates{{kFiles, ""}} : Candidates();
  }
  Candidates found;
  for (const CLI::Option *option : line.verb->get_options())
    if (option->get_positional()) {
      if (option->get_description().find("gallery:NAME") != std::string::npos)
        found = complete::gallery();
      found.push_back({kFiles, ""});
    }
  return found;
}

/// Prints the candidates that begin with `typed`.
/// \param typed the part of the word to complete
/// \param before the part of the word before it
void print(const Candidates &candidates, const std::string &typed, const std::string &before) {
  for (const Candidate &each : candidates)
    if (each.word == kFiles)
      std::printf("%s%s%s\n", kFiles, before.empty() ? "" : " ", before.c_str());
    else if (each.word.starts_with(kHint))
      std::printf("%s\n", each.word.c_str());
    else if (each.word.starts_with(typed))
      std::printf("%s%s\t%s\n", before.c_str(), each.word.c_str(), each.help.c_str());
}

/// Prints the possible values of an option.
/// \param before the part of the word before the value: "--profile="
void printValues(const CLI::Option &option, const std::string &typed, const std::string &before) {
  const std::size_t part = partBegin(option, typed);
  print(valuesOf(option, part), typed.substr(part), before + typed.substr(0, part));
}

} // namespace

int completeWords(const CLI::App &app, const Words &words, bool withCommand) {
  const std::string typed = words.empty() ? std::string() : words.back();
  const auto verbs = app.get_subcommands([&](const CLI::App *verb) {
    return words.size() > 1 && verb->get_name() == words[0] && !verb->get_group().empty();
  });
  if (words.size() < 2) {
    print(typed.starts_with("-") ? optionsOf(app) : verbsOf(app), typed, "");
    return kExitOk;
  }
  if (verbs.empty())
    return kExitOk;
  const Line line = readLine(*verbs.front(), words, withCommand);
  const std::size_t equals = typed.find('=');
  const CLI::Option *const assigned = typed.starts_with("--") && equals != std::string::npos
                                          ? optionOf(*line.verb, typed.substr(0, equals))
                                          : nullptr;
  if (line.command != 0 || (withCommand && !line.valueOf && !typed.starts_with("-")))
    std::printf(":command %zu\n", line.command != 0 ? line.command : words.size() - 1);
  else if (line.valueOf)
    printValues(*line.valueOf, typed, "");
  else if (assigned)
    printValues(*assigned, typed.substr(equals + 1), typed.substr(0, equals + 1));
  else if (typed.starts_with("-") && typed != "-")
    print(optionsOf(*line.verb), typed, "");
  else
    print(operandsOf(app, line), typed, "");
  return kExitOk;
}

} // namespace arbiter::tools
