#include "fp_compiler/hw/r300/check/reads.h"

#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::hw::r300 {

namespace {
constexpr std::uint8_t kXyz = 7;

Tap color(std::size_t component) { return {Tap::From::Rgb, std::uint8_t(component)}; }
constexpr Tap kW = {Tap::From::Alpha, 3};
} // namespace

Tap tapOf(RgbSelect select, std::size_t component) {
  switch (select) {
  case RgbSelect::Xyz:
    return color(component);
  case RgbSelect::Xxx:
    return color(0);
  case RgbSelect::Yyy:
    return color(1);
  case RgbSelect::Zzz:
    return color(2);
  case RgbSelect::Www:
    return kW;
  case RgbSelect::Yzx:
    return color((component + 1) % 3);
  case RgbSelect::Zxy:
    return color((component + 2) % 3);
  case RgbSelect::Wzy:
    return component == 0 ? kW : color(3 - component);
  case RgbSelect::Zero:
    return {Tap::From::Zero, 0};
  case RgbSelect::One:
    return {Tap::From::One, 0};
  case RgbSelect::Half:
    return {Tap::From::Half, 0};
  }
  return {};
}

Tap tapOf(AlphaSelect select) {
  switch (select) {
  case AlphaSelect::X:
    return color(0);
  case AlphaSelect::Y:
    return color(1);
  case AlphaSelect::Z:
    return color(2);
  case AlphaSelect::W:
    return kW;
  case AlphaSelect::Zero:
    return {Tap::From::Zero, 0};
  case AlphaSelect::One:
    return {Tap::From::One, 0};
  case AlphaSelect::Half:
    return {Tap::From::Half, 0};
  }
  return {};
}

std::uint8_t componentsRead(const Half<RgbOp, RgbArgument> &half) {
  if (half.op == RgbOp::Dp3 || half.op == RgbOp::Dp4)
    return kXyz;
  return std::uint8_t((half.mask | half.outputMask) & kXyz);
}

namespace {
/// Adds the component of a register that one component of an argument reads.
void add(std::vector<Read> &reads, Read read, Tap tap, std::uint8_t source, const Pair &pair) {
  if (tap.from != Tap::From::Rgb && tap.from != Tap::From::Alpha)
    return;
  read.alphaAddress = tap.from == Tap::From::Alpha;
  read.component = tap.component;
  read.number = source;
  read.presubtracted = source == kPresubtracted;
  if (!read.presubtracted) {
    reads.push_back(read);
    return;
  }
  switch (read.alphaAddress ? pair.alpha.presubtract : pair.rgb.presubtract) {
  case Presubtract::None:
    return;
  case Presubtract::S1MinusS0:
  case Presubtract::S1PlusS0:
    read.number = 1;
    reads.push_back(read);
    [[fallthrough]];
  case Presubtract::OneMinusTwoS0:
  case Presubtract::OneMinusS0:
    read.number = 0;
    reads.push_back(read);
  }
}
} // namespace

std::vector<Read> readsOf(const Pair &pair) {
  std::vector<Read> reads;
  const std::uint8_t components = componentsRead(pair.rgb);
  for (std::size_t i = 0; i < argumentCount(pair.rgb.op); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      if (components >> c & 1)
        add(reads, {.alphaHalf = false, .argument = std::uint8_t(i)},
            tapOf(pair.rgb.arguments[i].select, c), pair.rgb.arguments[i].source, pair);
  for (std::size_t i = 0; i < argumentCount(pair.alpha.op, pair.rgb.op); ++i)
    add(reads, {.alphaHalf = true, .argument = std::uint8_t(i)},
        tapOf(pair.alpha.arguments[i].select), pair.alpha.arguments[i].source, pair);
  return reads;
}

ir::TexTarget sampledTarget(ir::TexTarget target) {
  switch (target) {
  case ir::TexTarget::Shadow1D:
    return ir::TexTarget::Tex1D;
  case ir::TexTarget::Shadow2D:
    return ir::TexTarget::Tex2D;
  case ir::TexTarget::ShadowRect:
    return ir::TexTarget::Rect;
  case ir::TexTarget::Tex1D:
  case ir::TexTarget::Tex2D:
  case ir::TexTarget::Tex3D:
  case ir::TexTarget::Cube:
  case ir::TexTarget::Rect:
    break;
  }
  return target;
}

std::uint8_t componentsRead(const Texture &texture) {
  constexpr std::uint8_t kAll = 15, kLast = 8;
  const ir::TexTarget target = sampledTarget(texture.target);
  const std::uint8_t coordinate = ir::coordinateMask(target);
  switch (texture.op) {
  case TexOp::Kill:
    return kAll;
  case TexOp::Load:
    return coordinate;
  case TexOp::Project:
    return coordinate | kLast;
  case TexOp::Bias: // a rectangle has one level, so there is nothing to bias
    return target == ir::TexTarget::Rect ? coordinate : std::uint8_t(coordinate | kLast);
  }
  return kAll;
}

} // namespace arbiter::fp::hw::r300
