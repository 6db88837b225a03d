/// Tests that a compilation survives serialisation, and that damaged bytes never become a program.
#include "fp_compiler/compilation.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "fp_compiler/hw/profile.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/testing/inputs.h"
#include "fp_compiler/testing/random.h"

namespace arbiter::fp {
namespace {

CompilationInput input(LimitPolicy policy = LimitPolicy::Enforce) {
  CompilationInput input;
  input.options.limits = hw::findBuiltin("r300")->fragment;
  input.options.policy = policy;
  return input;
}

void expectSame(const Compilation &a, const Compilation &b, std::string_view text) {
  EXPECT_EQ(a.check.errorString(text), b.check.errorString(text));
  EXPECT_EQ(a.check.errorPosition(), b.check.errorPosition());
  ASSERT_EQ(a.check.ok(), b.check.ok());
  EXPECT_EQ(a.check.counts, b.check.counts);
  EXPECT_EQ(a.check.nativeCounts, b.check.nativeCounts);
  EXPECT_EQ(a.check.underNativeLimits, b.check.underNativeLimits);
  if (a.check.ok()) {
    EXPECT_EQ(ir::print(*a.check.program), ir::print(*b.check.program));
  }
  EXPECT_EQ(a.glsl.text, b.glsl.text);
  ASSERT_EQ(a.glsl.uniforms.size(), b.glsl.uniforms.size());
  for (std::size_t i = 0; i < a.glsl.uniforms.size(); ++i) {
    EXPECT_EQ(a.glsl.uniforms[i].parameter.kind, b.glsl.uniforms[i].parameter.kind);
    EXPECT_EQ(a.glsl.uniforms[i].parameter.index, b.glsl.uniforms[i].parameter.index);
    EXPECT_EQ(a.glsl.uniforms[i].parameter.state, b.glsl.uniforms[i].parameter.state);
  }
  ASSERT_EQ(a.glsl.samplers.size(), b.glsl.samplers.size());
  for (std::size_t i = 0; i < a.glsl.samplers.size(); ++i)
    EXPECT_EQ(a.glsl.samplers[i].uniform, b.glsl.samplers[i].uniform);
  EXPECT_EQ(a.glsl.writesDepth, b.glsl.writesDepth);
  EXPECT_EQ(a.glsl.kills, b.glsl.kills);
}

const char *const kArbTexts[] = {
    "!!ARBfp1.0\nPARAM p = program.env[3];\nPARAM c = {1,2,3,4};\nTEMP t;\n"
    "TEX t, fragment.texcoord[1], texture[2], 2D;\nMAD_SAT t.xyz, -t.wzyx, p, c;\n"
    "KIL t.x;\nMUL result.color, t, state.material.diffuse;\nMOV result.depth.z, t.w;\nEND\n",
    "!!ARBfp1.0\nOPTION ARB_fog_exp2;\nMOV result.color, fragment.color;\nEND\n",
    "!!ARBfp1.0\nMOV result.color, nothing;\nEND\n",
    "", // not a program at all
};

TEST(Compilation, LoopsAreFollowedOnce) {
  const std::string text = "!!ARBfp1.0\nOPTION NV_fragment_program2;\nTEMP r, k;\nMOV k.x, 0.0;\n"
                           "REP 9;\nMAD r, fragment.color, k.x, r;\nADDC k.x, k.x, 1.0;\n"
                           "SUBC k.y, k.x, 3.0;\nBRK (GE.y);\nENDREP;\nMOV result.color, r;\nEND\n";
  CompilationInput nv = input(LimitPolicy::Report);
  nv.options.limits.nvOptions = 2;
  const CheckResult checked = checkProgram(nv.language, text, nv.options);
  ASSERT_TRUE(checked.ok()) << checked.errorString(text);
  ASSERT_TRUE(ir::hasLoops(*checked.program));
  const Compilation compiled = compile(nv, text);
  EXPECT_FALSE(ir::hasLoops(*compiled.check.program));
  EXPECT_EQ(compiled.check.counts, checked.counts) << "those of the text";
  EXPECT_EQ(compiled.glsl.text, emitGlsl(*checked.program, nv.host).text);
  for (const bool special : {false, true})
    EXPECT_TRUE(
        testing::same(testing::outcome(*checked.program, {3, Numerics::Host, special}),
                      testing::outcome(*compiled.check.program, {3, Numerics::Host, special})));
  const auto after = deserialise(serialise(compiled));
  ASSERT_TRUE(after);
  expectSame(compiled, *after, text);
  nv.numerics = Numerics::Legacy; // machine code does not use the passes of another mode
  EXPECT_TRUE(ir::hasLoops(*compile(nv, text).check.program));
}

TEST(Compilation, ComesBackAsItWas) {
  for (const char *text : kArbTexts) {
    const Compilation before = compile(input(), text);
    const auto after = deserialise(serialise(before));
    ASSERT_TRUE(after) << text;
    expectSame(before, *after, text);
    EXPECT_EQ(serialise(before), serialise(*after)); // compares also what expectSame() does not
  }
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::string text = testing::spell(testing::randomProgram(seed), seed);
    const Compilation before = compile(input(LimitPolicy::Report), text);
    const auto after = deserialise(serialise(before));
    ASSERT_TRUE(after) << text;
    expectSame(before, *after, text);
    EXPECT_EQ(serialise(before), serialise(*after));
  }
}

TEST(Compilation, VertexProgramsComeBackToo) {
  CompilationInput vertex = input();
  vertex.language = ir::Language::ArbVertex;
  vertex.options.limits.api = {256, 256, 0, 0, 32, 256, 16, 1};
  vertex.options.limits.native = vertex.options.limits.api;
  const char *const text = "!!ARBvp1.0\nADDRESS a;\nPARAM m[] = { program.env[0..7] };\n"
                           "ARL a.x, vertex.attrib[3].x;\nMOV result.color, m[a.x + 2];\n"
                           "MOV result.position, vertex.position;\nEND\n";
  const Compilation before = compile(vertex, text);
  ASSERT_TRUE(before.check.ok()) << before.check.errorString(text);
  const auto after = deserialise(serialise(before));
  ASSERT_TRUE(after);
  expectSame(before, *after, text);
  EXPECT_EQ(serialise(before), serialise(*after));
}

TEST(Compilation, BytesThatEndEarlyOrLateAreRefused) {
  for (const char *text : kArbTexts) {
    const std::string good = serialise(compile(input(), text));
    for (std::size_t length = 0; length < good.size(); ++length)
      ASSERT_FALSE(deserialise(std::string_view(good).substr(0, length))) << length;
    EXPECT_FALSE(deserialise(good + '\0'));
  }
}

// A checksum finds most damage before this. Bytes that it misses must cause no crash, no wild
// allocation, and no program that validate() rejects.
TEST(Compilation, AFlippedBitIsNoCrash) {
  for (const char *text : kArbTexts) {
    const std::string good = serialise(compile(input(), text));
    for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
      std::string bad = good;
      bad[bit / 8] = char(bad[bit / 8] ^ (1 << (bit % 8)));
      (void)deserialise(bad);
    }
  }
}

TEST(CacheKey, DiffersWhereverTheResultMay) {
  const std::string text = kArbTexts[0];
  const std::string key = cacheKey(input(), text);
  EXPECT_EQ(key, cacheKey(input(), text));
  EXPECT_NE(key, cacheKey(input(), text + " "));
  EXPECT_NE(key, cacheKey(input(LimitPolicy::Report), text));
  CompilationInput other = input();
  other.language = ir::Language::ArbVertex;
  EXPECT_NE(key, cacheKey(other, text));
  other = input();
  other.options.limits.native.temporaries += 1;
  EXPECT_NE(key, cacheKey(other, text));
  other = input();
  other.host.clipPlanes = !other.host.clipPlanes;
  EXPECT_NE(key, cacheKey(other, text));
  other = input();
  other.host.bitEncoding = false;
  EXPECT_NE(key, cacheKey(other, text));
  other = input();
  other.numerics = Numerics::Legacy;
  const std::string legacy = cacheKey(other, text);
  EXPECT_NE(key, legacy);
  other.numerics = Numerics::Fp24;
  EXPECT_NE(key, cacheKey(other, text));
  EXPECT_NE(legacy, cacheKey(other, text));
}

TEST(Compilation, IsOfItsMode) {
  CompilationInput legacy = input();
  legacy.numerics = Numerics::Legacy;
  const std::string text =
      "!!ARBfp1.0\nMUL result.color, fragment.texcoord[0], program.env[0];\nEND";
  EXPECT_NE(compile(legacy, text).glsl.text.find("arb_mul("), std::string::npos);
  EXPECT_EQ(compile(input(), text).glsl.text.find("arb_mul("), std::string::npos);
}

} // namespace
} // namespace arbiter::fp
