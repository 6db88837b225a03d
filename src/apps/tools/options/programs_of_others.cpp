// The verbs about applications that will run under the layer: their defaults, and obstacles.
#include "apps/tools/options/verbs.h"

namespace arbiter::tools {

void addDefaults(CLI::App &app, DefaultsArguments &defaults) {
  Verb verb(app, "defaults",
            "Show the defaults of single programs, those of a command, or test a file of them:\n"
            "arbiter defaults [OPTIONS] [[--] COMMAND [ARGUMENTS...]]");
  verb.option("--check", defaults.check,
              "look at this file alone, and say what is wrong with it; with a COMMAND, what it "
              "would do");
  verb.flag("--json", defaults.json, "as one JSON document");
  verb.prefixCommand();
  verb.footer("The layer follows them in every process that it is loaded into; a variable or an "
              "option wins over them (arbiter-defaults(5)).\n"
              "Exit code: " +
              meaningsOf({kExitOk, kExitUsage, kExitInvalid}) +
              ".\n"
              "Examples:\n"
              "  arbiter defaults\n"
              "  arbiter defaults -- wine glquake.exe\n"
              "  arbiter defaults --check mine.toml");
}

void addDoctor(CLI::App &app, DoctorArguments &doctor) {
  Verb verb(app, "doctor",
            "Say why the layer does not reach a command, and what to do:\n"
            "arbiter doctor [OPTIONS] [--] COMMAND [ARGUMENTS...]");
  verb.flag("--run", doctor.run,
            "run it too, under the layer, and look at what the layer reports of it");
  verb.option("--for", doctor.seconds, "seconds that it may run for")
      .range(0.1, 3600.0)
      .needs("--run")
      .showDefault();
  verb.option("--root", doctor.root,
              "look at the libraries of the system in this folder (a container's, a chroot's)");
  verb.option("--library", doctor.library, "the layer's library, where it is not beside us");
  verb.flag("--json", doctor.json, "as one JSON document");
  verb.prefixCommand();
  verb.footer("Exit code: " + meaningsOf({kExitOk, kExitUsage, kExitObstacle}) +
              ".\n"
              "Examples:\n"
              "  arbiter doctor -- ./game\n"
              "  arbiter doctor --run --for 10 -- ./game -window");
}

} // namespace arbiter::tools
