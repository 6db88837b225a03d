#include "fp_compiler/back/llvm/testing/fragment_window.h"
#include "fp_compiler/back/llvm/testing/machine.h"
#include "fp_compiler/testing/nv_program.h"

/// Tests of NVIDIA's options in fragment functions.
namespace arbiter::fp::testing {
namespace {

ir::Program nvProgram(const std::string &statements) {
  return nvFragmentProgram("TEMP r, s, left;\nATTRIB c = fragment.texcoord[0];\n" + statements);
}

using NvFragmentTest = FragmentTest;
INSTANTIATE_TEST_SUITE_P(Cpus, NvFragmentTest, ::testing::ValuesIn(cpus()),
                         [](const auto &cpu) { return llvm_back::nameInTests(cpu.param); });

std::uint8_t byteOf(float value) {
  return std::uint8_t(std::lround(std::fmin(std::fmax(value, 0.0f), 1.0f) * 255.0f));
}

/// Checks every pixel of the last draw, within one step.
template <typename F> void expectPixels(Scene &scene, F value) {
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const ir::Vec4 want = value(x, y);
      for (std::size_t c = 0; c < 4; ++c)
        ASSERT_NEAR(scene.target.pixel(x, y)[c], byteOf(want[c]), 1)
            << "pixel " << x << ", " << y << " component " << c;
    }
}

TEST_P(NvFragmentTest, FacingIsThePrimitives) {
  const ir::Program program = nvProgram("MAD result.color, fragment.facing, 0.5, 0.5;");
  for (const bool back : {false, true}) {
    const ir::Vec4 value = {back ? 0.0f : 1.0f, 0.5f, 0.5f, 1};
    Scene scene(GetParam());
    scene.primitive.backFacing = back ? 1 : 0;
    scene.draw(program, {}, wholeRows());
    expectPixels(scene, [&](int, int) { return value; });
    scene.drawBlocks(program, {});
    expectPixels(scene, [&](int, int) { return value; });
  }
}

TEST_P(NvFragmentTest, DerivativesAreTheQuads) {
  const ir::Program program =
      nvProgram("MUL r, c, c; DDX s.x, r.x; DDY s.y, r.y; MUL result.color, s, 4.0;");
  Scene scene(GetParam());
  scene.drawBlocks(program, {{0, 0, 4, 1}});
  const auto square = [&](int component, int x, int y) {
    const float value = scene.at(0, component, x, y);
    return value * value;
  };
  expectPixels(scene, [&](int x, int y) {
    const int left = x & ~1, lower = y & ~1;
    return ir::Vec4{4 * (square(0, left + 1, y) - square(0, left, y)),
                    4 * (square(1, x, lower + 1) - square(1, x, lower)), 0, 0};
  });
}

TEST_P(NvFragmentTest, ARowHasNoDerivatives) {
  Scene scene(GetParam());
  scene.prepared = scene.engine->prepareFragment(nvProgram("DDX result.color, c;"), Numerics::Host);
  ASSERT_NE(scene.prepared, nullptr);
  EXPECT_TRUE(scene.prepared->shape().derivatives);
  std::string reason;
  EXPECT_EQ(scene.engine->compile(*scene.prepared, scene.key, reason), nullptr);
  EXPECT_NE(reason.find("derivative"), std::string::npos) << reason;
}

/// Each pixel iterates as often as its own coordinate says; some are discarded on the way.
TEST_P(NvFragmentTest, LoopsEndForEachPixelByItself) {
  const ir::Program program =
      nvProgram("MOV r, 0.0; MUL s.x, c.x, 16.0; REP 20; ADDC s.x, s.x, -1.0; BRK (LT.x); "
                "ADD r, r, 0.0625; SGTC s.y, r.x, 0.9; KIL NE.y; ENDREP; MOV result.color, r;");
  Scene scene(GetParam());
  const std::vector<std::uint8_t> rows = scene.draw(program, {{0, 0, 1, 1}}, wholeRows());
  EXPECT_EQ(scene.drawBlocks(program, {{0, 0, 1, 1}}), rows);
  const SceneTarget before = makeTarget(scene.target.format, kWidth, kHeight, 1);
  int killed = 0;
  for (int x = 0; x < kWidth; ++x) {
    const float value = std::floor(scene.at(0, 0, x, 0) * 16) * 0.0625f;
    const std::uint8_t *const got = scene.target.pixel(x, 0);
    if (value > 0.9f) {
      ++killed;
      ASSERT_EQ(std::memcmp(got, SceneTarget(before).pixel(x, 0), 4), 0) << "pixel " << x;
    } else {
      ASSERT_NEAR(got[0], byteOf(value), 1) << "pixel " << x;
    }
  }
  EXPECT_GT(killed, 0);
}

/// Only pixels still in a loop take its samples.
TEST_P(NvFragmentTest, SamplesInLoops) {
  const ir::Program program =
      nvProgram("MOV r, 0.0; MUL left.x, c.x, 3.0; FLR left.x, left.x; REP 3.0; "
                "SUBC left.x, left.x, 1.0; BRK (LT.x); TEX s, c, texture[0], 2D; "
                "MAD r, s, 0.25, r; ENDREP; MOV result.color, r;");
  Scene scene(GetParam());
  scene.addTexture(kWidth, kHeight, Wrap::ClampToEdge);
  const std::vector<std::uint8_t> rows = scene.draw(program, {{0, 0, 1, 1}}, wholeRows());
  EXPECT_EQ(scene.drawBlocks(program, {{0, 0, 1, 1}}), rows);
  expectPixels(scene, [&](int x, int y) {
    const float times = std::floor(scene.at(0, 0, x, y) * 3);
    const std::uint8_t *const texel = scene.textures[0]->level.base + (y * kWidth + x) * 4;
    ir::Vec4 value;
    for (std::size_t c = 0; c < 4; ++c)
      value[c] = times * 0.25f * float(texel[c]) / 255.0f;
    return value;
  });
}

} // namespace
} // namespace arbiter::fp::testing
