// The process that draws for the debugger.
#include <GL/arbiter.h>
#include <dlfcn.h>

#include "tools/commands.h"
#include "tools/debug/draws/server.h"
#include "tools/debug/gl/frame_drawer.h"
#include "tools/debug/gl/scene_subject.h"

namespace arbiter::tools {

namespace {

using debug::DebugError;
using debug::Drawer;

Result<std::unique_ptr<Drawer>, DebugError> open(const nlohmann::json &what) {
  DrawArguments arguments;
  arguments.files = {what.value("path", std::string())};
  arguments.frames = what.value("frame", 1);
  auto scene = readScene(arguments);
  if (!scene)
    return DebugError{scene.error().message};
  return debug::FrameDrawer::open(
      std::make_unique<debug::SceneSubject>(std::move(scene).value()));
}

} // namespace

int drawForDebugger() {
  return debug::serveDraws(0, open);
}

} // namespace arbiter::tools
