#include "common/demo.h"

#include <CLI/CLI.hpp>

namespace demos {
namespace {

std::string footer(Demo &demo) {
  static constexpr const char *kKeys[] = {"Left/Right", "Down/Up", "[ and ]", ", and .", "- and ="};
  const std::string name = demo.name();
  std::string text = "In the window:\n";
  std::size_t i = 0;
  for (const Slider *slider : demo.sliders())
    text += "  " + std::string(kKeys[i++ % std::size(kKeys)]) + "  " + slider->name + "\n";
  text += demo.controls();
  text += "  Space  pause    Escape  close\n"
          "\nExamples:\n"
          "  " +
          name +
          "\n"
          "  " +
          name + " --headless --out " + name +
          ".png\n"
          "  " +
          name +
          " --headless --verify --size 256x256\n"
          "  " +
          name +
          " --headless --bench --frames 100\n"
          "\nExit codes: 0 done, 1 failed, 77 the host has no ARB_fragment_program.";
  return text;
}

/// Parses WIDTHxHEIGHT, each from 1 to 8192.
std::string parseSize(const std::string &text, Options &options) {
  int width = 0, height = 0, used = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &used) != 2 ||
      std::size_t(used) != text.size() || width < 1 || height < 1 || width > 8192 || height > 8192)
    return "is not WIDTHxHEIGHT, each from 1 to 8192: " + text;
  options.width = width;
  options.height = height;
  return {};
}

} // namespace

bool parseOptions(Demo &demo, int argc, char **argv, Options &options, int &exitCode) {
  options.width = options.height = demo.side();
  CLI::App app(demo.summary(), demo.name());
  app.footer(footer(demo));
  app.add_option_function<std::string>(
         "--size",
         [&options](const std::string &text) {
           if (const std::string wrong = parseSize(text, options); !wrong.empty())
             throw CLI::ValidationError("--size", wrong);
         },
         "picture size, by default " + std::to_string(demo.side()) + "x" +
             std::to_string(demo.side()))
      ->type_name("WxH");
  app.add_option("--frames", options.frames, "how many frames to draw")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--out", options.out, "write the last frame")->type_name("FILE.png");
  app.add_option("--program", options.program, "a fragment program in place of the built-in one")
      ->type_name("FILE.fp")
      ->check(CLI::ExistingFile);
  app.add_flag("--headless", options.headless, "draw without a display");
  app.add_flag("--pbuffer", options.pbuffer,
               "with --headless: a pbuffer, not a framebuffer object");
  app.add_flag("--verify", options.verify,
               "compare every frame with a plain C++ computation of it");
  app.add_option("--reference", options.reference,
                 "with --verify: write the last frame so computed")
      ->type_name("FILE.png");
  app.add_flag("--bench", options.bench, "print the median time of a frame as JSON");
  app.add_flag("--paced", options.paced,
               "measure as --bench does, for each line of input the number of frames it says, so "
               "that two processes "
               "can take turns");
  app.add_flag("--info", options.info, "print the renderer and the programs' counts as JSON");
  const std::vector<std::string> forms = demo.forms();
  if (!forms.empty()) {
    options.form = forms.front();
    app.add_option("--form", options.form, "by default " + forms.front())
        ->check(CLI::IsMember(forms));
  }
  for (Slider *slider : demo.sliders())
    app.add_option("--" + slider->name, slider->value, slider->help)
        ->check(CLI::Range(slider->low, slider->high))
        ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError &error) {
    exitCode = app.exit(error) == 0 ? kExitOk : kExitFailed;
    return false;
  }
  return true;
}

} // namespace demos
