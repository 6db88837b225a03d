// Implements the process that draws for the debugger.
#include "apps/tools/commands.h"
#include "apps/tools/debug/draws/server.h"
#include "apps/tools/debug/gl/document_subject.h"
#include "apps/tools/debug/gl/frame_drawer.h"
#include "apps/tools/draw/uses.h"

namespace arbiter::tools {

namespace {

using debug::DebugError;
using debug::Drawer;

/// Opens {path, text, textures, pass, frame}. The text comes from the editor and may differ from
/// the file's.
Result<std::unique_ptr<Drawer>, DebugError> open(const control::Json &what) {
  control::Params params(what);
  scene::Document document =
      scene::assemble(params.text("path"), params.text("text"), scene::readText);
  std::vector<std::string> textures;
  for (const control::Json &each : what.value("textures", control::Json::array()))
    if (each.is_string())
      textures.push_back(each.get<std::string>());
  if (std::string fault = giveTextures(textures, document); !fault.empty())
    return DebugError{std::move(fault)};
  const auto pass = std::size_t(params.integer("pass", 0, INT32_MAX));
  const int frame = int(params.integer("frame", 0, INT32_MAX));
  if (!params.ok() || pass >= document.passes.size())
    return DebugError{"no such pass or frame"};
  return debug::FrameDrawer::open(
      std::make_unique<debug::DocumentSubject>(std::move(document), pass, frame));
}

} // namespace

int drawForDebugger() { return debug::serveDraws(0, open); }

} // namespace arbiter::tools
