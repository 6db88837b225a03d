// The verbs that talk to other processes (ctl, render, lsp, builder), and help.
#include "apps/tools/options/verbs.h"

namespace arbiter::tools {

void addCtl(CLI::App &app, CtlArguments &ctl) {
  Verb verb(app, "ctl",
            "Look at the programs of a process under arbiter run --control, and change them:\n"
            "arbiter ctl [OPTIONS] ACTION [OPERANDS...]");
  verb.option("--pid", ctl.process, "the process; needed where several listen").range(1, 1 << 22);
  verb.flag("--json", ctl.json, "print answers as they came");
  verb.option("-o,--output", ctl.output, "the file that frame, texture and get write");
  verb.option("--timeout", ctl.timeout, "seconds that an answer may take")
      .range(0.001, 3600.0)
      .showDefault();
  verb.option("--for", ctl.holdSeconds,
              "end after so many seconds; by default what an action changed is held until "
              "this is ended")
      .range(0.001, 86400.0);
  verb.option("ACTION", ctl.words, "an action below; or list: the processes that listen")
      .required();
  verb.footer("Actions:\n" + ctlActions() +
              "  -                           actions from standard input, a line each\n"
              "An ID is what programs prints, or as much of its beginning as no other has.\n"
              "What set, param, paint, enable and disable change is undone when this ends; set "
              "follows its file meanwhile.\n"
              "Exit code: " +
              meaningsOf({kExitOk, kExitUsage, kExitInvalid, kExitDiffers}) +
              ".\n"
              "Examples:\n"
              "  arbiter run --control -- ./game &\n"
              "  arbiter ctl programs\n"
              "  arbiter ctl frame -o frame.png\n"
              "  arbiter ctl set 0c51f6.fp water.fp");
}

void addRender(CLI::App &app, RenderArguments &render) {
  Verb verb(app, "render", "Draw documents for another process, which sends them through a socket");
  addLayer(verb, render.layer);
  verb.option("--folder", render.folder, "where files that a document names lie").showDefault();
  verb.option("--fd", render.descriptor,
              "serve the connected socket of this number, and end with it; without, listen "
              "and print where")
      .range(0, 1048576);
  verb.flag("--bare", render.bare, "without the layer: the host's own implementation");
  verb.flag("--in-layer", render.inLayer).hidden(); // render passes it to its own second process
  verb.footer("The builder starts it. The messages are those of docs/write/control.md; frames go "
              "through shared memory.\n"
              "Exit code: " +
              meaningsOf({kExitOk, kExitUsage, kExitNoGl}) +
              ".\n"
              "Example:\n  arbiter render --folder shaders");
}

void addLsp(CLI::App &app, LspArguments &lsp) {
  Verb verb(app, "lsp", "A language server for editors, on standard input and output (LSP 3.17)");
  verb.option("--profile", lsp.profile, kChosenProfileHelp);
  verb.footer(
      "An editor starts it; docs/write/editors.md says how. The profile can be changed while "
      "it runs, by the setting arbiter.profile.\n"
      "Exit code: " +
      meaningsOf({kExitOk, kExitUsage}) + ". An end without shutdown and exit is wrong usage.");
}

void addBuilder(CLI::App &app, BuilderArguments &builder) {
  Verb verb(app, "builder",
            "Open the Shader Builder's window: write programs, see them drawn, step through them");
  verb.option("DOCUMENT", builder.document,
              "a program, or a folder; gallery:NAME opens a copy of a document of the gallery; "
              "without one, the gallery itself");
  const Option screenshot = verb.option(
      "--screenshot", builder.screenshot,
      "write a picture of the window into this PNG when the document is drawn, and end; "
      "without a display too");
  verb.option("--size", builder.size, "WxH: the window's size in the picture; 1280x800 without")
      .needs(screenshot);
  verb.flag("--small", builder.small, "a picture of few colours, for a page").needs(screenshot);
  verb.option("--edit", builder.edit,
              "FROM=>TO: for a picture: replace a piece of the text when it is drawn")
      .needs(screenshot);
  verb.option("--attach", builder.attach, "PID: for a picture: the process to attach to")
      .needs(screenshot);
  const Option pixel =
      verb.option("--pixel", builder.pixel, "X,Y: for a picture: the pixel to debug")
          .needs(screenshot);
  verb.option("--watch", builder.watch,
              "LINE: for a picture: the line whose register is shown as A")
      .needs(pixel);
  verb.option("--panel", builder.panel,
              "NAME: the panel to bring to the front; arbiter-builder(1) lists them");
  verb.option("--colors", builder.colors, "the window's colors").oneOf({"system", "light", "dark"});
  verb.footer(
      "The window is the program arbiter-builder, which needs Qt 6; docs/write/builder_window.md "
      "says what it has.\n"
      "Exit code: " +
      meaningsOf({kExitOk, kExitUsage}) +
      ".\n"
      "Examples:\n"
      "  arbiter builder --screenshot window.png --size 1024x700 shader.fp\n"
      "  arbiter builder\n"
      "  arbiter builder shader.fp\n"
      "  arbiter builder gallery:twirl");
}

void addHelp(CLI::App &app, std::string &verb) {
  Verb help(app, kHelpVerb, "Show the help of a verb, or what verbs there are");
  help.option("VERB", verb, "a verb of arbiter");
  help.footer("Example:\n  arbiter help check");
}

} // namespace arbiter::tools
