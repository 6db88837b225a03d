#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "fp_compiler/back/llvm/engine.h"
#include "fp_compiler/back/llvm/fragment_scene.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"

/// Fragment functions over spans, against the interpreter with a nearest lookup of its own.
namespace arbiter::fp {
namespace {

using abi::Layout;
using abi::Wrap;
using ir::AttributeKind;
using ir::Opcode;
using ir::TexTarget;
using testing::QuadInput;

constexpr int kWidth = 75, kHeight = 9;

std::vector<std::string> cpus() {
  std::vector<std::string> names;
  for (const char *name : {"", "avx512", "avx2", "sse4", "neon"})
    if (llvm_back::makeEngine({name, nullptr}))
      names.emplace_back(name);
  return names;
}

int wrapped(int index, int size, Wrap wrap) {
  if (wrap == Wrap::Repeat)
    return ((index % size) + size) % size;
  return std::clamp(index, 0, size - 1);
}

/// Nearest texel of a U8x4 texture, as stored.
const std::uint8_t *texelAt(const testing::SceneTexture &texture, const ir::Vec4 &coordinate) {
  const int x = int(std::floor(coordinate[0] * float(texture.width)));
  const int y = int(std::floor(coordinate[1] * float(texture.height)));
  return texture.level.base +
         wrapped(y, texture.height, texture.key.wrap[1]) * texture.level.rowStride +
         wrapped(x, texture.width, texture.key.wrap[0]) * 4;
}

/// A program over a window whose first input is a texture coordinate.
struct Scene {
  explicit Scene(const std::string &cpu) : engine(llvm_back::makeEngine({cpu, nullptr})) {
    key.targets[0].format.layout = Layout::U8x4;
  }

  void addTexture(int width, int height, Wrap wrap, abi::Filter filter = abi::Filter::Nearest,
                  Layout layout = Layout::U8x4) {
    abi::SamplerKey sampler{};
    sampler.format.layout = layout;
    sampler.wrap = {wrap, wrap, wrap};
    sampler.magnify = sampler.minify = filter;
    key.samplers[textures.size()] = sampler;
    textures.push_back(testing::makeTexture(sampler, width, height, 5));
    data.textures[textures.size() - 1] = &textures.back()->view;
  }

  /// Shades the spans and returns the target's bytes.
  std::vector<std::uint8_t> draw(const ir::Program &program, const std::vector<QuadInput> &corners,
                                 const std::vector<abi::Span> &spans,
                                 const std::vector<std::array<float, 4>> &locals = {}) {
    key.lanes = abi::Lanes::Row;
    return shade(program, corners, spans.data(), spans.size(), locals);
  }

  /// The whole window by blocks.
  std::vector<std::uint8_t> drawBlocks(const ir::Program &program,
                                       const std::vector<QuadInput> &corners,
                                       const std::vector<std::array<float, 4>> &locals = {}) {
    key.lanes = abi::Lanes::Quad;
    std::vector<abi::Block> blocks;
    for (int y = 0; y < kHeight; y += engine->blockHeight())
      for (int x = 0; x < kWidth; x += engine->blockWidth()) {
        unsigned mask = 0;
        for (int i = 0; i < engine->lanes(); ++i)
          if (x + i % engine->blockWidth() < kWidth && y + i / engine->blockWidth() < kHeight)
            mask |= 1u << i;
        blocks.push_back({std::int16_t(x), std::int16_t(y), std::uint16_t(mask), 0});
      }
    return shade(program, corners, blocks.data(), blocks.size(), locals);
  }

  std::vector<std::uint8_t> shade(const ir::Program &program, const std::vector<QuadInput> &corners,
                                  const void *items, std::size_t count,
                                  const std::vector<std::array<float, 4>> &locals) {
    prepared = engine->prepareFragment(program, Numerics::Host);
    EXPECT_NE(prepared, nullptr);
    for (std::size_t i = 0; i < prepared->shape().inputs.size(); ++i) {
      key.inputs[i] = abi::Interpolation::Linear;
      testing::setQuadInput(primitive, int(i), corners[prepared->shape().inputs[i].attribute.index],
                            kWidth, kHeight);
    }
    rows = testing::parameterRows(prepared->program(), locals);
    data.parameters = reinterpret_cast<const float(*)[4]>(rows.data());
    target = testing::makeTarget(key.targets[0].format, kWidth, kHeight, 1);
    data.targets[0] = {target.pixel(0, 0), target.rowStride};
    std::string reason;
    const auto code = engine->compile(*prepared, key, reason);
    EXPECT_NE(code, nullptr) << reason;
    if (code)
      code->function(&data, &primitive, items, std::uint32_t(count));
    return target.bytes;
  }

  /// An input's value as the function computes it.
  float at(int input, int component, int x, int y) const {
    const abi::Plane &plane = primitive.inputs[input][component];
    volatile const float row = plane.dy * float(y - primitive.originY);
    volatile const float sum = plane.c + row;
    volatile const float along = plane.dx * float(x - primitive.originX);
    return sum + along;
  }

  std::unique_ptr<jit::Engine> engine;
  std::unique_ptr<jit::FragmentProgram> prepared;
  abi::FragmentKey key{};
  abi::FragmentData data{};
  abi::Primitive primitive{};
  std::vector<std::array<float, 4>> rows;
  std::vector<std::unique_ptr<testing::SceneTexture>> textures;
  testing::SceneTarget target;
};

std::vector<abi::Span> wholeRows() {
  std::vector<abi::Span> spans;
  for (int y = 0; y < kHeight; ++y)
    spans.push_back({0, std::int16_t(y), kWidth, 0});
  return spans;
}

ir::Program passThrough() {
  ir::Builder b;
  b.tex(Opcode::Tex, b.color(), b.attribute(AttributeKind::TexCoord), 0, TexTarget::Tex2D);
  return b.take();
}

/// What the interpreter makes of pixel (x, y), as bytes of an RGBA8 target.
std::array<std::uint8_t, 4> expected(const Scene &scene, const ir::Program &program, int x, int y,
                                     const std::vector<std::array<float, 4>> &locals = {}) {
  ir::Inputs inputs;
  std::vector<ir::Vec4> attributes;
  for (const ir::Attribute &attribute : program.attributes) {
    ir::Vec4 value = {};
    for (std::size_t i = 0; i < scene.prepared->shape().inputs.size(); ++i)
      if (scene.prepared->shape().inputs[i].attribute == attribute)
        for (int c = 0; c < 4; ++c)
          value[std::size_t(c)] = scene.at(int(i), c, x, y);
    attributes.push_back(value);
  }
  inputs.attributes = attributes;
  inputs.parameter = [&](const ir::Parameter &parameter) {
    return parameter.index < locals.size() ? locals[parameter.index] : ir::Vec4{};
  };
  inputs.texture = [&](const ir::Sample &sample) {
    const std::uint8_t *const texel = texelAt(*scene.textures[sample.unit], sample.coordinate);
    ir::Vec4 value;
    for (std::size_t c = 0; c < 4; ++c)
      value[c] = float(texel[c]) / 255.0f;
    return value;
  };
  const ir::Evaluation result = ir::evaluate(program, inputs);
  std::array<std::uint8_t, 4> bytes = {};
  for (std::size_t c = 0; c < 4; ++c) {
    const float value = result.outputs[0][c];
    bytes[c] = std::uint8_t(std::lround(std::fmin(std::fmax(value, 0.0f), 1.0f) * 255.0f));
  }
  return bytes;
}

/// Every pixel of the spans within one step of the interpreter's, every other byte as it was.
void check(Scene &scene, const ir::Program &program, const std::vector<abi::Span> &spans,
           const std::vector<std::array<float, 4>> &locals = {}) {
  testing::SceneTarget before = testing::makeTarget(scene.target.format, kWidth, kHeight, 1);
  for (const abi::Span &span : spans)
    for (int x = span.x; x < span.x + span.count; ++x) {
      const auto want = expected(scene, program, x, span.y, locals);
      std::uint8_t *const got = scene.target.pixel(x, span.y);
      for (std::size_t c = 0; c < 4; ++c)
        ASSERT_NEAR(got[c], want[c], 1) << "pixel " << x << ", " << span.y << " component " << c;
      std::memcpy(got, before.pixel(x, span.y), 4);
    }
  EXPECT_EQ(scene.target.bytes, before.bytes) << "bytes outside of the spans were written";
}

class FragmentTest : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Cpus, FragmentTest, ::testing::ValuesIn(cpus()), [](const auto &info) {
  return info.param.empty() ? "native" : info.param;
});

TEST_P(FragmentTest, CopiesATextureAsItLies) {
  for (const abi::Filter filter : {abi::Filter::Nearest, abi::Filter::Linear}) {
    Scene scene(GetParam());
    scene.addTexture(kWidth, kHeight, Wrap::ClampToEdge, filter);
    scene.draw(passThrough(), {{}}, wholeRows());
    for (int y = 0; y < kHeight; ++y)
      EXPECT_EQ(std::memcmp(scene.target.pixel(0, y),
                            scene.textures[0]->level.base + y * kWidth * 4, kWidth * 4),
                0)
          << "row " << y;
    check(scene, passThrough(), wholeRows());
  }
}

TEST_P(FragmentTest, PermutesBytesForTheTargetsFormat) {
  Scene scene(GetParam());
  scene.addTexture(kWidth, kHeight, Wrap::Repeat);
  scene.key.targets[0].format.swizzle = {abi::From::C2, abi::From::C1, abi::From::C0,
                                         abi::From::One};
  scene.draw(passThrough(), {{}}, wholeRows());
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const std::uint8_t *const texel = scene.textures[0]->level.base + (y * kWidth + x) * 4;
      const std::uint8_t *const got = scene.target.pixel(x, y);
      ASSERT_EQ(got[0], texel[2]);
      ASSERT_EQ(got[1], texel[1]);
      ASSERT_EQ(got[2], texel[0]);
      ASSERT_EQ(got[3], 0xFF);
    }
}

/// Shifts by whole texels in either direction, in both wrap modes; spans of all lengths.
TEST_P(FragmentTest, WrapsShiftedCoordinates) {
  for (const Wrap wrap : {Wrap::Repeat, Wrap::ClampToEdge})
    for (const float shift : {0.0f, 1.0f, -1.0f, 20.0f, -40.0f, 75.0f, 1000.0f, 0.5f, 0.3f}) {
      SCOPED_TRACE(shift);
      Scene scene(GetParam());
      scene.addTexture(kWidth, kHeight, wrap);
      std::vector<abi::Span> spans;
      for (int y = 0; y < kHeight; ++y)
        spans.push_back({std::int16_t(3 * y), std::int16_t(y), std::uint16_t(kWidth - 7 * y), 0});
      const float s = (shift + 0.01f) / kWidth, t = shift / kHeight;
      scene.draw(passThrough(), {{s, t, 1 + s, 1 + t}}, spans);
      check(scene, passThrough(), spans);
    }
}

/// Rows read consecutive texels as loads, blocks read them like any others.
TEST_P(FragmentTest, RowsAndBlocksAgree) {
  ir::Builder b;
  auto texel = b.temporary();
  b.tex(Opcode::Tex, texel, b.attribute(AttributeKind::TexCoord), 0, TexTarget::Tex2D);
  b.op(Opcode::Mad, b.color(), {texel.read(), b.local(0), b.local(1)});
  const ir::Program changed = b.take();
  const std::vector<std::array<float, 4>> locals = {{0.5f, 0.7f, 0.9f, 1}, {0.1f, 0, 0, 0}};
  for (const abi::Filter filter : {abi::Filter::Nearest, abi::Filter::Linear})
    for (const Wrap wrap : {Wrap::Repeat, Wrap::ClampToEdge, Wrap::MirroredRepeat, Wrap::Clamp})
      for (const Layout layout : {Layout::U8x4, Layout::U16x4, Layout::F32x4})
        for (const float shift : {0.0f, -3.0f, 40.0f}) {
          // Other layouts than of bytes read consecutive texels with the nearest filter alone.
          if ((layout != Layout::U8x4 && filter == abi::Filter::Linear) ||
              (layout == Layout::F32x4 && shift == 0.0f))
            continue;
          SCOPED_TRACE("filter " + std::to_string(int(filter)) + " wrap " +
                       std::to_string(int(wrap)) + " layout " + std::to_string(int(layout)) +
                       " shift " + std::to_string(shift));
          Scene scene(GetParam());
          scene.addTexture(kWidth, kHeight, wrap, filter, layout);
          if (layout == Layout::F32x4)
            for (std::size_t i = 0; i < scene.textures[0]->bytes.size(); i += 4)
              scene.textures[0]->bytes[i + 3] = 0x3E; // of numbers below 1
          const float s = shift / kWidth, t = 2 * shift / kHeight;
          const std::vector<QuadInput> corners = {{s, t, 1 + s, 1 + t}};
          const ir::Program &program =
              layout == Layout::U8x4 && shift < 0 ? passThrough() : changed;
          const auto rows = scene.draw(program, corners, wholeRows(), locals);
          EXPECT_EQ(rows, scene.drawBlocks(program, corners, locals));
        }
}

TEST_P(FragmentTest, WritesSeveralTargets) {
  ir::Builder b;
  b.options().drawBuffers = true;
  const ir::Source place = b.attribute(AttributeKind::TexCoord);
  b.op(Opcode::Mov, b.color(0), {place});
  b.op(Opcode::Sub, b.color(1), {b.constant(1), place});
  ir::Program program = b.take();
  for (const bool several : {true, false}) {
    program.options.drawBuffers = several;
    if (!several)
      program.outputs.pop_back(), program.code.pop_back();
    Scene scene(GetParam());
    scene.key.targets[1].format.layout = Layout::U8x4;
    testing::SceneTarget second =
        testing::makeTarget({Layout::U8x4, abi::kRgba}, kWidth, kHeight, 4);
    scene.data.targets[1] = {second.pixel(0, 0), second.rowStride};
    scene.draw(program, {{}}, wholeRows());
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const float s = scene.at(0, 0, x, y);
        ASSERT_NEAR(scene.target.pixel(x, y)[0], 255 * s, 0.51f);
        ASSERT_NEAR(second.pixel(x, y)[0], 255 * (several ? 1 - s : s), 0.51f);
      }
  }
}

TEST_P(FragmentTest, AppliesFogAndColourSum) {
  for (const ir::FogMode mode :
       {ir::FogMode::None, ir::FogMode::Exp, ir::FogMode::Exp2, ir::FogMode::Linear}) {
    ir::Builder b;
    b.options().fog = mode;
    b.options().colorSum = true;
    b.op(Opcode::Mul, b.color(), {b.attribute(AttributeKind::TexCoord), b.constant(1.2f)});
    const ir::Program program = b.take();
    Scene scene(GetParam());
    abi::FragmentData &data = scene.data;
    data.fogDensity = 1.3f;
    data.fogStart = 0.1f;
    data.fogEnd = 0.8f;
    data.fogScale = 1 / 0.7f;
    const float color[4] = {0.3f, 0.5f, 0.9f, 1};
    std::copy_n(color, 4, data.fogColor);
    scene.draw(program, {{}}, wholeRows());
    const std::vector<jit::FragmentInput> &wanted = scene.prepared->shape().inputs;
    const auto inputOf = [&](AttributeKind kind) {
      for (std::size_t i = 0; i < wanted.size(); ++i)
        if (wanted[i].attribute.kind == kind)
          return int(i);
      return -1;
    };
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const auto value = [&](AttributeKind kind) {
          ir::Vec4 four = {};
          for (int c = 0; c < 4 && inputOf(kind) >= 0; ++c)
            four[std::size_t(c)] = scene.at(inputOf(kind), c, x, y);
          return four;
        };
        ir::Inputs inputs;
        const std::vector<ir::Vec4> attributes = {value(AttributeKind::TexCoord)};
        inputs.attributes = attributes;
        inputs.fogCoordinate = value(AttributeKind::FogCoord)[0];
        inputs.secondary = value(AttributeKind::ColorSecondary);
        inputs.parameter = [&](const ir::Parameter &parameter) {
          if (parameter.kind == ir::ParameterKind::State &&
              parameter.state.item == ir::StateItem::FogColor)
            return ir::Vec4{color[0], color[1], color[2], color[3]};
          return ir::Vec4{data.fogDensity, data.fogStart, data.fogEnd, data.fogScale};
        };
        const ir::Evaluation want = ir::evaluate(program, inputs);
        for (std::size_t c = 0; c < 4; ++c)
          ASSERT_NEAR(scene.target.pixel(x, y)[c],
                      255 * std::fmin(std::fmax(want.outputs[0][c], 0.0f), 1.0f), 1)
              << x << ", " << y;
      }
  }
}

TEST_P(FragmentTest, TakesTheGeneralPathWhereTexelsAreNotConsecutive) {
  const QuadInput inputs[] = {
      {0.003f, 0.002f, 2.003f, 2.002f}, {1, 1, 0, 0}, {0, 0, 0.5f, 0.5f}, {0, 0, 1.01f, 1}};
  for (const QuadInput &input : inputs) {
    Scene scene(GetParam());
    scene.addTexture(kWidth, kHeight, Wrap::Repeat);
    scene.draw(passThrough(), {input}, wholeRows());
    check(scene, passThrough(), wholeRows());
  }
}

TEST_P(FragmentTest, ScalesAndShiftsByParameters) {
  ir::Builder b;
  auto place = b.temporary();
  auto texel = b.temporary();
  b.op(Opcode::Mad, place, {b.attribute(AttributeKind::TexCoord), b.local(0), b.local(1)});
  b.tex(Opcode::Tex, texel, place.read(), 0, TexTarget::Tex2D);
  b.op(Opcode::Mad, b.color(), {texel.read(), b.constant(0.5f), b.local(2)});
  const ir::Program program = b.take();
  for (const float shift : {0.0f, 3.0f / kWidth, -0.25f}) {
    Scene scene(GetParam());
    scene.addTexture(kWidth, kHeight, Wrap::Repeat);
    const std::vector<std::array<float, 4>> locals = {
        {0.5f, 0.5f, 0, 0}, {shift, 0, 0, 0}, {0.1f, 0.2f, 0.3f, 0.4f}};
    scene.draw(program, {{0, 0, 2, 2}}, wholeRows(), locals);
    check(scene, program, wholeRows(), locals);
  }
}

/// Many pixels in one call are looked up in tables (fragment_bytes.h); one row at a time they are
/// computed.
TEST_P(FragmentTest, LooksUpWhatItComputes) {
  ir::Builder b;
  auto texel = b.temporary();
  b.tex(Opcode::Tex, texel, b.attribute(AttributeKind::TexCoord), 0, TexTarget::Tex2D);
  for (const char *const c : {"x", "y", "z"})
    b.op(Opcode::Pow, texel.mask(c), {texel.read().swz(c), b.local(0).swz(c)});
  b.op(Opcode::Mad, b.color(), {texel.read().swz("zxyw"), b.local(1), b.local(2)});
  const ir::Program program = b.take();
  const std::vector<std::array<float, 4>> locals = {
      {0.5f, 1.5f, 3.0f, 0}, {1.3f, 0.8f, 1.0f, -1.0f}, {-0.2f, 0.1f, 0, 1.0f}};
  for (const abi::From alpha : {abi::From::C3, abi::From::One}) {
    Scene scene(GetParam());
    scene.addTexture(kWidth, kHeight, Wrap::Repeat);
    scene.key.targets[0].format.swizzle = {abi::From::C2, abi::From::C1, abi::From::C0, alpha};
    std::vector<abi::Span> often;
    for (int i = 0; i < 10; ++i)
      for (const abi::Span &span : wholeRows())
        often.push_back(span);
    const float shift = 5.0f / kWidth;
    const std::vector<std::uint8_t> many =
        scene.draw(program, {{shift, 0, 1 + shift, 1}}, often, locals);
    const std::vector<std::uint8_t> few =
        scene.draw(program, {{shift, 0, 1 + shift, 1}}, wholeRows(), locals);
    EXPECT_EQ(many, few);
  }
}

TEST_P(FragmentTest, KilledPixelsStay) {
  ir::Builder b;
  auto texel = b.temporary();
  b.tex(Opcode::Tex, texel, b.attribute(AttributeKind::TexCoord), 0, TexTarget::Tex2D);
  auto less = b.temporary();
  b.op(Opcode::Sub, less, {texel.read().swz("x"), b.constant(0.5f)});
  b.kil(less.read());
  b.op(Opcode::Mov, b.color(), {texel.read()});
  const ir::Program program = b.take();
  Scene scene(GetParam());
  scene.addTexture(kWidth, kHeight, Wrap::Repeat);
  scene.draw(program, {{}}, wholeRows());
  testing::SceneTarget before = testing::makeTarget(scene.target.format, kWidth, kHeight, 1);
  int killed = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const std::uint8_t *const texel8 = scene.textures[0]->level.base + (y * kWidth + x) * 4;
      const bool kill = texel8[0] < 128;
      killed += kill;
      ASSERT_EQ(std::memcmp(scene.target.pixel(x, y), kill ? before.pixel(x, y) : texel8, 4), 0);
    }
  EXPECT_GT(killed, 0);
}

TEST_P(FragmentTest, ReadsTheWindowPosition) {
  ir::Builder b;
  b.op(Opcode::Mul, b.color(),
       {b.attribute(AttributeKind::Position), b.constant(1.0f / kWidth, 1.0f / kHeight, 1, 1)});
  const ir::Program program = b.take();
  for (const bool upper : {false, true})
    for (const bool integer : {false, true}) {
      Scene scene(GetParam());
      ir::Program variant = program;
      variant.options.originUpperLeft = upper;
      variant.options.pixelCenterInteger = integer;
      scene.data.windowHeight = kHeight;
      scene.primitive.z = {0.25f, 0.01f, 0};
      scene.primitive.inverseW = {0.5f, 0, 0.02f};
      scene.draw(variant, {}, wholeRows());
      const float centre = integer ? 0.0f : 0.5f;
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
          const int row = upper ? kHeight - 1 - y : y;
          const float want[4] = {(float(x) + centre) / kWidth, (float(row) + centre) / kHeight,
                                 0.25f + 0.01f * float(x), 0.5f + 0.02f * float(y)};
          for (int c = 0; c < 4; ++c)
            ASSERT_NEAR(scene.target.pixel(x, y)[c], 255 * std::fmin(want[c], 1.0f), 0.51f)
                << x << ", " << y << ", " << c;
        }
    }
}

/// A texture at the pixel's own place, whichever way up the window is.
TEST_P(FragmentTest, SamplesAtTheWindowPosition) {
  for (const bool upper : {false, true}) {
    ir::Builder b;
    b.options().originUpperLeft = upper;
    auto place = b.temporary();
    b.op(Opcode::Mul, place,
         {b.attribute(AttributeKind::Position), b.constant(1.0f / kWidth, 1.0f / kHeight, 1, 1)});
    b.tex(Opcode::Tex, b.color(), place.read(), 0, TexTarget::Tex2D);
    const ir::Program program = b.take();
    Scene scene(GetParam());
    scene.addTexture(kWidth, kHeight, Wrap::ClampToEdge);
    scene.data.windowHeight = kHeight;
    scene.draw(program, {}, wholeRows());
    for (int y = 0; y < kHeight; ++y)
      EXPECT_EQ(
          std::memcmp(scene.target.pixel(0, y),
                      scene.textures[0]->level.base + (upper ? kHeight - 1 - y : y) * kWidth * 4,
                      kWidth * 4),
          0)
          << "row " << y;
  }
}

TEST_P(FragmentTest, KeepsMaskedComponents) {
  Scene scene(GetParam());
  scene.addTexture(kWidth, kHeight, Wrap::Repeat);
  scene.key.targets[0].writeMask = 0x5;
  scene.draw(passThrough(), {{}}, wholeRows());
  testing::SceneTarget before = testing::makeTarget(scene.target.format, kWidth, kHeight, 1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 4; ++c)
        ASSERT_EQ(scene.target.pixel(x, y)[c],
                  c % 2 == 0 ? scene.textures[0]->level.base[(y * kWidth + x) * 4 + c]
                             : before.pixel(x, y)[c]);
}

} // namespace
} // namespace arbiter::fp
