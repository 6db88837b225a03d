#pragma once
#include "fp_compiler/hw/r300/machine.h"
#include "fp_compiler/ir/builder.h"

/// A small Code that uses every part of the machine, for tests.
namespace arbiter::fp::hw::r300::testing {

inline constexpr const char *kSampleText = "!!ARBfp1.0\n"
                                           "TEMP a, b;\n"
                                           "TEX a, fragment.texcoord[0], texture[0], 2D;\n"
                                           "ADD a, a, program.local[0];\n"
                                           "KIL fragment.texcoord[0];\n"
                                           "TEX b, a, texture[1], 2D;\n"
                                           "DP4_SAT b, b, -a;\n"
                                           "SUB result.depth.z, 1, b.x;\n"
                                           "LRP result.color, b.x, fragment.color, a;\n"
                                           "END\n";

/// Returns the program of kSampleText.
inline ir::Program sampleProgram() {
  using ir::Opcode;
  ir::Builder b;
  const ir::Source place = b.attribute(ir::AttributeKind::TexCoord, 0);
  const ir::Target t0 = b.temporary("a"), t1 = b.temporary("b");
  b.tex(Opcode::Tex, t0, place, 0, ir::TexTarget::Tex2D);
  b.op(Opcode::Add, t0, {t0.read(), b.local(0)});
  b.kil(place);
  b.tex(Opcode::Tex, t1, t0.read(), 1, ir::TexTarget::Tex2D);
  b.op(Opcode::Dp4, t1.sat(), {t1.read(), -t0.read()});
  b.op(Opcode::Sub, b.depth().mask("z"), {b.constant(1), t1.read().swz("x")});
  b.op(Opcode::Lrp, b.color(),
       {t1.read().swz("x"), b.attribute(ir::AttributeKind::ColorPrimary), t0.read()});
  ir::Program program = b.take();
  // Each statement is on a line of its own, from the third.
  const std::string_view text = kSampleText;
  std::size_t at = text.find("TEX");
  for (ir::Instruction &instruction : program.code) {
    const std::size_t end = text.find('\n', at);
    instruction.span = {std::uint32_t(at), std::uint32_t(end)};
    at = end + 1;
  }
  return program;
}

inline Source reg(std::uint16_t index) { return {Source::Bank::Temporary, index}; }
inline Source row(std::uint16_t index) { return {Source::Bank::Constant, index}; }

/// Returns a legal Code for sampleProgram().
inline Code sampleCode() {
  Code code;
  code.interpolants = {{0, 0}, {1, 3}};
  code.temporaries = 4;
  code.interpolators = 1;
  Constant local;
  local.kind = Constant::Kind::Parameter;
  local.origin = 1;
  code.constants = {local};
  code.textures = {
      {TexOp::Load, 0, ir::TexTarget::Tex2D, 0, 1, 0},
      {TexOp::Kill, 0, ir::TexTarget::Tex2D, 0, kNone, 2},
      {TexOp::Load, 1, ir::TexTarget::Tex2D, 1, 2, 3},
  };
  code.nodes = {{0, 1, 0, 1}, {1, 2, 1, 3}};
  code.pairs.resize(4);

  Pair &sum = code.pairs[0]; // r1 = r1 + c0
  sum.rgb.op = RgbOp::Mad;
  sum.rgb.sources = {reg(1), row(0), {}};
  sum.rgb.arguments = {RgbArgument{RgbSelect::Xyz, 0}, {RgbSelect::One}, {RgbSelect::Xyz, 1}};
  sum.rgb.temporary = 1;
  sum.rgb.mask = 7;
  sum.rgb.origin = 1;
  sum.alpha.op = AlphaOp::Mad;
  sum.alpha.sources = sum.rgb.sources;
  sum.alpha.arguments = {AlphaArgument{AlphaSelect::W, 0}, {AlphaSelect::One}, {AlphaSelect::W, 1}};
  sum.alpha.temporary = 1;
  sum.alpha.mask = 8;
  sum.alpha.origin = 1;

  Pair &dot = code.pairs[1]; // r2 = SAT(dp4(r2, -r1))
  dot.rgb.op = RgbOp::Dp4;
  dot.rgb.sources = {reg(2), reg(1), {}};
  dot.rgb.arguments = {RgbArgument{RgbSelect::Xyz, 0}, {RgbSelect::Xyz, 1, false, true}, {}};
  dot.rgb.temporary = 2;
  dot.rgb.mask = 7;
  dot.rgb.clamp = true;
  dot.rgb.origin = 4;
  dot.alpha.op = AlphaOp::Dp;
  dot.alpha.sources = dot.rgb.sources;
  dot.alpha.arguments = {AlphaArgument{AlphaSelect::W, 0}, {AlphaSelect::W, 1, false, true}, {}};
  dot.alpha.temporary = 2;
  dot.alpha.mask = 8;
  dot.alpha.clamp = true;
  dot.alpha.origin = 4;

  Pair &difference = code.pairs[2]; // r3 = r3 - r1 through presubtract, depth = 1 - r2.x
  difference.rgb.op = RgbOp::Mad;
  difference.rgb.sources = {reg(1), reg(3), reg(2)};
  difference.rgb.presubtract = Presubtract::S1MinusS0;
  difference.rgb.arguments = {
      RgbArgument{RgbSelect::Xyz, kPresubtracted}, {RgbSelect::Xxx, 2}, {RgbSelect::Xyz, 0}};
  difference.rgb.output = 0;
  difference.rgb.outputMask = 7;
  difference.rgb.origin = 6;
  difference.alpha.op = AlphaOp::Mad;
  difference.alpha.arguments = {
      AlphaArgument{AlphaSelect::One}, {AlphaSelect::One}, {AlphaSelect::X, 2, false, true}};
  difference.alpha.depth = true;
  difference.alpha.origin = 5;

  Pair &alpha = code.pairs[3]; // the same operations in alpha
  alpha.alpha.op = AlphaOp::Mad;
  alpha.alpha.sources = {reg(1), reg(3), {}};
  alpha.alpha.presubtract = Presubtract::S1MinusS0;
  alpha.rgb.sources = {reg(2), {}, {}};
  alpha.alpha.arguments = {
      AlphaArgument{AlphaSelect::W, kPresubtracted}, {AlphaSelect::X, 0}, {AlphaSelect::W, 0}};
  alpha.alpha.outputMask = 8;
  alpha.alpha.origin = 6;
  return code;
}

} // namespace arbiter::fp::hw::r300::testing
