#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "fp_compiler/back/llvm/engine/engine.h"
#include "fp_compiler/back/llvm/testing/machine.h"
#include "fp_compiler/back/llvm/testing/pixel_reference.h"
#include "fp_compiler/ir/builder.h"

/// Tests random states of all operations after the program against the reference, in rows, in
/// blocks and packed.
namespace arbiter::fp {
namespace {

using abi::From;
using abi::Layout;

constexpr int kWidth = 44, kHeight = 8;

const abi::Format kFormats[] = {
    {Layout::U8x4, abi::kRgba},
    {Layout::U8x4, {From::C2, From::C1, From::C0, From::C3}},
    {Layout::U8x4, {From::C0, From::C1, From::C2, From::One}},
    {Layout::U8x1, {From::C0, From::C0, From::C0, From::One}},
    {Layout::U8x1, {From::Zero, From::Zero, From::Zero, From::C0}},
    {Layout::U8x2, {From::C0, From::C0, From::C0, From::C1}},
    {Layout::U16x4, abi::kRgba},
    {Layout::F32x4, abi::kRgba},
    {Layout::F32x2, {From::C0, From::C1, From::Zero, From::One}},
    {Layout::F32x1, {From::C0, From::Zero, From::Zero, From::One}},
    {Layout::U8x1, {From::C0, From::C0, From::C0, From::C0}},
    {Layout::U16x1, {From::C0, From::C0, From::C0, From::One}},
    {Layout::U16x2, {From::C0, From::C1, From::Zero, From::One}},
    {Layout::F16x1, {From::C0, From::C0, From::C0, From::C0}},
    {Layout::F16x2, {From::C0, From::C0, From::C0, From::C1}},
    {Layout::F16x4, abi::kRgba},
    {Layout::Bits565, {From::C0, From::C1, From::C2, From::One}},
    {Layout::Bits4444, abi::kRgba},
    {Layout::Bits5551, abi::kRgba},
    {Layout::Bits5551, {From::C0, From::C1, From::C2, From::One}},
    {Layout::Bits1010102, abi::kRgba},
};

/// Returns the allowed error of a stored component.
double toleranceOf(const abi::Format &format, std::size_t c) {
  const Layout layout = format.layout;
  if (abi::isHalf(layout))
    return 1.01 / 1024; // one step for numbers up to 2, because they are truncated
  if (abi::isFloat(layout))
    return 4e-6;
  int bits = 8 * abi::bytesOf(layout) / abi::componentsOf(layout);
  if (abi::isPacked(layout) && format.swizzle[c] <= From::C3)
    bits = abi::bitsOf(layout, int(format.swizzle[c])).bits;
  return bits < 8 ? 0.501 / ((1 << bits) - 1) : 1.01 / ((1 << bits) - 1);
}

class Random {
public:
  explicit Random(std::uint32_t seed) : m_engine(seed) {}
  int below(int count) { return int(m_engine() % unsigned(count)); }
  template <typename Enum> Enum any(Enum last) { return Enum(below(int(last) + 1)); }
  float unit() { return float(m_engine() % 100003) / 100002.0f; }

private:
  std::mt19937 m_engine;
};

abi::StencilFaceKey randomFace(Random &random) {
  return {random.any(abi::Compare::Always), random.any(abi::StencilOp::DecrementWrap),
          random.any(abi::StencilOp::DecrementWrap), random.any(abi::StencilOp::DecrementWrap)};
}

abi::FragmentKey randomKey(Random &random) {
  abi::FragmentKey key{};
  key.lanes = random.any(abi::Lanes::Packed);
  key.inputs[0] = random.any(abi::Interpolation::Perspective);
  abi::ColorTargetKey &target = key.targets[0];
  target.format = kFormats[random.below(int(std::size(kFormats)))];
  key.clampColors = random.below(2) != 0;
  target.writeMask = random.below(2) ? 0xF : std::uint8_t(random.below(16));
  if (random.below(3) == 0)
    key.alphaTest = random.any(abi::Compare::Always);
  if (random.below(2)) {
    const auto factor = abi::BlendFactor::SourceAlphaSaturate;
    const auto equation = abi::BlendEquation::Max;
    target.blend = {1,
                    random.any(factor),
                    random.any(factor),
                    random.any(factor),
                    random.any(factor),
                    random.any(equation),
                    random.any(equation)};
  } else if (target.format.layout == Layout::U8x4 && random.below(3) == 0) {
    key.logicOpEnabled = 1;
    key.logicOp = random.any(abi::LogicOp::Set);
  }
  const Layout depths[] = {Layout::None, Layout::Depth16, Layout::Depth24Stencil8, Layout::Depth32F,
                           Layout::Depth32};
  abi::DepthStencilKey &depth = key.depthStencil;
  depth.layout = depths[random.below(5)];
  if (depth.layout != Layout::None) {
    depth.depthTest = std::uint8_t(random.below(2));
    depth.depthWrite = std::uint8_t(random.below(2));
    depth.depthCompare = random.any(abi::Compare::Always);
    depth.stencilTest = std::uint8_t(random.below(2));
    depth.front = randomFace(random);
    depth.back = random.below(2) ? depth.front : randomFace(random);
  }
  return key;
}

struct Draw {
  abi::FragmentKey key{};
  abi::FragmentData data{};
  abi::Primitive primitive{};
  testing::SceneTarget color, depth;
  bool writesDepth = false, kills = false;
};

ir::Program programOf(const Draw &draw) {
  ir::Builder b;
  const ir::Source color = b.attribute(ir::AttributeKind::ColorPrimary);
  if (draw.kills)
    b.kil(color.swz("y"));
  if (draw.writesDepth)
    b.op(ir::Opcode::Mov, b.depth().mask("z"), {color.swz("z")});
  b.op(ir::Opcode::Mov, b.color(), {color});
  return b.take();
}

/// Fills in colours slightly beyond [0,1], and depths around the stored ones.
void fill(Draw &draw, Random &random) {
  abi::FragmentData &data = draw.data;
  data.alphaReference = random.unit();
  for (float &component : data.blendColor)
    component = 1.5f * random.unit() - 0.25f;
  for (std::size_t side = 0; side < 2; ++side) {
    data.stencilReference[side] = std::uint8_t(random.below(256));
    data.stencilCompareMask[side] = random.below(2) ? 255 : std::uint8_t(random.below(256));
    data.stencilWriteMask[side] = random.below(2) ? 255 : std::uint8_t(random.below(256));
  }
  draw.writesDepth = random.below(4) == 0;
  draw.kills = random.below(4) == 0;
  abi::Primitive &primitive = draw.primitive;
  data.originY = random.below(kHeight);
  primitive.backFacing = std::uint32_t(random.below(2));
  primitive.z = {random.unit(), 0.01f * random.unit(), 0.02f * random.unit(),
                 0.01f * random.unit()};
  primitive.inverseW = {1.0f + random.unit(), 0.01f * random.unit(), 0.01f * random.unit()};
  for (abi::Plane &plane : primitive.inputs[0])
    plane = {random.unit(), 0.03f * (random.unit() - 0.5f), 0.05f * (random.unit() - 0.5f)};
  draw.color = testing::makeTarget(draw.key.targets[0].format, kWidth, kHeight,
                                   std::uint32_t(random.below(1000)));
  draw.depth = testing::makeTarget({draw.key.depthStencil.layout, abi::kRgba}, kWidth, kHeight,
                                   std::uint32_t(random.below(1000)));
  const auto setUnits = [&](testing::SceneTarget &target) {
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        for (int k = 0; k < abi::bytesOf(target.format.layout) / 4; ++k) {
          const float value = random.unit();
          std::memcpy(target.pixel(x, y) + 4 * k, &value, 4);
        }
  };
  const Layout colors = draw.color.format.layout;
  if (abi::isFloat(colors) && !abi::isHalf(colors))
    setUnits(draw.color);
  if (abi::isHalf(colors)) // numbers below 1, of both signs
    for (std::size_t i = 1; i < draw.color.bytes.size(); i += 2)
      draw.color.bytes[i] = std::uint8_t((draw.color.bytes[i] & 0x80) | draw.color.bytes[i] % 0x3C);
  if (draw.depth.format.layout == Layout::Depth32F)
    setUnits(draw.depth);
}

testing::ReferenceFragment fragmentAt(const jit::Engine &engine, const Draw &draw, int x, int y) {
  y -= draw.data.originY;
  testing::ReferenceFragment fragment;
  const abi::Interpolation how = draw.key.inputs[0];
  for (std::size_t c = 0; c < 4; ++c) {
    const abi::Plane &plane = draw.primitive.inputs[0][c];
    float value = how == abi::Interpolation::Flat ? plane.c : testing::valueAt(engine, plane, x, y);
    if (how == abi::Interpolation::Perspective || how == abi::Interpolation::Even) {
      const abi::Plane &inverse = draw.primitive.inverseW;
      volatile const float w =
          1.0f /
          (how == abi::Interpolation::Even ? inverse.c : testing::valueAt(engine, inverse, x, y));
      value *= w;
    }
    fragment.color[c] = value;
  }
  fragment.depth = draw.writesDepth ? fragment.color[2] : abi::depthAt(draw.primitive.z, x, y);
  return fragment;
}

/// Items that cover a random subset of the pixels.
struct Items {
  std::vector<abi::Span> spans;
  std::vector<abi::Block> blocks;
  std::vector<abi::Pixel> pixels;
};
constexpr std::uint8_t kColumn = 2; ///< of the packed primitive, between others
/// Adds half of all quads in random order. Some of their pixels are helpers, or only single pixels
/// are covered.
void addPacked(int lanes, Random &random, Items &items) {
  std::vector<std::pair<int, int>> quads;
  for (int y = 0; y < kHeight; y += 2)
    for (int x = 0; x < kWidth; x += 2)
      quads.emplace(quads.begin() + random.below(int(quads.size()) + 1), x, y);
  quads.resize(quads.size() / 2);
  const bool whole = random.below(2) != 0;
  for (const auto &[x, y] : quads)
    for (int i = 0; i < 4; ++i) {
      const bool helper = random.below(3) == 0;
      if (helper && !whole)
        continue;
      items.pixels.push_back({std::uint8_t(x + i % 2), std::uint8_t(y + i / 2), kColumn,
                              std::uint8_t(helper ? abi::Pixel::kHelper : 0)});
    }
  while (items.pixels.size() % std::size_t(lanes) != 0) {
    items.pixels.push_back(items.pixels.back());
    items.pixels.back().isHelper = abi::Pixel::kHelper;
  }
}

Items randomItems(const jit::Engine &engine, Random &random) {
  Items items;
  for (int y = 0; y < kHeight; ++y) {
    const int x = random.below(20), count = random.below(kWidth - x) + 1;
    items.spans.push_back({std::int16_t(x), std::int16_t(y), std::uint16_t(count), 0});
  }
  const int width = engine.blockWidth(), height = engine.blockHeight();
  for (int y = 0; y < kHeight; y += height)
    for (int x = 0; x < kWidth; x += width)
      items.blocks.push_back(
          {std::int16_t(x), std::int16_t(y), std::uint16_t(random.below(1 << engine.lanes())), 0});
  addPacked(engine.lanes(), random, items);
  return items;
}

std::uint32_t wordAt(testing::SceneTarget &target, int x, int y) {
  std::uint32_t word = 0;
  const int bytes = abi::bytesOf(target.format.layout);
  std::memcpy(&word, target.pixel(x, y), std::size_t(std::min(bytes, 4)));
  return word;
}

/// Checks one pixel against the reference; \p before holds the previous contents.
void checkPixel(const jit::Engine &engine, Draw &draw, Draw &before, int x, int y) {
  const testing::ReferenceFragment fragment = fragmentAt(engine, draw, x, y);
  const bool killed = draw.kills && fragment.color[1] < 0;
  const std::array<double, 4> dest =
      testing::readPixel(draw.color.format, before.color.pixel(x, y));
  const std::uint32_t oldDepth =
      draw.depth.format.layout == Layout::None ? 0 : wordAt(before.depth, x, y);
  testing::ReferencePixel want;
  want.depthStencil = oldDepth;
  if (!killed)
    want = testing::shadeReference(draw.key, draw.data, draw.primitive.backFacing != 0, fragment,
                                   dest, wordAt(before.color, x, y), oldDepth);
  if (draw.depth.format.layout != Layout::None) {
    ASSERT_EQ(wordAt(draw.depth, x, y), want.depthStencil) << "depth at " << x << ", " << y;
  }
  const int bytes = abi::bytesOf(draw.color.format.layout);
  if (!want.passed) {
    ASSERT_EQ(std::memcmp(draw.color.pixel(x, y), before.color.pixel(x, y), std::size_t(bytes)), 0)
        << "a discarded fragment at " << x << ", " << y;
    return;
  }
  if (draw.key.logicOpEnabled) {
    const std::uint32_t named = draw.color.format.swizzle[3] == From::One ? 0xFFFFFF : ~0u;
    ASSERT_EQ(wordAt(draw.color, x, y) & named, want.bits & named) << x << ", " << y;
    return;
  }
  const std::array<double, 4> got = testing::readPixel(draw.color.format, draw.color.pixel(x, y));
  const bool isFloat = abi::isFloat(draw.color.format.layout);
  for (std::size_t c = 0; c < 4; ++c) {
    const double expected = isFloat ? want.color[c] : std::clamp(want.color[c], 0.0, 1.0);
    if (want.written[c]) {
      ASSERT_NEAR(got[c], expected, toleranceOf(draw.color.format, c))
          << "component " << c << " at " << x << ", " << y;
    } else if (draw.color.format.swizzle[c] <= From::C3 &&
               (draw.color.format.layout == Layout::U8x4 ||
                abi::isPacked(draw.color.format.layout))) {
      ASSERT_EQ(got[c], dest[c]) << "a masked component " << c;
    }
  }
}

class PixelTest : public ::testing::TestWithParam<const char *> {};
INSTANTIATE_TEST_SUITE_P(Cpus, PixelTest, ::testing::Values("avx512", "avx2", "sse4.1", "neon"),
                         [](const auto &cpu) { return llvm_back::nameInTests(cpu.param); });

TEST_P(PixelTest, RandomStates) {
  const auto engine = llvm_back::makeEngine({GetParam()});
  if (!engine)
    GTEST_SKIP() << "this processor does not run code for " << GetParam();
  for (std::uint32_t seed = 0; seed < 220; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Draw draw;
    draw.key = randomKey(random);
    fill(draw, random);
    Draw before = draw;
    draw.data.targets[0] = {draw.color.pixel(0, 0), draw.color.rowStride};
    draw.data.depthStencil = {draw.depth.pixel(0, 0), draw.depth.rowStride};
    const auto prepared = engine->prepareFragment(programOf(draw), Numerics::Host);
    ASSERT_NE(prepared, nullptr);
    const float zeros[4] = {};
    draw.data.parameters = &zeros;
    std::string reason;
    const auto code = engine->compile(*prepared, draw.key, reason);
    ASSERT_NE(code, nullptr) << reason;
    Items items = randomItems(*engine, random);
    const auto shade = [&](const auto &list) {
      code->function(&draw.data, &draw.primitive, list.data(), std::uint32_t(list.size()));
    };
    const bool rows = draw.key.lanes == abi::Lanes::Row;
    const bool packed = draw.key.lanes == abi::Lanes::Packed;
    if (packed) {
      abi::PrimitiveColumns columns;
      std::memset(columns.rows, 0x5A, sizeof columns.rows);
      columns.set(kColumn, draw.primitive);
      reinterpret_cast<abi::PackedShadeFunction>(code->function)(
          &draw.data, &columns, items.pixels.data(), std::uint32_t(items.pixels.size()));
    } else if (rows)
      shade(items.spans);
    else
      shade(items.blocks);
    const auto check = [&](int x, int y) {
      checkPixel(*engine, draw, before, x, y);
      const std::size_t bytes = std::size_t(abi::bytesOf(draw.color.format.layout));
      std::memcpy(draw.color.pixel(x, y), before.color.pixel(x, y), bytes);
      const std::size_t depthBytes = std::size_t(abi::bytesOf(draw.depth.format.layout));
      std::memcpy(draw.depth.pixel(x, y), before.depth.pixel(x, y), depthBytes);
    };
    if (rows)
      for (const abi::Span &span : items.spans)
        for (int x = span.x; x < span.x + span.count; ++x)
          check(x, span.y);
    else if (packed)
      for (const abi::Pixel &pixel : items.pixels) {
        if (pixel.isHelper == 0)
          check(pixel.x, pixel.y);
      }
    else
      for (const abi::Block &block : items.blocks)
        for (int i = 0; i < engine->lanes(); ++i)
          if (block.mask >> i & 1)
            check(block.x + i % engine->blockWidth(), block.y + i / engine->blockWidth());
    if (HasFatalFailure())
      return;
    ASSERT_EQ(draw.color.bytes, before.color.bytes) << "colours outside of the items";
    ASSERT_EQ(draw.depth.bytes, before.depth.bytes) << "depths outside of the items";
  }
}

} // namespace
} // namespace arbiter::fp
