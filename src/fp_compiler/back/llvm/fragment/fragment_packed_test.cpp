#include <random>

#include "fp_compiler/back/llvm/testing/fragment_window.h"

/// Compares packed quads of many primitives bit for bit with the blocks of each primitive, where
/// derivatives select filters.
namespace arbiter::fp::testing {
namespace {

using ir::AttributeKind;
using ir::Opcode;

/// Returns the column of the primitive that a quad of the window belongs to.
int columnAt(int x, int y, int columns) { return (x / 2 * 7 + y / 2 * 5) % columns; }

/// Returns the window's quads in random order, each with its primitive. Pixels beyond the window's
/// right or upper side are helpers. The window begins at \p left of the base.
std::vector<abi::Pixel> shuffledQuads(int lanes, int left) {
  std::vector<std::pair<int, int>> quads;
  for (int y = 0; y < kHeight; y += 2)
    for (int x = 0; x < kWidth; x += 2)
      quads.emplace_back(x, y);
  std::shuffle(quads.begin(), quads.end(), std::mt19937(3));
  std::vector<abi::Pixel> pixels;
  for (const auto &[x, y] : quads)
    for (int i = 0; i < 4; ++i) {
      const int px = x + i % 2, py = y + i / 2;
      const bool helper = px >= kWidth || py >= kHeight;
      pixels.push_back({std::uint8_t(left + px), std::uint8_t(py),
                        std::uint8_t(columnAt(x, y, lanes)),
                        std::uint8_t(helper ? abi::Pixel::kHelper : 0)});
    }
  while (pixels.size() % std::size_t(lanes) != 0) {
    pixels.push_back(pixels.back());
    pixels.back().isHelper = abi::Pixel::kHelper;
  }
  return pixels;
}

/// Returns the blocks of one primitive.
std::vector<abi::Block> blocksOf(int column, int lanes, int width, int height) {
  std::vector<abi::Block> blocks;
  for (int y = 0; y < kHeight; y += height)
    for (int x = 0; x < kWidth; x += width) {
      unsigned mask = 0;
      for (int i = 0; i < width * height; ++i) {
        const int px = x + i % width, py = y + i / width;
        if (px < kWidth && py < kHeight && columnAt(px, py, lanes) == column)
          mask |= 1u << i;
      }
      if (mask != 0)
        blocks.push_back({std::int16_t(x), std::int16_t(y), std::uint16_t(mask), 0});
    }
  return blocks;
}

/// Returns primitives that have no plane coefficient in common.
std::vector<abi::Primitive> primitivesLike(const abi::Primitive &first, int count) {
  std::vector<abi::Primitive> all;
  for (int k = 0; k < count; ++k) {
    abi::Primitive each = first;
    const float step = 0.013f * float(k);
    each.backFacing = unsigned(k) & 1;
    each.z = {0.1f + step, 0.001f * step, 0.002f, 0.01f * step};
    each.inverseW = {1 + step, 0.002f + 0.01f * step, 0.01f * step};
    for (abi::Plane &plane : each.inputs[0]) {
      plane.c += step;
      plane.dx *= 1 + step;
      plane.dy -= 0.1f * step;
    }
    all.push_back(each);
  }
  return all;
}

/// Returns a program with a texture in perspective, magnified at one side and minified at the
/// other, and the window's position.
ir::Program projected() {
  ir::Builder b;
  auto place = b.temporary(), texel = b.temporary();
  const ir::Source position = b.attribute(AttributeKind::Position);
  b.op(Opcode::Mul, place, {position, b.constant(0.05f, 0.3f, 0, 0)});
  b.op(Opcode::Mad, place.mask("w"),
       {position.swz("x"), b.constant(0.03f, 0.03f, 0.03f, 0.03f),
        b.constant(0.4f, 0.4f, 0.4f, 0.4f)});
  b.tex(Opcode::Txp, texel, place.read(), 0, ir::TexTarget::Tex2D);
  auto side = b.temporary();
  b.op(Opcode::Mad, side,
       {b.attribute(AttributeKind::Facing), b.constant(0.1f, 0, 0, 0), position.swz("zwzw")});
  b.op(Opcode::Mad, side, {texel.read(), b.attribute(AttributeKind::TexCoord), side.read()});
  b.op(Opcode::Mul, b.color(), {side.read(), b.constant(0.4f, 0.3f, 0.4f, 0.3f)});
  return b.take();
}

TEST_P(FragmentTest, PackedAndBlocksAgree) {
  std::vector<std::uint8_t> pictures[2][4];
  for (const abi::Filter minify : {abi::Filter::Nearest, abi::Filter::Linear})
    for (const auto interpolation :
         {abi::Interpolation::Linear, abi::Interpolation::Even, abi::Interpolation::Perspective}) {
      Scene scene(GetParam());
      const int lanes = scene.engine->lanes();
      scene.addTexture(64, 64, Wrap::Repeat);
      scene.key.samplers[0].minify = minify;
      scene.interpolation = interpolation;
      scene.data.originY = 5;
      const ir::Program program = projected();

      scene.key.lanes = abi::Lanes::Quad;
      const auto quads = scene.begin(program, {{}});
      ASSERT_NE(quads, nullptr);
      const std::vector<abi::Primitive> primitives = primitivesLike(scene.primitive, lanes);
      abi::PrimitiveColumns columns;
      for (int k = 0; k < lanes; ++k) {
        const auto blocks =
            blocksOf(k, lanes, scene.engine->blockWidth(), scene.engine->blockHeight());
        quads->function(&scene.data, &primitives[std::size_t(k)], blocks.data(),
                        std::uint32_t(blocks.size()));
        columns.set(k, primitives[std::size_t(k)]);
      }
      const std::vector<std::uint8_t> expected = scene.target.bytes;

      scene.key.lanes = abi::Lanes::Packed;
      const auto packed = scene.begin(program, {{}});
      ASSERT_NE(packed, nullptr);
      constexpr int kLeft = 20;
      columns.baseX = -kLeft;
      columns.baseY = 0;
      const auto pixels = shuffledQuads(lanes, kLeft);
      reinterpret_cast<abi::PackedShadeFunction>(packed->function)(
          &scene.data, &columns, pixels.data(), std::uint32_t(pixels.size()));
      EXPECT_EQ(scene.target.bytes, expected);
      pictures[int(minify)][int(interpolation)] = expected;
    }
  constexpr int kLinear = int(abi::Interpolation::Linear), kEven = int(abi::Interpolation::Even);
  EXPECT_NE(pictures[0][kLinear], pictures[1][kLinear]) << "no level of detail was taken";
  EXPECT_NE(pictures[0][kLinear], pictures[0][kEven]) << "nothing was divided by the one w";
  EXPECT_NE(pictures[0][kEven], pictures[0][int(abi::Interpolation::Perspective)])
      << "nothing was divided by w";
}

} // namespace
} // namespace arbiter::fp::testing
