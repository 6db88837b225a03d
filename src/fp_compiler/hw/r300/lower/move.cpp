#include "fp_compiler/hw/r300/lower/move.h"

#include <bit>

namespace arbiter::fp::hw::r300 {

AlphaOp otherUnit(RgbOp op) {
  switch (op) {
  case RgbOp::Mad:
    return AlphaOp::Mad;
  case RgbOp::Min:
    return AlphaOp::Min;
  case RgbOp::Max:
    return AlphaOp::Max;
  case RgbOp::Cnd:
    return AlphaOp::Cnd;
  case RgbOp::Cmp:
    return AlphaOp::Cmp;
  case RgbOp::Frc:
    return AlphaOp::Frc;
  case RgbOp::None:
  case RgbOp::Dp3:
  case RgbOp::Dp4:
  case RgbOp::ReplAlpha:
    break;
  }
  return AlphaOp::None;
}

RgbOp otherUnit(AlphaOp op) {
  switch (op) {
  case AlphaOp::Mad:
    return RgbOp::Mad;
  case AlphaOp::Min:
    return RgbOp::Min;
  case AlphaOp::Max:
    return RgbOp::Max;
  case AlphaOp::Cnd:
    return RgbOp::Cnd;
  case AlphaOp::Cmp:
    return RgbOp::Cmp;
  case AlphaOp::Frc:
    return RgbOp::Frc;
  case AlphaOp::None:
  case AlphaOp::Dp:
  case AlphaOp::Ex2:
  case AlphaOp::Lg2:
  case AlphaOp::Rcp:
  case AlphaOp::Rsq:
    break;
  }
  return RgbOp::None;
}

namespace {
constexpr std::uint8_t kConstants = std::uint8_t(RgbSelect::Zero) - std::uint8_t(AlphaSelect::Zero);

/// Marks the items that \p reader reads together with another item. They cannot move.
void markFixed(const Item &reader, std::vector<std::uint8_t> &movable) {
  const auto fix = [&](const FlowArgument &argument) {
    if (argument.bank == FlowArgument::Bank::Item || reader.kind == Item::Kind::Texture)
      for (const ItemId id : argument.source)
        if (id != kNoItem)
          movable[id] = 0;
  };
  if (reader.kind == Item::Kind::Texture) {
    fix(reader.rgbArguments[0]);
    fix(reader.alphaArguments[0]);
    return;
  }
  if (reader.presubtract != Presubtract::None)
    for (const FlowArgument &argument : reader.presubtracted)
      fix(argument);
  const std::uint8_t components = rgbComponents(reader);
  for (int i = 0; i < argumentsOf(reader.rgb); ++i) {
    const FlowArgument &argument = reader.rgbArguments[std::size_t(i)];
    const ItemId first = argument.source[std::size_t(std::countr_zero(components))];
    for (std::size_t c = 0; c < 3; ++c)
      if ((components >> c & 1) && argument.source[c] != first)
        fix(argument);
  }
}
} // namespace

std::vector<std::uint8_t> movableItems(const Flow &flow) {
  std::vector<std::uint8_t> movable(flow.items.size(), 0), writers(flow.items.size(), 0);
  for (ItemId id = 0; id < flow.items.size(); ++id) {
    const Item &item = flow.items[id];
    if (!item.live)
      continue;
    std::uint8_t &count = writers[flow.parent[id]];
    count = count < 2 ? std::uint8_t(count + 1) : count;
    const bool scalar = item.kind == Item::Kind::Rgb ? otherUnit(item.rgb) != AlphaOp::None
                                                     : item.kind == Item::Kind::Alpha &&
                                                           otherUnit(item.alpha) != RgbOp::None;
    movable[id] = scalar && std::has_single_bit(item.mask) && item.outputMask == 0 && !item.depth &&
                  item.presubtract == Presubtract::None;
  }
  for (ItemId id = 0; id < flow.items.size(); ++id)
    if (flow.items[id].live && flow.items[id].kind != Item::Kind::Interpolant)
      markFixed(flow.items[id], movable);
  for (ItemId id = 0; id < flow.items.size(); ++id)
    movable[id] &= writers[flow.parent[id]] < 2;
  return movable;
}

Item moved(const Item &item) {
  Item result = item;
  if (item.kind == Item::Kind::Rgb) {
    const std::size_t component = std::size_t(std::countr_zero(item.mask));
    for (std::size_t i = 0; i < 3; ++i) {
      const FlowArgument &from = item.rgbArguments[i];
      FlowArgument &to = result.alphaArguments[i];
      to = from;
      if (from.bank == FlowArgument::Bank::None) {
        to.select = std::uint8_t(from.select - kConstants);
        continue;
      }
      to.select = kTaps[from.select][component];
      if (from.bank == FlowArgument::Bank::Item)
        to.source[0] = from.source[component];
    }
    result.kind = Item::Kind::Alpha;
    result.alpha = otherUnit(item.rgb);
    result.rgb = RgbOp::None;
    result.mask = 8;
    return result;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const FlowArgument &from = item.alphaArguments[i];
    FlowArgument &to = result.rgbArguments[i];
    to = from;
    to.select = std::uint8_t(from.bank == FlowArgument::Bank::None
                                 ? from.select + kConstants
                                 : from.select + std::uint8_t(RgbSelect::Xxx));
    if (from.bank == FlowArgument::Bank::Item)
      to.source.fill(from.source[0]);
  }
  result.kind = Item::Kind::Rgb;
  result.rgb = otherUnit(item.alpha);
  result.alpha = AlphaOp::None;
  result.mask = 1;
  return result;
}

void readMoved(Item &reader, ItemId item, std::uint8_t component) {
  const std::uint8_t components = rgbComponents(reader);
  for (int i = 0; i < argumentsOf(reader.rgb); ++i) {
    FlowArgument &argument = reader.rgbArguments[std::size_t(i)];
    if (argument.bank != FlowArgument::Bank::Item ||
        argument.source[std::size_t(std::countr_zero(components))] != item)
      continue;
    argument.select = std::uint8_t(std::uint8_t(RgbSelect::Xxx) + component);
    argument.source.fill(item);
  }
  for (int i = 0; i < argumentsOf(reader.alpha, reader.rgb); ++i) {
    FlowArgument &argument = reader.alphaArguments[std::size_t(i)];
    if (argument.bank == FlowArgument::Bank::Item && argument.source[0] == item)
      argument.select = component;
  }
}

} // namespace arbiter::fp::hw::r300
