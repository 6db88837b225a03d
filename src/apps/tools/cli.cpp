// Parses the command line into the structures of commands.h. Only this file and options/ use CLI11.
#include <CLI/CLI.hpp>
#include <GL/arbiter.h>
#include <algorithm>

#include "apps/tools/input.h"
#include "apps/tools/options/options.h"

namespace arbiter::tools {

namespace {

/// The verbs that run or examine another command line.
constexpr std::string_view kWithCommand[] = {"run", "capture", "defaults", "doctor"};

bool takesCommand(const std::vector<std::string> &words) {
  return !words.empty() && std::find(std::begin(kWithCommand), std::end(kWithCommand), words[0]) !=
                               std::end(kWithCommand);
}

/// Cuts off and returns the words after the first "--", which belong to the other command.
std::vector<std::string> cutCommand(std::vector<std::string> &words) {
  if (!takesCommand(words))
    return {};
  const auto mark = std::find(words.begin(), words.end(), "--");
  if (mark == words.end())
    return {};
  std::vector<std::string> command(mark + 1, words.end());
  words.erase(mark, words.end());
  return command;
}

/// Takes the command of such a verb: the words after "--", or the words that no option took.
/// \returns false after a complaint.
bool takeCommand(const CLI::App &subcommand, bool optional, std::vector<std::string> &command) {
  const std::vector<std::string> rest = subcommand.remaining();
  const std::string help = " (arbiter " + subcommand.get_name() + " --help)";
  const std::vector<std::string> &first = rest.empty() ? command : rest;
  if (!first.empty() && first[0].starts_with("-")) {
    complain(unknownOption(subcommand, first[0]) + help);
    return false;
  }
  if (command.empty()) {
    command = rest;
  } else if (!rest.empty()) {
    complain("unexpected " + rest[0] + " before --" + help);
    return false;
  }
  if (command.empty() && !optional) {
    complain("no command to run" + help);
    return false;
  }
  return true;
}

int runCommand(const CLI::App &app, RunArguments &arguments, std::vector<std::string> command) {
  if (!takeCommand(*app.get_subcommand("run"), arguments.printEnvironment, command))
    return kExitWrapper;
  arguments.command = std::move(command);
  return run(arguments);
}

int captureCommand(const CLI::App &app, CaptureArguments &arguments,
                   std::vector<std::string> command) {
  if (!takeCommand(*app.get_subcommand("capture"), arguments.indexOnly, command))
    return kExitWrapper;
  if (arguments.indexOnly && (arguments.folder.empty() || !command.empty())) {
    complain("--index-only takes a folder (-o DIR) and no command");
    return kExitWrapper;
  }
  arguments.command = std::move(command);
  return capture(arguments);
}

int defaultsCommand(const CLI::App &app, DefaultsArguments &arguments,
                    std::vector<std::string> command) {
  if (!takeCommand(*app.get_subcommand("defaults"), true, command))
    return kExitUsage;
  arguments.command = std::move(command);
  return showDefaults(arguments);
}

int doctorCommand(const CLI::App &app, DoctorArguments &arguments,
                  std::vector<std::string> command) {
  if (!takeCommand(*app.get_subcommand("doctor"), false, command))
    return kExitUsage;
  arguments.command = std::move(command);
  return diagnose(arguments);
}

int dispatch(const CLI::App &app, Arguments &arguments, std::vector<std::string> command,
             const std::vector<std::string> &argv) {
  if (app.got_subcommand("check"))
    return check(arguments.check);
  if (app.got_subcommand("compile"))
    return compile(arguments.compile);
  if (app.got_subcommand("draw"))
    return draw(arguments.draw, argv);
  if (app.got_subcommand("debug"))
    return debugPixel(arguments.debug);
  if (app.got_subcommand(kDrawsVerb))
    return drawForDebugger();
  if (app.got_subcommand("ctl"))
    return controlProcess(arguments.ctl);
  if (app.got_subcommand("render"))
    return render(arguments.render, argv);
  if (app.got_subcommand("lsp"))
    return serve(arguments.lsp);
  if (app.got_subcommand("builder"))
    return builder(arguments.builder);
  if (app.got_subcommand("cache"))
    return cache(arguments.cache);
  if (app.got_subcommand("profiles"))
    return profiles(arguments.profiles);
  if (app.got_subcommand("report"))
    return report(arguments.report);
  if (app.got_subcommand("stats"))
    return sumStatistics(arguments.stats);
  if (app.got_subcommand("defaults"))
    return defaultsCommand(app, arguments.defaults, std::move(command));
  if (app.got_subcommand("doctor"))
    return doctorCommand(app, arguments.doctor, std::move(command));
  if (app.got_subcommand("capture"))
    return captureCommand(app, arguments.capture, std::move(command));
  return runCommand(app, arguments.run, std::move(command));
}

/// Replaces `help VERB` by `VERB --help`.
void replaceHelp(std::vector<std::string> &words) {
  if (words.empty() || words.size() > 2 || words[0] != kHelpVerb ||
      (words.size() == 2 && words[1].starts_with("-")))
    return;
  words.erase(words.begin());
  words.emplace_back("--help");
}

int refuse(const std::string &fault, const std::string &verb) {
  complain(fault + " (arbiter " + verb + (verb.empty() ? "" : " ") + "--help)");
  return verb == "run" || verb == "capture" ? kExitWrapper : kExitUsage;
}

int interpret(int argc, char **argv) {
  CLI::App app{"Assembly-era OpenGL programs on today's drivers: check them, compile them, draw "
               "them, and run applications under the layer.",
               "arbiter"};
  Arguments arguments;
  app.require_subcommand(1);
  app.set_version_flag("-V,--version", "arbiter " ARBITER_VERSION_TEXT);
  app.set_help_all_flag("--help-all", "help of all subcommands");
  addVerbs(app, arguments);
  app.footer("See arbiter(1), and arbiter(7) for the environment variables.");

  const std::vector<std::string> all(argv, argv + argc);
  std::vector<std::string> words(all.begin() + std::min(argc, 1), all.end());
  if (words.empty()) {
    std::fputs(app.help().c_str(), stdout);
    return kExitUsage;
  }
  if (words[0] == kCompleteVerb) {
    words.erase(words.begin(), words.begin() + (words.size() > 1 && words[1] == "--" ? 2 : 1));
    return completeWords(app, words, takesCommand(words));
  }
  replaceHelp(words);
  if (!words[0].starts_with("-")) {
    // CLI11 would report an unknown subcommand as a missing one.
    if (const std::string fault = unknownVerb(app, words[0]); !fault.empty())
      return refuse(fault, "");
    speakAs(words[0]);
  }
  const std::string name = words[0].starts_with("-") ? std::string() : words[0];
  std::vector<std::string> command = cutCommand(words);
  std::reverse(words.begin(), words.end()); // CLI11 expects reversed order
  try {
    app.parse(words);
  } catch (const CLI::Success &asked) { // thrown for help and for the version
    return app.exit(asked);
  } catch (const CLI::ParseError &error) {
    return refuse(faultOf(app, error), name);
  }
  if (const std::string fault = withoutEffect(*app.get_subcommands().front()); !fault.empty())
    return refuse(fault, name);
  return dispatch(app, arguments, std::move(command), all);
}

} // namespace

} // namespace arbiter::tools

int main(int argc, char **argv) {
  try {
    return arbiter::tools::interpret(argc, argv);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "arbiter: internal error: %s\n", error.what());
  } catch (...) {
    std::fputs("arbiter: internal error\n", stderr);
  }
  return arbiter::kExitInternal;
}
