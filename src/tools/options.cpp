#include "tools/options.h"

#include <GL/arbiter.h>

#include "tools/language.h"
#include "util/flags.h"

namespace arbiter::tools {

namespace {

constexpr const char *kProfileHelp = "a profile's name (arbiter profiles), or a TOML file";
constexpr const char *kChosenProfileHelp =
    "a profile's name (arbiter profiles), or a TOML file; by default the one that a text's panel "
    "names, else ARBITER_PROFILE's, else r300";

void addLanguage(CLI::App &command, std::string &language) {
  command
      .add_option("--language", language,
                  "auto: as the header says; or the language to hold the program to")
      ->check(CLI::IsMember(languageNames()))
      ->capture_default_str();
}

void addCheck(CLI::App &app, CheckArguments &check) {
  CLI::App *command = app.add_subcommand(
      "check", "Check programs: errors with line and column, counts against limits");
  command
      ->add_option("--profile", check.profiles,
                   std::string(kChosenProfileHelp) +
                       "; all: every card, a row a file, a column a card")
      ->allow_extra_args(false)
      ->take_all();
  command
      ->add_option("--limits", check.limits,
                   "a program over the API limits: enforce: invalid; report: a warning")
      ->check(CLI::IsMember({"enforce", "report"}))
      ->capture_default_str();
  addLanguage(*command, check.language);
  command->add_flag("--json", check.json, "one JSON document for all files");
  CLI::Option *brief =
      command->add_flag("--brief", check.brief, "one line a diagnostic, no counts");
  CLI::Option *why = command->add_flag(
      "--why", check.why, "every reason, texture node, dependent read and cost, for every file");
  CLI::Option *advise = command->add_flag(
      "--advise", check.advise,
      "what would cost less on the profile's card: each compiled, and run beside the program");
  CLI::Option *fix = command
                         ->add_flag("--fix", check.fix,
                                    "make every such change of --advise that the program alone "
                                    "decides, in the files")
                         ->needs(advise);
  command
      ->add_flag("--compare", check.compare,
                 "two files side by side, or one under two profiles (--profile twice)")
      ->excludes(brief)
      ->excludes(why)
      ->excludes(advise)
      ->excludes(fix);
  command
      ->add_option("--gauges", check.gauges,
                   "auto: blocks on a UTF-8 terminal; always: into a file too, and a table for "
                   "each of many files; never: numbers alone")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
  command
      ->add_option("FILE", check.files,
                   "program texts, or folders of them and of captures; - is standard input")
      ->required();
  command->footer("Up to eight files get a table each; more, or a folder, the lines of what is "
                  "wrong and a summary.\n"
                  "Exit code: 0 valid; 1 usage, or a file cannot be read; 2 invalid; 3 valid but "
                  "over the native limits; 4 internal error. The worst file decides.\n"
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
  CLI::App *command = app.add_subcommand("compile", "Show what the compiler makes of a program");
  command->add_option("--profile", compile.profile, kChosenProfileHelp);
  command
      ->add_option("--emit", compile.emit,
                   "tokens, ir (checked program), assembly (plain text), glsl (1.20), native "
                   "(as the profile's card runs it, where that is modelled), llvm or machine "
                   "(the rasterizer's code)")
      ->check(CLI::IsMember({"tokens", "ir", "assembly", "glsl", "native", "llvm", "machine"}))
      ->capture_default_str();
  addLanguage(*command, compile.language);
  command->add_flag("--optimise,-O", compile.optimise, "ir, assembly: after the passes");
  command
      ->add_option("--numerics", compile.numerics,
                   "glsl, llvm, machine, and the passes: for this arithmetic")
      ->check(CLI::IsMember({"host", "legacy", "fp24"}))
      ->capture_default_str();
  command->add_option("-o,--output", compile.output, "file to write; - is standard output")
      ->capture_default_str();
  command->add_option("FILE", compile.file, "a program text; - is standard input")->required();
  command->footer("Exit code: as for check, without 3.\n"
                  "Examples:\n"
                  "  arbiter compile --emit glsl shader.fp\n"
                  "  arbiter compile --emit ir -O shader.fp -o shader.ir");
}

void addLayer(CLI::App &command, LayerArguments &layer) {
  const std::size_t first = command.get_options({}).size();
  command.add_option("--profile", layer.profile, kProfileHelp);
  command
      .add_option("--limits", layer.limits,
                  "programs over the API limits: enforce refuses them, report loads them")
      ->check(CLI::IsMember({"enforce", "report"}));
  command
      .add_option("--identity", layer.identity,
                  "whom GL says it is: the host, or the profile's card and driver, with its limits")
      ->check(CLI::IsMember({"host", "profile"}));
  command
      .add_option("--numerics", layer.numerics,
                  "how programs compute: as the host; legacy: 0 times infinity is 0; fp24: 24-bit "
                  "floats")
      ->check(CLI::IsMember({"host", "legacy", "fp24"}));
  command
      .add_option("--backend", layer.backend,
                  "who draws with programs: auto; the host; swrast, Arbiter's own rasterizer")
      ->check(CLI::IsMember({"auto", "host", "swrast"}));
  command
      .add_option(
          "--fixed-function", layer.fixedFunction,
          "whose draws without a program are: the rasterizer's once a program has been drawn, "
          "or always")
      ->check(CLI::IsMember({"programs", "always"}));
  command
      .add_option("--extensions-max-year", layer.extensionsMaxYear,
                  "announce no extension of a later year")
      ->check(CLI::Range(1992, 9999));
  command
      .add_option("--extensions-max-length", layer.extensionsMaxLength,
                  "keep the oldest extensions, as many as fit into this many bytes of the string")
      ->check(CLI::Range(1, 1048576));
  command.add_option("--stats", layer.stats,
                     "write statistics as JSON at exit; %p becomes the process id");
  command.add_option("--log", layer.log, "off, error, warn, info, debug, FILE or LEVEL:FILE");
  command.add_option("--debug", layer.debug, "debug flags, separated by commas; help lists them");
  command.add_option("--replace", layer.replace,
                     "a folder of texts named by hash (as capture writes them) that are loaded in "
                     "place of the application's, and again when a file changes");
  command.add_flag("--control", layer.control,
                   "let arbiter ctl and the builder look at the programs and change them while it "
                   "runs");
  command.add_flag("--hud", layer.hud,
                   "show frame time, draws by path and programs over native limits in each frame");
  command.add_option("--host-vendor", layer.hostVendor,
                     "the GL vendor under the layer, as libglvnd names it (mesa, nvidia)");
  command.add_option("--library", layer.library, "the layer's library, where it is not beside us");
  const std::vector<CLI::Option *> options = command.get_options({});
  for (std::size_t i = first; i < options.size(); ++i)
    options[i]->group(kLayerGroup);
}

void addDraw(CLI::App &app, DrawArguments &draw) {
  CLI::App *command = app.add_subcommand(
      "draw",
      "Draw a document, or programs on a mesh, through the layer, with no display, into a PNG");
  addLayer(*command, draw.layer);
  command->add_option("--size", draw.size,
                      "WxH in pixels, in place of the document's or of 512x512");
  command
      ->add_option("--texture", draw.textures,
                   "N=IMG.png, N=checker or N=noise: the 2D texture of unit N (repeatable)")
      ->allow_extra_args(false)
      ->take_all();
  command
      ->add_option(
          "--mesh", draw.mesh,
          "what carries the programs, in place of the document's or of a quad; a grid is 64x64 of "
          "them, for vertex programs to bend")
      ->check(CLI::IsMember(
          {"quad", "grid", "plane", "cube", "sphere", "torus", "cylinder", "knot", "billboards"}));
  const auto addValues = [&](const char *name, std::vector<std::string> &values, const char *help) {
    command->add_option(name, values, help)->allow_extra_args(false)->take_all();
  };
  addValues("--local", draw.locals,
            "[vp:|fp:]N=x,y,z,w: program.local[N], of one program or of both (repeatable)");
  addValues("--env", draw.envs, "[vp:|fp:]N=x,y,z,w: program.env[N], likewise (repeatable)");
  addValues("--attrib", draw.attribs, "N=x,y,z,w: vertex.attrib[N] of every vertex (repeatable)");
  command->add_option("--frames", draw.frames, "draw this many times; the last picture is kept")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command
      ->add_option("--frame", draw.frame,
                   "draw the frame of this number, from 0, of an animation; with feedback those "
                   "before it too")
      ->check(CLI::Range(0, 1000000))
      ->excludes("--frames");
  command
      ->add_option("--feedback", draw.feedback,
                   "copy each frame into the texture of this unit (glCopyTexSubImage2D)")
      ->check(CLI::Range(0, 31));
  command->add_option(
      "-o,--output", draw.output,
      "the PNG to write; without it the document's name with the ending .png, here");
  command->add_flag("--json", draw.json, "say what was drawn as JSON");
  command->add_flag("--bare", draw.bare, "without the layer: the host's own implementation");
  command->add_flag("--in-layer", draw.inLayer)->group(""); // what draw passes to itself
  command
      ->add_option(
          "FILE", draw.files,
          "a document: a program text (!!ARBfp1.0, !!ARBvp1.0, !!ATIfs1.0) whose lines that begin "
          "with #@ say what it is drawn with, or a folder of one; or a program of vertices and "
          "one of fragments; - is standard input")
      ->required()
      ->expected(1, 2);
  command->footer("The mesh fills the picture; every texture coordinate set runs from 0 to 1 with "
                  "y up, the primary colour is (s, t, 0, 1). A stage without a program is fixed "
                  "function's.\n"
                  "An image or a value that no program reads is an error; a sample of a unit "
                  "without an image is black, and is said.\n"
                  "Exit code: 0 drawn; 1 usage or a file; 2 the program or its panel is invalid; "
                  "4 no GL.\n"
                  "Examples:\n"
                  "  arbiter draw twirl.fp --frame 30 -o out.png\n"
                  "  arbiter draw shader.fp -o out.png\n"
                  "  arbiter draw --mesh grid waves.vp water.fp --local vp:0=0.5 -o out.png\n"
                  "  arbiter draw --texture 0=photo.png --local 0=0.5,1,0,0 shader.fp -o out.png\n"
                  "  arbiter draw --size 256x256 --texture 0=noise --feedback 0 --frames 100 "
                  "life.fp -o life.png");
}

void addDebugComparison(CLI::App &command, DebugArguments &debug) {
  command
      .add_option("--against", debug.against,
                  "whose picture the interpreter is compared with: swrast (the rasterizer), host "
                  "(GLSL on the host), bare (the host's own implementation); fp24 (the other "
                  "arithmetic alone); or another program's file")
      ->capture_default_str();
  command.add_option("--break", debug.breakOn,
                     "stop at the first row with nan, inf, unwritten, over1, below0, kil, differs, "
                     "or where a value is so: 'REG.x>0.5'");
  command.add_option("--line", debug.line, "run to this line and stop")->check(CLI::PositiveNumber);
  CLI::Option *watch = command.add_option(
      "--watch", debug.watch, "REG@LINE: any register after any line, over the whole picture");
  command.add_option("--range", debug.range, "LOW,HIGH: values of --watch that become 0 and 255")
      ->needs(watch)
      ->capture_default_str();
  watch->needs(
      command.add_option("-o,--output", debug.output, "the PNG that --watch writes")->needs(watch));
}

void addDebug(CLI::App &app, DebugArguments &debug) {
  CLI::App *command = app.add_subcommand(
      "debug", "Show what a program does for one pixel: each instruction, its operands and result");
  command->add_option("--pixel", debug.pixel, "X,Y: the pixel; 0,0 is the lower left one")
      ->required();
  command->add_flag("--from-top", debug.fromTop, "Y counts from the picture's upper edge");
  command
      ->add_option("--stage", debug.stage,
                   "whose instructions: fragment; or vertex, those of "
                   "the pixel's triangle")
      ->check(CLI::IsMember({"fragment", "vertex"}))
      ->capture_default_str();
  command->add_option("--pass", debug.pass, "which of the document's passes, from 1")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
  command->add_option("--frame", debug.frame, "which frame, from 0")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  addDebugComparison(*command, debug);
  command->add_flag("--json", debug.json, "the whole trace as one JSON document");
  command->add_option("--profile", debug.profile, kProfileHelp);
  command
      ->add_option("--numerics", debug.numerics,
                   "the arithmetic to show; fp24 and host beside each other")
      ->check(CLI::IsMember({"host", "legacy", "fp24"}));
  command->add_option("--library", debug.library, "the layer's library, where it is not beside us");
  command
      ->add_option("FILE", debug.document,
                   "a document: a program text, or a folder with one; - is standard input")
      ->required();
  command->footer(
      "Exit code: 0 equal; 1 usage, a file, or nothing covers the pixel; 2 the program "
      "is invalid; 4 no GL, or a fault; 5 a comparison found a difference, or --break a "
      "row.\n"
      "Examples:\n"
      "  arbiter debug twirl.fp --pixel 100,200\n"
      "  arbiter debug twirl.fp --pixel 100,200 --against host\n"
      "  arbiter debug wrong.fp --pixel 8,8 --against right.fp\n"
      "  arbiter debug twirl.fp --pixel 8,8 --break nan\n"
      "  arbiter debug twirl.fp --pixel 0,0 --watch offset@10 --range -1,1 -o offset.png");
}

void addRun(CLI::App &app, RunArguments &run) {
  CLI::App *command =
      app.add_subcommand("run", "Run a command, and all that it starts, under the layer:\n"
                                "arbiter run [OPTIONS] [--] COMMAND [ARGUMENTS...]");
  addLayer(*command, run.layer);
  command->add_flag("--print-environment", run.printEnvironment,
                    "print the variables for a shell in place of running a command");
  command->prefix_command();
  command->footer("Exit code: that of COMMAND, which ends by a signal where COMMAND does; 1 usage; "
                  "126 COMMAND cannot be executed; 127 there "
                  "is no such command.\n"
                  "Examples:\n"
                  "  arbiter run -- glxgears -info\n"
                  "  arbiter run --profile nv30 --stats stats-%p.json -- wine game.exe\n"
                  "  eval \"$(arbiter run --print-environment --limits report)\"");
}

void addStats(CLI::App &app, StatsArguments &stats) {
  CLI::App *command = app.add_subcommand(
      "stats", "Make the statistics of processes that were killed, from what they left behind");
  command
      ->add_option("FILE", stats.file, "what ARBITER_STATS was; %p stands for any process's number")
      ->required();
  command->footer("What `arbiter run` starts needs no such step. Prints how many were made.\n"
                  "Exit code: 0 some were; 1 usage, or there was nothing to be made.\n"
                  "Example:\n"
                  "  arbiter stats /tmp/stats-%p.json");
}

void addCapture(CLI::App &app, CaptureArguments &capture) {
  CLI::App *command = app.add_subcommand(
      "capture", "Run a command under the layer and keep each program that it loads:\n"
                 "arbiter capture [-o DIR] [OPTIONS] [--] COMMAND [ARGUMENTS...]");
  command->add_option("-o,--output", capture.folder,
                      "the folder to write; COMMAND.capture by default");
  command->add_flag("--index-only", capture.indexOnly,
                    "run nothing: make the index of the folder anew");
  addLayer(*command, capture.layer);
  command->prefix_command();
  command->footer("The folder gets HASH.fp, .vp or .atifs for each text, its GLSL, a shader_test "
                  "for piglit, index.json and index.html. Edit a text there, and\n"
                  "  arbiter run --replace DIR -- COMMAND\n"
                  "loads it in place of the application's, while it runs too.\n"
                  "Exit code: that of COMMAND, or 128 and the signal that ended it; 1 usage or a "
                  "file; 126 COMMAND cannot be executed; 127 there is no such command.\n"
                  "Examples:\n"
                  "  arbiter capture -o game.capture -- ./game\n"
                  "  arbiter capture --index-only -o game.capture");
}

void addReport(CLI::App &app, ReportArguments &report) {
  CLI::App *command = app.add_subcommand(
      "report", "Write one HTML page about a set of programs: what fits, what not, and why");
  command->add_option("-o,--output", report.output, "the page to write; - is standard output")
      ->capture_default_str();
  command->add_option("--profile", report.profile,
                      std::string(kProfileHelp) + "; by default the capture's, or as for check");
  command->add_option("--json", report.json, "write the same as JSON too; - is standard output");
  command
      ->add_option("FILE", report.operands,
                   "program texts, folders of them, or the folder of one capture")
      ->required();
  command->footer("The page needs nothing beside it and asks nothing of a network. Its address "
                  "keeps how the table is sorted and filtered: page.html#sort=cycles&filter=water\n"
                  "Exit code: 0 written, whatever the programs are; 1 usage, no program, or a file "
                  "that cannot be read or written; 4 internal error.\n"
                  "Examples:\n"
                  "  arbiter report shaders -o shaders.html\n"
                  "  arbiter report game.capture --profile nv30 -o game.html --json game.json");
}

void addProfiles(CLI::App &app, ProfilesArguments &profiles) {
  CLI::App *command =
      app.add_subcommand("profiles", "List the hardware profiles, or print one with its sources");
  command->add_option("NAME", profiles.name, "a name, or a TOML file");
  command->footer("Examples:\n  arbiter profiles\n  arbiter profiles r300 > mine.toml");
}

void addCache(CLI::App &app, CacheArguments &cache) {
  CLI::App *command =
      app.add_subcommand("cache", "Show where compiled programs are kept on disk, and how many");
  command->add_flag("--clear", cache.clear, "remove them");
  command->footer("ARBITER_CACHE and ARBITER_CACHE_MAX_MB rule the cache; see arbiter(7).\n"
                  "Examples:\n  arbiter cache\n  arbiter cache --clear");
}

void addCtl(CLI::App &app, CtlArguments &ctl) {
  CLI::App *command = app.add_subcommand(
      "ctl", "Look at the programs of a process under arbiter run --control, and change them:\n"
             "arbiter ctl [OPTIONS] ACTION [OPERANDS...]");
  command->add_option("--pid", ctl.process, "the process; needed where several listen")
      ->check(CLI::Range(1, 1 << 22));
  command->add_flag("--json", ctl.json, "print answers as they came");
  command->add_option("-o,--output", ctl.output, "the file that frame, texture and get write");
  command->add_option("--timeout", ctl.timeout, "seconds that an answer may take")
      ->check(CLI::Range(0.001, 3600.0))
      ->capture_default_str();
  command
      ->add_option("--for", ctl.holdSeconds,
                   "end after so many seconds; by default what an action changed is held until "
                   "this is ended")
      ->check(CLI::Range(0.001, 86400.0));
  command->add_option("ACTION", ctl.words, "list: the processes that listen; or an action below")
      ->required();
  command->footer("Actions:\n" + ctlActions() +
                  "  -                           actions from standard input, a line each\n"
                  "What set, param, paint, enable and disable change is undone when this ends; set "
                  "follows its file meanwhile.\n"
                  "Exit code: 0; 1 usage, no such process, or no answer; 2 a text is not valid.\n"
                  "Examples:\n"
                  "  arbiter run --control -- ./game &\n"
                  "  arbiter ctl programs\n"
                  "  arbiter ctl frame -o frame.png\n"
                  "  arbiter ctl set 0c51f6.fp water.fp");
}

void addRender(CLI::App &app, RenderArguments &render) {
  CLI::App *command = app.add_subcommand(
      "render", "Draw documents for another process, which sends them through a socket");
  addLayer(*command, render.layer);
  command->add_option("--folder", render.folder, "where files that a document names lie")
      ->capture_default_str();
  command
      ->add_option("--fd", render.descriptor,
                   "serve the connected socket of this number, and end with it; without, listen "
                   "and print where")
      ->check(CLI::Range(0, 1048576));
  command->add_flag("--bare", render.bare, "without the layer: the host's own implementation");
  command->add_flag("--in-layer", render.inLayer)->group(""); // what render passes to itself
  command->footer("The builder starts it. The messages are those of docs/control.md; frames go "
                  "through shared memory.\n"
                  "Exit code: 0 the client is gone; 1 usage, or no socket; 4 no GL.\n"
                  "Example:\n  arbiter render --folder shaders");
}

void addLsp(CLI::App &app, LspArguments &lsp) {
  CLI::App *command = app.add_subcommand(
      "lsp", "A language server for editors, on standard input and output (LSP 3.17)");
  command->add_option("--profile", lsp.profile, kChosenProfileHelp);
  command->footer("An editor starts it; docs/editors.md says how. The profile can be changed while "
                  "it runs, by the setting arbiter.profile.\n"
                  "Exit code: 0 after shutdown and exit; 1 otherwise.");
}

void addBuilder(CLI::App &app, BuilderArguments &builder) {
  CLI::App *command = app.add_subcommand(
      "builder",
      "Open the Shader Builder's window: write programs, see them drawn, step through them");
  command->add_option("DOCUMENT", builder.document,
                      "a program, or a folder; without one, the gallery");
  command->footer(
      "The window is the program arbiter-builder, which needs Qt 6; docs/builder_window.md "
      "says what it has.\n"
      "Exit code: that of the window; 1 where arbiter-builder is not installed.\n"
      "Examples:\n"
      "  arbiter builder\n"
      "  arbiter builder shader.fp");
}

} // namespace

void addVerbs(CLI::App &app, Arguments &arguments) {
  addCheck(app, arguments.check);
  addCompile(app, arguments.compile);
  addDraw(app, arguments.draw);
  addDebug(app, arguments.debug);
  addRun(app, arguments.run);
  addStats(app, arguments.stats);
  addCapture(app, arguments.capture);
  addReport(app, arguments.report);
  addProfiles(app, arguments.profiles);
  addCache(app, arguments.cache);
  addCtl(app, arguments.ctl);
  addRender(app, arguments.render);
  addLsp(app, arguments.lsp);
  app.add_subcommand(kDrawsVerb, "")->group("");
  addBuilder(app, arguments.builder);
}

} // namespace arbiter::tools
