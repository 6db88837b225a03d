#pragma once
#include <string>

#include "tools/commands.h"

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

/// Makes help show options in this project's words. Verbs that are added later do so too.
void useOwnWords(CLI::App &app);
/// Adds every verb; parsing fills \p arguments, which must outlive the application.
void addVerbs(CLI::App &app, Arguments &arguments);

/// "X,Y", of the description "X,Y: the pixel"; empty: it does not begin so.
[[nodiscard]] std::string saidPlaceholder(const std::string &description);

/// "no option --jsn; did you mean --json?"
[[nodiscard]] std::string unknownOption(const CLI::App &verb, const std::string &word);
/// Returns the complaint about an unknown verb, or "" if the verb exists.
[[nodiscard]] std::string unknownVerb(const CLI::App &app, const std::string &word);
/// Returns what CLI11 found wrong with a command line, and what was expected.
[[nodiscard]] std::string faultOf(const CLI::App &app, const CLI::ParseError &error);

/// The hidden verb that runs completeWords(); no help shows it.
inline constexpr const char *kCompleteVerb = "complete";
/// Prints what the last word may become, a line each: the word, a tab, a help. A line ":files"
/// means names of files too, ":files TEXT" those behind that text, which the word begins with;
/// ":hint TEXT" says what is expected; ":command N" that another's command line begins at the word
/// of that number. \param words behind `arbiter`; the last one may be empty \param withCommand the
/// verb takes another's command line
int completeWords(const CLI::App &app, const std::vector<std::string> &words, bool withCommand);

/// Returns a complaint about the first given option that has no effect beside the others: "--why
/// has no effect with --json". Returns "" if each has an effect.
[[nodiscard]] std::string withoutEffect(const CLI::App &verb);

} // namespace arbiter::tools
