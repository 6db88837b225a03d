// Tests which texts load in NVIDIA's own languages, and where the others have their error. NVIDIA's
// driver (580.159) gives the same results unless a row says otherwise.
#include <gtest/gtest.h>

#include "fp_compiler/front/testing/nvidia.h"
#include "fp_compiler/front/testing/test_support.h"
#include "fp_compiler/ir/validate.h"

namespace arbiter::fp {
namespace {

using testing_support::check;
using testing_support::firstError;
using testing_support::judgeMarked;
using testing_support::offering;
using testing_support::repeat;

CompileOptions nvidiaLanguages() {
  CompileOptions options = offering(1);
  options.limits.localParameters = 64;
  return options;
}

struct LanguageRow {
  std::string statements;
  std::string_view error; ///< the diagnostic's ID; empty: it loads. '@' in the text is where
};

/// Tests each row. `begin` is the header and the common beginning of the programs, `end` their
/// common end.
void judgeLanguage(const std::string &begin, const std::vector<LanguageRow> &rows,
                   const std::string &end = "") {
  for (const LanguageRow &row : rows) {
    const bool ends = row.statements.ends_with('@'); // the error is at END
    std::string program = begin + "\n" + row.statements + (ends ? "" : "\n") + end + "END\n";
    judgeMarked(program, row.error, nvidiaLanguages());
  }
}

void judgeFp1(const std::vector<LanguageRow> &rows) {
  judgeLanguage("!!FP1.0", rows, "MOV o[COLR], R0;\n");
}
void judgeVp(const char *header, const std::vector<LanguageRow> &rows) {
  judgeLanguage(std::string(header) + "\nMOV o[HPOS], v[OPOS];", rows);
}
void judgeVsp(const std::vector<LanguageRow> &rows) { judgeLanguage("!!VSP1.0", rows); }

TEST(NativeGrammar, TheHeaderDecidesAndItsTargetMustFit) {
  const std::string fragment = "!!FP1.0\nMOV o[COLR], f[COL0];\nEND\n";
  EXPECT_TRUE(check(fragment, nvidiaLanguages()).ok());
  EXPECT_EQ(check(fragment, nvidiaLanguages()).native.language, ir::NativeLanguage::Fp1);
  EXPECT_EQ(check("!!ARBfp1.0\nEND\n", nvidiaLanguages()).native.language,
            ir::NativeLanguage::None);
  const CheckResult other = checkProgram(ir::Language::ArbVertex, fragment, nvidiaLanguages());
  EXPECT_EQ(firstError(other), "native_header");
  EXPECT_EQ(other.errorPosition(), 2);
  EXPECT_EQ(firstError(checkProgram(ir::Language::ArbFragment, "!!VSP1.0\nMOV c[0], v[0];\nEND\n",
                                    nvidiaLanguages())),
            "native_header");
  for (const auto &[header, position] : {std::pair("!!FP1.1", 6),
                                         {"!!FP2.0", 4},
                                         {"!!FCP1.0", 3},
                                         {"!!VP1.2", 6},
                                         {"!!VP3.0", 4},
                                         {"!!VSP1.1", 7}}) {
    const std::string text = std::string(header) + "\nEND\n";
    const CheckResult result = check(text, nvidiaLanguages());
    EXPECT_EQ(firstError(result), "native_header") << text;
    EXPECT_EQ(result.errorPosition(), position) << text;
    EXPECT_NE(result.errorString(text).find("!!FP1.0, !!VP1.0"), std::string::npos);
  }
}

TEST(NativeGrammar, NothingIsOfferedWithoutTheOptions) {
  CompileOptions none = nvidiaLanguages();
  none.limits.nvOptions = 0;
  const std::string text = "!!VP1.0\nMOV o[HPOS], v[OPOS];\nEND\n";
  EXPECT_EQ(firstError(check(text, none)), "header_missing");
}

TEST(NativeGrammar, RegistersOfFragments) {
  judgeFp1({{"MOV R31, f[WPOS]; MOV H63, f[COL1];", ""},
            {"MOV @R32, f[COL0];", "native_register"},
            {"MOV @H64, f[COL0];", "native_register"},
            {"MOV R0, @R32;", "native_register"},
            {"MOV R0, f[@FACE];", "unknown_binding"},
            {"MOV R0, f[@TEX8];", "unknown_binding"},
            {"MOV R0, @fragment.color;", "undeclared_name"},
            {"MOV R0, p[63];", ""},
            {"MOV R0, p[@64];", "parameter_index"},
            {"ADDC RC, R0, R1; ADDC HC.x, R0, R1;", ""},
            {"MOVC @CC, R0;", "syntax"},
            {"MOV R0, @RC;", "write_only_source"},
            {"MOV R1, @o[COLR];", "write_only_source"},
            {"MOV @f[COL0], R0;", "read_only_destination"},
            {"MOV @p[0], R0;", "read_only_destination"},
            {"MOV o[@COLX], R0;", "unknown_binding"}});
}

TEST(NativeGrammar, ResultsOfFragments) {
  judgeLanguage("!!FP1.0", {{"MOV o[COLR], R0; MOV o[@COLH], R0;", "native_outputs"},
                            {"MOV o[DEPR].z, 0.5;", ""},
                            {"MOV R0, f[COL0]; @", "native_outputs"}}); // NVIDIA loads the last one
}

TEST(NativeGrammar, OneAttributeAndOneParameterAnInstruction) {
  judgeFp1({{"ADD R0, f[TEX0], @f[TEX1];", "native_operands"},
            {"ADD R0, f[TEX0], -f[TEX0].x;", ""},
            {"ADD R0, p[0], @p[1];", "native_operands"},
            {"MAD R0, p[0], p[0].x, -p[0];", ""},
            {"MUL R0, f[COL0], p[3];", ""},
            {"MAD R0, R1, 2, -1;", ""},
            {"ADD R0, {1,2,3,4}, 4;", ""},
            {"ADD R0, {1,2,3,4}, -@4;", "native_operands"},
            {"ADD R0, {1,2,3,4}, |-@4|;", "native_operands"},
            {"ADD R0, {1,2,3,4}, @{4,5,6,7}.x;", "native_operands"},
            {"DECLARE a; ADD R0, a, a.x;", ""},
            {"DECLARE a; DECLARE b; ADD R0, a, @b;", "native_operands"},
            {"MAD R0, p[0], @2, R1;", "native_operands"}});
  for (const char *header : {"!!VP1.0", "!!VP1.1", "!!VP2.0"})
    judgeVp(header, {{"ADD R0, c[0], @c[1];", "native_operands"},
                     {"ADD R0, c[0], -c[0];", ""},
                     {"ARL A0.x, v[0].x; ADD R0, c[A0.x], @c[0];", "native_operands"},
                     {"ARL A0.x, v[0].x; ADD R0, c[A0.x+1], c[A0.x+1];", ""},
                     {"ADD R0, v[0], @v[1];", "native_operands"},
                     {"ADD R0, v[0], v[OPOS];", ""}});
}

TEST(NativeGrammar, RegisterHalves) {
  const auto moves = [](char letter, int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
      text += std::string("MOV ") + letter + std::to_string(i) + ", f[COL0];\n";
    return text;
  };
  judgeLanguage("!!FP1.0", {{moves('R', 31) + "MOV o[COLR], R0;", ""},
                            {moves('R', 32) + "MOV @o[COLR], R0;", "limit_temporaries"},
                            {moves('H', 63) + "MOV o[COLH], H0;", ""},
                            {moves('H', 64) + "MOV @o[COLH], H0;", "limit_temporaries"}});
}

TEST(NativeGrammar, NamedParametersAndConstants) {
  judgeFp1({{"MOV R0, 1; DECLARE a; ADD R0, R0, a;", ""},
            {"DECLARE a; DECLARE @a;", "redeclared_name"},
            {"DEFINE a = 2; DEFINE b = a; DEFINE v = {1, -2, a}; DEFINE w = v; MOV R0, -w.x;", ""},
            {"DEFINE a = 2; MOV R0, |-a|;", ""},
            {"DEFINE a = 2; MOV R0, a@.x;", "syntax"},
            {"DECLARE a = {1,2}; MOV R0, a.w; DECLARE b = -0.5; RCP R0, b.x;", ""},
            {"DECLARE a; DEFINE b = @a;", "syntax"},
            {"MOV R0, @zzz;", "undeclared_name"},
            {"DECLARE a; MOV @a, R0;", "read_only_destination"},
            {"DECLARE @TEX0;", "reserved_name"},
            {"DECLARE TEX16; DECLARE R32; DECLARE EQ; MOV R0, R32;", ""},
            {"DECLARE @R5;", "reserved_name"},
            {"DECLARE ADD; DECLARE ADDH_SAT; DECLARE END; MOV R0, ADD; ADD R0, END, R0;", ""},
            {"DECLARE $a_1; MOV R0, $a_1;", ""},
            {"DEFINE a@;", "syntax"}});
}

TEST(NativeGrammar, InstructionsOfFragments) {
  for (const char *word : {"ABS", "CMP", "SWZ", "SCS", "XPD", "DPH", "TXB", "TXL", "NRM", "DIV",
                           "DP2", "IF", "ADD_SSAT", "COSX", "PK2HC", "KILC", "EXP", "OPTION"})
    judgeFp1({{"@" + std::string(word) + " R0, R1;",
               std::string_view(word) == "OPTION" ? "unsupported_option" : "unknown_instruction"}});
  judgeFp1({{"ADDX_SAT R0, R1, R1; ADDRC H0, R0, R0; UP2H_SAT R0, R1.x; PK4UB R0.x, R1;", ""},
            {"KIL EQ.x; KIL NE; KIL (EQ.x);", "syntax"},
            {"KIL @R0;", "syntax"},
            {"RCP R0, R1@;", "scalar_suffix"},
            {"RCP R0, |R1.x|; RCP R0, 2; RCP R0, -|{1,2}.y|;", ""},
            {"MOV R0, -|-R1|; MOV R0, +1.5e1; MOV R0, .5; MOV R0, 5.; MOV R0, -{1,2}.wzyx;", ""},
            {"MOV R0.@r, R1;", "bad_mask"},
            {"MOV R0, R1.@rgba;", "bad_swizzle"},
            {"MOV R0 (GT.@xy), R1;", "bad_swizzle"},
            {"MOV R0.xy (GT.x), R1;", ""},
            {"SFL R0@;", "syntax"},
            {"TEX R0, R1, TEX15, 2D; TXP R0, R1, TEX15, 2D; TXD R0, R1, R1, R1, TEX3, CUBE;", ""},
            {"TEX R0, R1, @TEX16, 2D;", "image_unit"},
            {"TEX R0, R1, TEX1, @SHADOW2D;", "unknown_target"},
            {"TEX R0, R1, TEX0, 2D; TEX R0, R1, TEX0, @3D;", "target_conflict"}});
}

TEST(NativeGrammar, RegistersOfVertices) {
  for (const char *header : {"!!VP1.0", "!!VP1.1", "!!VP2.0"}) {
    const bool second = std::string_view(header) == "!!VP2.0";
    const auto only2 = [&](std::string statement, std::string_view error) {
      if (second)
        statement.erase(statement.find('@'), 1);
      return LanguageRow{statement, second ? "" : error};
    };
    judgeVp(header, {{"MOV R11, c[95]; MOV o[TEX7], v[TEX7]; MOV R0, v[15];", ""},
                     only2("MOV R0, c[@96];", "parameter_index"),
                     {"MOV R0, c[@256];", "parameter_index"},
                     only2("MOV @R12, v[0];", "native_register"),
                     {"MOV @R16, v[0];", "native_register"},
                     {"MOV R0, v[@16];", "attribute_index"},
                     {"MOV R0, @o[HPOS];", "write_only_source"},
                     {"MOV @c[0], v[0];", "read_only_destination"},
                     {"MOV R0.@r, v[0];", "bad_mask"},
                     {"MOV R0, @1.0;", "syntax"}, // NVIDIA takes it
                     only2("MOV o[@CLP5].x, v[0].x;", "unknown_binding"),
                     {"MOV o[@CLP6].x, v[0].x;", "unknown_binding"},
                     {"MOV o[@TEX8], v[0];", "unknown_binding"},
                     {"ARL A0.x, v[0].x; MOV R0, c[A0.x+63]; MOV R0, c[A0.x-64];", ""},
                     only2("ARL A0.x, v[0].x; MOV R0, c[A0.x+@64];", "relative_offset"),
                     only2("ARL A0.x, v[0].x; MOV R0, c[A0.x-@65];", "relative_offset"),
                     {"ARL A0.x, v[0].x; MOV R0, c[A0.x+@256];", "relative_offset"},
                     only2("ARL A0.@y, v[0].x; MOV R0, c[A0.x];", "address_component"),
                     only2("ARL @A1.x, v[0].x;", "syntax"),
                     only2("ARL A0@, v[0].x;", "syntax"),
                     {"MOV R0, @A0.x;", "address_register"}});
  }
}

TEST(NativeGrammar, InstructionsOfVertices) {
  for (const char *statement : {"XPD R0, R1, R1", "POW R0, R1.x, R1.y", "TEX R0, v[8], TEX0, 2D",
                                "LRP R0, R1, R1, R1", "MOV_SAT R0, R1", "MOVH R0, R1"})
    for (const char *header : {"!!VP1.0", "!!VP1.1", "!!VP2.0"})
      judgeVp(header, {{"@" + std::string(statement) + ";", "unknown_instruction"}});
  for (const char *statement : {"SUB R0, R1, R2", "ABS R0, R1", "DPH R0, R1, R1", "RCC R0, R1.x"}) {
    judgeVp("!!VP1.0", {{"@" + std::string(statement) + ";", "unknown_instruction"}});
    judgeVp("!!VP1.1", {{std::string(statement) + ";", ""}});
    judgeVp("!!VP2.0", {{std::string(statement) + ";", ""}});
  }
  for (const char *statement : {"MOVC CC, v[0]", "EX2 R0, v[0].x", "SSG R0, v[0]", "FLR R0, R1",
                                "ARR A1, v[0]", "ARA A0, A1", "RET"}) {
    judgeVp("!!VP1.1", {{"@" + std::string(statement) + ";", "unknown_instruction"}});
    judgeVp("!!VP2.0", {{std::string(statement) + ";", ""}});
  }
  judgeVp("!!VP1.0", {{"MOV R0, @|v[0]|;", "syntax"}, {"MOV R0, @+R1;", "syntax"}});
  judgeVp("!!VP1.1", {{"MOV R0, @|v[0]|;", "syntax"}, {"MOV R0, +R1; ADD R0, +R0, -R1;", ""}});
  judgeVp("!!VP2.0", {{"MOV R0.xy (LT.x), -|+v[0].x|; BRA l (EQ.x); l: MOV R0, v[0];", ""},
                      {"BRA @nowhere;", "undeclared_name"},
                      {"l: @l: MOV R0, R1;", "redeclared_name"},
                      {"CAL s; RET; s: @CAL s; RET;", "flow_control"}});
}

TEST(NativeGrammar, PositionInvariance) {
  const std::string option = "\nOPTION NV_position_invariant;";
  for (const std::string header : {"!!VP1.1", "!!VP2.0"}) {
    judgeLanguage(header + option,
                  {{"MOV o[COL0], v[COL0];", ""},
                   {"ARL A0.x, v[0].x; MOV o[COL0], c[A0.x];", ""},
                   {"MOV o[@HPOS], v[0];", "invariant_position"},
                   {"MOV R0, v[0]; @OPTION NV_position_invariant;", "late_option"}});
    judgeLanguage(header,
                  {{"OPTION @ARB_position_invariant; MOV o[COL0], v[0];", "unsupported_option"},
                   {"MOV o[COL0], v[COL0]; @", "native_outputs"}}); // NVIDIA loads it
  }
  judgeLanguage("!!VP1.0",
                {{"@OPTION NV_position_invariant; MOV o[HPOS], v[0];", "unsupported_option"}});
}

TEST(NativeGrammar, InstructionLimits) {
  const auto adds = [](std::size_t count) { return repeat("ADD R0, R0, R1;\n", count); };
  for (const char *header : {"!!VP1.0", "!!VP1.1"})
    judgeVp(header, {{adds(127), ""}, {adds(127) + "@ADD R0, R0, R1;", "limit_instructions"}});
  judgeVp("!!VP2.0", {{adds(255), ""}, {adds(255) + "@ADD R0, R0, R1;", "limit_instructions"}});
  judgeLanguage("!!VP1.1\nOPTION NV_position_invariant;",
                {{adds(124), ""}, {adds(124) + "@ADD R0, R0, R1;", "limit_instructions"}});
  judgeVsp({{"MOV c[0], v[0];" + adds(127), ""},
            {"MOV c[0], v[0];" + adds(127) + "@ADD R0, R0, R1;", "limit_instructions"}});
  CompileOptions options = nvidiaLanguages();
  options.limits.api.instructions = 64; // the target's limit is that of fragment programs
  const std::string text = "!!FP1.0\n" + adds(64) + "MOV o[COLR], R0;\nEND\n";
  EXPECT_EQ(firstError(check(text, options)), "limit_instructions");
}

TEST(NativeGrammar, StatePrograms) {
  judgeVsp({{"MOV c[0], v[0];", ""},
            {"ADD c[0], c[0], v[0];", ""},
            {"ARL A0.x, v[0].x; MOV c[0], c[A0.x+1];", ""},
            {"MOV R0, v[0]; @", "native_outputs"},   // NVIDIA loads it
            {"MOV c[0], v[@1];", "attribute_index"}, // NVIDIA takes it
            {"MOV c[0], v[@OPOS];", "syntax"},
            {"ARL A0.x, v[0].x; MOV c[@A0.x], v[0];", "syntax"},
            {"MOV @o[COL0], v[0];", "native_register"},
            {"MOV c[@96], v[0];", "parameter_index"},
            {"@SUB c[0], v[0], v[0];", "unknown_instruction"},
            {"@OPTION NV_position_invariant; MOV c[0], v[0];", "unsupported_option"}});
}

TEST(NativeGrammar, WhatTheApiMustKnow) {
  const std::string fragment = "!!FP1.0\nDEFINE pi = 3;\nDECLARE a = {1,2};\nDECLARE b = 0.5;\n"
                               "DECLARE c;\nMUL R0, a, pi;\nMOV o[COLR], b;\nEND\n";
  EXPECT_EQ(firstError(check(fragment, nvidiaLanguages())),
            "native_operands"); // a parameter, a constant
  const std::string text = "!!FP1.0\nDEFINE pi = 3;\nDECLARE a = {1,2};\nDECLARE b = 0.5;\n"
                           "DECLARE c;\nMUL R0, a, R1;\nMOV o[COLR], b;\nEND\n";
  const CheckResult named = check(text, nvidiaLanguages());
  ASSERT_TRUE(named.ok()) << named.errorString(text);
  ASSERT_EQ(named.native.named.size(), 3u);
  EXPECT_EQ(named.native.constants, std::vector<std::string>{"pi"});
  ASSERT_NE(named.native.find("b"), nullptr);
  EXPECT_EQ(named.native.find("b")->local, 64 + 1);
  EXPECT_EQ(named.native.find("a")->value, (ir::Vec4{1, 2, 0, 1}));
  EXPECT_EQ(named.native.find("b")->value, (ir::Vec4{0.5f, 0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(named.native.find("c")->value, ir::Vec4{});
  EXPECT_EQ(named.native.find("pi"), nullptr);
  ASSERT_EQ(named.program->parameters.size(), 2u);
  EXPECT_EQ(named.program->parameters[1].index, 64 + 1);

  const CheckResult vertex = check("!!VP1.1\nDP4 o[HPOS].x, v[OPOS], c[7];\nMOV o[COL0], v[3];\n"
                                   "MOV o[TEX0], v[6];\nMOV o[TEX1], c[4];\nEND\n",
                                   nvidiaLanguages());
  ASSERT_TRUE(vertex.ok());
  EXPECT_EQ(vertex.native.attributes, 1u << 0 | 1u << 3 | 1u << 6);
  EXPECT_EQ(vertex.native.rowsRead, (std::vector<std::uint16_t>{4, 7}));
  EXPECT_FALSE(vertex.native.readsAnyRow);
  const CheckResult state =
      check("!!VSP1.0\nARL A0.x, v[0].x;\nMOV c[9], c[A0.x];\nMOV c[3].x, v[0];\nEND\n",
            nvidiaLanguages());
  ASSERT_TRUE(state.ok());
  EXPECT_EQ(state.native.language, ir::NativeLanguage::Vsp1);
  EXPECT_EQ(state.native.rowsWritten, (std::vector<std::uint16_t>{3, 9}));
  EXPECT_TRUE(state.native.readsAnyRow);
}

TEST(NativeGrammar, AnythingMayStandAnywhere) {
  const std::string texts[] = {
      "!!FP1.0\nDEFINE a = {1,2};\nDECLARE b = -1;\nMADC RC.xy, f[TEX0], |b.x|, -R1;\n"
      "TXD R0 (LT.x), R1, R2, R3, TEX1, 2D;\nKIL NE.w;\nMOV o[COLR], a;\nEND\n",
      "!!VP2.0\nOPTION NV_position_invariant;\nARL A0.xy, v[WGHT];\nmain: ADDC R0, c[A0.y-3], "
      "-v[0];\nBRA main (GT.x);\nCAL s;\nRET;\ns: MOV o[TEX0].x, R0;\nEND\n",
      "!!VSP1.0\nARL A0.x, v[0].x;\nMAD c[4].xw, c[A0.x+3], R1, R2;\nEND\n"};
  for (const std::string &text : texts) {
    ASSERT_TRUE(check(text, nvidiaLanguages()).ok())
        << check(text, nvidiaLanguages()).errorString(text);
    testing_support::forEachTokenEdit(text, [](const std::string &edited) {
      const CheckResult result = check(edited, nvidiaLanguages());
      if (result.ok())
        EXPECT_TRUE(ir::validate(*result.program).empty()) << edited;
      else
        EXPECT_GE(result.errorPosition(), 0) << edited;
    });
    for (std::size_t size = 0; size + 1 < text.size(); ++size)
      EXPECT_FALSE(check(text.substr(0, size), nvidiaLanguages()).ok()) << size;
  }
}

} // namespace
} // namespace arbiter::fp
