#include "apps/tools/debug/draws/server.h"

#include "apps/tools/debug/draws/channel.h"
#include "apps/tools/debug/pixel/cut.h"

namespace arbiter::tools::debug {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxLocals = 16;

struct Answer {
  Json json;
  std::vector<std::uint8_t> bytes;
};

Answer failure(const std::string &message, bool isOfUsage = false) {
  return {{{"error", message}, {"of_usage", isOfUsage}}, {}};
}

int integer(const Json &json, const char *name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_number_integer() ? found->get<int>() : -1;
}

class Server {
public:
  Server(Channel &channel, const OpenDrawer &open) : m_channel(channel), m_open(open) {}

  int run() {
    while (const auto line = m_channel.receive(-1)) {
      Answer answer = reply(Json::parse(*line, nullptr, false));
      if (!answer.json.contains("error") && !answer.bytes.empty())
        answer.json["bytes"] = answer.bytes.size();
      const std::string text = answer.json.dump(-1, ' ', false, Json::error_handler_t::replace);
      if (!m_channel.send(text, answer.bytes.data(), answer.bytes.size()))
        return 1;
    }
    return 0;
  }

private:
  Answer reply(const Json &request) {
    if (!request.is_object())
      return failure("no request");
    if (request.contains("open"))
      return open(request["open"]);
    if (!m_drawer)
      return failure("nothing is open");
    if (request.contains("draw") && request["draw"].is_string())
      return draw(request);
    if (request.contains("picture"))
      return picture(request["picture"]);
    if (request.contains("texture"))
      return texture(request);
    if (request.contains("state"))
      return state(request);
    return failure("no such request");
  }

  Answer open(const Json &what) {
    auto drawer = m_open(what);
    if (!drawer)
      return failure(drawer.error().message, drawer.error().isOfUsage);
    m_drawer = std::move(drawer).value();
    const auto [width, height] = m_drawer->size();
    return {{{"width", width}, {"height", height}}, {}};
  }

  /// Returns a region within the picture, or nothing.
  std::optional<Region> regionOf(const Json &json) const {
    if (!json.is_object())
      return {};
    const Region region{integer(json, "x"), integer(json, "y"), integer(json, "width"),
                        integer(json, "height")};
    const auto [width, height] = m_drawer->size();
    const bool inside = region.x >= 0 && region.y >= 0 && region.width > 0 && region.height > 0 &&
                        region.width <= width - region.x && region.height <= height - region.y;
    return inside ? std::optional(region) : std::nullopt;
  }

  template <typename Item>
  static Answer itemsOf(const Result<std::vector<Item>, DebugError> &drawn) {
    if (!drawn)
      return failure(drawn.error().message);
    const auto *const bytes = reinterpret_cast<const std::uint8_t *>(drawn.value().data());
    return {Json::object(), {bytes, bytes + drawn.value().size() * sizeof(Item)}};
  }

  /// Returns at most kMaxLocals rows of four numbers, or nothing.
  static std::optional<std::vector<Drawer::Vec4>> localsOf(const Json &json) {
    if (!json.is_array() || json.size() > kMaxLocals)
      return {};
    std::vector<Drawer::Vec4> locals;
    for (const Json &row : json) {
      if (!row.is_array() || row.size() != 4)
        return {};
      Drawer::Vec4 &value = locals.emplace_back();
      for (std::size_t i = 0; i < 4; ++i) {
        if (!row[i].is_number())
          return {};
        value[i] = row[i].get<float>();
      }
    }
    return locals;
  }

  Answer draw(const Json &request) {
    const auto region = regionOf(request.value("region", Json()));
    const int targets = integer(request, "targets");
    if (!region || targets < 1 || targets > int(kMaxTargets))
      return failure("a region outside the picture, or a wrong number of targets");
    const auto locals = localsOf(request.value("locals", Json::array()));
    if (!locals)
      return failure("no values of local parameters");
    return itemsOf(
        m_drawer->draw(request["draw"].get<std::string>(), std::size_t(targets), *region, *locals));
  }

  Answer picture(const Json &request) {
    const auto region = regionOf(request);
    return region ? itemsOf(m_drawer->picture(*region)) : failure("a region outside the picture");
  }

  Answer texture(const Json &request) {
    const int unit = integer(request, "texture"), target = integer(request, "target");
    if (unit < 0 || target < 0 || target > int(fp::ir::TexTarget::ShadowRect))
      return failure("no such texture");
    const auto size = m_drawer->textureSize(unsigned(unit), fp::ir::TexTarget(target));
    return size ? Answer{{{"size", size.value()}}, {}} : failure(size.error().message);
  }

  Answer state(const Json &request) {
    using fp::ir::StateItem;
    fp::ir::StateRef state;
    const int item = integer(request, "state"), index = integer(request, "index");
    const int row = integer(request, "row");
    if (item < int(StateItem::TexGenEye) || item > int(StateItem::PointAttenuation) || index < 0 ||
        index > 255 || row < 0 || row > 3)
      return failure("no such state of vertex programs");
    state.item = StateItem(item);
    state.index = std::uint8_t(index);
    state.row = std::uint8_t(row);
    const auto value = m_drawer->vertexState(state);
    return value ? Answer{{{"value", value.value()}}, {}} : failure(value.error().message);
  }

  Channel &m_channel;
  const OpenDrawer &m_open;
  std::unique_ptr<Drawer> m_drawer;
};

} // namespace

int serveDraws(int descriptor, const OpenDrawer &open) {
  Channel channel(descriptor);
  return Server(channel, open).run();
}

} // namespace arbiter::tools::debug
