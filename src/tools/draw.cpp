#include <GL/arbiter.h>
#include <charconv>
#include <cstdio>
#include <dlfcn.h>

#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"
#include "tools/commands.h"
#include "tools/input.h"
#include "tools/launch.h"
#include "tools/renderer.h"
#include "util/flags.h"

namespace arbiter::tools {

namespace {

constexpr int kMaxSide = 8192;
constexpr int kCheckerSide = 256;

template <typename Number> bool readNumber(std::string_view text, Number &number) {
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  return end.ec == std::errc() && end.ptr == text.data() + text.size();
}

bool readSize(std::string_view text, Scene &scene) {
  const std::size_t mark = text.find('x');
  return mark != std::string_view::npos && readNumber(text.substr(0, mark), scene.width) &&
         readNumber(text.substr(mark + 1), scene.height) && scene.width > 0 && scene.height > 0 &&
         scene.width <= kMaxSide && scene.height <= kMaxSide;
}

/// "N=x,y,z,w"; missing components are 0.
bool readParameter(std::string_view text, Scene::Parameter &parameter) {
  const std::size_t mark = text.find('=');
  if (mark == std::string_view::npos || !readNumber(text.substr(0, mark), parameter.index))
    return false;
  std::string_view list = text.substr(mark + 1);
  for (float &component : parameter.value) {
    const std::size_t comma = std::min(list.find(','), list.size());
    if (!readNumber(list.substr(0, comma), component))
      return false;
    if (comma == list.size())
      return true;
    list.remove_prefix(comma + 1);
  }
  return false; // a fifth component
}

/// \returns an empty string, or what is wrong.
std::string readTexture(const std::string &text, Scene &scene) {
  Scene::Texture texture;
  const std::size_t mark = text.find('=');
  if (mark == std::string::npos ||
      !readNumber(std::string_view(text).substr(0, mark), texture.unit))
    return "--texture " + text + ": expected N=IMG.png, N=checker or N=noise";
  const std::string source = text.substr(mark + 1);
  if (source == "checker") {
    texture.picture = checker(kCheckerSide);
  } else if (source == "noise") {
    texture.picture = noise(scene.width, scene.height);
  } else {
    auto picture = readPng(source);
    if (!picture)
      return picture.error().message;
    texture.picture = std::move(picture).value();
  }
  scene.textures.push_back(std::move(texture));
  return {};
}

/// A feedback unit needs a texture of the picture's size, black where none was asked for.
std::string readFeedback(const DrawArguments &arguments, Scene &scene) {
  scene.feedback = arguments.feedback;
  if (scene.feedback < 0)
    return {};
  for (const Scene::Texture &texture : scene.textures) {
    if (int(texture.unit) != scene.feedback)
      continue;
    if (texture.picture.width != scene.width || texture.picture.height != scene.height)
      return "--feedback " + std::to_string(scene.feedback) +
             ": the texture must have the size of the picture, " + arguments.size;
    return {};
  }
  Picture black{scene.width, scene.height,
                std::vector<std::uint8_t>(std::size_t(4) * scene.width * scene.height)};
  scene.textures.push_back({unsigned(scene.feedback), std::move(black)});
  return {};
}

std::string readScene(const DrawArguments &arguments, Scene &scene) {
  if (!readSize(arguments.size, scene))
    return "--size " + arguments.size + ": expected WxH, 1 to 8192 pixels a side";
  for (const std::string &text : arguments.textures)
    if (std::string fault = readTexture(text, scene); !fault.empty())
      return fault;
  for (const auto &[list, parameters, option] :
       {std::tuple(&arguments.locals, &scene.locals, "--local "),
        std::tuple(&arguments.envs, &scene.envs, "--env ")}) {
    for (const std::string &text : *list) {
      if (!readParameter(text, parameters->emplace_back()))
        return option + text + ": expected N=x,y,z,w";
    }
  }
  scene.frames = arguments.frames;
  auto program = readInput(arguments.file);
  if (!program)
    return program.error().message;
  scene.program = std::move(program).value();
  return readFeedback(arguments, scene);
}

/// With the file's name and carets. Where the compiler of this command has no complaint (the host
/// alone refused, or the layer runs under other limits), GL's own words at GL's own position.
void explain(const DrawArguments &arguments, const Scene &scene, const RenderError &error) {
  const std::string name = arguments.file == "-" ? "<stdin>" : arguments.file;
  const auto profile = fp::hw::loadProfile(settings().profile);
  if (!arguments.bare && profile) {
    fp::CompileOptions options;
    options.limits = profile.value().fragment;
    options.policy = settings().enforceLimits ? fp::LimitPolicy::Enforce : fp::LimitPolicy::Report;
    const fp::CheckResult result = fp::checkFragmentProgram(scene.program, options);
    for (const fp::Diagnostic &diagnostic : result.diagnostics)
      std::fputs(fp::render(name, scene.program, diagnostic).c_str(), stderr);
    if (!result.ok())
      return;
  }
  fp::Diagnostic diagnostic;
  const auto position = std::uint32_t(std::max(0, error.position));
  diagnostic.id = "gl";
  diagnostic.span = {position, position};
  diagnostic.message = error.message.substr(0, error.message.find('\n'));
  std::fputs(fp::render(name, scene.program, diagnostic).c_str(), stderr);
}

int drawHere(const DrawArguments &arguments) {
  Scene scene;
  if (const std::string fault = readScene(arguments, scene); !fault.empty()) {
    complain(fault);
    return kExitUsage;
  }
  const auto rendering = render(scene);
  if (!rendering) {
    const RenderError &error = rendering.error();
    switch (error.kind) {
    case RenderError::Kind::Program:
      explain(arguments, scene, error);
      return kExitInvalid;
    case RenderError::Kind::Scene:
      complain(error.message);
      return kExitUsage;
    case RenderError::Kind::NoGl:
      complain(error.message);
      return kExitInternal;
    }
  }
  if (const std::string fault = writePng(arguments.output, rendering.value().picture);
      !fault.empty()) {
    complain(fault);
    return kExitUsage;
  }
  std::printf("%s: %dx%d on %s", arguments.output.c_str(), scene.width, scene.height,
              rendering.value().renderer.c_str());
  if (scene.frames > 1)
    std::printf(", %d frames, %.3f ms a frame", scene.frames,
                rendering.value().millisecondsPerFrame);
  std::printf("\n");
  return kExitOk;
}

} // namespace

int draw(const DrawArguments &arguments, const std::vector<std::string> &argv) {
  if (arguments.bare)
    return drawHere(arguments);
  if (arguments.inLayer) {
    // RTLD_NOLOAD: a handle only if the preload worked, so that no picture of the bare host is
    // ever passed off as the layer's.
    if (::dlopen(ARBITER_PRELOAD_LIBRARY, RTLD_NOLOAD | RTLD_LAZY) == nullptr) {
      complain("the layer was not loaded into this process");
      return kExitInternal;
    }
    return drawHere(arguments);
  }
  const auto files = findLayer(arguments.layer.library);
  if (!files) {
    complain(files.error().message);
    return kExitUsage;
  }
  const auto environment = layerEnvironment(files.value(), arguments.layer);
  if (!environment) {
    complain(environment.error().message);
    return kExitUsage;
  }
  std::vector<std::string> command = argv;
  command[0] = "/proc/self/exe"; // argv[0] may be relative to a PATH of another time
  command.insert(command.begin() + 2, "--in-layer");
  return execute(environment.value(), command);
}

} // namespace arbiter::tools
