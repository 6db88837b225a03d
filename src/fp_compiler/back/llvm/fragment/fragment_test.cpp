#include "fp_compiler/back/llvm/testing/fragment_window.h"
#include "fp_compiler/back/llvm/testing/machine.h"

/// Compares samples of fragment functions over spans with the interpreter, which has its own
/// nearest lookup.
namespace arbiter::fp::testing {
namespace {

using ir::AttributeKind;
using ir::Opcode;
using ir::TexTarget;

int wrapped(int index, int size, Wrap wrap) {
  if (wrap == Wrap::Repeat)
    return ((index % size) + size) % size;
  return std::clamp(index, 0, size - 1);
}

/// Returns the nearest texel of a U8x4 texture, as stored.
const std::uint8_t *texelAt(const SceneTexture &texture, const ir::Vec4 &coordinate) {
  const int x = int(std::floor(coordinate[0] * float(texture.width)));
  const int y = int(std::floor(coordinate[1] * float(texture.height)));
  return texture.level.base +
         wrapped(y, texture.height, texture.key.wrap[1]) * texture.level.rowStride +
         wrapped(x, texture.width, texture.key.wrap[0]) * 4;
}

/// Returns the interpreter's result for pixel (x, y), as bytes of an RGBA8 target.
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

/// Checks that every pixel of the spans is within one step of the interpreter's, and that no other
/// byte changed.
void check(Scene &scene, const ir::Program &program, const std::vector<abi::Span> &spans,
           const std::vector<std::array<float, 4>> &locals = {}) {
  SceneTarget before = makeTarget(scene.target.format, kWidth, kHeight, 1);
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

INSTANTIATE_TEST_SUITE_P(Cpus, FragmentTest, ::testing::ValuesIn(cpus()),
                         [](const auto &cpu) { return llvm_back::nameInTests(cpu.param); });

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

/// Shifts by whole texels in both directions and in both wrap modes, with spans of all lengths.
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

/// A vector of pixels reaches beyond both edges at once.
TEST_P(FragmentTest, ClampsToBothEdgesOfANarrowTexture) {
  for (const int width : {1, 5, 13})
    for (const float shift : {-1.0f, -4.0f}) {
      SCOPED_TRACE(std::to_string(width) + " texels from " + std::to_string(shift) + " on");
      Scene scene(GetParam());
      scene.addTexture(width, kHeight, Wrap::ClampToEdge);
      const float s = (shift + 0.25f) / float(width);
      scene.draw(passThrough(), {{s, 0, s + float(kWidth) / float(width), 1}}, wholeRows());
      check(scene, passThrough(), wholeRows());
    }
}

/// Rows read consecutive texels as plain loads, but blocks sample them individually.
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
          // Layouts other than bytes read consecutive texels only with the nearest filter.
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
              scene.textures[0]->bytes[i + 3] = 0x3E; // makes numbers below 1
          const float s = shift / kWidth, t = 2 * shift / kHeight;
          const std::vector<QuadInput> corners = {{s, t, 1 + s, 1 + t}};
          const ir::Program &program =
              layout == Layout::U8x4 && shift < 0 ? passThrough() : changed;
          const auto rows = scene.draw(program, corners, wholeRows(), locals);
          EXPECT_EQ(rows, scene.drawBlocks(program, corners, locals));
        }
}

/// A linear filter at 1:1 loads texels of large textures too, where coordinates have larger
/// rounding errors. The program amplifies differences of a 64th of a step, so that weights of
/// neighbours would show.
TEST_P(FragmentTest, LoadsTexelsOfLargeLinearTextures) {
  ir::Builder b;
  auto texel = b.temporary();
  b.tex(Opcode::Tex, texel, b.attribute(AttributeKind::TexCoord), 0, TexTarget::Tex2D);
  b.op(Opcode::Mad, texel, {texel.read(), b.constant(255.0f), b.constant(0.5f)});
  b.op(Opcode::Frc, texel, {texel.read()});
  b.op(Opcode::Mad, b.color(), {texel.read(), b.constant(64.0f), b.constant(-31.5f)});
  const ir::Program program = b.take();
  for (const int width : {1024, 1280, 1536, 1920, 2047, 2048, 2560, 3840, 4095, 4096}) {
    SCOPED_TRACE(width);
    Scene scene(GetParam());
    scene.addTexture(width, kHeight, Wrap::ClampToEdge, abi::Filter::Linear);
    const float s = float(width - kWidth) / float(width); // samples the last columns
    scene.draw(program, {{s, 0, 1, 1}}, wholeRows());
    check(scene, program, wholeRows());
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

/// Many pixels in one call use tables (fragment_bytes.h). Single rows compute the same values.
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

} // namespace
} // namespace arbiter::fp::testing
