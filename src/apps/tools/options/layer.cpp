// The verbs that run commands under the layer, and the layer's options.
#include "apps/tools/options/verbs.h"

namespace arbiter::tools {

void addLayer(Verb &verb, LayerArguments &layer) {
  const std::size_t first = verb.count();
  verb.option("--profile", layer.profile, kProfileHelp);
  verb.option("--limits", layer.limits,
              "programs over the API limits: enforce refuses them, report loads them")
      .oneOf({"enforce", "report"});
  verb.option("--identity", layer.identity,
              "whom GL says it is: the host, or the profile's card and driver, with its limits")
      .oneOf({"host", "profile"});
  verb.option("--numerics", layer.numerics,
              "how programs compute: as the host; legacy: 0 times infinity is 0; fp24: 24-bit "
              "floats; fx9: 9-bit register combiners")
      .oneOf({"host", "legacy", "fp24", "fx9"});
  verb.option("--backend", layer.backend,
              "who draws with programs: auto; the host; swrast, Arbiter's own rasterizer")
      .oneOf({"auto", "host", "swrast"});
  verb.option("--fixed-function", layer.fixedFunction,
              "whose draws without a program are: always the rasterizer's, or only once a program "
              "has been drawn")
      .oneOf({"always", "programs"});
  verb.option(
          "--attributes", layer.attributes,
          "generic and conventional vertex attributes of a number: alias, one attribute; apart, "
          "two; else as the profile's card")
      .oneOf({"alias", "apart"});
  verb.option("--extensions-max-year", layer.extensionsMaxYear,
              "announce no extension of a later year")
      .range(1992, 9999);
  verb.option("--extensions-max-length", layer.extensionsMaxLength,
              "keep the oldest extensions, as many as fit into this many bytes of the string")
      .range(1, 1048576);
  verb.option("--extensions", layer.extensions,
              "NAME=on or NAME=off, several with commas: announce an extension (GL_... or GLX_...) "
              "that is there, or hide it; may be repeated")
      .repeatable();
  verb.option("--stats", layer.stats,
              "write statistics as JSON at exit; %p becomes the process id");
  verb.option("--log", layer.log, "off, error, warn, info, debug, FILE or LEVEL:FILE");
  verb.option("--debug", layer.debug, "debug flags, separated by commas; help lists them");
  verb.option("--replace", layer.replace,
              "a folder of texts named by hash (as capture writes them) that are loaded in "
              "place of the application's, and again when a file changes");
  verb.flag("--control", layer.control,
            "let arbiter ctl and the builder look at the programs and change them while it "
            "runs");
  verb.flagOrValue(
      "--hud", layer.hud,
      "show figures in each frame: version, host, frames a second, draws by path, "
      "programs over native limits; --hud=fps,top-right chooses (docs/reference/flags.md)");
  verb.option("--host-vendor", layer.hostVendor,
              "the GL vendor under the layer, as libglvnd names it (mesa, nvidia)");
  verb.option("--library", layer.library, "the layer's library, where it is not beside us");
  verb.group(kLayerGroup, first);
}

/// Returns the codes of a verb that runs COMMAND and ends as it did.
std::string wrapperCodes() {
  return "that of COMMAND, and the signal that ended it ends this too; " +
         meaningsOf({kExitWrapper, kExitNotExecutable, kExitNoCommand});
}

void addRun(CLI::App &app, RunArguments &run) {
  Verb verb(app, "run",
            "Run a command, and all that it starts, under the layer:\n"
            "arbiter run [OPTIONS] [--] COMMAND [ARGUMENTS...]");
  addLayer(verb, run.layer);
  verb.flag("--print-environment", run.printEnvironment,
            "print the variables for a shell in place of running a command");
  verb.prefixCommand();
  verb.footer("Exit code: " + wrapperCodes() +
              ".\n"
              "Examples:\n"
              "  arbiter run -- glxgears -info\n"
              "  arbiter run --profile nv30 --stats stats-%p.json -- wine game.exe\n"
              "  eval \"$(arbiter run --print-environment --limits report)\"");
}

void addStats(CLI::App &app, StatsArguments &stats) {
  Verb verb(app, "stats",
            "Show the statistics that processes wrote, and their sum; killed processes' are made "
            "of what they left");
  verb.option("FILE", stats.files, "what --stats was; %p stands for any process's number")
      .required();
  verb.flag("--json", stats.json, "as one JSON document");
  verb.footer(
      "A line for each file, and the sum of several: frames, programs, draws by path, and why the "
      "rasterizer gave draws to the driver. docs/reference/statistics.md explains the words and "
      "the files.\n"
      "Exit code: " +
      meaningsOf({kExitOk, kExitUsage}) +
      ".\n"
      "Examples:\n"
      "  arbiter stats /tmp/stats-%p.json\n"
      "  arbiter stats --json game.json server.json");
}

void addCapture(CLI::App &app, CaptureArguments &capture) {
  Verb verb(app, "capture",
            "Run a command under the layer and keep each program that it loads:\n"
            "arbiter capture [-o DIR] [OPTIONS] [--] COMMAND [ARGUMENTS...]");
  verb.option("-o,--output", capture.folder, "the folder to write; COMMAND.capture by default");
  verb.flag("--index-only", capture.indexOnly, "run nothing: make the index of the folder anew");
  addLayer(verb, capture.layer);
  verb.prefixCommand();
  verb.footer("The folder gets HASH.fp, .vp or .atifs for each text, HASH.nvrc and .nvts for "
              "register combiners and texture shaders, their GLSL, a shader_test "
              "for piglit, index.json and index.html. Edit a text there, and\n"
              "  arbiter run --replace DIR -- COMMAND\n"
              "loads it in place of the application's, while it runs too.\n"
              "Exit code: " +
              wrapperCodes() +
              ".\n"
              "Examples:\n"
              "  arbiter capture -o game.capture -- ./game\n"
              "  arbiter capture --index-only -o game.capture");
}

void addCache(CLI::App &app, CacheArguments &cache) {
  Verb verb(app, "cache", "Show where compiled programs are kept on disk, and how many");
  verb.flag("--clear", cache.clear, "remove them");
  verb.flag("--json", cache.json, "as one JSON document");
  verb.footer("ARBITER_CACHE and ARBITER_CACHE_MAX_MB rule the cache; see arbiter(7).\n"
              "Exit code: " +
              meaningsOf({kExitOk, kExitUsage}) +
              ".\n"
              "Examples:\n  arbiter cache\n  arbiter cache --clear");
}

} // namespace arbiter::tools
