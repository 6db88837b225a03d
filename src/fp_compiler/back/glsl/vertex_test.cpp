#include <gtest/gtest.h>

#include "fp_compiler/back/glsl/glsl.h"
#include "fp_compiler/back/glsl/validator.h"
#include "fp_compiler/ir/builder.h"

/// Tests of vertex programs in GLSL: bindings, arrays with relative addressing, positions.
namespace arbiter::fp::glsl {
namespace {

using ir::AttributeKind;
using ir::Builder;
using ir::Opcode;
using ir::OutputKind;

struct Vertex : Builder {
  Vertex() : Builder(ir::Language::ArbVertex) {}
  ir::Source vertex() { return attribute(AttributeKind::Position); }
  ir::Target position() { return result(OutputKind::Position); }
  GlslShader shader(const GlslHost &host = {}) const {
    GlslShader result = emit(program(), host);
    EXPECT_TRUE(validates(result.text, "vert"));
    return result;
  }
  std::string text() const { return shader().text; }
};

ir::StateRef row(ir::StateItem item, int number, int index = 0) {
  ir::StateRef ref;
  ref.item = item;
  ref.row = std::uint8_t(number);
  ref.index = std::uint8_t(index);
  return ref;
}

TEST(EmitVertex, ReadsEveryAttribute) {
  Vertex b;
  const auto t = b.temporary();
  b.op(Opcode::Mov, t, {b.vertex()});
  for (const AttributeKind kind : {AttributeKind::Normal, AttributeKind::ColorPrimary,
                                   AttributeKind::ColorSecondary, AttributeKind::FogCoord})
    b.op(Opcode::Add, t, {t.read(), b.attribute(kind)});
  b.op(Opcode::Add, t, {t.read(), b.attribute(AttributeKind::TexCoord, 5)});
  b.op(Opcode::Add, t, {t.read(), b.attribute(AttributeKind::Generic, 0)});
  b.op(Opcode::Add, b.position(), {t.read(), b.attribute(AttributeKind::Generic, 11)});
  const GlslShader shader = b.shader();
  for (const char *part :
       {"t0 = gl_Vertex;", "vec4(gl_Normal.x, gl_Normal.y, gl_Normal.z, 1.0)", "t0 + gl_Color;",
        "t0 + gl_SecondaryColor;", "vec4(gl_FogCoord, 0.0, 0.0, 1.0)", "t0 + gl_MultiTexCoord5;",
        "t0 = t0 + gl_Vertex;", "attribute vec4 arb_attrib11;", "gl_Position = t0 + arb_attrib11;"})
    EXPECT_TRUE(contains(shader.text, part)) << part << "\n" << shader.text;
  ASSERT_EQ(shader.attributes.size(), 1u) << "attribute 0 is gl_Vertex";
  EXPECT_EQ(shader.attributes[0].name, "arb_attrib11");
  EXPECT_EQ(shader.attributes[0].index, 11);
}

TEST(EmitVertex, WritesEveryResult) {
  Vertex b;
  const auto value = b.local(2);
  b.op(Opcode::Mov, b.position(), {value});
  for (const OutputKind kind : {OutputKind::FrontPrimary, OutputKind::FrontSecondary,
                                OutputKind::BackPrimary, OutputKind::BackSecondary})
    b.op(Opcode::Mov, b.result(kind), {value});
  b.op(Opcode::Mov, b.result(OutputKind::FogCoord), {value.swz("y")});
  b.op(Opcode::Mov, b.result(OutputKind::PointSize), {value.swz("wzyx")});
  b.op(Opcode::Mov, b.result(OutputKind::TexCoord, 7), {value});
  const GlslShader shader = b.shader();
  for (const char *part :
       {"uniform vec4 arb_vparam[1];", "gl_Position = arb_vparam[0];",
        "gl_FrontColor = arb_vparam[0];", "gl_FrontSecondaryColor = ", "gl_BackColor = ",
        "gl_BackSecondaryColor = ", "gl_FogFragCoord = arb_vparam[0].y;",
        "gl_PointSize = arb_vparam[0].w;", "gl_TexCoord[7] = "})
    EXPECT_TRUE(contains(shader.text, part)) << part << "\n" << shader.text;
  EXPECT_FALSE(contains(shader.text, "vec4(0.0)")) << "everything is written whole";
  ASSERT_EQ(shader.uniforms.size(), 1u);
  EXPECT_EQ(shader.uniforms[0].parameter.index, 2);
}

TEST(EmitVertex, PartlyWrittenResultsAreZeroElsewhere) {
  Vertex b;
  b.op(Opcode::Mov, b.result(OutputKind::FrontPrimary).mask("xyz"), {b.local(0)});
  b.op(Opcode::Mov, b.result(OutputKind::FogCoord).mask("yzw"), {b.local(0)});
  b.result(OutputKind::TexCoord, 1);
  const std::string text = b.text();
  EXPECT_TRUE(contains(text, "gl_FrontColor = vec4(0.0);\n")) << text;
  EXPECT_TRUE(contains(text, "gl_Position = vec4(0.0, 0.0, 0.0, -1.0);\n"))
      << "hosts want it written";
  EXPECT_FALSE(contains(text, "gl_FogFragCoord")) << "its x is never written";
  EXPECT_FALSE(contains(text, "gl_TexCoord")) << "bound, never written";
}

TEST(EmitVertex, APositionWithoutWIsOutsideOfTheVolume) {
  const auto textOf = [](const char *mask) {
    Vertex b;
    b.op(Opcode::Mov, b.result(OutputKind::Position).mask(mask), {b.local(0)});
    return b.text();
  };
  EXPECT_TRUE(contains(textOf("xyz"), "gl_Position = vec4(0.0, 0.0, 0.0, -1.0);\n"));
  EXPECT_TRUE(contains(textOf("xw"), "gl_Position = vec4(0.0);\n")) << "y and z are zero";
  EXPECT_FALSE(contains(textOf("xyzw"), "gl_Position = vec4(0.0"));
}

TEST(EmitVertex, PositionInvariantIsFixedFunctions) {
  Vertex b;
  b.options().positionInvariant = true;
  b.op(Opcode::Mov, b.result(OutputKind::FrontPrimary), {b.attribute(AttributeKind::ColorPrimary)});
  EXPECT_TRUE(contains(b.text(), "  gl_Position = ftransform();\n")) << b.text();
  EXPECT_TRUE(contains(b.text(), "gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;")) << b.text();
}

TEST(EmitVertex, OthersAreClippedInClipSpace) {
  Vertex b;
  b.op(Opcode::Mov, b.position(), {b.vertex()});
  EXPECT_TRUE(contains(b.text(), "gl_ClipVertex = gl_ProjectionMatrixInverse * gl_Position;\n}"));
  GlslHost host;
  host.clipPlanes = false;
  EXPECT_FALSE(contains(b.shader(host).text, "gl_ClipVertex"));
}

TEST(EmitVertex, ArraysOfParametersAreOneRunOfUniforms) {
  Vertex b;
  const auto a = b.address();
  const auto single = b.env(9);
  const int array = b.array({b.env(4), b.env(9), b.local(0), b.constant(1, 2, 3, 4)});
  b.op(Opcode::Arl, a, {b.vertex().swz("x")});
  b.op(Opcode::Mul, b.position(),
       {-Builder::element(array, a, -3).swz("wzyx"), Builder::element(array, a, 2)});
  b.op(Opcode::Mov, b.result(OutputKind::FrontPrimary), {single});
  const GlslShader shader = b.shader();
  for (const char *part :
       {"uniform vec4 arb_vparam[4];", "i >= 0 && i < 4 ? arb_vparam[i] : vec4(0.0)",
        "a0 = arb_address(gl_Vertex.x);", "t0 = arb_array0(a0 - 3);", "t1 = arb_array0(a0 + 2);",
        "gl_Position = -t0.wzyx * t1;", "gl_FrontColor = arb_vparam[1];"})
    EXPECT_TRUE(contains(shader.text, part)) << part << "\n" << shader.text;
  ASSERT_EQ(shader.uniforms.size(), 4u);
  EXPECT_EQ(shader.uniforms[0].parameter.index, 4);
  EXPECT_EQ(shader.uniforms[2].parameter.kind, ir::ParameterKind::Local);
  EXPECT_EQ(shader.uniforms[3].parameter.constant[3], 4.0f);
}

TEST(EmitVertex, ArraysFollowEachOther) {
  Vertex b;
  const auto a = b.address();
  const int unused = b.array({b.env(0)});
  const int first = b.array({b.env(1), b.env(2)});
  const int second = b.array({b.local(1), b.local(2)});
  (void)unused;
  b.op(Opcode::Arl, a, {b.vertex().swz("y")});
  b.op(Opcode::Add, b.position(), {Builder::element(first, a), Builder::element(second, a)});
  const GlslShader shader = b.shader();
  EXPECT_TRUE(
      contains(shader.text, "arb_array2(int i) { return i >= 0 && i < 2 ? arb_vparam[2 + i]"))
      << shader.text;
  EXPECT_FALSE(contains(shader.text, "arb_array0"));
  EXPECT_EQ(shader.uniforms.size(), 4u);
}

TEST(EmitVertex, ArraysOfConstantsAndOfState) {
  Vertex b;
  const auto a = b.address();
  const int constants = b.array({b.constant(1), b.constant(2)});
  std::vector<ir::Source> rows;
  for (int i = 0; i < 4; ++i)
    rows.push_back(b.state(row(ir::StateItem::MatrixMvp, i)));
  rows.push_back(b.env(7));
  rows.push_back(b.state(row(ir::StateItem::MatrixProgram, 0, 3)));
  rows.push_back(b.constant(5));
  const int state = b.array(rows);
  b.op(Opcode::Arl, a, {b.vertex().swz("y")});
  b.op(Opcode::Add, b.position(), {Builder::element(constants, a), Builder::element(state, a)});
  const GlslShader shader = b.shader();
  for (const char *part :
       {"const vec4 arb_array0_rows[2] = vec4[2](vec4(1.0, 1.0, 1.0, 1.0), vec4(2.0",
        "vec4 arb_array1_rows[7];",
        "arb_array1_rows[1] = gl_ModelViewProjectionMatrixTranspose[1];",
        "arb_array1_rows[4] = arb_vparam[0];", "arb_array1_rows[5] = arb_vparam[1];",
        "arb_array1_rows[6] = vec4(5.0, 5.0, 5.0, 5.0);",
        "i >= 0 && i < 7 ? arb_array1_rows[i] : vec4(0.0)"})
    EXPECT_TRUE(contains(shader.text, part)) << part << "\n" << shader.text;
  EXPECT_EQ(shader.uniforms.size(), 2u);
}

TEST(EmitVertex, RowThatNothingReadsIsNotFetched) {
  Vertex b;
  const auto a = b.address();
  const int array = b.array({b.env(0)});
  b.op(Opcode::Swz, b.position(), {Builder::element(array, a).swz("0101")});
  const std::string text = b.text();
  EXPECT_TRUE(contains(text, "gl_Position = vec4(0.0, 1.0, 0.0, 1.0);")) << text;
  EXPECT_FALSE(contains(text, "arb_array")) << text;
}

TEST(EmitVertex, EveryOpcodeUnderEveryMask) {
  for (int op = 0; op < ir::kOpcodeCount; ++op) {
    const ir::OpInfo &info = ir::info(Opcode(op));
    if (info.has(ir::FragmentOnly) || Opcode(op) == Opcode::Arl)
      continue;
    Vertex b;
    const auto a = b.address();
    const int array = b.array({b.local(0), b.local(1)});
    b.op(Opcode::Arl, a, {b.vertex().swz("x")});
    for (std::uint8_t mask = 1; mask < 16; ++mask) {
      auto dst = b.position();
      dst.Destination::mask = mask;
      const auto scalar = [&](int i) { return info.operandCount() > i && info.shapes[i] == 'S'; };
      const std::array<ir::Source, 3> sources = {
          b.attribute(AttributeKind::Normal).swz(scalar(0) ? "w" : "xw1y"),
          -Builder::element(array, a, 1).swz(scalar(1) ? "z" : "zyxw"), b.constant(-1)};
      if (info.operandCount() == 1)
        b.op(Opcode(op), dst, {sources[0]});
      else if (info.operandCount() == 2)
        b.op(Opcode(op), dst, {sources[0], sources[1]});
      else
        b.op(Opcode(op), dst, {sources[0], sources[1], sources[2]});
    }
    EXPECT_FALSE(b.text().empty()) << info.mnemonic;
  }
}

TEST(EmitVertex, LogSearchesItsExponent) {
  Vertex b;
  b.op(Opcode::Log, b.position().mask("yz"), {b.vertex().swz("x")});
  const std::string text = b.text();
  EXPECT_TRUE(contains(text, "gl_Position.yz = arb_log(gl_Vertex.x).yz;")) << text;
  EXPECT_FALSE(contains(text, "arb_address"));
}

} // namespace
} // namespace arbiter::fp::glsl
