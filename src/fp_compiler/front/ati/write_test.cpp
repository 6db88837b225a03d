#include "fp_compiler/front/ati/write.h"

#include <gtest/gtest.h>

#include "fp_compiler/ati/lower.h"
#include "fp_compiler/front/ati/parser.h"
#include "fp_compiler/front/ati/testing/eight_units.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/testing/random_ati.h"

namespace arbiter::fp::ati {
namespace {

TEST(AtiWrite, TheTextMeansTheShader) {
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    const Shader shader = testing::randomAtiShader(seed);
    const std::optional<std::string> text = write(shader);
    ASSERT_TRUE(text) << "seed " << seed;
    const ParseResult parsed = parse(*text, eightUnits());
    ASSERT_TRUE(parsed.shader) << "seed " << seed << "\n"
                               << *text << renderAll("text", *text, parsed.diagnostics);
    ASSERT_EQ(ir::print(lower(shader)), ir::print(lower(*parsed.shader))) << *text;
    EXPECT_EQ(write(*parsed.shader), text) << "another text of the same shader";
  }
}

/// Returns a bump map in two passes, as its commands would make it.
Shader bumps() {
  Shader shader;
  shader.passCount = 2;
  Pass &first = shader.passes[0];
  first.setups[1] = {SetupKind::SampleMap, false, 1, Coordinates::Str, {}};
  first.pairs[0].color =
      Operation{.op = Op::Mad,
                .destination = 2,
                .mask = 3,
                .scale = Scale::Twice,
                .saturate = true,
                .arguments = {{{Source::Register, 1, Replicate::None, false, true, true, true},
                               {Source::Constant, 3},
                               {Source::Zero}}}};
  first.pairCount = 1;
  Pass &last = shader.passes[1];
  last.setups[0] = {SetupKind::SampleMap, true, 2, Coordinates::StrDr, {}};
  last.pairs[0].color =
      Operation{.op = Op::Dot3, .arguments = {{{Source::Register, 0}, {Source::Constant, 0}}}};
  last.pairs[0].alpha = last.pairs[0].color;
  last.pairs[1].alpha =
      Operation{.op = Op::Mov, .arguments = {{{Source::Primary, 0, Replicate::Green, true}}}};
  last.pairCount = 2;
  shader.constants[3].kind = ConstantKind::Value;
  shader.constants[3].value = {0.5f, 0.1f, 0.0f, 1.0f};
  return shader;
}

TEST(AtiWrite, AStatementALine) {
  EXPECT_EQ(write(bumps()).value_or(""), "!!ATIfs1.0\n"
                                         "StartConstants;\n"
                                         "  CONSTANT c0 = program.env[0];\n"
                                         "  CONSTANT c3 = { 0.5, 0.100000001, 0, 1 };\n"
                                         "EndConstants;\n"
                                         "StartPrelimPass;\n"
                                         "  SampleMap r1, t1.str;\n"
                                         "  MAD r2.rg.2x.sat, r1.neg.2x.bias, c3, 0;\n"
                                         "EndPass;\n"
                                         "StartOutputPass;\n"
                                         "  SampleMap r0, r2.str_dr;\n"
                                         "  DOT3 r0, r0, c0;\n"
                                         "  MOV r0.a, color0.g.comp;\n"
                                         "EndPass;\n");
}

/// The text form cannot express these shaders.
TEST(AtiWrite, WhatHasNoWordsHasNoText) {
  Shader shader = bumps();
  shader.passes[0].setups[1].source = 6;
  EXPECT_FALSE(write(shader)) << "there is no t6";
  shader = bumps();
  shader.constants[3].value[1] = 1.5f;
  EXPECT_FALSE(write(shader)) << "literals are in [0,1]";
  shader.passes[0].pairs[0].color->arguments[1].index = 4;
  EXPECT_TRUE(write(shader)) << "none that is read is out of it";
  shader = bumps();
  shader.passes[1].pairs[0].alpha->destination = 1;
  EXPECT_FALSE(write(shader)) << "one statement has one destination";
}

} // namespace
} // namespace arbiter::fp::ati
