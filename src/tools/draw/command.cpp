#include <GL/arbiter.h>
#include <cstdio>
#include <dlfcn.h>

#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"
#include "tools/draw/renderer.h"
#include "tools/draw/uses.h"
#include "tools/input.h"
#include "tools/language.h"
#include "tools/launch.h"
#include "util/flags.h"

namespace arbiter::tools {

namespace {

/// With the file's name and carets. Where the compiler of this command has no complaint (the host
/// alone refused, or the layer runs under other limits), GL's own words at GL's own position.
void explain(const DrawArguments &arguments, const SceneProgram &program,
             const RenderError &error) {
  const auto profile = fp::hw::loadProfile(settings().profile);
  if (!arguments.bare && profile) {
    fp::CompileOptions options;
    options.limits = limitsOf(profile.value(), program.language);
    options.policy = settings().enforceLimits ? fp::LimitPolicy::Enforce : fp::LimitPolicy::Report;
    const fp::CheckResult result = fp::checkProgram(program.language, program.text, options);
    for (const fp::Diagnostic &diagnostic : result.diagnostics)
      std::fputs(fp::render(program.name, program.text, diagnostic).c_str(), stderr);
    if (!result.ok())
      return;
  }
  fp::Diagnostic diagnostic;
  const auto position = std::uint32_t(std::max(0, error.position));
  diagnostic.id = "gl";
  diagnostic.span = {position, position};
  diagnostic.message = error.message.substr(0, error.message.find('\n'));
  std::fputs(fp::render(program.name, program.text, diagnostic).c_str(), stderr);
}

int fail(const DrawArguments &arguments, const Scene &scene, const RenderError &error) {
  switch (error.kind) {
  case RenderError::Kind::Program:
    explain(arguments, scene.programs[error.program], error);
    return kExitInvalid;
  case RenderError::Kind::Scene:
    complain(error.message);
    return kExitUsage;
  case RenderError::Kind::NoGl:
    break;
  }
  complain(error.message);
  return kExitInternal;
}

int drawHere(const DrawArguments &arguments) {
  const auto read = readScene(arguments);
  if (!read) {
    complain(read.error().message);
    return kExitUsage;
  }
  const Scene &scene = read.value();
  if (const std::string fault = faultOfUses(scene); !fault.empty()) {
    complain(fault);
    return kExitUsage;
  }
  const auto rendering = render(scene);
  if (!rendering)
    return fail(arguments, scene, rendering.error());
  for (const std::string &line : unfedSamples(scene))
    complain(line);
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
