#include "apps/tools/ctl/held_drawer.h"

#include <cstring>

#include "control/base64.h"

namespace arbiter::tools::ctl {

namespace {

using debug::DebugError;
using wire::Json;

/// Returns a target's word in texture.list.
const char *wordOf(fp::ir::TexTarget target) {
  using fp::ir::TexTarget;
  switch (target) {
  case TexTarget::Tex1D:
  case TexTarget::Shadow1D:
    return "1D";
  case TexTarget::Tex3D:
    return "3D";
  case TexTarget::Cube:
    return "CUBE";
  case TexTarget::Rect:
  case TexTarget::ShadowRect:
    return "RECT";
  case TexTarget::Tex2D:
  case TexTarget::Shadow2D:
    break;
  }
  return "2D";
}

} // namespace

HeldDrawer::HeldDrawer(Connection &connection, const Json &held,
                       std::array<std::uint8_t, 4> picture)
    : m_connection(connection), m_picture(picture) {
  wire::Params params(held);
  m_size = {int(params.integer("width", 1, wire::kMaxFrameSide)),
            int(params.integer("height", 1, wire::kMaxFrameSide))};
}

HeldDrawer::~HeldDrawer() { m_connection.client().notify("pixel.release"); }

Result<std::vector<HeldDrawer::Vec4>, DebugError>
HeldDrawer::draw(const std::string &text, std::size_t targets, const debug::Region &region,
                 const std::vector<Vec4> &locals) {
  const Vec4 clear = debug::uncovered();
  Json request = {{"text", text},  {"targets", targets},    {"x", region.x},
                  {"y", region.y}, {"width", region.width}, {"height", region.height},
                  {"clear", clear}};
  if (!locals.empty())
    request["locals"] = wire::toBase64(
        {reinterpret_cast<const std::uint8_t *>(locals.data()), locals.size() * sizeof(Vec4)});
  const auto answer = m_connection.ask("pixel.draw", std::move(request));
  if (!answer)
    return DebugError{answer.error().message};
  wire::Params params(answer.value());
  const auto bytes = wire::fromBase64(params.text("values"));
  std::vector<Vec4> values(targets * std::size_t(region.width) * std::size_t(region.height));
  if (!params.ok() || !bytes || bytes->size() != values.size() * sizeof(Vec4))
    return DebugError{"pixel.draw: the answer has another number of values than was asked for"};
  std::memcpy(values.data(), bytes->data(), bytes->size());
  return values;
}

Result<std::vector<std::array<std::uint8_t, 4>>, DebugError>
HeldDrawer::picture(const debug::Region &region) {
  return std::vector<std::array<std::uint8_t, 4>>(
      std::size_t(region.width) * std::size_t(region.height), m_picture);
}

Result<std::array<int, 3>, DebugError> HeldDrawer::textureSize(unsigned unit,
                                                               fp::ir::TexTarget target) {
  const auto answer =
      m_connection.ask("pixel.texture", {{"unit", unit}, {"target", wordOf(target)}});
  if (!answer)
    return DebugError{answer.error().message};
  std::array<int, 3> size = {};
  const auto found = answer.value().find("size");
  if (found == answer.value().end() || !found->is_array() || found->size() != size.size())
    return DebugError{"pixel.texture: the answer has no size"};
  for (std::size_t i = 0; i < size.size(); ++i)
    size[i] = (*found)[i].is_number_integer() ? (*found)[i].get<int>() : 0;
  return size;
}

Result<HeldDrawer::Vec4, DebugError> HeldDrawer::vertexState(const fp::ir::StateRef &) {
  return DebugError{"the vertex stage of an application's draw is not traced"};
}

} // namespace arbiter::tools::ctl
