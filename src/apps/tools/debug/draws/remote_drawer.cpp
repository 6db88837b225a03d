#include "apps/tools/debug/draws/remote_drawer.h"

#include "control/base64.h"

namespace arbiter::tools::debug {

control::Json regionJson(const Region &region) {
  return {{"x", region.x}, {"y", region.y}, {"width", region.width}, {"height", region.height}};
}

const char *targetWord(fp::ir::TexTarget target) {
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

Result<std::vector<Drawer::Vec4>, DebugError> RemoteDrawer::draw(const std::string &text,
                                                                 std::size_t targets,
                                                                 const Region &region,
                                                                 const std::vector<Vec4> &locals) {
  Json request = regionJson(region);
  request["text"] = text;
  request["targets"] = targets;
  request["clear"] = uncovered();
  if (!locals.empty())
    request["locals"] = control::toBase64(
        {reinterpret_cast<const std::uint8_t *>(locals.data()), locals.size() * sizeof(Vec4)});
  return askItems<Vec4>("pixel.draw", std::move(request),
                        targets * std::size_t(region.width) * std::size_t(region.height));
}

Result<std::array<int, 3>, DebugError> RemoteDrawer::textureSize(unsigned unit,
                                                                 fp::ir::TexTarget target) {
  const auto answer = ask("pixel.texture", {{"unit", unit}, {"target", targetWord(target)}});
  if (!answer)
    return answer.error();
  std::array<int, 3> size = {};
  const auto found = answer.value().find("size");
  if (found == answer.value().end() || !found->is_array() || found->size() != size.size())
    return DebugError{"pixel.texture: the answer has no size"};
  for (std::size_t i = 0; i < size.size(); ++i)
    size[i] = (*found)[i].is_number_integer() ? (*found)[i].get<int>() : 0;
  return size;
}

} // namespace arbiter::tools::debug
