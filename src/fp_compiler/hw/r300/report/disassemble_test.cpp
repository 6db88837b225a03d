#include "fp_compiler/hw/r300/report/disassemble.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "fp_compiler/hw/r300/check/sample_code.h"

namespace arbiter::fp::hw::r300 {
namespace {

using namespace testing;

/// Returns the line that starts with \p beginning, with runs of spaces removed.
std::string line(const std::string &text, const std::string &beginning) {
  const std::size_t at = ("\n" + text).find("\n" + beginning);
  if (at == std::string::npos)
    return "nothing starts with " + beginning + " in\n" + text;
  std::string found = text.substr(at, text.find('\n', at) - at);
  found.erase(
      std::unique(found.begin(), found.end(), [](char a, char b) { return a == ' ' && b == ' '; }),
      found.end());
  return found;
}

TEST(Disassemble, Sample) {
  EXPECT_EQ(disassemble(sampleCode(), sampleProgram(), kSampleText),
            R"(; Radeon 9700 (R300) fragment program
; 2 of 4 nodes
; 4 of 64 pairs
; 3 of 32 texture instructions
; 4 of 32 registers
; 1 of 32 constants
; 1 of 8 texture coordinate interpolators

interpolants
  r0 = fragment.texcoord[0]
  r3 = fragment.color.primary

constants
  c0 = program.local[0]

node 1
      tex   r1 = r0, texture[0], 2D                                            ; line 3: TEX
    0 rgb   s0=r1 s1=c0                 r1.xyz =  mad s0.xyz, 1, s1.xyz        ; line 4: ADD
      alpha s0=r1 s1=c0                 r1.w =    mad s0.w, 1, s1.w            ; line 4: ADD

node 2
      kil   r0                                                                 ; line 5: KIL
      tex   r2 = r1, texture[1], 2D                                            ; line 6: TEX
    1 rgb   s0=r2 s1=r1                 r2.xyz =  dp4_sat s0.xyz, -s1.xyz      ; line 7: DP4
      alpha s0=r2 s1=r1                 r2.w =    dp_sat s0.w, -s1.w           ; line 7: DP4
    2 rgb   s0=r1 s1=r3 s2=r2 pre=s1-s0 o0.xyz =  mad pre.xyz, s2.xxx, s0.xyz  ; line 9: LRP
      alpha                             depth =   mad 1, 1, -s2.x              ; line 8: SUB
    3 rgb   s0=r2                                 nop
      alpha s0=r1 s1=r3 pre=s1-s0       o0.w =    mad pre.w, s0.x, s0.w        ; line 9: LRP
)");
}

TEST(Disassemble, WithoutTextInstructionsHaveNumbers) {
  const std::string text = disassemble(sampleCode(), sampleProgram(), "");
  EXPECT_EQ(line(text, "      kil"), " kil r0 ; 3: KIL");
}

TEST(Disassemble, EveryLineBreakCounts) {
  std::string text = kSampleText;
  std::replace(text.begin(), text.end(), '\n', '\r');
  EXPECT_EQ(line(disassemble(sampleCode(), sampleProgram(), text), "      kil"),
            " kil r0 ; line 5: KIL");
  text.replace(text.find('\r'), 1, "\r\n");
  ir::Program program = sampleProgram();
  for (ir::Instruction &instruction : program.code)
    ++instruction.span.begin;
  EXPECT_EQ(line(disassemble(sampleCode(), program, text), "      kil"), " kil r0 ; line 5: KIL");
}

TEST(Disassemble, WhatDoesNotFitIsSaid) {
  const std::string text =
      disassemble(sampleCode(), sampleProgram(), kSampleText, {.pairs = 3, .nodes = 1});
  EXPECT_EQ(line(text, "; 4 of 3"), "; 4 of 3 pairs: does not fit");
  EXPECT_EQ(line(text, "; 2 of 1"), "; 2 of 1 nodes: does not fit");
}

TEST(Disassemble, ConstantsOfTheDriverHaveAReason) {
  Code code = sampleCode();
  const auto add = [&](Constant::Kind kind, std::uint16_t index, std::uint16_t origin) {
    Constant constant;
    constant.kind = kind;
    constant.index = index;
    constant.origin = origin;
    constant.value = {0.25f, -1, 0, 1e-6f};
    code.constants.push_back(constant);
  };
  add(Constant::Kind::Value, 0, 4);
  add(Constant::Kind::RectangleScale, 3, 3);
  add(Constant::Kind::ViewportScale, 0, kNone);
  add(Constant::Kind::ViewportOffset, 0, kNone);
  add(Constant::Kind::FogColor, 0, kNone);
  const std::string text = disassemble(code, sampleProgram(), kSampleText);
  EXPECT_EQ(line(text, "  c1"), " c1 = {0.25, -1, 0, 1e-06} ; line 7: DP4, the driver's");
  EXPECT_EQ(line(text, "  c2"),
            " c2 = (1/width, 1/height, 1, 1) of texture[3] ; line 6: TEX, the driver's");
  EXPECT_EQ(line(text, "  c3"), " c3 = viewport scale ; the driver's");
  EXPECT_EQ(line(text, "  c4"), " c4 = viewport offset ; the driver's");
  EXPECT_EQ(line(text, "  c5"), " c5 = state.fog.color ; the driver's");
}

TEST(Disassemble, ArgumentsModifiersAndCauses) {
  Code code = sampleCode();
  Pair &pair = code.pairs[3];
  pair.rgb.op = RgbOp::Cmp;
  pair.rgb.sources = {reg(2), row(0), {}};
  pair.rgb.arguments = {RgbArgument{RgbSelect::Wzy, 1, true, true},
                        {RgbSelect::Half, 0, false, true},
                        {RgbSelect::Zxy, 0, true, false}};
  pair.rgb.modifier = Modifier::Eighth;
  pair.rgb.clamp = true;
  pair.rgb.temporary = 3;
  pair.rgb.mask = 5;
  pair.rgb.outputMask = 2;
  pair.rgb.origin = 6;
  pair.rgb.cause = Cause::Swizzle;
  pair.alpha = {};
  pair.alpha.cause = Cause::EmptyNode;
  const std::string text = disassemble(code, sampleProgram(), kSampleText);
  EXPECT_EQ(line(text, "    3 rgb"), " 3 rgb s0=r2 s1=c0 r3.xz o0.y = cmp_d8_sat -|s1.wzy|, -0.5, "
                                     "|s0.zxy| ; line 9: LRP, swizzle");
  const std::string idle = text.substr(text.rfind("      alpha"));
  EXPECT_EQ(line(idle, "      alpha"), " alpha nop ; node needs a pair");
}

} // namespace
} // namespace arbiter::fp::hw::r300
