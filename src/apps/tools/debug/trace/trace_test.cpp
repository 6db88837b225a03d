#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "apps/tools/debug/json.h"
#include "apps/tools/debug/testing/fake_drawer.h"
#include "apps/tools/debug/trace/condition.h"
#include "apps/tools/debug/trace/record.h"
#include "apps/tools/debug/trace/text.h"

namespace arbiter::tools::debug {
namespace {

using fp::Numerics;

/// Traces a program whose attributes all have the same value.
Trace traced(const std::string &text, const Vec4 &attribute = {0.25f, 0.5f, 0.75f, 1},
             Both<Numerics> numerics = {Numerics::Host, Numerics::Fp24}) {
  const fp::ir::Program program = checked(text);
  TraceInputs inputs;
  inputs.attributes.assign(program.attributes.size(), attribute);
  for (const fp::ir::Parameter &parameter : program.parameters)
    inputs.parameters.push_back({float(parameter.index), 0.5f, -1, 2});
  inputs.texture = [](std::size_t, const fp::ir::Sample &sample, Numerics) {
    return texelAt(sample);
  };
  return record(program, text, inputs, numerics);
}

std::string fragment(const std::string &body) {
  return "!!ARBfp1.0\nTEMP a, b;\n" + body + "END\n";
}

TEST(Trace, RowSaysWhatTheInstructionReadAndWrote) {
  const Trace trace = traced(fragment("MUL a.xz,\n  fragment.color.wzyx, -program.local[3].yyyw;\n"
                                      "MOV result.color, a;\n"));
  ASSERT_EQ(trace.rows.size(), 2u);
  const Row &row = trace.rows[0];
  EXPECT_EQ(row.at.line, 3u);
  EXPECT_EQ(row.text, "MUL a.xz, fragment.color.wzyx, -program.local[3].yyyw");
  EXPECT_EQ(row.destination, "a.xz");
  EXPECT_EQ(row.mask, 0b0101);
  ASSERT_EQ(row.operands.size(), 2u);
  EXPECT_EQ(row.operands[0].text, "fragment.color.wzyx");
  EXPECT_EQ(row.operands[0].value.first, (Vec4{1, 0.75f, 0.5f, 0.25f}));
  EXPECT_EQ(row.operands[0].reads, 0b0101);
  EXPECT_EQ(row.operands[1].value.first, (Vec4{-0.5f, -0.5f, -0.5f, -2}));
  EXPECT_EQ(row.value.first, (Vec4{-0.5f, 0, -0.25f, 0}));
  ASSERT_EQ(trace.attributes.size(), 1u);
  EXPECT_EQ(trace.attributes[0].name, "fragment.color.primary");
  ASSERT_EQ(trace.parameters.size(), 1u);
  EXPECT_EQ(trace.parameters[0].name, "program.local[3]");
  ASSERT_EQ(trace.results.size(), 1u);
  EXPECT_EQ(trace.results[0].value.first, (Vec4{-0.5f, 0, -0.25f, 0}));
}

TEST(Trace, ARegisterHasOneNameHoweverItIsSpelt) {
  const Trace trace = traced(fragment("ALIAS c = a;\nOUTPUT o = result.color;\n"
                                      "MOV a.rgb, fragment.color;\nMOV a.w, 1;\nMOV c.x, 0;\n"
                                      "MOV o.xyz, a;\nMOV result.color.w, a;\n"));
  ASSERT_EQ(trace.rows.size(), 5u);
  EXPECT_EQ(trace.rows[0].destination, "a.rgb");
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(trace.rows[std::size_t(i)].name, "a");
  EXPECT_EQ(trace.rows[3].name, "o");
  EXPECT_EQ(trace.rows[4].name, "o");
}

/// Each fragment opcode's row must hold the value that the interpreter returns for it alone.
TEST(Trace, EachOpcodeHasItsValue) {
  for (int op = 0; op < fp::ir::kFragmentOpcodeCount; ++op) {
    const fp::ir::OpInfo &info = fp::ir::info(fp::ir::Opcode(op));
    if (info.has(fp::ir::Texture) || info.has(fp::ir::Kills))
      continue;
    std::string text = std::string(info.mnemonic) + " a";
    for (int i = 0; i < info.operandCount(); ++i)
      text += std::string(", fragment.color") + (info.shapes[i] == 'S' ? ".y" : "");
    if (fp::ir::Opcode(op) == fp::ir::Opcode::Swz)
      text += ", w, 0, -x, 1";
    const Trace trace = traced(fragment(text + ";\nMOV result.color, a;\n"));
    const Row &row = trace.rows[0];
    fp::ir::Operands operands = {};
    for (std::size_t i = 0; i < row.operands.size(); ++i)
      operands[i] = row.operands[i].value.first;
    EXPECT_EQ(row.value.first, fp::ir::apply(fp::ir::Opcode(op), operands, Numerics::Host)) << text;
    EXPECT_EQ(trace.results[0].value.first, row.value.first) << text;
  }
}

TEST(Trace, TextureAccessesHaveCoordinateAndTexel) {
  const Trace trace =
      traced(fragment("TXP a.x, fragment.texcoord[1], texture[3], 2D;\n"
                      "TXB b, a, texture[2], 2D;\nTEX result.color, b, texture[0], 3D;\n"),
             {0.5f, 1, 0, 2});
  ASSERT_TRUE(trace.rows[0].texel);
  EXPECT_EQ(trace.rows[0].texel->unit, 3u);
  EXPECT_EQ(trace.rows[0].texel->coordinate.first, (Vec4{0.25f, 0.5f, 0, 0}));
  const Vec4 texel = trace.rows[0].texel->value.first;
  EXPECT_NE(texel[1], 0);
  EXPECT_EQ(trace.rows[0].value.first, (Vec4{texel[0], 0, 0, 0})) << "the mask is .x";
  EXPECT_EQ(trace.rows[1].texel->coordinate.first[0], texel[0]);
  EXPECT_EQ(trace.rows[2].texel->coordinate.first[2], trace.rows[1].value.first[2]);
  EXPECT_FALSE(trace.rows[0].texel->lod);
}

TEST(Trace, KilPassesOrDiscardsAndTheRestIsMarked) {
  const std::string text = fragment("MOV a, fragment.color;\nKIL a.x;\nKIL -a.y;\n"
                                    "ADD result.color, a, a;\n");
  const Trace trace = traced(text);
  EXPECT_EQ(trace.rows[1].mask, 0);
  EXPECT_FALSE(trace.rows[1].discards.first);
  EXPECT_TRUE(trace.rows[2].discards.first);
  EXPECT_FALSE(trace.rows[2].isDiscarded) << "the row that discards is not behind itself";
  EXPECT_TRUE(trace.rows[3].isDiscarded);
  EXPECT_TRUE(trace.isDiscarded.first);
  EXPECT_EQ(trace.results[0].value.first[0], 0.5f) << "what it would have been";
  EXPECT_NE(rowsText(trace, {}).find("=> discarded"), std::string::npos);
  EXPECT_FALSE(traced(text, {0.25f, -0.5f, 0, 1}).isDiscarded.first);
}

TEST(Trace, FlagsAreOfWrittenComponentsAlone) {
  const Trace trace = traced(fragment("RCP a.x, program.local[0].x;\nMUL a.y, a.x, 0.0;\n"
                                      "MOV a.z, 0.5;\nADD b.w, 1.0, 0.5;\nMOV_SAT b.x, b.w;\n"
                                      "MOV result.color, -b.w;\n"));
  EXPECT_EQ(trace.rows[0].flags, unsigned(kInf | kOver1));
  EXPECT_EQ(trace.rows[1].flags, unsigned(kNan));
  EXPECT_EQ(trace.rows[1].value.second[1], 0.0f) << "legacy: 0 times an infinity is 0";
  EXPECT_EQ(greatestError(trace.rows[1]), std::numeric_limits<float>::infinity());
  EXPECT_EQ(trace.rows[2].flags, 0u) << "the NaN in y is an older one";
  EXPECT_EQ(trace.rows[3].flags, unsigned(kOver1));
  EXPECT_EQ(trace.rows[4].flags, 0u);
  EXPECT_EQ(trace.rows[5].flags, unsigned(kBelow0));
}

TEST(Trace, ReadsOfWhatNothingHasWrittenAreMarked) {
  const Trace trace = traced(fragment("MOV a.xy, fragment.color;\nMOV b.x, a.y;\n"
                                      "ADD b.yz, a.xzyw, b;\nDP3 result.color.x, a, b;\n"));
  EXPECT_EQ(trace.rows[0].flags, 0u);
  EXPECT_EQ(trace.rows[1].flags, 0u) << "a.y is written";
  EXPECT_EQ(trace.rows[2].operands[0].unwritten, 0b0010) << "y takes a.z; z takes a.y";
  EXPECT_EQ(trace.rows[2].operands[1].unwritten, 0b0110);
  EXPECT_EQ(trace.rows[3].operands[0].unwritten, 0b0100);
  EXPECT_EQ(trace.rows[3].operands[1].unwritten, 0);
  EXPECT_EQ(trace.results[0].mask, 0b0001);
  EXPECT_NE(resultsText(trace).find("nothing writes yzw"), std::string::npos);
}

TEST(Trace, TheSecondArithmeticHasItsOwnValues) {
  const Trace trace = traced(fragment("MUL a, fragment.texcoord[0], 0.1;\nMOV result.color, a;\n"),
                             {0.3f, 0.5f, 1, 1});
  const Row &row = trace.rows[0];
  EXPECT_EQ(row.value.first[0], 0.3f * 0.1f);
  EXPECT_EQ(row.value.second[0], fp::fp24::rounded(row.value.second[0]));
  EXPECT_NE(row.error[0], 0);
  EXPECT_LT(greatestError(row), 1e-5f);
  EXPECT_EQ(row.error[0], row.value.second[0] - row.value.first[0]);
}

TEST(Trace, VertexProgramsAreTracedToTheirResults) {
  const std::string text = "!!ARBvp1.0\nADDRESS A;\nPARAM c[2] = { program.env[5..6] };\nTEMP t;\n"
                           "ARL A.x, vertex.attrib[1].w;\nMUL t, vertex.position, c[A.x];\n"
                           "MOV result.position, t;\nMOV result.texcoord[2].xy, t;\nEND\n";
  const Trace trace = traced(text, {0.5f, 1, 1, 1}, {Numerics::Host, Numerics::Legacy});
  ASSERT_EQ(trace.rows.size(), 4u);
  EXPECT_EQ(trace.rows[0].value.first[0], 1.0f);
  EXPECT_EQ(trace.rows[1].value.first, (Vec4{3, 0.5f, -1, 2})) << "env[6] is c[1]";
  EXPECT_EQ(trace.results[0].name, "result.position");
  EXPECT_EQ(trace.results[1].value.first, (Vec4{3, 0.5f, 0, 0}));
}

TEST(Trace, FogIsInTheResult) {
  TraceInputs inputs;
  const std::string text = "!!ARBfp1.0\nOPTION ARB_fog_linear;\nMOV result.color, 0.5;\nEND\n";
  inputs.fogColor = {1, 0, 0, 0};
  inputs.fogParams = {1, 0, 1, 1};
  inputs.fogCoordinate = 0.75f;
  const Trace trace = record(checked(text), text, inputs, {Numerics::Host, Numerics::Host});
  EXPECT_EQ(trace.rows[0].value.first, (Vec4{0.5f, 0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(trace.results[0].value.first, (Vec4{0.875f, 0.125f, 0.125f, 0.5f}));
}

TEST(Condition, EachWordStopsAtItsRow) {
  const Trace trace = traced(fragment("MOV b.x, a.x;\nRCP a.x, b.x;\nMUL a.x, a.x, 0.0;\n"
                                      "MOV a.yzw, 0.25;\nMAD a.y, a.z, 4.0, a.w;\nKIL -a.y;\n"
                                      "MOV result.color, -a.z;\n"));
  const auto row = [&](const char *text) {
    const auto condition = parseCondition(text);
    EXPECT_TRUE(condition.ok()) << text;
    const auto found = firstRow(trace, condition.value());
    return found ? int(*found) : -1;
  };
  EXPECT_EQ(row("unwritten"), 0);
  EXPECT_EQ(row("inf"), 1);
  EXPECT_EQ(row("nan"), 2);
  EXPECT_EQ(row("differs"), 2);
  EXPECT_EQ(row("over1"), 1);
  EXPECT_EQ(row("kil"), 5);
  EXPECT_EQ(row("below0"), 6);
  EXPECT_EQ(row("a.y > 1"), 4);
  EXPECT_EQ(row("a.g>=0.25"), 3);
  EXPECT_EQ(row("a.y=0.25"), 3);
  EXPECT_EQ(row("a.y!=0.25"), 4);
  EXPECT_EQ(row("a.y<0"), -1);
  EXPECT_EQ(row("result.color.x<0"), 6);
  EXPECT_EQ(row("result.x<0"), -1);
}

TEST(Condition, WrongOnesAreNamed) {
  for (const char *text : {"", "nonsense", "a.x>", "a>1", "a.q>1", ".x>1", "a.x>1b", "a.xy>1"}) {
    const auto condition = parseCondition(text);
    ASSERT_FALSE(condition.ok()) << text;
    EXPECT_NE(condition.error().message.find("expected nan"), std::string::npos);
  }
}

TEST(Trace, LinesFindRows) {
  const Trace trace =
      traced("!!ARBfp1.0\nTEMP a;\n\nMOV a, 1.0; ADD a, a, a;\n\nMOV result.color, a;\nEND");
  EXPECT_EQ(rowAtLine(trace, 1), 0u);
  EXPECT_EQ(rowAtLine(trace, 4), 1u);
  EXPECT_EQ(rowAtLine(trace, 5), 1u);
  EXPECT_EQ(rowAtLine(trace, 99), 2u);
}

TEST(TraceJson, NumbersThatAreNoneAreWords) {
  const Json json = traceJson(traced(fragment("RCP a, program.local[0].x;\nMUL a.x, a.x, 0.0;\n"
                                              "MOV result.color, -a;\n")));
  EXPECT_EQ(json["rows"][0]["value"][0], "inf");
  EXPECT_EQ(json["rows"][1]["value"][0], "nan");
  EXPECT_EQ(json["rows"][1]["value"][1], "inf");
  EXPECT_EQ(json["rows"][2]["value"][1], "-inf");
  EXPECT_EQ(json["rows"][1]["flags"], Json({"nan"}));
  EXPECT_EQ(json["rows"][1]["mask"], "x");
  EXPECT_EQ(json["rows"][2]["color"], "00000000");
  EXPECT_EQ(json["rows"][0]["line"], 3);
  EXPECT_EQ(json["numerics"], "host");
  EXPECT_EQ(Json::parse(json.dump()), json);
}

} // namespace
} // namespace arbiter::tools::debug
