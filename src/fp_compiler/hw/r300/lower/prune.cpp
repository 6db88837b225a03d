#include "fp_compiler/hw/r300/lower/prune.h"

namespace arbiter::fp::hw::r300 {

namespace {
void chooseHalves(Item &item) {
  const std::uint8_t written = item.written();
  if (item.rgb == RgbOp::Dp4)
    return;
  if (item.rgb == RgbOp::Dp3) {
    item.alpha = written & 8 ? AlphaOp::Dp : AlphaOp::None;
    item.kind = written & 8 ? Item::Kind::Both : Item::Kind::Rgb;
    return;
  }
  item.rgb = written & 7 ? RgbOp::ReplAlpha : RgbOp::None;
  item.kind = written & 7 ? Item::Kind::Both : Item::Kind::Alpha;
}
} // namespace

void prune(Flow &flow) {
  std::vector<std::uint8_t> needed(flow.items.size(), 0);
  for (std::size_t at = flow.items.size(); at-- > 0;) {
    Item &item = flow.items[at];
    if (item.kind == Item::Kind::Texture || item.kind == Item::Kind::Interpolant) {
      item.live = needed[at] || (item.kind == Item::Kind::Texture && item.texture == TexOp::Kill);
    } else {
      item.mask &= needed[at];
      item.live = item.written() != 0;
      if (item.live && item.replicated)
        chooseHalves(item);
    }
    if (item.live)
      forEachRead(item, [&](ItemId read, std::uint8_t component) {
        needed[read] |= std::uint8_t(1 << component);
      });
  }
  for (std::size_t i = 0; i < flow.items.size(); ++i)
    flow.parent[i] = flow.web(ItemId(i));
}

} // namespace arbiter::fp::hw::r300
