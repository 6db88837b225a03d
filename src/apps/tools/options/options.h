#pragma once
#include <string>

#include "apps/tools/commands.h"

namespace CLI {
class App;
class ParseError;
} // namespace CLI

/// Defines the verbs of `arbiter` and their options with CLI11.
namespace arbiter::tools {

/// The parsed arguments of all verbs.
struct Arguments {
  CheckArguments check;
  CompileArguments compile;
  DrawArguments draw;
  DebugArguments debug;
  RunArguments run;
  DefaultsArguments defaults;
  DoctorArguments doctor;
  StatsArguments stats;
  CaptureArguments capture;
  ReportArguments report;
  ProfilesArguments profiles;
  CacheArguments cache;
  CtlArguments ctl;
  RenderArguments render;
  LspArguments lsp;
  BuilderArguments builder;
  std::string helpOf;
};

/// The help group of options that all verbs with the layer share.
inline constexpr const char *kLayerGroup = "Options of the layer";

/// The verb that shows the help of another verb; its words are replaced by that verb's --help.
inline constexpr const char *kHelpVerb = "help";

/// Makes help show options in this project's words, also for verbs that are added later.
void useOwnWords(CLI::App &app);
/// Adds every verb; parsing fills \p arguments, which must outlive the application.
void addVerbs(CLI::App &app, Arguments &arguments);

/// Returns "X,Y" for the description "X,Y: the pixel", or "" if the description has no such start.
[[nodiscard]] std::string saidPlaceholder(const std::string &description);

/// Returns the complaint about an unknown option: "no option --jsn; did you mean --json?"
[[nodiscard]] std::string unknownOption(const CLI::App &verb, const std::string &word);
/// Returns the complaint about an unknown verb, or "" if the verb exists.
[[nodiscard]] std::string unknownVerb(const CLI::App &app, const std::string &word);
/// Returns what CLI11 found wrong with a command line, and what was expected.
[[nodiscard]] std::string faultOf(const CLI::App &app, const CLI::ParseError &error);

/// The hidden verb that runs completeWords(); no help shows it.
inline constexpr const char *kCompleteVerb = "complete";
/// Prints the possible completions of the last word, one per line: the word, a tab, a help text. A
/// line ":files" stands for file names; ":files TEXT" for those after TEXT, with which the word
/// begins. A line ":hint TEXT" says what is expected. A line ":command N" says that another command
/// line begins at word N.
/// \param words after `arbiter`; the last one may be empty
/// \param withCommand true if the verb takes another command line
int completeWords(const CLI::App &app, const std::vector<std::string> &words, bool withCommand);

/// Returns a complaint about the first given option that has no effect beside the others: "--why
/// has no effect with --json". Returns "" if each has an effect.
[[nodiscard]] std::string withoutEffect(const CLI::App &verb);

} // namespace arbiter::tools
