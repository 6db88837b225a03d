#include "apps/tools/ctl/held_drawer.h"

#include <algorithm>

#include "control/base64.h"

namespace arbiter::tools::ctl {

using debug::DebugError;

HeldDrawer::HeldDrawer(Connection &connection, const Json &held,
                       std::array<std::uint8_t, 4> picture)
    : m_connection(connection), m_picture(picture) {
  wire::Params params(held);
  m_size = {int(params.integer("width", 1, wire::kMaxFrameSide)),
            int(params.integer("height", 1, wire::kMaxFrameSide))};
}

HeldDrawer::~HeldDrawer() { m_connection.client().notify("pixel.release"); }

Result<wire::Json, DebugError> HeldDrawer::ask(const std::string &method, Json params) {
  auto answer = m_connection.ask(method, std::move(params));
  if (!answer)
    return DebugError{answer.error().message};
  return std::move(answer).value();
}

std::optional<DebugError> HeldDrawer::take(const Json &answer, std::span<std::uint8_t> bytes) {
  wire::Params params(answer);
  const auto values = wire::fromBase64(params.text("values"));
  if (!params.ok() || !values || values->size() != bytes.size())
    return DebugError{"pixel.draw: the answer has another number of values than was asked for"};
  std::copy(values->begin(), values->end(), bytes.begin());
  return {};
}

Result<std::vector<std::array<std::uint8_t, 4>>, DebugError>
HeldDrawer::picture(const debug::Region &region) {
  return std::vector<std::array<std::uint8_t, 4>>(
      std::size_t(region.width) * std::size_t(region.height), m_picture);
}

Result<HeldDrawer::Vec4, DebugError> HeldDrawer::vertexState(const fp::ir::StateRef &) {
  return DebugError{"the vertex stage of an application's draw is not traced"};
}

} // namespace arbiter::tools::ctl
