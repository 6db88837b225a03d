#include <random>

#include "fp_compiler/back/llvm/testing/fragment_window.h"

/// Packed quads against blocks, bit for bit, where derivatives decide about filters.
namespace arbiter::fp::testing {
namespace {

using ir::AttributeKind;
using ir::Opcode;

/// The window's quads in any order; pixels beyond its right or upper side are helpers.
std::vector<abi::Pixel> shuffledQuads(int lanes) {
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
      pixels.push_back({std::uint16_t(px), std::uint16_t(py | (helper ? abi::Pixel::kHelper : 0))});
    }
  while (pixels.size() % std::size_t(lanes) != 0) {
    pixels.push_back(pixels.back());
    pixels.back().y |= abi::Pixel::kHelper;
  }
  return pixels;
}

/// A texture in perspective, which is magnified at one side and minified at the other, and the
/// window's position.
ir::Program projected() {
  ir::Builder b;
  auto place = b.temporary(), texel = b.temporary();
  const ir::Source position = b.attribute(AttributeKind::Position);
  b.op(Opcode::Mul, place, {position, b.constant(0.05f, 0.3f, 0, 0)});
  b.op(Opcode::Mad, place.mask("w"),
       {position.swz("x"), b.constant(0.03f, 0.03f, 0.03f, 0.03f),
        b.constant(0.4f, 0.4f, 0.4f, 0.4f)});
  b.tex(Opcode::Txp, texel, place.read(), 0, ir::TexTarget::Tex2D);
  b.op(Opcode::Mad, b.color(),
       {texel.read(), b.attribute(AttributeKind::TexCoord), b.constant(0.1f, 0.2f, 0, 0.5f)});
  return b.take();
}

TEST_P(FragmentTest, PackedAndBlocksAgree) {
  std::vector<std::uint8_t> pictures[2];
  for (const abi::Filter minify : {abi::Filter::Nearest, abi::Filter::Linear}) {
    Scene scene(GetParam());
    scene.addTexture(64, 64, Wrap::Repeat);
    scene.key.samplers[0].minify = minify;
    scene.primitive.originX = 11;
    scene.primitive.originY = 2;
    const ir::Program program = projected();
    const auto blocks = scene.drawBlocks(program, {{}});
    const auto pixels = shuffledQuads(scene.engine->lanes());
    scene.key.lanes = abi::Lanes::Packed;
    EXPECT_EQ(scene.shade(program, {{}}, pixels.data(), pixels.size(), {}), blocks);
    pictures[int(minify)] = blocks;
  }
  EXPECT_NE(pictures[0], pictures[1]) << "no level of detail was taken";
}

} // namespace
} // namespace arbiter::fp::testing
