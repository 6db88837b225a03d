// The verbs that read program texts: check, compile, report, profiles.
#include "apps/tools/options/verbs.h"

#include "apps/tools/language.h"

namespace arbiter::tools {

namespace {

void addLanguage(Verb &verb, std::string &language) {
  verb.option("--language", language,
              "auto: as the header says; or the language to hold the program to")
      .oneOf(languageNames())
      .showDefault();
}

} // namespace

void addCheck(CLI::App &app, CheckArguments &check) {
  Verb verb(app, "check", "Check programs: errors with line and column, counts against limits");
  verb.option("--profile", check.profiles,
              std::string(kChosenProfileHelp) + "; all: every card, a row a file, a column a card")
      .repeatable();
  verb.option("--limits", check.limits,
              "a program over the API limits: enforce: invalid; report: a warning")
      .oneOf({"enforce", "report"})
      .showDefault();
  addLanguage(verb, check.language);
  verb.flag("--json", check.json, "one JSON document for all files");
  const Option brief = verb.flag("--brief", check.brief, "one line a diagnostic, no counts");
  const Option why = verb.flag(
      "--why", check.why, "every reason, texture node, dependent read and cost, for every file");
  const Option advise = verb.flag(
      "--advise", check.advise,
      "what would cost less on the profile's card: each compiled, and run beside the program");
  const Option fix = verb.flag("--fix", check.fix,
                               "make every such change of --advise that the program alone "
                               "decides, in the files")
                         .needs(advise);
  verb.flag("--compare", check.compare,
            "two files side by side, or one under two profiles (--profile twice)")
      .excludes(brief)
      .excludes(why)
      .excludes(advise)
      .excludes(fix);
  verb.option("--gauges", check.gauges,
              "auto: blocks on a UTF-8 terminal; always: into a file too, and a table for "
              "each of many files; never: numbers alone")
      .oneOf({"auto", "always", "never"})
      .showDefault();
  verb.option("FILE", check.files,
              "program texts, each with one program or several (.vfp), or folders of them and of "
              "captures; gallery:NAME; - is standard input")
      .required()
      .documents();
  verb.footer("Up to eight files get a table each; more, or a folder, the lines of what is "
              "wrong and a summary.\n"
              "Exit code: " +
              meaningsOf({kExitOk, kExitUsage, kExitInvalid, kExitOverNative}) +
              ". The worst file decides; with --profile "
              "all a program counts as on the card that takes it best; with --compare the second "
              "file decides, or the second profile.\n"
              "Examples:\n"
              "  arbiter check --why shader.fp\n"
              "  arbiter check --profile nv30 --json *.fp *.vp\n"
              "  arbiter check shaders/ game.capture/\n"
              "  arbiter check --profile all shaders/\n"
              "  arbiter check --advise shader.fp\n"
              "  arbiter check --compare before.fp after.fp\n"
              "  arbiter check --compare --profile r300 --profile nv30 shader.fp\n"
              "  arbiter check --profile r300-catalyst-2004 - < shader.fp");
}

void addCompile(CLI::App &app, CompileArguments &compile) {
  Verb verb(app, "compile", "Show what the compiler makes of a program");
  verb.option("--profile", compile.profile, kChosenProfileHelp);
  verb.option("--emit", compile.emit,
              "tokens, ir (checked program), assembly (plain text), glsl (1.20), native "
              "(as the profile's card runs it, where that is modelled), llvm or machine "
              "(the rasterizer's code)")
      .oneOf({"tokens", "ir", "assembly", "glsl", "native", "llvm", "machine"})
      .showDefault();
  addLanguage(verb, compile.language);
  verb.flag("--optimize,-O", compile.optimise, "ir, assembly: after the passes");
  verb.option("--numerics", compile.numerics,
              "glsl, llvm, machine, the passes, and fx9 of combiners: for this arithmetic")
      .oneOf({"host", "legacy", "fp24", "fx9"})
      .showDefault();
  verb.flag("--json", compile.json, "what is emitted as one JSON document, with the diagnostics");
  verb.option("-o,--output", compile.output, "file to write; - is standard output").showDefault();
  verb.option("FILE", compile.file, "a program text; - is standard input").required();
  verb.footer("Exit code: " + meaningsOf({kExitOk, kExitUsage, kExitInvalid}) +
              ".\n"
              "Examples:\n"
              "  arbiter compile --emit glsl shader.fp\n"
              "  arbiter compile --emit ir -O shader.fp -o shader.ir");
}

void addReport(CLI::App &app, ReportArguments &report) {
  Verb verb(app, "report",
            "Write one HTML page about a set of programs: what fits, what not, and why");
  verb.option("-o,--output", report.output, "the page to write; - is standard output")
      .showDefault();
  verb.option("--profile", report.profile,
              std::string(kProfileHelp) + "; by default the capture's, or as for check");
  verb.flag("--json", report.json, "print the same as one JSON document too");
  verb.option("FILE", report.operands,
              "program texts, folders of them, or the folder of one capture")
      .required();
  verb.footer("The page needs nothing beside it and asks nothing of a network. Its address "
              "keeps how the table is sorted and filtered: page.html#sort=cycles&filter=water\n"
              "Exit code: " +
              meaningsOf({kExitOk, kExitUsage}) +
              ". The programs do not count.\n"
              "Examples:\n"
              "  arbiter report shaders -o shaders.html\n"
              "  arbiter report game.capture --profile nv30 -o game.html --json > game.json");
}

void addProfiles(CLI::App &app, ProfilesArguments &profiles) {
  Verb verb(app, "profiles", "List the hardware profiles, or print one with its sources");
  verb.flag("--json", profiles.json, "as one JSON document");
  verb.option("NAME", profiles.name, "a name, or a TOML file");
  verb.footer("Exit code: " + meaningsOf({kExitOk, kExitUsage}) +
              ".\n"
              "Examples:\n  arbiter profiles\n  arbiter profiles r300 > mine.toml");
}

} // namespace arbiter::tools
