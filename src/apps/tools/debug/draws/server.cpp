#include "apps/tools/debug/draws/server.h"

#include <cstring>

#include "apps/tools/debug/draws/remote_drawer.h"
#include "apps/tools/debug/pixel/cut.h"
#include "control/attached.h"
#include "control/base64.h"
#include "control/server.h"

namespace arbiter::tools::debug {

namespace {

using control::Answer;
using control::Fault;
using control::Json;
using control::Params;

constexpr std::size_t kMaxLocals = 16;

Fault faultOf(const DebugError &error) {
  return {error.isOfUsage ? control::kWrongParameters : control::kNotPossible, error.message, {}};
}

/// Decodes local parameters: base64 of four floats each. Returns nothing for other texts.
std::optional<std::vector<Drawer::Vec4>> localsOf(Params &params) {
  const auto bytes = control::fromBase64(params.text("locals", ""));
  if (!bytes || bytes->size() % sizeof(Drawer::Vec4) != 0 ||
      bytes->size() > kMaxLocals * sizeof(Drawer::Vec4))
    return {};
  std::vector<Drawer::Vec4> locals(bytes->size() / sizeof(Drawer::Vec4));
  if (!locals.empty())
    std::memcpy(locals.data()->data(), bytes->data(), bytes->size());
  return locals;
}

/// Answers on the thread that GL is current on.
class Draws final : public control::Service {
public:
  Draws(control::Server &server, const OpenDrawer &open) : m_server(server), m_open(open) {}

  void connected(control::ClientId, pid_t) override {}
  void disconnected(control::ClientId) override {}
  void received(control::ClientId client, control::Request request) override {
    Params params(request.params);
    const Answer answer = request.method == "pixel.open" ? open(request.params)
                          : m_drawer                     ? reply(request.method, params)
                                                         : faultOf({"nothing is open"});
    m_server.send(client, control::answerLine(request.id, answer), std::move(m_memory));
  }

private:
  Answer reply(const std::string &method, Params &params) {
    if (method == "pixel.draw")
      return draw(params);
    if (method == "pixel.picture")
      return picture(params);
    if (method == "pixel.texture")
      return texture(params);
    if (method == "pixel.state")
      return state(params);
    return Fault{control::kNoMethod, "no such request", {}};
  }

  Answer open(const Json &what) {
    auto drawer = m_open(what);
    if (!drawer)
      return faultOf(drawer.error());
    m_drawer = std::move(drawer).value();
    const auto [width, height] = m_drawer->size();
    return Json{{"width", width}, {"height", height}};
  }

  /// Reads a region within the picture.
  Region regionOf(Params &params) const {
    const auto [width, height] = m_drawer->size();
    Region region;
    region.x = int(params.integer("x", 0, width - 1));
    region.y = int(params.integer("y", 0, height - 1));
    region.width = int(params.integer("width", 1, width - region.x));
    region.height = int(params.integer("height", 1, height - region.y));
    return region;
  }

  template <typename Item> Answer answerOf(const Result<std::vector<Item>, DebugError> &drawn) {
    if (!drawn)
      return faultOf(drawn.error());
    const auto *const bytes = reinterpret_cast<const std::uint8_t *>(drawn.value().data());
    m_memory = control::memoryOf({bytes, drawn.value().size() * sizeof(Item)});
    if (!m_memory)
      return faultOf({"no memory for the pixels"});
    return Json::object();
  }

  Answer draw(Params &params) {
    const Region region = regionOf(params);
    const auto targets = std::size_t(params.integer("targets", 1, kMaxTargets));
    const std::string text = params.text("text");
    if (!params.ok())
      return Fault{
          control::kNotPossible, "a region outside the picture, or a wrong number of targets", {}};
    const auto locals = localsOf(params);
    if (!locals)
      return faultOf({"no values of local parameters"});
    return answerOf(m_drawer->draw(text, targets, region, *locals));
  }

  Answer picture(Params &params) {
    const Region region = regionOf(params);
    return params.ok() ? answerOf(m_drawer->picture(region))
                       : faultOf({"a region outside the picture"});
  }

  Answer texture(Params &params) {
    using fp::ir::TexTarget;
    const auto unit = unsigned(params.integer("unit", 0, INT32_MAX));
    const std::string word = params.text("target");
    int target = 0;
    while (target <= int(TexTarget::ShadowRect) && word != targetWord(TexTarget(target)))
      ++target;
    if (!params.ok() || target > int(TexTarget::ShadowRect))
      return faultOf({"no such texture"});
    const auto size = m_drawer->textureSize(unit, TexTarget(target));
    return size ? Answer(Json{{"size", size.value()}}) : faultOf(size.error());
  }

  Answer state(Params &params) {
    using fp::ir::StateItem;
    fp::ir::StateRef state;
    state.item = StateItem(params.integer("item", std::int64_t(StateItem::TexGenEye),
                                          std::int64_t(StateItem::PointAttenuation)));
    state.index = std::uint8_t(params.integer("index", 0, 255));
    state.row = std::uint8_t(params.integer("row", 0, 3));
    if (!params.ok())
      return faultOf({"no such state of vertex programs"});
    const auto value = m_drawer->vertexState(state);
    return value ? Answer(Json{{"value", value.value()}}) : faultOf(value.error());
  }

  control::Server &m_server;
  const OpenDrawer &m_open;
  std::unique_ptr<Drawer> m_drawer;
  control::Descriptor m_memory; ///< goes with the next answer
};

} // namespace

int serveDraws(int descriptor, const OpenDrawer &open) {
  const auto server = control::Server::connected(control::Descriptor(descriptor));
  if (!server)
    return 1;
  Draws draws(*server, open);
  server->run(draws);
  return 0;
}

} // namespace arbiter::tools::debug
