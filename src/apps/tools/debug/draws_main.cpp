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
using nlohmann::json;

std::string stringAt(const json &what, const char *name) {
  const auto found = what.find(name);
  return found != what.end() && found->is_string() ? found->get<std::string>() : std::string();
}

int integerAt(const json &what, const char *name) {
  const auto found = what.find(name);
  return found != what.end() && found->is_number_integer() ? found->get<int>() : -1;
}

std::vector<std::string> stringsAt(const json &what, const char *name) {
  std::vector<std::string> strings;
  for (const json &each : what.value(name, json::array()))
    if (each.is_string())
      strings.push_back(each.get<std::string>());
  return strings;
}

/// Opens {path, text, textures, pass, frame}. The text comes from the editor and may differ from
/// the file's.
Result<std::unique_ptr<Drawer>, DebugError> open(const json &what) {
  if (!what.is_object())
    return DebugError{"nothing to open"};
  scene::Document document =
      scene::assemble(stringAt(what, "path"), stringAt(what, "text"), scene::readText);
  if (std::string fault = giveTextures(stringsAt(what, "textures"), document); !fault.empty())
    return DebugError{std::move(fault)};
  const int pass = integerAt(what, "pass"), frame = integerAt(what, "frame");
  if (pass < 0 || std::size_t(pass) >= document.passes.size() || frame < 0)
    return DebugError{"no such pass or frame"};
  return debug::FrameDrawer::open(
      std::make_unique<debug::DocumentSubject>(std::move(document), std::size_t(pass), frame));
}

} // namespace

int drawForDebugger() { return debug::serveDraws(0, open); }

} // namespace arbiter::tools
