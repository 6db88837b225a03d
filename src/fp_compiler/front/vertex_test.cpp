// Tests ARBvp1.0: what vertex programs have and fragment programs lack.
#include <gtest/gtest.h>

#include "fp_compiler/front/testing/test_support.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"

namespace arbiter::fp {
namespace {

using testing_support::check;
using testing_support::firstError;
using testing_support::generous;
using testing_support::wrapVertex;

ir::Program program(std::string_view statements) {
  const std::string text = wrapVertex(statements);
  CheckResult result = check(text, generous());
  EXPECT_TRUE(result.ok()) << result.errorString(text);
  if (!result.ok())
    return {};
  EXPECT_TRUE(ir::validate(*result.program).empty()) << text;
  EXPECT_EQ(result.program->language, ir::Language::ArbVertex);
  return std::move(*result.program);
}

TEST(Vertex, EveryOpcodeOfTheLanguage) {
  int opcodes = 0;
  for (int i = 0; i < ir::kOpcodeCount; ++i) {
    const ir::OpInfo &op = info(ir::Opcode(i));
    std::string statement = std::string(op.mnemonic) + " ";
    if (op.has(ir::FragmentOnly)) {
      EXPECT_EQ(firstError(check(wrapVertex(statement + "r, r;"))), "fragment_only") << statement;
      continue;
    }
    ++opcodes;
    statement += ir::Opcode(i) == ir::Opcode::Arl ? "A.x" : "r";
    for (int k = 0; k < op.operandCount(); ++k)
      statement += op.shapes[k] == 'S' ? ", r.x" : ", r";
    if (ir::Opcode(i) == ir::Opcode::Swz)
      statement += ", x, -y, 0, 1";
    const ir::Program p = program("TEMP r; ADDRESS A;" + statement + ";");
    ASSERT_EQ(p.code.size(), 1u) << statement;
    EXPECT_EQ(p.code[0].op, ir::Opcode(i)) << statement;
  }
  EXPECT_EQ(opcodes, 27); // table X.5
}

// piglit's vp-arl-constant-array-huge-relative-offset uses such an offset, and Mesa accepts it.
TEST(Vertex, AnOffsetBeyondTheGrammarsIsAWarning) {
  const std::string text = wrapVertex(
      "ADDRESS A; PARAM c[] = {1, 2}; ARL A.x, c[0].x; MOV result.color, c[A.x - 4095];");
  const CheckResult result = check(text, generous());
  ASSERT_TRUE(result.ok()) << result.errorString(text);
  EXPECT_EQ(result.errorPosition(), -1);
  ASSERT_EQ(result.diagnostics.size(), 1u);
  EXPECT_EQ(result.diagnostics[0].severity, Severity::Warning);
  EXPECT_EQ(result.program->code[1].src[0].offset, -4095);
}

TEST(Vertex, RelativeOperands) {
  const ir::Program p =
      program("PARAM c[] = { program.env[0..3], state.matrix.mvp, {1,2,3,4}, {1,2,3,4} };"
              "PARAM d[2] = { 1, 2 };"
              "ADDRESS A, B; ALIAS E = c; TEMP r; ARL B.x, vertex.position.w;"
              "ADD r, c[A.x], -E[B.x - 64].wzyx; MAD r, c[B.x+63], d[1], c[9];");
  ASSERT_EQ(p.arrays.size(), 1u);
  EXPECT_EQ(p.arrays[0].name, "c");
  EXPECT_EQ(p.arrays[0].rows, (std::vector<std::uint16_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 8}));
  ASSERT_EQ(p.addresses.size(), 2u);
  EXPECT_EQ(print(p.code[0]), "ARL A1.x, a0.w");
  EXPECT_EQ(print(p.code[1]), "ADD t0, c0[A0], -c0[A1-64].wzyx");
  EXPECT_EQ(print(p.code[2]), "MAD t0, c0[A1+63], p10, p8");
}

TEST(Vertex, Attributes) {
  using ir::AttributeKind;
  const ir::Program p =
      program("ATTRIB a = vertex.position; ATTRIB b = vertex.normal; ATTRIB c = vertex.color;"
              "ATTRIB d = vertex.color.primary; ATTRIB e = vertex.color.secondary;"
              "ATTRIB f = vertex.fogcoord; ATTRIB g = vertex.texcoord; TEMP t;"
              "MOV t, vertex.texcoord[7]; MOV t, vertex.attrib[1]; MOV t, vertex.color.x;");
  EXPECT_EQ(p.attributes, (std::vector<ir::Attribute>{{AttributeKind::Position, 0},
                                                      {AttributeKind::Normal, 0},
                                                      {AttributeKind::ColorPrimary, 0},
                                                      {AttributeKind::ColorSecondary, 0},
                                                      {AttributeKind::FogCoord, 0},
                                                      {AttributeKind::TexCoord, 0},
                                                      {AttributeKind::TexCoord, 7},
                                                      {AttributeKind::Generic, 1}}));
}

// Tests each row of table X.2.1 in both orders. Every other pair of a conventional and a generic
// attribute loads.
TEST(Vertex, AliasedAttributesDoNotLoadTogether) {
  const struct {
    const char *conventional;
    int generic;
  } rows[] = {{"position", 0},      {"normal", 2},          {"color", 3},
              {"color.primary", 3}, {"color.secondary", 4}, {"fogcoord", 5},
              {"texcoord", 8},      {"texcoord[0]", 8},     {"texcoord[1]", 9},
              {"texcoord[2]", 10},  {"texcoord[3]", 11},    {"texcoord[4]", 12},
              {"texcoord[5]", 13},  {"texcoord[6]", 14},    {"texcoord[7]", 15}};
  for (const auto &row : rows)
    for (int generic = 0; generic < 16; ++generic) {
      const std::string a = std::string("ATTRIB a = vertex.") + row.conventional + ";";
      const std::string b = "ATTRIB b = vertex.attrib[" + std::to_string(generic) + "];";
      const char *expected = generic == row.generic ? "attribute_alias" : "";
      EXPECT_EQ(firstError(check(wrapVertex(a + b))), expected) << a << b;
      EXPECT_EQ(firstError(check(wrapVertex(b + a))), expected) << b << a;
    }
}

TEST(Vertex, Results) {
  using ir::OutputKind;
  const ir::Program p = program(
      "OUTPUT a = result.position; OUTPUT b = result.color; OUTPUT c = result.color.primary;"
      "OUTPUT d = result.color.secondary; OUTPUT e = result.color.front;"
      "OUTPUT f = result.color.front.secondary; OUTPUT g = result.color.back;"
      "OUTPUT h = result.color.back.primary; OUTPUT i = result.color.back.secondary;"
      "OUTPUT j = result.fogcoord; OUTPUT k = result.pointsize; OUTPUT l = result.texcoord;"
      "MOV result.texcoord[3].xy, 1; MOV result.color.back.x, 1;"
      "MOV result.color.front.primary.xyz, 1; MOV c.w, 1;");
  EXPECT_EQ(p.outputs, (std::vector<ir::Output>{{OutputKind::Position, 0},
                                                {OutputKind::FrontPrimary, 0},
                                                {OutputKind::FrontSecondary, 0},
                                                {OutputKind::BackPrimary, 0},
                                                {OutputKind::BackSecondary, 0},
                                                {OutputKind::FogCoord, 0},
                                                {OutputKind::PointSize, 0},
                                                {OutputKind::TexCoord, 0},
                                                {OutputKind::TexCoord, 3}}));
  EXPECT_EQ(print(p.code[0]), "MOV o8.xy, p0");
  EXPECT_EQ(print(p.code[1]), "MOV o3.x, p0");
  EXPECT_EQ(print(p.code[2]), "MOV o1.xyz, p0");
  EXPECT_EQ(print(p.code[3]), "MOV o1.w, p0");
}

TEST(Vertex, State) {
  const std::pair<const char *, const char *> bindings[] = {
      {"state.texgen.eye.s", "state.texgen[0].eye.s"},
      {"state.texgen[3].object.q", "state.texgen[3].object.q"},
      {"state.texgen[7].eye.r", "state.texgen[7].eye.r"},
      {"state.clip[5].plane", "state.clip[5].plane"},
      {"state.point.size", "state.point.size"},
      {"state.point.attenuation", "state.point.attenuation"},
      {"state.fog.params", "state.fog.params"},
      {"state.lightprod[7].back.specular", "state.lightprod[7].back.specular"},
      {"state.matrix.program[3].invtrans.row[2]", "state.matrix.program[3].invtrans.row[2]"},
  };
  for (const auto &[text, printed] : bindings) {
    const ir::Program p = program(std::string("PARAM p = ") + text + ";");
    ASSERT_EQ(p.parameters.size(), 1u) << text;
    EXPECT_EQ(ir::bindingText(p.parameters[0]), printed);
  }
}

TEST(Vertex, WordsOfFragmentProgramsAreNames) {
  program("TEMP fragment, texture, TEX, MOV_SAT, KIL; MOV fragment, texture.x;"
          "ADD TEX, MOV_SAT, -KIL;");
}

TEST(Vertex, PositionInvariance) {
  const ir::Program p =
      program("OPTION ARB_position_invariant; MOV result.color, vertex.position;");
  EXPECT_TRUE(p.options.positionInvariant);
  EXPECT_FALSE(program("MOV result.position, vertex.position;").options.positionInvariant);
}

TEST(Vertex, PositionInvarianceTakesFourInstructions) {
  CompileOptions options = generous();
  options.limits.api.instructions = 10;
  const auto text = [](std::size_t n) {
    return wrapVertex("OPTION ARB_position_invariant;\n" +
                      testing_support::repeat("MOV result.color, 1;\n", n));
  };
  EXPECT_TRUE(check(text(6), options).ok());
  EXPECT_EQ(check(text(6), options).counts.instructions, 6u);
  const CheckResult over = check(text(7), options);
  EXPECT_EQ(firstError(over), "limit_instructions");
  EXPECT_EQ(over.diagnostics[0].message,
            "more than 6 instructions (10 less 4 for OPTION ARB_position_invariant)");
  EXPECT_EQ(over.errorPosition(), std::int32_t(text(7).rfind("MOV")));
}

ResourceCounts vertexCounts(std::string_view statements) {
  const std::string text = wrapVertex(statements);
  const CheckResult result = check(text, generous());
  EXPECT_TRUE(result.ok()) << result.errorString(text);
  return result.counts;
}

TEST(VertexCounts, EmptyProgramUsesNothing) { EXPECT_EQ(vertexCounts(""), ResourceCounts{}); }

TEST(VertexCounts, OfEachResource) {
  EXPECT_EQ(vertexCounts("ADDRESS A, B; ALIAS C = A; TEMP t, u, v; ALIAS w = t;"
                         "ATTRIB a = vertex.position; ARL A.x, a.x; MOV t, vertex.position;"
                         "EXP u, a.y; MOV result.position, program.env[1];"),
            (ResourceCounts{.instructions = 4,
                            .temporaries = 3,
                            .parameters = 1,
                            .attribs = 1,
                            .addressRegisters = 2}));
}

// The example of 2.14.3.7, and the same program without relative addressing.
TEST(VertexCounts, ConstantsOfArraysUnderRelativeAddressingCountEach) {
  const std::string arrays = "PARAM arr1[4] = { {1,2,3,4}, {1,2,3,4}, {4,4,4,4}, {5,6,7,8} };"
                             "PARAM arr2[3] = { {1,2,3,4}, {5,6,7,8}, {0,1,2,3} };"
                             "PARAM x = {4,3,2,1}; PARAM y = {1,2,3,4}; PARAM z = 4;"
                             "PARAM r = {4,3,2,1}; ADDRESS A; TEMP t;";
  EXPECT_EQ(vertexCounts(arrays).parameters, 5u);
  EXPECT_EQ(vertexCounts(arrays + "MOV t, arr1[3];").parameters, 5u);
  EXPECT_EQ(vertexCounts(arrays + "MOV t, arr1[A.x];").parameters, 6u);
  EXPECT_EQ(vertexCounts(arrays + "MOV t, arr1[A.x]; ADD t, arr1[A.x+1], arr1[2];").parameters, 6u);
  EXPECT_EQ(vertexCounts(arrays + "MOV t, arr1[A.x]; MOV t, arr2[A.x];").parameters, 8u);
  // Numerically equal constants count as two here.
  EXPECT_EQ(vertexCounts("PARAM c[] = {0, -0}; ADDRESS A; TEMP t; MOV t, c[A.x];").parameters, 2u);
  EXPECT_EQ(vertexCounts("PARAM c[] = {0, -0};").parameters, 1u);
}

TEST(VertexCounts, AStateVectorMayBeBoundTwiceUnlessBothAreUnderRelativeAddressing) {
  const std::string arrays = "PARAM c[] = { program.env[0..3] }; PARAM d[] = { program.env[2..5] };"
                             "PARAM e = program.env[2]; ADDRESS A; TEMP t;";
  EXPECT_EQ(vertexCounts(arrays + "MOV t, c[A.x]; MOV t, d[0]; MOV t, e;").parameters, 6u);
  EXPECT_EQ(firstError(check(wrapVertex(arrays + "MOV t, c[A.x]; MOV t, d[A.x];"))),
            "relative_duplicate");
}

struct Statement {
  const char *id;
  std::uint32_t ResourceCounts::*resource;
  const char *before;
  const char *after;
};

TEST(VertexLimits, AtTheLimitLoadsAndOneMoreFailsWhereItGoesOver) {
  const Statement makers[] = {
      {"limit_instructions", &ResourceCounts::instructions, "MOV result.texcoord[", "], 0;\n"},
      {"limit_temporaries", &ResourceCounts::temporaries, "TEMP t", ";\n"},
      {"limit_parameters", &ResourceCounts::parameters, "PARAM p", " = program.env[0];\n"},
      {"limit_attribs", &ResourceCounts::attribs, "ATTRIB a", " = vertex.attrib[0];\n"},
      {"limit_address_registers", &ResourceCounts::addressRegisters, "ADDRESS A", ";\n"}};
  for (const Statement &maker : makers) {
    const auto text = [&](std::uint32_t n) {
      std::string all;
      for (std::uint32_t i = 0; i < n; ++i) {
        std::string after = maker.after;
        if (const std::size_t zero = after.find("[0]"); zero != std::string::npos)
          after.replace(zero + 1, 1, std::to_string(i));
        all += maker.before + std::to_string(i) + after;
      }
      return wrapVertex(all);
    };
    CompileOptions options = generous();
    options.limits.api.*maker.resource = 6;
    EXPECT_TRUE(check(text(6), options).ok()) << maker.id;
    const CheckResult over = check(text(7), options);
    EXPECT_EQ(firstError(over), maker.id);
    EXPECT_EQ(over.diagnostics.size(), 1u) << maker.id;
    const std::string seven = text(7);
    EXPECT_GT(over.errorPosition(), std::int32_t(seven.rfind('\n', seven.find("\nEND") - 2)));
    options.policy = LimitPolicy::Report;
    EXPECT_TRUE(check(text(7), options).ok()) << maker.id;
  }
}

// An excess of an array under relative addressing is reported where it is first indexed.
TEST(VertexLimits, RelativeAddressingMayGoOverTheParameters) {
  CompileOptions options = generous();
  options.limits.api.parameters = 3;
  const std::string text =
      wrapVertex("PARAM c[3] = {1, 1, 2}; PARAM d[1] = {1}; ADDRESS A; TEMP t;\n"
                 "MOV t, c[A.x];\nMOV t, c[A.x];\nMOV t, d[A.x];");
  const CheckResult result = check(text, options);
  EXPECT_EQ(firstError(result), "limit_parameters");
  EXPECT_EQ(result.errorPosition(), std::int32_t(text.find("d[A.x]")));
}

TEST(VertexLimits, AddressRegistersAreNumberedInAByte) {
  CompileOptions options = generous();
  options.policy = LimitPolicy::Report;
  std::string names = "ADDRESS a";
  for (int i = 0; i < 255; ++i)
    names += ",a" + std::to_string(i);
  EXPECT_TRUE(check(wrapVertex(names + ";"), options).ok());
  EXPECT_EQ(firstError(check(wrapVertex(names + ",z;"), options)), "limit_address_registers");
}

} // namespace
} // namespace arbiter::fp
