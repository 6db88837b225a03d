#include "fp_compiler/back/glsl/glsl.h"

#include <cstdlib>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>

#include "fp_compiler/back/glsl/number.h"
#include "fp_compiler/back/glsl/state.h"
#include "fp_compiler/back/glsl/validator.h"
#include "fp_compiler/ir/builder.h"

namespace arbiter::fp::glsl {
namespace {

using ir::AttributeKind;
using ir::Builder;
using ir::Opcode;
using ir::TexTarget;

std::string textOf(const Builder &builder) { return emit(builder.program(), {}).text; }

TEST(Number, RoundTripsEveryBit) {
  for (const float value :
       {0.0f, -0.0f, 1.0f, 0.1f, -3.14159274f, 16777216.0f, 1e-40f, 3.4028235e38f, 1.17549435e-38f,
        1e20f, 123456.789f, std::numeric_limits<float>::denorm_min()}) {
    const std::string text = number(value);
    const float back = std::strtof(text.c_str(), nullptr);
    EXPECT_EQ(std::memcmp(&back, &value, sizeof value), 0) << text;
    EXPECT_NE(text.find_first_of(".e"), std::string::npos) << text << " is an integer";
  }
  EXPECT_EQ(number(std::numeric_limits<float>::infinity()), "(1.0 / 0.0)");
}

TEST(EmitGlsl, WritesOnlyTheMask) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mul, t.mask("xz"),
       {b.attribute(AttributeKind::ColorPrimary), -b.local(3).swz("wzyx")});
  b.op(Opcode::Mov, b.color(), {t.read()});
  const GlslShader shader = emit(b.program(), {});
  EXPECT_TRUE(contains(shader.text, "t0.xz = gl_Color.xz * -arb_param[0].wy;")) << shader.text;
  EXPECT_TRUE(contains(shader.text, "vec4 t0 = vec4(0.0);")) << "y and w are read unwritten";
  ASSERT_EQ(shader.uniforms.size(), 1u);
  EXPECT_EQ(shader.uniforms[0].parameter.index, 3);
  EXPECT_TRUE(validates(shader.text));
}

TEST(EmitGlsl, DeclaresOnlyWhatIsUsed) {
  Builder b;
  b.temporary("unused");
  (void)b.env(1);
  (void)b.attribute(AttributeKind::TexCoord, 4);
  b.op(Opcode::Mov, b.color(), {b.constant(1, 2, 3, 4)});
  const GlslShader shader = emit(b.program(), {});
  EXPECT_EQ(shader.text,
            "#version 120\nvoid main() {\n  gl_FragColor = vec4(1.0, 2.0, 3.0, 4.0);\n}\n");
  EXPECT_TRUE(shader.uniforms.empty());
}

TEST(EmitGlsl, SharesRowsThatAreTheSame) {
  Builder b;
  b.op(Opcode::Add, b.color(), {b.env(2), b.env(2)});
  const GlslShader shader = emit(b.program(), {});
  EXPECT_TRUE(contains(shader.text, "gl_FragColor = arb_param[0] + arb_param[0];")) << shader.text;
  EXPECT_EQ(shader.uniforms.size(), 1u);
}

TEST(EmitGlsl, UnwrittenColorIsZero) {
  Builder b;
  b.op(Opcode::Mov, b.color().mask("x"), {b.constant(1)});
  EXPECT_TRUE(contains(textOf(b), "gl_FragColor = vec4(0.0);\n  gl_FragColor.x = 1.0;"));
  Builder none;
  none.op(Opcode::Mov, none.depth(), {none.constant(1)});
  EXPECT_TRUE(contains(textOf(none), "gl_FragColor = vec4(0.0);"));
}

TEST(EmitGlsl, DepthIsZComponentOnAllPaths) {
  Builder b;
  b.op(Opcode::Mov, b.depth(), {b.attribute(AttributeKind::TexCoord, 0).swz("wwyx")});
  EXPECT_TRUE(contains(textOf(b), "gl_FragDepth = gl_TexCoord[0].y;")) << textOf(b);
  Builder unwritten;
  unwritten.op(Opcode::Mov, unwritten.depth().mask("x"), {unwritten.constant(1)});
  EXPECT_TRUE(contains(textOf(unwritten), "gl_FragDepth = gl_FragCoord.z;")) << textOf(unwritten);
  EXPECT_FALSE(contains(textOf(unwritten), "gl_FragDepth = 1.0"));
}

TEST(EmitGlsl, GuardsOnlyWhereNeeded) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mov, t.sat(), {b.attribute(AttributeKind::TexCoord, 0)});
  b.op(Opcode::Pow, b.color().mask("x"), {t.read().swz("x"), b.constant(2.5f).swz("x")});
  b.op(Opcode::Pow, b.color().mask("y"), {b.local(0).swz("x"), b.local(0).swz("y")});
  const std::string text = textOf(b);
  EXPECT_TRUE(contains(text, "gl_FragColor.x = pow(t0.x, 2.5);")) << text;
  EXPECT_TRUE(contains(text, "(arb_param[0].y != 0.0 && arb_param[0].x > 0.0 ? pow(")) << text;
  EXPECT_TRUE(validates(text));
}

TEST(EmitGlsl, KillsOncePerDistinctComponent) {
  Builder b;
  b.kil(b.attribute(AttributeKind::TexCoord, 0).swz("x"));
  b.kil(-b.attribute(AttributeKind::TexCoord, 0).swz("xyxy"));
  const std::string text = textOf(b);
  EXPECT_TRUE(contains(text, "if (gl_TexCoord[0].x < 0.0) discard;")) << text;
  EXPECT_TRUE(contains(text, "any(lessThan(-gl_TexCoord[0].xy, vec2(0.0)))")) << text;
  EXPECT_TRUE(emit(b.program(), {}).kills);
}

TEST(EmitGlsl, SamplesEveryTargetInEveryWay) {
  for (const TexTarget target :
       {TexTarget::Tex1D, TexTarget::Tex2D, TexTarget::Tex3D, TexTarget::Cube, TexTarget::Rect,
        TexTarget::Shadow1D, TexTarget::Shadow2D, TexTarget::ShadowRect}) {
    Builder b;
    const auto t = b.temporary();
    const auto coordinate = b.attribute(AttributeKind::TexCoord, 1);
    b.tex(Opcode::Tex, t, coordinate, 5, target);
    b.tex(Opcode::Txp, t, coordinate.swz("wzyx"), 5, target);
    b.tex(Opcode::Txb, t.mask("xw").sat(), -coordinate, 5, target);
    b.op(Opcode::Mov, b.color(), {t.read()});
    const GlslShader shader = emit(b.program(), {});
    EXPECT_TRUE(validates(shader.text));
    ASSERT_EQ(shader.samplers.size(), 1u);
    EXPECT_EQ(shader.samplers[0].uniform, "arb_tex5");
    EXPECT_EQ(shader.samplers[0].target, target);
  }
}

TEST(EmitGlsl, EveryArithmeticOpcodeUnderEveryMask) {
  for (int op = 0; op < ir::kFragmentOpcodeCount; ++op) {
    const ir::OpInfo &row = ir::info(Opcode(op));
    if (row.has(ir::Texture) || row.has(ir::Kills))
      continue;
    Builder b;
    const auto fog = b.attribute(AttributeKind::FogCoord);
    const auto local = b.local(0);
    const auto literal = b.constant(-1, 2, 0, 1e-30f);
    for (std::uint8_t mask = 1; mask < 16; ++mask) {
      auto dst = b.color();
      dst.Destination::mask = mask;
      dst.saturate = mask & 1;
      const std::array<ir::Source, 3> sources = {
          fog.swz(row.shapes[0] == 'S' ? "x" : "xw1y"),
          -local.swz(row.operandCount() > 1 && row.shapes[1] == 'S' ? "z" : "zyxw"),
          -literal.swz("xyzw")};
      if (row.operandCount() == 1)
        b.op(Opcode(op), dst, {sources[0]});
      else if (row.operandCount() == 2)
        b.op(Opcode(op), dst, {sources[0], sources[1]});
      else
        b.op(Opcode(op), dst, {sources[0], sources[1], sources[2]});
    }
    EXPECT_TRUE(validates(textOf(b))) << row.mnemonic;
  }
}

TEST(EmitGlsl, EveryRowOfState) {
  for (int item = 0; item <= int(ir::StateItem::MatrixProgram); ++item) {
    for (int modifier = 0; modifier < 4; ++modifier) {
      Builder b;
      ir::StateRef ref;
      ref.item = ir::StateItem(item);
      ref.modifier = ir::MatrixModifier(modifier);
      ref.row = 2;
      ref.back = modifier & 1;
      b.op(Opcode::Mov, b.color(), {b.state(ref)});
      const GlslShader shader = emit(b.program(), {});
      EXPECT_TRUE(validates(shader.text));
      EXPECT_EQ(shader.uniforms.size(), stateText(ref) ? 0u : 1u);
    }
  }
}

TEST(EmitGlsl, MatrixRowsAreColumnsOfTheTranspose) {
  ir::StateRef ref;
  ref.item = ir::StateItem::MatrixTexture;
  ref.index = 3;
  ref.row = 1;
  EXPECT_EQ(stateText(ref)->text, "gl_TextureMatrixTranspose[3][1]");
  ref.modifier = ir::MatrixModifier::InvTrans;
  EXPECT_EQ(stateText(ref)->text, "gl_TextureMatrixInverse[3][1]");
}

TEST(EmitGlsl, FogBlendsTheClampedColor) {
  for (const ir::FogMode mode : {ir::FogMode::Exp, ir::FogMode::Exp2, ir::FogMode::Linear}) {
    Builder b;
    b.options().fog = mode;
    b.op(Opcode::Mov, b.color(), {b.attribute(AttributeKind::ColorPrimary)});
    const std::string text = emitGlsl(b.program()).text;
    EXPECT_TRUE(contains(text, "t0 = clamp(gl_Color, 0.0, 1.0);\n")) << text;
    EXPECT_TRUE(contains(text, "t0.xyz = mix(gl_Fog.color.xyz, t0.xyz, t1.xxx);\n"
                               "  gl_FragColor = t0;\n"))
        << text;
    EXPECT_TRUE(validates(text));
  }
}

TEST(EmitGlsl, ColorSumIsBetweenTheClampAndTheFog) {
  Builder b(ir::Language::AtiFragment);
  b.options().colorSum = true;
  b.op(Opcode::Mov, b.color(), {b.attribute(AttributeKind::ColorPrimary)});
  const std::string sum = "t0.xyz = clamp(gl_Color.xyz, 0.0, 1.0);\n"
                          "  t0.xyz = t0.xyz + gl_SecondaryColor.xyz;\n";
  const std::string alone = emitGlsl(b.program()).text;
  EXPECT_TRUE(contains(alone, sum)) << alone;
  b.options().fog = ir::FogMode::Linear;
  const std::string text = emitGlsl(b.program()).text;
  EXPECT_TRUE(contains(text, sum)) << text;
  EXPECT_LT(text.find(sum), text.find("mix(gl_Fog.color")) << text;
  EXPECT_TRUE(validates(text));
}

TEST(EmitGlsl, FogIsOfDistancesWhereTheHostHasThemBelowZero) {
  GlslHost host;
  host.negativeFogDistances = true;
  for (const Numerics numerics : {Numerics::Host, Numerics::Legacy, Numerics::Fp24})
    for (const ir::FogMode mode : {ir::FogMode::Exp, ir::FogMode::Exp2, ir::FogMode::Linear}) {
      Builder b;
      b.options().fog = mode;
      b.op(Opcode::Mov, b.color(), {b.attribute(AttributeKind::FogCoord)});
      const std::string text = emitGlsl(b.program(), host, numerics).text;
      const bool rounds = numerics == Numerics::Fp24;
      EXPECT_TRUE(contains(text, rounds ? "abs(i0.x)" : "abs(gl_FogFragCoord)")) << text;
      EXPECT_TRUE(contains(text, "(gl_FogFragCoord, 0.0")) << "the program's own: " << text;
      EXPECT_TRUE(numerics == Numerics::Fp24 || validates(text)) << "Fp24 needs extensions";
    }
  // Register combiners have a fog factor of their own.
  Builder b(ir::Language::Combiners);
  b.op(Opcode::Mov, b.color(), {b.attribute(AttributeKind::FogCoord)});
  EXPECT_TRUE(contains(emit(b.program(), host).text, "(abs(gl_FogFragCoord), 0.0"));
}

TEST(EmitGlsl, LinearFogHasNoDivision) {
  Builder b;
  b.options().fog = ir::FogMode::Linear;
  b.op(Opcode::Mov, b.color(), {b.attribute(AttributeKind::ColorPrimary)});
  const std::string text = emitGlsl(b.program()).text;
  EXPECT_TRUE(contains(text, "= vec4(-gl_Fog.scale, gl_Fog.end * gl_Fog.scale, ")) << text;
  EXPECT_TRUE(contains(text, "clamp(gl_FogFragCoord * s0.x + s0.y, 0.0, 1.0)")) << text;
  EXPECT_FALSE(contains(text, " / ")) << text;
}

TEST(EmitGlsl, FragCoordConventionsAndDrawBuffers) {
  Builder b;
  b.options().originUpperLeft = true;
  b.options().pixelCenterInteger = true;
  b.options().drawBuffers = true;
  b.op(Opcode::Mov, b.color(2), {b.attribute(AttributeKind::Position)});
  const std::string text = textOf(b);
  EXPECT_TRUE(contains(text, "layout(origin_upper_left, pixel_center_integer)")) << text;
  EXPECT_TRUE(contains(text, "gl_FragData[2] = gl_FragCoord;")) << text;
}

} // namespace
} // namespace arbiter::fp::glsl
