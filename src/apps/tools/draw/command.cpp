#include <GL/arbiter.h>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "apps/tools/check/rendered.h"
#include "apps/tools/draw/drawing.h"
#include "apps/tools/draw/renderer.h"
#include "apps/tools/draw/uses.h"
#include "apps/tools/input.h"
#include "apps/tools/language.h"
#include "apps/tools/launch/in_layer.h"
#include "control/attached.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"
#include "util/flags.h"

namespace arbiter::tools {

namespace {

void print(const scene::ProgramFile &file, const std::vector<fp::Diagnostic> &diagnostics) {
  std::fputs(rendered(file.name, file.text, diagnostics, styleOfErrors()).c_str(), stderr);
}

/// Warns if the profile's card has no programs of a document's language. The layer still draws
/// them.
void warnOfLack(const scene::Document &document) {
  const auto profile = fp::hw::loadProfile(settings().profile);
  if (!profile)
    return;
  for (const scene::ProgramFile &file : document.files) {
    const fp::Limits limits = limitsOf(profile.value(), file.language);
    if (hasPrograms(limits, file.language))
      continue;
    complain(profile.value().name + ": " + std::string(lackOf(limits, file.language)) +
             "; this picture is the layer's alone");
    return;
  }
}

/// Prints the errors of a program with the file's name and carets. If this command's compiler finds
/// none, prints GL's message at GL's position. That happens if only the host rejects the program,
/// or if the layer's limits differ.
void explain(const DrawArguments &arguments, const scene::ProgramFile &program,
             const RenderError &error) {
  const auto profile = fp::hw::loadProfile(settings().profile);
  if (!arguments.bare && profile) {
    fp::CompileOptions options;
    options.limits = limitsOf(profile.value(), program.language);
    options.policy = settings().enforceLimits ? fp::LimitPolicy::Enforce : fp::LimitPolicy::Report;
    const fp::CheckResult result = fp::checkProgramIn(program.text, program.program(), options);
    print(program, result.diagnostics);
    if (!result.ok())
      return;
  }
  fp::Diagnostic diagnostic;
  const auto position = program.place.begin + std::uint32_t(std::max(0, error.position));
  diagnostic.id = "gl";
  diagnostic.span = {position, position};
  diagnostic.message = error.message.substr(0, error.message.find('\n'));
  print(program, {diagnostic});
}

int fail(const DrawArguments &arguments, const scene::Document &document,
         const RenderError &error) {
  const scene::ProgramFile &file = document.files[error.file];
  switch (error.kind) {
  case RenderError::Kind::Program:
    explain(arguments, file, error);
    return kExitInvalid;
  case RenderError::Kind::Panel:
    if (error.span.end == 0) { // an option has no position in a text
      complain(error.message);
      return kExitUsage;
    }
    print(file, {{fp::Severity::Error, "panel_draw", error.span, error.message, {}}});
    return kExitInvalid;
  case RenderError::Kind::NoGl:
    break;
  }
  complain(error.message);
  return kExitNoGl;
}

/// Returns the output file. Without -o it is the document's name with the ending .png, in the
/// working folder.
std::string outputOf(const DrawArguments &arguments, const scene::Document &document) {
  if (!arguments.output.empty())
    return arguments.output;
  std::string name = document.files.front().name;
  name = name.substr(name.rfind('/') + 1);
  return name.substr(0, name.rfind('.')) + ".png";
}

void report(const DrawArguments &arguments, const Drawing &drawing, const Rendering &rendering,
            const std::string &output) {
  const scene::Document &document = drawing.document;
  if (arguments.json) {
    nlohmann::ordered_json json;
    json["schema"] = ARBITER_DRAW_SCHEMA;
    json["document"] = document.files.front().name;
    json["picture"] = output;
    json["width"] = document.width();
    json["height"] = document.height();
    json["frame"] = drawing.last;
    json["passes"] = document.passes.size();
    json["renderer"] = rendering.renderer;
    if (drawing.first < drawing.last)
      json["milliseconds_per_frame"] = rendering.millisecondsPerFrame;
    const auto replace = nlohmann::ordered_json::error_handler_t::replace;
    std::printf("%s\n", json.dump(2, ' ', false, replace).c_str());
    return;
  }
  std::printf("%s: %dx%d on %s", output.c_str(), document.width(), document.height(),
              rendering.renderer.c_str());
  if (drawing.first < drawing.last)
    std::printf(", %d frames, %.3f ms a frame", drawing.last - drawing.first + 1,
                rendering.millisecondsPerFrame);
  std::printf("\n");
}

/// True if viewers, which mix pixels with a background, show another picture than was drawn. One
/// step below alpha 1 cannot be seen, and where nothing was drawn a background is expected.
bool looksMixed(const scene::Picture &picture) {
  for (std::size_t at = 0; at + 4 <= picture.bytes.size(); at += 4) {
    const auto *const pixel = &picture.bytes[at];
    const bool cleared = pixel[0] == 0 && pixel[1] == 0 && pixel[2] == 0 && pixel[3] == 0;
    if (pixel[3] < 254 && !cleared)
      return true;
  }
  return false;
}

void makeOpaque(scene::Picture &picture) {
  for (std::size_t at = 3; at < picture.bytes.size(); at += 4)
    picture.bytes[at] = 255;
}

int drawHere(const DrawArguments &arguments) {
  const auto read = readDrawing(arguments);
  if (!read) {
    complain(read.error().message);
    return kExitUsage;
  }
  const Drawing &drawing = read.value();
  const scene::Document &document = drawing.document;
  for (const scene::ProgramFile &file : document.files)
    print(file, file.panel.diagnostics);
  if (!document.ok())
    return kExitInvalid;
  if (const std::string fault = faultOfUses(drawing); !fault.empty()) {
    complain(fault);
    return kExitUsage;
  }
  if (arguments.output.empty() && arguments.files.front() == "-") {
    complain("standard input has no name that the picture could have: -o PNG gives one");
    return kExitUsage;
  }
  if (!arguments.bare)
    warnOfLack(document);
  auto rendering = render(document, drawing.first, drawing.last);
  if (!rendering)
    return fail(arguments, document, rendering.error());
  for (const std::string &line : unfedSamples(document))
    complain(line);
  const std::string output = outputOf(arguments, document);
  scene::Picture &picture = rendering.value().picture;
  const bool mixed = !arguments.opaque && looksMixed(picture);
  if (arguments.opaque)
    makeOpaque(picture);
  if (const std::string fault = scene::writePng(output, picture); !fault.empty()) {
    complain(fault);
    return kExitUsage;
  }
  if (mixed)
    complain(output + ": alpha is not 1 everywhere, and viewers mix such pixels with a background; "
                      "--opaque writes 1");
  report(arguments, drawing, rendering.value(), output);
  return kExitOk;
}

/// Copies standard input, so that two processes can read it: this one, for the document's settings,
/// and the one that draws.
bool keepInput(std::string &text) {
  auto input = readInput("-");
  if (!input) {
    complain(input.error().message);
    return false;
  }
  text = std::move(input).value();
  const control::Descriptor file =
      control::memoryOf({reinterpret_cast<const std::uint8_t *>(text.data()), text.size()});
  const bool good = file && ::dup2(file.get(), STDIN_FILENO) >= 0;
  if (!good)
    complain("standard input cannot be kept");
  return good;
}

/// Takes the document's profile and numerics unless the command line sets them.
bool takeSettings(const DrawArguments &arguments, LayerArguments &layer) {
  scene::Document document;
  if (std::find(arguments.files.begin(), arguments.files.end(), "-") != arguments.files.end()) {
    std::string text;
    if (!keepInput(text))
      return false;
    document = scene::assemble("", std::move(text), scene::readText);
  } else if (auto loaded = scene::loadDocument(arguments.files.front())) {
    document = std::move(loaded).value();
  } else {
    return true; // the drawing process reports the error
  }
  if (layer.profile.empty())
    layer.profile = document.profile();
  if (layer.numerics.empty())
    layer.numerics = document.panel().numerics.text;
  return true;
}

/// Adds "steady", so that the picture does not depend on the machine's load.
/// \param debug from the command line; empty: from the environment
std::string withSteady(std::string debug) {
  if (const char *const inherited = std::getenv(ARBITER_ENV_DEBUG); debug.empty() && inherited)
    debug = inherited;
  return debug.empty() ? "steady" : debug + ",steady";
}

} // namespace

int draw(const DrawArguments &arguments, const std::vector<std::string> &argv) {
  if (arguments.bare)
    return drawHere(arguments);
  if (arguments.inLayer)
    return isInLayer() ? drawHere(arguments) : int(kExitInternal);
  LayerArguments layer = arguments.layer;
  if (!takeSettings(arguments, layer))
    return kExitUsage;
  layer.debug = withSteady(layer.debug);
  return executeInLayer(layer, argv);
}

} // namespace arbiter::tools
