// Words the errors of CLI11 like all other errors: what is wrong, and what was expected.
#include <CLI/CLI.hpp>
#include <algorithm>

#include "apps/tools/options/options.h"
#include "apps/tools/options/verb.h"
#include "util/suggest.h"

namespace arbiter::tools {

namespace {

/// Returns the only word that begins with `typed`; empty if there is none, or more than one.
std::string_view begunBy(std::string_view typed, const std::vector<std::string_view> &known) {
  const auto begins = [&](std::string_view word) { return word.starts_with(typed); };
  const auto found = std::find_if(known.begin(), known.end(), begins);
  return std::count_if(known.begin(), known.end(), begins) == 1 ? *found : std::string_view();
}

std::string meant(std::string_view typed, const std::vector<std::string> &known) {
  const std::vector<std::string_view> views(known.begin(), known.end());
  const std::string_view begun = begunBy(typed, views);
  const std::string_view near = begun.empty() ? nearest(typed, views) : begun;
  return near.empty() ? std::string() : "; did you mean " + std::string(near) + "?";
}

/// Returns the option with the longest name that the text contains. Hidden options have no name.
const CLI::Option *mentioned(const CLI::App &verb, const std::string &text) {
  const CLI::Option *found = nullptr;
  for (const CLI::Option *option : verb.get_options())
    if (isShown(*option) && text.find(option->get_name()) != std::string::npos &&
        (!found || option->get_name().size() > found->get_name().size()))
      found = option;
  return found;
}

/// Returns what an option expects, from its help: "a program text" of "a program text; - is
/// standard input".
std::string expected(const CLI::Option &option) {
  const std::string &help = option.get_description();
  return "expected " + help.substr(0, help.find_first_of(";:("));
}

std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

/// Returns a complaint about an unexpected word, preferably an option.
std::string leftOver(const CLI::App &app, const CLI::App &verb) {
  const std::vector<std::string> rest = app.remaining(true);
  const auto option = std::find_if(rest.begin(), rest.end(), [](const std::string &word) {
    return word.size() > 1 && word[0] == '-';
  });
  if (option != rest.end())
    return unknownOption(verb, *option);
  return rest.empty() ? std::string() : "unexpected " + rest.front();
}

/// Returns "2" of "FILE: At Most 2 required but received 3"; empty for another text.
std::string mostOf(const std::string &text) {
  constexpr std::string_view kStart = ": At Most ";
  const std::size_t at = text.find(kStart);
  if (at == std::string::npos)
    return {};
  const std::size_t begin = at + kStart.size();
  return text.substr(begin, text.find(' ', begin) - begin);
}

} // namespace

std::string faultOf(const CLI::App &app, const CLI::ParseError &error) {
  const auto verbs = app.get_subcommands();
  const CLI::App &verb = verbs.empty() ? app : *verbs.front();
  const std::string kind = error.get_name(), text = error.what();
  const CLI::Option *const option = mentioned(verb, text);
  const std::string rest = leftOver(app, verb);
  if (!option || text.starts_with("The following argument") || rest.starts_with("no option"))
    return rest.empty() ? text : rest;
  const std::string &name = option->get_name();
  if (kind == "RequiredError")
    return name + " is missing: " + trimmed(expected(*option));
  if (kind == "RequiresError" || kind == "ExcludesError") {
    const std::size_t first = text.find(' '), last = text.rfind(' ');
    return text.substr(0, first) +
           (kind == "RequiresError" ? " needs " : " cannot be given with ") + text.substr(last + 1);
  }
  if (kind == "ValidationError") {
    const std::string what = text.substr(std::min(text.size(), text.find(": ") + 2));
    return option->get_positional() ? what : name + " " + what;
  }
  if (kind == "ArgumentMismatch" && text.ends_with("missing"))
    return name + " has no value: " + trimmed(expected(*option));
  if (const std::string most = mostOf(text); !most.empty())
    return name + ": at most " + most + " are taken";
  return name + ": " + trimmed(expected(*option));
}

std::string unknownOption(const CLI::App &verb, const std::string &word) {
  std::vector<std::string> known;
  for (const CLI::Option *option : verb.get_options())
    if (isShown(*option))
      for (const std::string &name : option->get_lnames())
        known.push_back("--" + name);
  return "no option " + word + meant(word.substr(0, word.find('=')), known);
}

std::string unknownVerb(const CLI::App &app, const std::string &word) {
  std::vector<std::string> known;
  for (const CLI::App *verb : app.get_subcommands({})) {
    if (verb->get_name() == word)
      return {};
    if (!verb->get_group().empty())
      known.push_back(verb->get_name());
  }
  return "no verb " + word + meant(word, known);
}

} // namespace arbiter::tools
