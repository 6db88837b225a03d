#include "fp_compiler/back/assembly/assembly.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>

#include "fp_compiler/back/assembly/names.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/testing/inputs.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_nv.h"

namespace arbiter::fp {
namespace {

using ir::AttributeKind;
using ir::Builder;
using ir::Opcode;
using ir::OutputKind;

constexpr AssemblyLimits kRoomy = {
    .instructions = 4096, .temporaries = 4096, .parameters = 1024, .addresses = 4};

Limits roomy() {
  Limits limits;
  limits.api = {4096, 4096, 4096, 4096, 256, 256, 32, 4};
  limits.native = limits.api;
  limits.localParameters = limits.envParameters = 256;
  limits.textureCoords = limits.textureImageUnits = limits.textureUnits = 8;
  limits.programMatrices = 8;
  limits.drawBuffers = 4;
  return limits;
}

/// Checks that the text is a program of the same meaning.
void expectRoundTrip(const ir::Program &program, const std::string &context) {
  const std::string text = emitAssembly(program);
  const CheckResult checked = checkProgram(program.language, text, {roomy(), LimitPolicy::Enforce});
  ASSERT_TRUE(checked.ok()) << context << "\n" << checked.errorString(text) << "\n" << text;
  for (std::uint64_t pixel = 0; pixel < 4; ++pixel)
    ASSERT_TRUE(
        testing::same(testing::outcome(program, pixel), testing::outcome(*checked.program, pixel)))
        << context << "\n"
        << text << ir::print(program) << ir::print(*checked.program);
}

/// Replaces infinities, which text cannot express.
void makeFinite(ir::Program &program) {
  for (ir::Parameter &row : program.parameters)
    for (float &value : row.constant)
      if (std::isinf(value))
        value = std::copysign(std::numeric_limits<float>::max(), value);
}

TEST(Assembly, NumeralsRoundTripEveryBit) {
  for (const float value : {0.0f, -0.0f, 1.0f, 0.1f, -3.14159274f, 16777217.0f, 1e-40f,
                            3.4028235e38f, 1.17549435e-38f, 1e20f, 123456.789f}) {
    const std::string text = assembly::numeral(value);
    const float back = std::strtof(text.c_str(), nullptr);
    EXPECT_EQ(std::memcmp(&back, &value, sizeof value), 0) << text;
  }
}

TEST(Assembly, FragmentTextIsPlain) {
  Builder b;
  b.options().fog = ir::FogMode::Linear;
  const auto t = b.temporary("some_name");
  (void)b.temporary("never_used");
  const auto k = b.constant(-0.5f, 2, 1e-20f, 0);
  b.tex(Opcode::Txp, t, -b.attribute(AttributeKind::TexCoord, 2).swz("yxzw"), 3,
        ir::TexTarget::Cube);
  b.op(Opcode::Mad, t.mask("xw").sat(), {t.read().swz("w"), k, b.local(4).swz("x1z0").negated(5)});
  b.op(Opcode::Mov, b.color(), {t.read()});
  EXPECT_EQ(emitAssembly(b.program()), "!!ARBfp1.0\n"
                                       "OPTION ARB_fog_linear;\n"
                                       "TEMP t0, s0;\n"
                                       "PARAM p0 = {-0.5, 2, 1e-20, 0};\n"
                                       "PARAM p1 = program.local[4];\n"
                                       "TXP t0, -fragment.texcoord[2].yxzw, texture[3], CUBE;\n"
                                       "SWZ s0, p1, -x, 1, -z, 0;\n"
                                       "MAD_SAT t0.xw, t0.w, p0, s0;\n"
                                       "MOV result.color, t0;\n"
                                       "END\n");
}

// A host may read a constant by other components in SWZ.
TEST(Assembly, ConstantsAreNotSwizzled) {
  Builder b;
  const auto t = b.temporary();
  const auto k = b.constant(0.25f, 0.25f, 0.25f, 0.25f);
  b.op(Opcode::Swz, t, {k.swz("xy01").negated(0b1010)});
  b.op(Opcode::Add, t, {t.read(), b.constant(2, 3, 4, 5).swz("wz10").negated(1)});
  b.op(Opcode::Rcp, t.mask("w"), {k.swz("1111")});
  b.op(Opcode::Mul, b.color(), {t.read(), k});
  const std::string text = emitAssembly(b.program());
  EXPECT_EQ(text, "!!ARBfp1.0\n"
                  "TEMP t0;\n"
                  "PARAM p0 = {0.25, 0.25, 0.25, 0.25};\n"
                  "PARAM p2 = {0.25, -0.25, 0, -1};\n"
                  "PARAM p3 = {-5, 4, 1, 0};\n"
                  "PARAM p4 = {1, 1, 1, 1};\n"
                  "MOV t0, p2;\n"
                  "ADD t0, t0, p3;\n"
                  "RCP t0.w, p4.x;\n"
                  "MUL result.color, t0, p0;\n"
                  "END\n");
  expectRoundTrip(b.program(), "constants");
}

TEST(Assembly, WhatIsUndefinedElsewhereIsWrittenOut) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mov, t.mask("x"), {b.local(0)});
  b.op(Opcode::Mov, b.color().mask("xyz"), {t.read()});
  const std::string text = emitAssembly(b.program());
  EXPECT_NE(text.find("MOV t0, {0, 0, 0, 0};\n"), std::string::npos) << text;
  EXPECT_NE(text.find("MOV result.color.w, {0, 0, 0, 0};\n"), std::string::npos) << text;
}

TEST(Assembly, ProgramsByTheirOwnText) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    testing::RandomOptions options;
    options.wild = seed & 1;
    ir::Program program = testing::randomProgram(seed + 70000, options);
    makeFinite(program);
    expectRoundTrip(program, "seed " + std::to_string(seed));
    optimise(program);
    expectRoundTrip(program, "optimised, seed " + std::to_string(seed));
    if (::testing::Test::HasFailure())
      return;
  }
}

TEST(Assembly, VertexProgramsByTheirOwnText) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    testing::RandomOptions options;
    options.wild = seed & 1;
    ir::Program program = testing::randomVertexProgram(seed + 80000, options);
    makeFinite(program);
    expectRoundTrip(program, "seed " + std::to_string(seed));
    optimise(program);
    expectRoundTrip(program, "optimised, seed " + std::to_string(seed));
    if (::testing::Test::HasFailure())
      return;
  }
}

TEST(Assembly, VertexText) {
  Builder b(ir::Language::ArbVertex);
  const auto a = b.address();
  const auto position = b.result(OutputKind::Position);
  const auto row = b.env(8);
  const int array = b.array({b.env(7), row, b.constant(1)});
  b.op(Opcode::Arl, a, {-b.attribute(AttributeKind::Generic, 5).swz("z")});
  b.op(Opcode::Add, position,
       {-Builder::element(array, a, -2).swz("x"), Builder::element(array, a).swz("wzyx")});
  b.op(Opcode::Mul, b.result(OutputKind::TexCoord, 3).mask("xy"),
       {row, b.attribute(AttributeKind::Normal)});
  EXPECT_EQ(emitAssembly(b.program()), "!!ARBvp1.0\n"
                                       "ADDRESS a0;\n"
                                       "PARAM c0[3] = { program.env[7..8], {1, 1, 1, 1} };\n"
                                       "MOV result.texcoord[3].zw, {0, 0, 0, 0};\n"
                                       "ARL a0.x, -vertex.attrib[5].z;\n"
                                       "ADD result.position, -c0[a0.x-2].x, c0[a0.x].wzyx;\n"
                                       "MUL result.texcoord[3].xy, c0[1], vertex.normal;\n"
                                       "END\n");
}

TEST(Assembly, AddressesStartAtZero) {
  Builder b(ir::Language::ArbVertex);
  b.options().positionInvariant = true;
  const auto a = b.address();
  const int array = b.array({b.env(7)});
  b.op(Opcode::Mov, b.result(OutputKind::FrontPrimary), {Builder::element(array, a)});
  const std::string text = emitAssembly(b.program());
  EXPECT_NE(text.find("OPTION ARB_position_invariant;\n"), std::string::npos) << text;
  EXPECT_NE(text.find("ARL a0.x, {0, 0, 0, 0}.x;\nMOV result"), std::string::npos) << text;
}

/// Returns a program under NVIDIA's options or in one of its languages, after the passes.
ir::Program optimised(const std::string &text) {
  CompileOptions options = {roomy(), LimitPolicy::Report};
  options.limits.nvOptions = 2;
  options.limits.clipPlanes = 6;
  CheckResult checked = checkProgram(languageOfText(text).value(), text, options);
  EXPECT_TRUE(checked.ok()) << checked.errorString(text) << text;
  ir::Program program = std::move(checked.program.value());
  optimise(program);
  return program;
}

bool optionIsOfArb(const std::string &statements) {
  return isOfArb(optimised("!!ARBvp1.0\nOPTION NV_vertex_program3;\nTEMP r;\n"
                           "MOV result.position, vertex.position;\n" +
                           statements + "\nEND\n"));
}

TEST(Assembly, WhatOfNvidiasLanguagesIsOfTheArb) {
  EXPECT_TRUE(optionIsOfArb("MUL r, vertex.color, 2.0; SGT result.color, r, 1.0;"));
  EXPECT_TRUE(optionIsOfArb("MOVC r.x, 1.0; BRA end (GT.x); MOV r, vertex.color;\nend:\n"
                            "MOV result.color, r;"))
      << "decided by constants";
  EXPECT_TRUE(optionIsOfArb("ADDRESS A; PARAM c[3] = { program.env[0..2] }; ARL A.x, 1.0; "
                            "MOV result.color, c[A.x];"));
  EXPECT_FALSE(optionIsOfArb("MOVC r, vertex.color; MOV r (GT.x), 2.0; MOV result.color, r;"));
  EXPECT_FALSE(optionIsOfArb("ADDRESS A; PARAM c[3] = { program.env[0..2] }; "
                             "ARL A.x, vertex.color.x; MOV result.color, c[A.x];"));
  EXPECT_FALSE(optionIsOfArb("TEX result.color, vertex.texcoord[0], texture[0], 2D;"));
  EXPECT_FALSE(optionIsOfArb("MOV result.clip[2].x, vertex.color.x;"));
  EXPECT_FALSE(optionIsOfArb("MUL_SAT result.color, vertex.color, 2.0;"));
  EXPECT_FALSE(optionIsOfArb("XPD result.color, vertex.color, vertex.normal;")) << "w is 0";
  EXPECT_FALSE(optionIsOfArb("SIN result.color, vertex.color.x;"));
  EXPECT_FALSE(optionIsOfArb("SEQ result.color, vertex.color, 0.5;"));
  const std::string shadow = emitAssembly(
      optimised("!!ARBvp1.0\nOPTION NV_vertex_program3;\nOPTION ARB_fragment_program_shadow;\n"
                "MOV result.position, vertex.position;\nEND\n"));
  EXPECT_EQ(shadow.find("OPTION"), std::string::npos) << shadow;
  const std::string native = "!!VP1.0\nMOV o[HPOS], v[OPOS];\nMUL o[COL0], v[NRML], v[2];\nEND";
  EXPECT_TRUE(isOfArb(optimised(native)));
  ir::Program both = optimised(native);
  both.attributes.push_back({AttributeKind::Generic, 2});
  EXPECT_FALSE(isOfArb(both)) << "the normal is the ARB's attribute 2";
  ir::Program infinite = optimised("!!VP1.0\nMOV o[HPOS], v[OPOS];\nMOV o[COL0], c[1];\nEND");
  EXPECT_TRUE(isOfArb(infinite));
  for (ir::Parameter &row : infinite.parameters)
    row.constant[1] = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(isOfArb(infinite)) << "no text spells it";
  EXPECT_FALSE(isOfArb(optimised("!!ARBfp1.0\nOPTION NV_fragment_program;\n"
                                 "DDX result.color, fragment.texcoord[0];\nEND")));
}

/// Returns the colour of a vertex with \p x in texture coordinate 2.
ir::Vec4 colorAt(const ir::Program &program, float x) {
  std::vector<ir::Vec4> attributes;
  for (const ir::Attribute &attribute : program.attributes)
    attributes.push_back(attribute.kind == AttributeKind::TexCoord ? ir::Vec4{x, 1, 2, 3}
                                                                   : ir::Vec4{1, 1, 1, 1});
  ir::Inputs inputs;
  inputs.attributes = attributes;
  inputs.parameter = [](const ir::Parameter &row) {
    const auto n = float(row.index);
    return ir::Vec4{n + 1, -n, n * n, 1};
  };
  const ir::Evaluation evaluation = ir::evaluate(program, inputs);
  for (std::size_t i = 0; i < program.outputs.size(); ++i)
    if (program.outputs[i].kind == OutputKind::FrontPrimary)
      return evaluation.outputs[i];
  ADD_FAILURE() << "no colour";
  return {};
}

/// Checks that the assembly text reads the same rows at every address.
void expectSameRows(const std::string &text) {
  const ir::Program program = optimised(text);
  ir::Program made = program;
  ASSERT_TRUE(defineAddresses(made, kRoomy)) << text;
  ASSERT_TRUE(isOfArb(made, true)) << ir::print(made);
  const std::string assembly = emitAssembly(made);
  const CheckResult checked =
      checkProgram(ir::Language::ArbVertex, assembly, {roomy(), LimitPolicy::Report});
  ASSERT_TRUE(checked.ok()) << checked.errorString(assembly) << assembly;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float x : {0.0f,
                        -0.0f,
                        0.75f,
                        5.0f,
                        -0.5f,
                        -8.0f,
                        -9.0f,
                        -10.25f,
                        -11.0f,
                        -12.0f,
                        84.0f,
                        85.0f,
                        86.5f,
                        87.99f,
                        88.0f,
                        95.0f,
                        96.0f,
                        1e9f,
                        -1e9f,
                        1e38f,
                        kInfinity,
                        -kInfinity,
                        std::numeric_limits<float>::quiet_NaN()})
    EXPECT_EQ(colorAt(program, x), colorAt(*checked.program, x)) << x << "\n" << assembly;
}

TEST(Assembly, RowsByAddressAreReadAsNvidiasLanguagesHaveThem) {
  const std::string rows = "c[A0.x + 8]; ADD R0, R0, c[A0.x + 10]; ADD R0, R0, c[A0.x - 3];";
  for (const char *const version : {"!!VP1.0\n", "!!VP1.1\n", "!!VP2.0\n"})
    expectSameRows(version + ("MOV o[HPOS], v[OPOS]; ARL A0.x, v[TEX2].x; MOV R0, " + rows) +
                   "MOV o[COL0], R0;\nEND\n");
  // Address 0 reads a row so far before the array that the padding does not reach it.
  expectSameRows("!!VP1.1\nMOV o[HPOS], v[OPOS]; ARL A0.x, v[TEX2].x;\n"
                 "MOV R0, c[A0.x - 3]; ADD R0, R0, c[A0.x - 4]; MOV o[COL0], R0;\nEND\n");
  // Several addresses use the same temporaries.
  for (const char *const version : {"!!VP1.1\n", "!!VP2.0\n"})
    expectSameRows(version + ("MOV o[HPOS], v[OPOS]; ARL A0.x, v[TEX2].x; MOV R0, " + rows) +
                   "ARL A0.x, v[TEX2].z; MUL R0, R0, c[A0.x + 9]; ADD R0, R0, " + rows +
                   "ADD R1, R0.x, -v[TEX2].x; ARL A0.x, R1.x; ADD R0, R0, c[A0.x];\n" +
                   "MOV o[COL0], R0;\nEND\n");
  const std::string option = "!!ARBvp1.0\nOPTION NV_vertex_program2;\nADDRESS A;\nTEMP r;\n"
                             "PARAM c[7] = { program.env[0..5], { 1, 2, 3, 4 } };\n"
                             "MOV result.position, vertex.position;\n";
  expectSameRows(option + "ARL A, vertex.texcoord[2]; MOV r, c[A.x]; ADD r, r, c[A.y + 2];\n"
                          "MOV result.color, r;\nEND\n");
}

TEST(Assembly, WhatNoTextReadsByAddress) {
  ir::Program many = optimised("!!VP1.0\nMOV o[HPOS], v[OPOS]; ARL A0.x, v[TEX2].x;\n"
                               "MOV o[COL0], c[A0.x + 8];\nEND\n");
  const std::string before = ir::print(many);
  EXPECT_FALSE(defineAddresses(many, {.parameters = 96, .addresses = 4})) << "zeros beside 96 rows";
  EXPECT_EQ(ir::print(many), before);
  ir::Program far = optimised("!!VP1.0\nMOV o[HPOS], v[OPOS]; ARL A0.x, v[TEX2].x;\n"
                              "MUL o[COL0], v[COL0], c[A0.x + 63]; END\n");
  EXPECT_FALSE(defineAddresses(far, kRoomy)) << "64 stands in no text";
  ir::Program two = optimised("!!ARBvp1.0\nOPTION NV_vertex_program2;\nADDRESS A;\n"
                              "PARAM c[4] = { program.env[0..3] }; ARL A, vertex.texcoord[2];\n"
                              "MOV result.position, c[A.x]; MOV result.color, c[A.y];\nEND\n");
  ir::Program tight = two, scarce = two;
  EXPECT_FALSE(defineAddresses(two, {.parameters = 1024, .addresses = 1}));
  EXPECT_TRUE(defineAddresses(two, {.parameters = 1024, .addresses = 2}));
  std::size_t rows = two.parameters.size();
  for (const ir::ParameterArray &array : two.arrays)
    rows += array.rows.size();
  EXPECT_TRUE(defineAddresses(tight, {.parameters = int(rows), .addresses = 2}));
  EXPECT_FALSE(defineAddresses(scarce, {.parameters = int(rows) - 1, .addresses = 2}))
      << "the constants are rows too";
  ir::Program added = optimised("!!ARBvp1.0\nOPTION NV_vertex_program2;\nADDRESS A, B;\n"
                                "PARAM c[4] = { program.env[0..3] };\n"
                                "MOV result.position, vertex.position; ARL A, vertex.texcoord[2];\n"
                                "ARA B, A; MOV result.color, c[B.x];\nEND\n");
  EXPECT_FALSE(defineAddresses(added, kRoomy) && isOfArb(added, true))
      << "an address that is added";
}

TEST(Assembly, TextsKeepToWhatAHostTakes) {
  // Besides the program's temporaries, the text needs some for clamped addresses and one for SWZ.
  ir::Program program = optimised(
      "!!ARBvp1.0\nOPTION NV_vertex_program2;\nADDRESS A;\nTEMP r, s, q;\n"
      "PARAM c[4] = { program.env[0..3] };\nMOV result.position, vertex.position;\n"
      "ARL A.x, vertex.texcoord[2].x; MUL r, c[A.x], vertex.color;\n"
      "ARL A.x, vertex.texcoord[2].y; MUL s, c[A.x], vertex.normal;\n"
      "MUL result.texcoord[0], r, s; SWZ q, s, x, y, -z, -w; ADD result.color, r, q;\nEND\n");
  ASSERT_TRUE(defineAddresses(program, kRoomy));
  const std::string text = emitAssembly(program, PartlyWritten::Zero, kRoomy);
  const CheckResult checked =
      checkProgram(ir::Language::ArbVertex, text, {roomy(), LimitPolicy::Report});
  ASSERT_TRUE(checked.ok()) << checked.errorString(text) << text;
  EXPECT_EQ(emitAssembly(program), text);
  const AssemblyLimits enough = {.instructions = int(checked.counts.instructions),
                                 .temporaries = int(checked.counts.temporaries)};
  EXPECT_NE(text.find("SWZ s0"), std::string::npos) << text;
  EXPECT_EQ(emitAssembly(program, PartlyWritten::Zero, enough), text);
  AssemblyLimits scarce = enough;
  --scarce.temporaries;
  EXPECT_EQ(emitAssembly(program, PartlyWritten::Zero, scarce), "") << text;
  scarce = enough;
  --scarce.instructions;
  EXPECT_EQ(emitAssembly(program, PartlyWritten::Zero, scarce), "") << text;
}

TEST(Assembly, AddressesShareTheirTemporaries) {
  std::string text = "!!VP1.1\nMOV o[HPOS], v[OPOS]; MOV R0, v[COL0];\n";
  for (int i = 0; i < 9; ++i)
    text += "ARL A0.x, v[TEX" + std::to_string(i % 8) + "].x; MAD R0, c[A0.x + " +
            std::to_string(i) + "], v[WGHT], R0;\n";
  ir::Program program = optimised(text + "MOV o[COL0], R0;\nEND\n");
  const std::size_t before = program.temporaries.size();
  ASSERT_TRUE(defineAddresses(program, kRoomy));
  EXPECT_EQ(program.temporaries.size(), before + 3) << "whatever the number of addresses";
}

TEST(Assembly, AddressesAreHeldAgainOnlyWhereZeroIsNotInTheirRange) {
  const auto held = [](const std::string &row) {
    ir::Program program =
        optimised("!!VP1.1\nMOV o[HPOS], v[OPOS]; ARL A0.x, v[TEX2].x;\nMOV R0, " + row +
                  "; MOV o[COL0], R0;\nEND\n");
    EXPECT_TRUE(defineAddresses(program, kRoomy));
    const auto &code = program.code;
    return std::count_if(code.begin(), code.end(),
                         [](const auto &each) { return each.op == Opcode::Max; });
  };
  EXPECT_EQ(held("c[A0.x + 8]"), 1);
  EXPECT_EQ(held("c[A0.x - 1]"), 1);
  EXPECT_EQ(held("c[A0.x - 2]"), 2) << "row -2 is before the zeros that are there";
}

TEST(Assembly, NvidiasProgramsThatAreOfTheArbByTheirText) {
  int vertices = 0, fragments = 0, addressed = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const bool vertex = seed % 2 != 0;
    const ir::Program program = optimised(
        testing::randomNvProgram(seed, {.vertex = vertex, .textures = !vertex, .statements = 3}));
    ir::Program made = program;
    if (!defineAddresses(made, kRoomy) || !isOfArb(made, true))
      continue;
    ++(vertex ? vertices : fragments);
    addressed += made.parameters.size() > program.parameters.size() ? 1 : 0;
    expectRoundTrip(made, "seed " + std::to_string(seed));
    for (std::uint64_t pixel = 0; pixel < 4; ++pixel)
      EXPECT_TRUE(testing::same(testing::outcome(program, pixel), testing::outcome(made, pixel)))
          << ir::print(program) << ir::print(made);
    if (::testing::Test::HasFailure())
      return;
  }
  EXPECT_GT(vertices, 20);
  EXPECT_GT(fragments, 20);
  EXPECT_GT(addressed, 5);
}

} // namespace
} // namespace arbiter::fp
