#include "fp_compiler/back/llvm/testing/fragment_window.h"
#include "fp_compiler/ir/fog.h"

/// Tests of further parts of a fragment function: KIL, the window position, several targets, masks,
/// options.
namespace arbiter::fp::testing {
namespace {

using ir::AttributeKind;
using ir::Opcode;
using ir::TexTarget;

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
    SceneTarget second = makeTarget({Layout::U8x4, abi::kRgba}, kWidth, kHeight, 4);
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

TEST_P(FragmentTest, AppliesFogAndColorSum) {
  for (const ir::FogMode mode :
       {ir::FogMode::None, ir::FogMode::Exp, ir::FogMode::Exp2, ir::FogMode::Linear}) {
    ir::Builder b;
    b.options().fog = mode;
    b.options().colorSum = true;
    b.op(Opcode::Mul, b.color(), {b.attribute(AttributeKind::TexCoord), b.constant(1.2f)});
    const ir::Program program = b.take();
    Scene scene(GetParam());
    scene.state = [](const ir::StateRef &row) {
      const ir::Vec4 params = {1.3f, 0.1f, 0.8f, 1 / 0.7f};
      return row.item == ir::StateItem::FogColor     ? ir::Vec4{0.3f, 0.5f, 0.9f, 1}
             : row.item == ir::StateItem::FogFactors ? ir::fogFactors(params)
                                                     : params;
    };
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
        inputs.parameter = [&](const ir::Parameter &row) { return scene.state(row.state); };
        const ir::Evaluation want = ir::evaluate(program, inputs);
        for (std::size_t c = 0; c < 4; ++c)
          ASSERT_NEAR(scene.target.pixel(x, y)[c],
                      255 * std::fmin(std::fmax(want.outputs[0][c], 0.0f), 1.0f), 1)
              << x << ", " << y;
      }
  }
}

TEST_P(FragmentTest, ASmoothLineCoversAPartOfAlpha) {
  ir::Builder b;
  b.op(Opcode::Mov, b.color(), {b.attribute(AttributeKind::TexCoord)});
  Scene scene(GetParam());
  scene.key.coverage = abi::Coverage::Line;
  scene.key.inputs[1] = abi::Interpolation::Linear;
  scene.key.alphaTest = abi::Compare::Greater;
  scene.data.alphaReference = 0;
  abi::Plane *const line = scene.primitive.inputs[1];
  line[0] = {-3.31f, 0.1f, 0.7f}; // never exactly the reach
  line[1] = {-6.21f, 0.9f, -0.05f};
  line[2] = {2.25f, 0, 0};
  line[3] = {4.5f, 0, 0};
  scene.draw(b.take(), {{}}, wholeRows());
  SceneTarget before = makeTarget(scene.target.format, kWidth, kHeight, 1);
  const auto part = [](float from, float reach) {
    return std::fmin(std::fmax(reach - std::fabs(from), 0.0f), 1.0f);
  };
  int whole = 0, some = 0, none = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const auto at = [&](int c) {
        return line[c].c + line[c].dx * float(x) + line[c].dy * float(y);
      };
      const float covered = part(at(0), 2.25f) * part(at(1), 4.5f);
      const std::uint8_t *const pixel = scene.target.pixel(x, y);
      ++(covered == 1 ? whole : covered > 0 ? some : none);
      if (covered == 0) {
        ASSERT_EQ(std::memcmp(pixel, before.pixel(x, y), 4), 0) << "alpha is tested after it";
        continue;
      }
      ASSERT_NEAR(pixel[3], 255 * covered, 1) << x << ", " << y;
      ASSERT_NEAR(pixel[0], 255 * scene.at(0, 0, x, y), 0.51f) << "colours stay";
    }
  EXPECT_GT(std::min({whole, some, none}), 4);
}

TEST_P(FragmentTest, ASmoothPointIsADisc) {
  ir::Builder b;
  b.op(Opcode::Mov, b.color(), {b.constant(0.4f)});
  b.op(Opcode::Mov, b.color().mask("x"), {b.attribute(AttributeKind::TexCoord)});
  Scene scene(GetParam());
  scene.key.coverage = abi::Coverage::Disc;
  scene.key.inputs[1] = abi::Interpolation::Linear;
  scene.primitive.inputs[1][0] = {-4.1f, 0.25f, 0};
  scene.primitive.inputs[1][1] = {-0.9f, 0, 0.25f};
  scene.primitive.inputs[1][2] = {1.6f, 0, 0};
  const float alpha = 0.4f;
  scene.draw(b.take(), {{}}, wholeRows());
  SceneTarget before = makeTarget(scene.target.format, kWidth, kHeight, 1);
  int inside = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float distance = std::hypot(0.25f * float(x) - 4.1f, 0.25f * float(y) - 0.9f);
      const bool isInside = distance <= 1;
      const std::uint8_t *const pixel = scene.target.pixel(x, y);
      inside += isInside;
      if (isInside)
        ASSERT_NEAR(pixel[3], 255 * alpha * std::fmax(1.6f * (1 - distance * distance), 1.0f), 1)
            << x << ", " << y;
      else
        ASSERT_EQ(std::memcmp(pixel, before.pixel(x, y), 4), 0) << x << ", " << y;
    }
  EXPECT_GT(inside, 30);
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
  SceneTarget before = makeTarget(scene.target.format, kWidth, kHeight, 1);
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

/// Samples a texture at the pixel's own place, for both window orientations.
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
  SceneTarget before = makeTarget(scene.target.format, kWidth, kHeight, 1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 4; ++c)
        ASSERT_EQ(scene.target.pixel(x, y)[c],
                  c % 2 == 0 ? scene.textures[0]->level.base[(y * kWidth + x) * 4 + c]
                             : before.pixel(x, y)[c]);
}

} // namespace
} // namespace arbiter::fp::testing
