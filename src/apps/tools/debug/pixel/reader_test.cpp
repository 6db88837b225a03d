#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/tools/debug/pixel/cut.h"
#include "apps/tools/debug/pixel/reader.h"
#include "apps/tools/debug/pixel/verdict.h"
#include "apps/tools/debug/pixel/watch.h"
#include "apps/tools/debug/testing/fake_drawer.h"
#include "fp_compiler/back/assembly/assembly.h"
#include "fp_compiler/ir/validate.h"

namespace arbiter::tools::debug {
namespace {

using fp::Numerics;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char *kText = "!!ARBfp1.0\n"
                              "PARAM k = {0.5, 0.25, 0.125, 1.0};\n"
                              "TEMP a, b;\n"
                              "TEX a, fragment.texcoord[0], texture[1], 2D;\n"
                              "MUL b, a, k;\n"
                              "KIL b.x;\n"
                              "MAD b.xy, b, program.local[3].y, fragment.color;\n"
                              "TXP a.xyz, b, texture[0], 2D;\n"
                              "MOV result.color.w, b;\n"
                              "ADD_SAT result.color.xyz, a, b;\n"
                              "END\n";

/// Traces a program with the reader's inputs.
struct Debugged {
  Debugged(FakeDrawer &drawer, const std::string &text, int x, int y)
      : program(checked(text)), reader(drawer, program, x, y, Numerics::Host) {
    error = reader.read();
    if (!error)
      trace = record(program, text, reader.inputs(), {Numerics::Host, Numerics::Fp24});
  }
  fp::ir::Program program;
  PixelReader reader;
  std::optional<DebugError> error;
  Trace trace;
};

TEST(PixelReader, InputsAreTheDrawersOwn) {
  FakeDrawer drawer(kText, 16, 8);
  const Debugged pixel(drawer, kText, 5, 2);
  ASSERT_FALSE(pixel.error) << pixel.error->message;
  EXPECT_EQ(pixel.trace.rows[0].operands[0].value.first, (Vec4{5.5f / 16, 2.5f / 8, 0, 1}));
  EXPECT_EQ(pixel.trace.parameters[0].value.first, (Vec4{3, 0.5f, -1, 2}));
  EXPECT_EQ(pixel.reader.position(), (Vec4{5.5f, 2.5f, 0.5f, 1}));
  fp::ir::Sample sample;
  sample.unit = 1;
  sample.coordinate = {5.5f / 16, 2.5f / 8, 0, 0};
  EXPECT_EQ(pixel.trace.rows[0].texel->value.first, texelAt(sample));
  // 64 texels over 16 pixels and 32 over 8 are four texels per pixel.
  ASSERT_TRUE(pixel.trace.rows[0].texel->lod);
  EXPECT_FLOAT_EQ(*pixel.trace.rows[0].texel->lod, 2.0f);
}

TEST(PixelReader, TexelsOfAnotherArithmeticAreAtItsCoordinates) {
  FakeDrawer drawer(kText, 16, 8);
  const Debugged pixel(drawer, kText, 5, 2);
  const Texel &texel = *pixel.trace.rows[4].texel;
  ASSERT_NE(texel.coordinate.first, texel.coordinate.second);
  fp::ir::Sample sample;
  sample.unit = 0;
  sample.coordinate = texel.coordinate.second;
  EXPECT_EQ(texel.value.second, texelAt(sample));
  EXPECT_FALSE(pixel.reader.failure());
}

TEST(PixelReader, EveryPixelOfAnOddPictureCanBeRead) {
  FakeDrawer drawer(kText, 3, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) {
      const Debugged pixel(drawer, kText, x, y);
      ASSERT_FALSE(pixel.error);
      const auto verdict = judge(drawer, pixel.program, pixel.trace, x, y);
      ASSERT_TRUE(verdict);
      EXPECT_TRUE(verdict.value().bitsEqual) << x << "," << y;
    }
}

TEST(PixelReader, WhatLiesOutsideOrUncoveredIsSaid) {
  FakeDrawer drawer(kText, 16, 8);
  drawer.covers = [](int x, int) { return x > 3; };
  EXPECT_THAT(Debugged(drawer, kText, 16, 0).error->message, HasSubstr("15,7"));
  EXPECT_THAT(Debugged(drawer, kText, -1, 0).error->message, HasSubstr("-1,0"));
  EXPECT_THAT(Debugged(drawer, kText, 3, 0).error->message, HasSubstr("nothing"));
  EXPECT_FALSE(Debugged(drawer, kText, 4, 0).error);
}

TEST(Cut, EveryCutIsAProgramAndShowsItsRow) {
  FakeDrawer drawer(kText, 16, 8);
  const Debugged pixel(drawer, kText, 5, 2);
  for (std::size_t i = 0; i < pixel.program.code.size(); ++i) {
    EXPECT_THAT(fp::ir::validate(cutProgram(pixel.program, {{Probe::Kind::Value, i}})), IsEmpty());
    const auto drawn = drawRows(drawer, pixel.program, {i}, 5, 2);
    ASSERT_TRUE(drawn) << drawn.error().message;
    const Row &row = pixel.trace.rows[i];
    const Vec4 wanted = row.mask ? row.value.first : row.operands[0].value.first;
    EXPECT_EQ(differing(drawn.value()[0], wanted, row.mask ? row.mask : 0xF, {}), 0) << row.text;
  }
}

TEST(Verdict, EqualPicturesAreEqual) {
  FakeDrawer drawer(kText, 16, 8);
  const Debugged pixel(drawer, kText, 5, 2);
  const auto verdict = judge(drawer, pixel.program, pixel.trace, 5, 2);
  ASSERT_TRUE(verdict) << verdict.error().message;
  EXPECT_TRUE(verdict.value().isEqual());
  EXPECT_TRUE(verdict.value().bitsEqual);
  EXPECT_THAT(verdictLine(verdict.value(), pixel.trace), HasSubstr("fake drew "));
  EXPECT_THAT(verdictLine(verdict.value(), pixel.trace), HasSubstr(": equal, to the bit"));
}

TEST(Verdict, AWrongDrawerIsFoundAtItsFirstInstruction) {
  FakeDrawer drawer(kText, 16, 8);
  const Debugged pixel(drawer, kText, 5, 2);
  for (const auto op : {fp::ir::Opcode::Mul, fp::ir::Opcode::Mad}) {
    drawer.wrong = [op](const fp::ir::Instruction &instruction, Vec4 &value) {
      if (instruction.op == op)
        value[0] += 0.125f;
    };
    const auto verdict = judge(drawer, pixel.program, pixel.trace, 5, 2);
    ASSERT_TRUE(verdict);
    EXPECT_FALSE(verdict.value().isEqual());
    ASSERT_TRUE(verdict.value().first);
    EXPECT_EQ(pixel.trace.rows[verdict.value().first->row].op, op);
    EXPECT_EQ(verdict.value().first->components & 1, 1);
    EXPECT_THAT(verdictLine(verdict.value(), pixel.trace),
                HasSubstr(op == fp::ir::Opcode::Mul ? "/255, first at line 5: MUL b, a, k"
                                                    : "/255, first at line 7: MAD"));
  }
}

TEST(Verdict, ADiscardThatOnlyOneSideMakesDiffers) {
  FakeDrawer drawer(kText, 16, 8);
  const Debugged pixel(drawer, kText, 5, 2);
  drawer.wrong = [](const fp::ir::Instruction &instruction, Vec4 &value) {
    if (instruction.op == fp::ir::Opcode::Mul)
      value[0] = -1;
  };
  const auto verdict = judge(drawer, pixel.program, pixel.trace, 5, 2);
  ASSERT_TRUE(verdict);
  EXPECT_FALSE(verdict.value().isEqual());
  EXPECT_THAT(verdictLine(verdict.value(), pixel.trace),
              HasSubstr("discarded the fragment, the interpreter does not, first at line 5"));
}

constexpr const char *kDepthText = "!!ARBfp1.0\n"
                                   "TEMP far;\n"
                                   "MOV far, 1.0;\n"
                                   "MOV result.depth.z, far;\n"
                                   "KIL fragment.color;\n"
                                   "MUL result.color, fragment.color, {0.5, 1, 1, 1};\n"
                                   "END\n";

TEST(Verdict, AFragmentThatItsDepthHidesIsNotDiscarded) {
  FakeDrawer drawer(kDepthText, 16, 8);
  const Debugged pixel(drawer, kDepthText, 5, 2);
  ASSERT_FALSE(pixel.error);
  EXPECT_THAT(fp::ir::validate(withoutDepth(pixel.program)), IsEmpty());
  drawer.limit = 1;
  const auto verdict = judge(drawer, pixel.program, pixel.trace, 5, 2);
  ASSERT_TRUE(verdict) << verdict.error().message;
  EXPECT_TRUE(verdict.value().isHidden);
  EXPECT_TRUE(verdict.value().isEqual());
  EXPECT_TRUE(verdict.value().bitsEqual);
  EXPECT_THAT(verdictLine(verdict.value(), pixel.trace), HasSubstr("): equal, to the bit"));
  EXPECT_THAT(verdictLine(verdict.value(), pixel.trace),
              HasSubstr(" (the depth test hides the fragment "));
}

TEST(Verdict, AHiddenFragmentOfAnotherColorDiffers) {
  FakeDrawer drawer(kDepthText, 16, 8);
  const Debugged pixel(drawer, kDepthText, 5, 2);
  drawer.limit = 1;
  drawer.wrong = [](const fp::ir::Instruction &instruction, Vec4 &value) {
    if (instruction.op == fp::ir::Opcode::Mul)
      value[0] += 0.125f;
  };
  const auto verdict = judge(drawer, pixel.program, pixel.trace, 5, 2);
  ASSERT_TRUE(verdict) << verdict.error().message;
  EXPECT_TRUE(verdict.value().isHidden);
  EXPECT_FALSE(verdict.value().isEqual());
  ASSERT_TRUE(verdict.value().first);
  EXPECT_EQ(pixel.trace.rows[verdict.value().first->row].op, fp::ir::Opcode::Mul);
}

TEST(Verdict, ADiscardBeforeADepthIsADiscard) {
  FakeDrawer drawer(kDepthText, 16, 8);
  const Debugged pixel(drawer, kDepthText, 5, 2);
  drawer.covers = [](int, int) { return false; };
  const auto verdict = judge(drawer, pixel.program, pixel.trace, 5, 2);
  ASSERT_TRUE(verdict) << verdict.error().message;
  EXPECT_FALSE(verdict.value().isHidden);
  EXPECT_FALSE(verdict.value().isEqual());
  EXPECT_THAT(verdictLine(verdict.value(), pixel.trace),
              HasSubstr("discarded the fragment, the interpreter does not"));
}

TEST(Verdict, LongProgramsAreHalved) {
  std::string text = "!!ARBfp1.0\nTEMP a;\nMOV a, fragment.color;\n";
  for (int i = 0; i < 300; ++i)
    text += i == 200 ? "MUL a, a, 0.5;\n" : "ADD a, a, 0.001;\n";
  text += "MOV result.color, a;\nEND\n";
  FakeDrawer drawer(text, 4, 4);
  const Debugged pixel(drawer, text, 1, 1);
  drawer.wrong = [](const fp::ir::Instruction &instruction, Vec4 &value) {
    if (instruction.op == fp::ir::Opcode::Mul)
      value[2] += 0.25f;
  };
  drawer.drawn = 0;
  const auto verdict = judge(drawer, pixel.program, pixel.trace, 1, 1);
  ASSERT_TRUE(verdict);
  EXPECT_TRUE(verdict.value().bisected);
  ASSERT_TRUE(verdict.value().first);
  EXPECT_EQ(verdict.value().first->row, 201u);
  EXPECT_LT(drawer.drawn, 16);
}

std::string faultOfWatch(const char *text) {
  const auto watch = parseWatch(text);
  if (!watch)
    return watch.error().message;
  const auto program = watchProgram(checked(kText), kText, watch.value());
  return program ? "" : program.error().message;
}

/// The test draws nearer fragments later, and the program discards some; the visible one must
/// survive.
TEST(Cut, SurvivingFragmentsAreThoseOfTheProgram) {
  FakeDrawer drawer(kText, 16, 8);
  const fp::ir::Program program = checked(kText);
  EXPECT_TRUE(decidesFragments(program));
  drawer.wrong = [](const fp::ir::Instruction &instruction, Vec4 &value) {
    if (instruction.op == fp::ir::Opcode::Mul)
      value[0] = -1; // which makes every KIL discard
  };
  const auto at = [&](Fragments fragments) {
    const auto cut = cutProgram(program, {{Probe::Kind::Value, 0}}, fragments);
    EXPECT_THAT(fp::ir::validate(cut), IsEmpty());
    return drawer.draw(fp::emitAssembly(cut), 1, Region{5, 2, 1, 1}).value()[0];
  };
  EXPECT_NE(at(Fragments::Covered), uncovered());
  EXPECT_EQ(at(Fragments::Surviving), uncovered());
  EXPECT_EQ(Debugged(drawer, kText, 5, 2).reader.fragments(), Fragments::Covered);
  drawer.wrong = nullptr;
  EXPECT_EQ(at(Fragments::Surviving), at(Fragments::Covered));
  EXPECT_EQ(Debugged(drawer, kText, 5, 2).reader.fragments(), Fragments::Surviving);
}

TEST(Cut, DepthsOfTheProgramAreKept) {
  const fp::ir::Program program = checked("!!ARBfp1.0\nTEMP a;\nMOV a, fragment.color;\n"
                                          "MOV result.depth.z, a.x;\nMOV result.color, a;\nEND\n");
  EXPECT_TRUE(decidesFragments(program));
  for (const auto &cut : {cutProgram(program, {{Probe::Kind::Value, 0}}, Fragments::Surviving),
                          showOperands(program, {program.code[0].src[0]}, Fragments::Surviving)}) {
    EXPECT_THAT(fp::ir::validate(cut), IsEmpty());
    EXPECT_TRUE(fp::ir::validate(checked(fp::emitAssembly(cut))).empty());
    EXPECT_THAT(fp::emitAssembly(cut), HasSubstr("result.depth"));
  }
  EXPECT_THAT(fp::emitAssembly(cutProgram(program, {{Probe::Kind::Value, 1}})),
              testing::Not(HasSubstr("result.depth")));
}

TEST(Watch, AnyRegisterAfterAnyLine) {
  FakeDrawer drawer(kText, 16, 8);
  const Debugged pixel(drawer, kText, 5, 2);
  const auto at = [&](const char *text) {
    const auto program = watchProgram(pixel.program, kText, parseWatch(text).value());
    EXPECT_TRUE(program) << program.error().message;
    EXPECT_THAT(fp::ir::validate(program.value()), IsEmpty());
    const auto drawn = drawer.draw(fp::emitAssembly(program.value()), 1, Region{5, 2, 1, 1});
    EXPECT_TRUE(drawn);
    return drawn.value()[0];
  };
  EXPECT_EQ(at("a@4"), pixel.trace.rows[0].value.first);
  EXPECT_EQ(at("b@5"), pixel.trace.rows[1].value.first);
  EXPECT_EQ(at("b@6"), pixel.trace.rows[1].value.first) << "past the KIL";
  EXPECT_EQ(at("b@7"), pixel.trace.rows[3].value.first);
  EXPECT_EQ(at("k@5"), (Vec4{0.5f, 0.25f, 0.125f, 1}));
  EXPECT_EQ(at("-k.yyyy@99"), (Vec4{-0.25f, -0.25f, -0.25f, -0.25f}));
  EXPECT_EQ(at("fragment.color@4"), (Vec4{5.5f / 16, 2.5f / 8, 0, 1}));
  EXPECT_EQ(at("result.color@9")[3], pixel.trace.rows[5].value.first[3]);
  EXPECT_EQ(at("result.color@10"), pixel.trace.results[0].value.first);
}

TEST(Watch, WhatCannotBeSeenIsSaid) {
  EXPECT_THAT(faultOfWatch("a@3"), HasSubstr("no instruction stands at or before line 3"));
  EXPECT_THAT(faultOfWatch("c@5"), HasSubstr("'c'"));
  EXPECT_THAT(faultOfWatch("a"), HasSubstr("REGISTER@LINE"));
  EXPECT_THAT(faultOfWatch("@5"), HasSubstr("REGISTER@LINE"));
  EXPECT_THAT(faultOfWatch("a@"), HasSubstr("REGISTER@LINE"));
  EXPECT_THAT(faultOfWatch("a@-1"), HasSubstr("REGISTER@LINE"));
  EXPECT_THAT(faultOfWatch("a@99999999999"), HasSubstr("REGISTER@LINE"));
  EXPECT_THAT(faultOfWatch("a; KIL a@5"), HasSubstr("REGISTER@LINE"));
  EXPECT_THAT(faultOfWatch("a, a@5"), HasSubstr("--watch a, a@5: "));
  EXPECT_EQ(faultOfWatch("a@5"), "");
}

TEST(Watch, TheExtentIsOfNumbersThatAreCovered) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const Extent extent = extentOf({uncovered(), {1, kNan, 3, kNan}, {2, 5, -1, kNan}});
  EXPECT_EQ(extent.covered, 2u);
  EXPECT_EQ(extent.least[0], 1);
  EXPECT_EQ(extent.least[1], 5);
  EXPECT_EQ(extent.least[2], -1);
  EXPECT_EQ(extent.greatest[0], 2);
  EXPECT_EQ(extent.greatest[2], 3);
  EXPECT_TRUE(std::isnan(extent.least[3]) && std::isnan(extent.greatest[3]));
  EXPECT_EQ(extentOf({uncovered()}).covered, 0u);
}

TEST(Watch, ValuesBecomeColors) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(
      picturedValues({{0, 1, 2, -1}, {kNan, 0, 0, 0}, uncovered(), {0.5f, 1.5f, -1, 0}}, 0, 2),
      (std::vector<std::uint8_t>{0, 128, 255, 255, 255, 0, 255, 255, 0, 0, 0, 0, 64, 191, 0, 255}));
}

} // namespace
} // namespace arbiter::tools::debug
