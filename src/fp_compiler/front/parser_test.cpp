// Tests the translation from text to IR: operands, masks, bindings, constants.
#include <gtest/gtest.h>

#include "fp_compiler/front/testing/test_support.h"

namespace arbiter::fp {
namespace {

using namespace ir;
using testing_support::check;
using testing_support::firstError;
using testing_support::generous;
using testing_support::wrap;

/// Returns the program. Fails with its diagnostics if there are errors.
Program parsed(std::string_view statements) {
  const std::string text = wrap(statements);
  const CheckResult result = check(text, generous());
  EXPECT_TRUE(result.ok()) << result.errorString(text);
  return result.program.value_or(Program{});
}

Instruction only(std::string_view statements) {
  const Program program = parsed(statements);
  EXPECT_EQ(program.code.size(), 1u);
  return program.code.empty() ? Instruction{} : program.code[0];
}

/// Returns the only parameter row of a program.
Parameter binding(const std::string &item) {
  const Program program = parsed("PARAM p = " + item + ";");
  EXPECT_EQ(program.parameters.size(), 1u) << item;
  return program.parameters.empty() ? Parameter{} : program.parameters[0];
}

constexpr Select X = Select::X, Y = Select::Y, Z = Select::Z, W = Select::W;

TEST(Parser, EveryOpcodeWithAndWithoutSaturation) {
  for (int i = 0; i < kFragmentOpcodeCount; ++i) {
    const auto op = Opcode(i);
    const OpInfo &row = info(op);
    std::string operands;
    for (const char *shape = row.shapes; *shape; ++shape)
      operands += std::string(operands.empty() && row.has(Kills) ? " t" : ", t") +
                  (*shape == 'S' ? ".y" : "");
    if (op == Opcode::Swz)
      operands += ", x, y, z, w";
    if (row.has(Texture))
      operands += ", texture[3], CUBE";
    const std::string rest = (row.has(Kills) ? "" : " t.xz") + operands + ";";
    const Instruction plain = only("TEMP t;\n" + std::string(row.mnemonic) + rest);
    EXPECT_EQ(plain.op, op);
    EXPECT_FALSE(plain.dst.saturate);
    const std::string saturated = "TEMP t;\n" + std::string(row.mnemonic) + "_SAT" + rest;
    if (row.has(Kills)) {
      EXPECT_EQ(firstError(check(wrap(saturated))), "unknown_instruction");
      continue;
    }
    EXPECT_EQ(plain.dst.mask, 0b0101);
    EXPECT_TRUE(only(saturated).dst.saturate) << row.mnemonic;
  }
}

TEST(Parser, OperandsHaveSignAndSwizzle) {
  const Instruction mad = only("TEMP a, b;\nMAD a.yw, -b.wzyx, +a.r, -b;");
  EXPECT_EQ(mad.dst.mask, 0b1010);
  EXPECT_EQ(mad.src[0].swizzle, (Swizzle{W, Z, Y, X}));
  EXPECT_EQ(mad.src[0].negate, 0xF);
  EXPECT_EQ(mad.src[0].index, 1);
  EXPECT_EQ(mad.src[1].swizzle, (Swizzle{X, X, X, X}));
  EXPECT_EQ(mad.src[1].negate, 0);
  EXPECT_EQ(mad.src[2].swizzle, kIdentity);
  EXPECT_EQ(mad.src[2].negate, 0xF);
}

TEST(Parser, ScalarOperandsRepeatTheirComponent) {
  const Instruction pow = only("TEMP a;\nPOW a.x, -a.b, {1, 2}.g;");
  EXPECT_EQ(pow.src[0].swizzle, (Swizzle{Z, Z, Z, Z}));
  EXPECT_EQ(pow.src[0].negate, 0xF);
  EXPECT_EQ(pow.src[1].swizzle, (Swizzle{Y, Y, Y, Y}));
  EXPECT_EQ(pow.src[1].file, File::Parameter);
}

TEST(Parser, ExtendedSwizzle) {
  const Instruction swz = only("TEMP a;\nSWZ a, a, -w, 0, -1, +y;");
  EXPECT_EQ(swz.src[0].swizzle, (Swizzle{W, Select::Zero, Select::One, Y}));
  EXPECT_EQ(swz.src[0].negate, 0b0101);
  EXPECT_EQ(only("TEMP a;\nSWZ a, {1,2,3,4}, a, b, g, r;").src[0].swizzle, (Swizzle{W, Z, Y, X}));
}

TEST(Parser, MasksOfBothSets) {
  EXPECT_EQ(only("TEMP a;\nMOV a.xyzw, a;").dst.mask, 0xF);
  EXPECT_EQ(only("TEMP a;\nMOV a.rb, a;").dst.mask, 0b0101);
  EXPECT_EQ(only("TEMP a;\nMOV a . w , a;").dst.mask, 0b1000);
}

TEST(Parser, TexturesHaveUnitAndTarget) {
  const Instruction tex = only("TEMP a;\nTXB a, a, texture[7], RECT;");
  EXPECT_EQ(tex.unit, 7);
  EXPECT_EQ(tex.target, TexTarget::Rect);
  EXPECT_EQ(only("TEMP a;\nTEX a, a, texture, 1D;").unit, 0);
  const Program shadow = parsed("OPTION ARB_fragment_program_shadow;\nTEMP a;\n"
                                "TEX a, a, texture[0], SHADOW1D;\n"
                                "TEX a, a, texture[1], SHADOW2D;\n"
                                "TXP a, a, texture[2], SHADOWRECT;\n");
  EXPECT_TRUE(shadow.options.shadow);
  EXPECT_EQ(shadow.code[2].target, TexTarget::ShadowRect);
}

TEST(Parser, SpansCoverTheStatement) {
  const std::string text = "!!ARBfp1.0 TEMP a; MOV  a.x ,\n -a . w ; END";
  const CheckResult result = check(text);
  ASSERT_TRUE(result.ok());
  const Instruction &mov = result.program->code[0];
  const auto cut = [&](Span span) { return text.substr(span.begin, span.end - span.begin); };
  EXPECT_EQ(cut(mov.span), "MOV  a.x ,\n -a . w");
  EXPECT_EQ(cut(mov.dst.span), "a.x");
  EXPECT_EQ(cut(mov.src[0].span), "-a . w");
}

TEST(Parser, AttributesAreBoundOnce) {
  const Program program = parsed("ATTRIB c = fragment.color.primary;\nTEMP t;\n"
                                 "ADD t, c, fragment.color;\n"
                                 "ADD t, fragment.texcoord, fragment.texcoord[0].x;\n"
                                 "ADD t, fragment.color.secondary, fragment.fogcoord;\n"
                                 "MOV t, fragment.position;\nMOV t, fragment.color.r;\n");
  const std::vector<Attribute> expected = {{AttributeKind::ColorPrimary},
                                           {AttributeKind::TexCoord, 0},
                                           {AttributeKind::ColorSecondary},
                                           {AttributeKind::FogCoord},
                                           {AttributeKind::Position}};
  EXPECT_EQ(program.attributes, expected);
}

TEST(Parser, Outputs) {
  const Program program = parsed("OPTION ARB_draw_buffers;\nOUTPUT o = result.color[2];\n"
                                 "MOV o.x, 1;\nMOV result.color, 2;\nMOV result.depth.z, 3;\n"
                                 "MOV result.color[0].rgb, 4;");
  const std::vector<Output> expected = {
      {OutputKind::Color, 2}, {OutputKind::Color, 0}, {OutputKind::Depth, 0}};
  EXPECT_EQ(program.outputs, expected);
  EXPECT_EQ(program.code[3].dst.index, 1);
  EXPECT_EQ(program.code[3].dst.mask, 0b0111);
}

TEST(Parser, ConstantsDefaultToZeroZeroOne) {
  EXPECT_EQ(binding("{0.5}").constant, (Vec4{0.5f, 0, 0, 1}));
  EXPECT_EQ(binding("{1, -2}").constant, (Vec4{1, -2, 0, 1}));
  EXPECT_EQ(binding("{1, 2, +3}").constant, (Vec4{1, 2, 3, 1}));
  EXPECT_EQ(binding("-.5").constant, (Vec4{-.5f, -.5f, -.5f, -.5f}));
  EXPECT_EQ(binding("5.").constant, (Vec4{5, 5, 5, 5}));
  EXPECT_EQ(binding("1e-1").constant, (Vec4{.1f, .1f, .1f, .1f}));
}

TEST(Parser, ASignBeforeAConstantIsTheOperands) {
  const Program program = parsed("TEMP t;\nADD t, -2, -{-2}.x;");
  ASSERT_EQ(program.parameters.size(), 2u);
  EXPECT_EQ(program.parameters[0].constant, (Vec4{2, 2, 2, 2}));
  EXPECT_EQ(program.parameters[1].constant, (Vec4{-2, 0, 0, 1}));
  EXPECT_EQ(program.code[0].src[0].negate, 0xF);
}

TEST(Parser, ProgramParameters) {
  EXPECT_EQ(binding("program.env[7]").kind, ParameterKind::Env);
  EXPECT_EQ(binding("program.local[4095]").index, 4095);
  EXPECT_EQ(binding("program . local [ 3 ]").kind, ParameterKind::Local);
}

TEST(Parser, StateItems) {
  const struct {
    const char *text;
    StateRef ref;
  } cases[] = {
      {"state.material.ambient", {StateItem::MaterialAmbient}},
      {"state.material.front.diffuse", {StateItem::MaterialDiffuse}},
      {"state.material.back.specular", {StateItem::MaterialSpecular, true}},
      {"state.material.emission", {StateItem::MaterialEmission}},
      {"state.material.back.shininess", {StateItem::MaterialShininess, true}},
      {"state.light[1].ambient", {StateItem::LightAmbient, false, 1}},
      {"state.light[2].diffuse", {StateItem::LightDiffuse, false, 2}},
      {"state.light[3].specular", {StateItem::LightSpecular, false, 3}},
      {"state.light[4].position", {StateItem::LightPosition, false, 4}},
      {"state.light[5].attenuation", {StateItem::LightAttenuation, false, 5}},
      {"state.light[6].spot.direction", {StateItem::LightSpotDirection, false, 6}},
      {"state.light[7].half", {StateItem::LightHalf, false, 7}},
      {"state.lightmodel.ambient", {StateItem::LightModelAmbient}},
      {"state.lightmodel.scenecolor", {StateItem::LightModelSceneColor}},
      {"state.lightmodel.front.scenecolor", {StateItem::LightModelSceneColor}},
      {"state.lightmodel.back.scenecolor", {StateItem::LightModelSceneColor, true}},
      {"state.lightprod[1].ambient", {StateItem::LightProdAmbient, false, 1}},
      {"state.lightprod[1].front.diffuse", {StateItem::LightProdDiffuse, false, 1}},
      {"state.lightprod[1].back.specular", {StateItem::LightProdSpecular, true, 1}},
      {"state.texenv.color", {StateItem::TexEnvColor}},
      {"state.texenv[3].color", {StateItem::TexEnvColor, false, 3}},
      {"state.fog.color", {StateItem::FogColor}},
      {"state.fog.params", {StateItem::FogParams}},
      {"state.depth.range", {StateItem::DepthRange}},
      {"state.matrix.modelview.row[1]",
       {StateItem::MatrixModelview, false, 0, MatrixModifier::Plain, 1}},
      {"state.matrix.modelview[0].inverse.row[2]",
       {StateItem::MatrixModelview, false, 0, MatrixModifier::Inverse, 2}},
      {"state.matrix.projection.transpose.row[3]",
       {StateItem::MatrixProjection, false, 0, MatrixModifier::Transpose, 3}},
      {"state.matrix.mvp.invtrans.row[0]",
       {StateItem::MatrixMvp, false, 0, MatrixModifier::InvTrans, 0}},
      {"state.matrix.texture.row[0]", {StateItem::MatrixTexture}},
      {"state.matrix.texture[7].row[0]", {StateItem::MatrixTexture, false, 7}},
      {"state.matrix.program[5].row[0]", {StateItem::MatrixProgram, false, 5}},
  };
  for (const auto &c : cases) {
    const Parameter parameter = binding(c.text);
    EXPECT_EQ(parameter.kind, ParameterKind::State) << c.text;
    EXPECT_EQ(parameter.state, c.ref) << c.text;
    // The same item can be an operand, with a suffix after it.
    EXPECT_EQ(parsed("TEMP t;\nMOV t, " + std::string(c.text) + ".x;").parameters[0].state, c.ref)
        << c.text;
  }
}

TEST(Parser, PaletteMatricesWhereTheyAreOffered) {
  CompileOptions options = generous();
  options.limits.paletteMatrices = 4;
  EXPECT_TRUE(check(wrap("PARAM p = state.matrix.palette[3].row[0];"), options).ok());
  EXPECT_EQ(firstError(check(wrap("PARAM p = state.matrix.palette[4].row[0];"), options)),
            "matrix_index");
  EXPECT_EQ(firstError(check(wrap("PARAM p = state.matrix.palette.row[0];"), options)), "syntax");
}

TEST(Parser, ArraysBecomeRows) {
  const Program program =
      parsed("PARAM p[8] = { program.local[2..3], state.matrix.mvp, {1}, 2 };\nTEMP t;\n"
             "MOV t, p[1];\nMOV t, p[5].x;\nMOV t, p[6];\nMOV t, p[7];");
  ASSERT_EQ(program.parameters.size(), 8u);
  EXPECT_EQ(program.parameters[program.code[0].src[0].index].index, 3);
  EXPECT_EQ(program.parameters[program.code[1].src[0].index].state.row, 3);
  EXPECT_EQ(program.parameters[program.code[2].src[0].index].constant, (Vec4{1, 0, 0, 1}));
  EXPECT_EQ(program.parameters[program.code[3].src[0].index].constant, (Vec4{2, 2, 2, 2}));
}

TEST(Parser, ArrayElementsThatAreBoundTwiceShareARow) {
  const Program program = parsed("PARAM p[] = { program.env[1], {2,2,2,2}, program.env[0..2] };\n"
                                 "TEMP t;\nADD t, p[0], p[3];\nADD t, p[1], 2.0;");
  EXPECT_EQ(program.parameters.size(), 4u);
  EXPECT_EQ(program.code[0].src[0].index, program.code[0].src[1].index);
  EXPECT_EQ(program.code[1].src[0].index, program.code[1].src[1].index);
}

TEST(Parser, AliasesNameTheSameVariable) {
  const Program program = parsed("TEMP t;\nPARAM p[] = {1, 2};\nOUTPUT o = result.color;\n"
                                 "ALIAS a = t;\nALIAS b = a;\nALIAS q = p;\nALIAS r = o;\n"
                                 "MOV b, q[1];\nMOV r, a;");
  EXPECT_EQ(program.temporaries.size(), 1u);
  EXPECT_EQ(program.code[0].dst.file, File::Temporary);
  EXPECT_EQ(program.code[0].src[0].index, 1);
  EXPECT_EQ(program.code[1].dst.file, File::Output);
}

TEST(Parser, DeclarationsMayFollowInstructions) {
  EXPECT_EQ(parsed("TEMP a;\nMOV a, 1;\nTEMP b;\nPARAM p = 2;\nMOV b, p;").code.size(), 2u);
}

TEST(Parser, Options) {
  const Options options = parsed("OPTION ARB_fog_exp2;\nOPTION ARB_precision_hint_nicest;\n"
                                 "OPTION ATI_draw_buffers;\n"
                                 "OPTION ARB_fragment_coord_origin_upper_left;\n"
                                 "OPTION ARB_fragment_coord_pixel_center_integer;\n"
                                 "OPTION ARB_fragment_program_shadow;")
                              .options;
  EXPECT_EQ(options.fog, FogMode::Exp2);
  EXPECT_EQ(options.precision, Precision::Nicest);
  EXPECT_TRUE(options.drawBuffers && options.originUpperLeft && options.pixelCenterInteger &&
              options.shadow);
  EXPECT_EQ(parsed("OPTION ARB_fog_exp;").options.fog, FogMode::Exp);
  EXPECT_EQ(parsed("OPTION ARB_fog_linear;OPTION ARB_fog_linear;").options.fog, FogMode::Linear);
  EXPECT_EQ(parsed("OPTION ARB_precision_hint_fastest;").options.precision, Precision::Fastest);
  EXPECT_EQ(parsed("").options, Options{});
}

TEST(Parser, OneErrorDoesNotHideOrCauseOthers) {
  const std::string text = wrap("TEMP t;\nPARAM p[2] = {1, program.local[99]};\n"
                                "MOV t, p[1];\nMOV t, nope;\nMOV nope, t;\nRCP t, t;\n"
                                "MOV t, t;\nMOV t t;\nOUTPUT o = result.nothing;\nMOV o, t;");
  const CheckResult result = check(text);
  std::vector<std::string> ids;
  for (const Diagnostic &diagnostic : result.diagnostics)
    ids.emplace_back(diagnostic.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"parameter_index", "undeclared_name", "scalar_suffix",
                                           "syntax", "unknown_binding"}))
      << result.errorString(text);
  EXPECT_EQ(result.counts, ResourceCounts{});
}

} // namespace
} // namespace arbiter::fp
