// Tests which texts load under NVIDIA's options, and where the others have their error. NVIDIA's
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
using testing_support::kF1;
using testing_support::kF2;
using testing_support::kV2;
using testing_support::kV3;
using testing_support::offering;

CompileOptions nvidiaOptions(std::uint32_t options) {
  CompileOptions result = offering(options);
  result.limits.clipPlanes = 8;
  return result;
}

std::string text(std::string_view option, std::string_view statements) {
  const bool vertex = option.find("vertex") != std::string_view::npos;
  return std::string(vertex ? "!!ARBvp1.0\n" : "!!ARBfp1.0\n") + "OPTION " + std::string(option) +
         ";\n" + std::string(statements) + "\nEND\n";
}

struct OptionRow {
  std::string_view option;
  std::string statements;
  std::string_view error; ///< the diagnostic's ID; empty: it loads. '@' in the text is where
};

void judge(const std::vector<OptionRow> &rows) {
  for (const OptionRow &row : rows) {
    std::string program = text(row.option, row.statements);
    judgeMarked(program, row.error, nvidiaOptions(2));
  }
}

TEST(NvGrammar, AnOptionLoadsWhereTheProfileHasIt) {
  for (const std::string_view option : {kF1, kF2, kV2, kV3}) {
    const bool second = option == kF2 || option == kV3;
    const std::string program =
        text(option, option == kF1 || option == kF2 ? "TEMP a; MOVC a (GT.x), fragment.color;"
                                                    : "TEMP a; MOVC a (GT.x), vertex.color;");
    for (std::uint32_t offered = 0; offered <= 2; ++offered) {
      const CheckResult result = check(program, nvidiaOptions(offered));
      const bool loads = offered >= (second ? 2u : 1u);
      EXPECT_EQ(firstError(result), loads ? "" : "unsupported_option") << program << offered;
      if (!loads) {
        EXPECT_EQ(result.errorPosition(), 18);
      }
    }
  }
}

TEST(NvGrammar, ThereAreNoMoreLabelsThanNumbersForThem) {
  std::string many = "MOV result.position, 0.0;\n";
  for (int i = 0; i < 65535; ++i)
    many += "L" + std::to_string(i) + ":";
  EXPECT_EQ(firstError(check(text(kV2, many), nvidiaOptions(2))), "");
  EXPECT_EQ(firstError(check(text(kV2, many + "M:"), nvidiaOptions(2))), "flow_control");
}

TEST(NvGrammar, OneOptionOfNvidiaOrTheSameTwice) {
  judge({{kF1, "OPTION NV_fragment_program; MOV result.color, 0.0;", ""},
         {kF1, "OPTION @NV_fragment_program2; MOV result.color, 0.0;", "conflicting_nv_options"},
         {kF2, "OPTION ARB_fog_linear; OPTION ARB_precision_hint_fastest; MOV result.color, 0.0;",
          ""},
         {kV3, "OPTION @NV_vertex_program2; MOV result.position, 0.0;", "conflicting_nv_options"},
         {kV2, "OPTION @NV_fragment_program; MOV result.position, 0.0;", "unsupported_option"}});
}

TEST(NvGrammar, ShadowTargetsOfVertexPrograms) {
  const std::string sample =
      "TEMP r; TXL r, vertex.color, texture[0], SHADOW2D; MOV result.position, r;";
  judge({{kV3, "OPTION ARB_fragment_program_shadow; " + sample, ""},
         {kV3, "TEMP r; TXL r, vertex.color, texture[0], @SHADOW2D;", "shadow_target"},
         {kV2, "OPTION ARB_fragment_program_shadow; MOV result.position, 0.0;", ""}});
  const std::string_view alone = "!!ARBvp1.0\nOPTION ARB_fragment_program_shadow;\n"
                                 "MOV result.position, vertex.position;\nEND";
  EXPECT_EQ(firstError(check(alone, nvidiaOptions(2))), "");
  EXPECT_EQ(firstError(check(alone, nvidiaOptions(1))), "unsupported_option")
      << "no vertex program samples there";
}

TEST(NvGrammar, SuffixesOfNames) {
  const auto loads = [](std::string_view option, const std::string &statement) {
    return OptionRow{option, "TEMP a; " + statement + ";", ""};
  };
  const auto fails = [](std::string_view option, const std::string &statement) {
    return OptionRow{option, "TEMP a; @" + statement + ";", "unknown_instruction"};
  };
  judge({loads(kF1, "ADDRC_SAT a, a, a"), loads(kF1, "ADDXC a, a, a"),
         loads(kF1, "CMPH a, a, a, a"), loads(kF1, "SINC a, a.x"), loads(kF1, "DDXHC_SAT a, a"),
         loads(kF1, "TEXC_SAT a, a, texture[0], 2D"), loads(kF1, "UP2H_SAT a, a.x"),
         loads(kF2, "ADD_SSAT a, a, a"), loads(kF2, "DP2ARC a, a, a, a"),
         loads(kF2, "DP2X a, a, a"), loads(kF2, "NRMHC a, a"), loads(kV3, "MOVC1_SAT a, a"),
         loads(kV3, "MOVC0 a, a"), loads(kV2, "MOVC a, a")});
  judge({fails(kF1, "ADD_SSAT a, a, a"), fails(kF1, "ADDC0 a, a, a"), fails(kF1, "ADDCR a, a, a"),
         fails(kF1, "ADD_SATC a, a, a"), fails(kF1, "COSX a, a.x"), fails(kF1, "DDXX a, a"),
         fails(kF1, "PK2HC a, a"), fails(kF1, "PK2H_SAT a, a"), fails(kF1, "KILC a"),
         fails(kF1, "DP2A a, a, a, a"), fails(kF2, "NRMX a, a"), fails(kF2, "add a, a, a"),
         fails(kV2, "MOVC0 a, a"), fails(kV3, "MOV_SSAT a, a"), fails(kV3, "MOVH a, a")});
  judge({{kF1, "TEMP a; @TEXR a, a, texture[0], 2D;", "unknown_instruction"},
         {kV2, "TEMP a; @MOV_SAT a, a;", "unknown_instruction"}});
}

TEST(NvGrammar, NamesAreReservedUnderTheirOptionOnly) {
  judge({{kF1, "TEMP @DDX;", "reserved_name"},
         {kF1, "TEMP @ADDR;", "reserved_name"},
         {kF1, "TEMP IF, DP2, NRM, SHORT, EQ, CC, RC, HC; MOV SHORT, EQ;", ""},
         {kF2, "TEMP @IF;", "reserved_name"},
         {kF2, "TEMP @DP2;", "reserved_name"},
         {kV2, "TEMP @SSGC;", "reserved_name"},
         {kV2, "TEMP TEX, DDX, IF; MOV TEX, DDX;", ""}});
  const std::string plain = "!!ARBfp1.0\nTEMP DDX, ADDR, IF, SHORT; MOV DDX, IF;\nEND\n";
  EXPECT_TRUE(check(plain, nvidiaOptions(2)).ok());
}

TEST(NvGrammar, ConditionsStandBehindTheMask) {
  judge({{kF1, "TEMP a; MOV a.xy (EQ.wzyx), 1.0;", ""},
         {kF1, "TEMP a; MOV a (GE.r), 1.0;", ""},
         {kF1, "TEMP a; MOV a (NE.@xy), 1.0;", "bad_swizzle"},
         {kF1, "TEMP a; MOV a (EQ)@.x, 1.0;", "syntax"},
         {kF1, "TEMP a; MOV a (@eq), 1.0;", "syntax"},
         {kF1, "TEMP a; MOV a (EQ@, 1.0;", "syntax"},
         {kF1, "TEMP a; MOV @CC, a;", "undeclared_name"},
         {kV2, "TEMP a; MOV a (@EQ1.x), 1.0;", "syntax"},
         {kV3, "TEMP a; MOV a (EQ1.x), 1.0;", ""}});
}

TEST(NvGrammar, KillTakesATestWithoutParentheses) {
  judge({{kF1, "KIL LT.x;", ""},
         {kF1, "TEMP EQ; KIL EQ;", ""},
         {kF1, "TEMP a; KIL -|a.x|;", ""},
         {kF1, "KIL @(LT.x);", "syntax"}});
}

/// Operands of 0 and 1 read no register, and the text may declare none.
TEST(NvGrammar, ProgramsWithoutTemporaries) {
  judge({{kF1, "KIL TR;", ""},
         {kF2, "KIL FL;", ""},
         {kF2, "IF TR; KIL TR; ENDIF;", ""},
         {kF2, "STR result.color, fragment.color, fragment.color;", ""},
         {kF2, "SFL result.color, 1.0, 2.0;", ""},
         {kF2, "REP 2; BRK (TR); ENDREP;", ""},
         {kF2, "KIL TR; RET; MOV result.color, 1.0;", ""},
         {kF2, "RET (FL); sub: RET;", ""},
         {kV2, "STR result.position, vertex.position, vertex.position;", ""},
         {kV3, "BRA end (TR); MOV result.color, 1.0; end:", ""}});
  const std::string natives[] = {"!!FP1.0\nKIL TR;\nMOV o[COLR], f[WPOS];\nEND",
                                 "!!FP1.0\nSTR o[COLR], f[WPOS], f[WPOS];\nEND",
                                 "!!VP2.0\nSFL o[HPOS], v[OPOS], v[OPOS];\nEND"};
  for (const std::string &native : natives) {
    const CheckResult result = check(native, nvidiaOptions(2));
    ASSERT_TRUE(result.ok()) << result.errorString(native);
    EXPECT_TRUE(ir::validate(*result.program).empty()) << native;
  }
}

TEST(NvGrammar, OperandsWithinBars) {
  judge({{kF1, "TEMP a; MOV a, -|-a.wzyx|;", ""},
         {kF1, "TEMP a; RCP a, |a.x|;", ""},
         {kF1, "TEMP a; MOV a, |program.local[0]|;", ""},
         {kF1, "TEMP a; SWZ a, |a|, x, -y, 0, 1;", ""},
         {kF1, "TEMP a; MOV a, |a|@.x;", "syntax"},
         {kF1, "TEMP a; MOV a, |@|a||;", "syntax"},
         {kF1, "TEMP a; MOV a, -@-a;", "syntax"}});
}

TEST(NvGrammar, NumbersTakeNoSuffix) {
  judge({{kF1, "TEMP a; POW a, 2.0, 3.0;", ""},
         {kF1, "TEMP a; RCP a, 2.0@.x;", "syntax"},
         {kF1, "TEMP a; RCP a, {1, 2, 3, 4}.y;", ""},
         {kF1, "TEMP a; RCP a, a@;", "scalar_suffix"}});
}

TEST(NvGrammar, Sizes) {
  judge({{kF1, "SHORT TEMP a; LONG TEMP b; SHORT OUTPUT c = result.color; MUL c, a, b;", ""},
         {kF1, "@SHORT ATTRIB a = fragment.color;", "unknown_instruction"},
         {kF1, "@SHORT LONG TEMP a;", "unknown_instruction"},
         {kF1,
          "SHORT OUTPUT a = result.color; LONG OUTPUT b = result.color; MOV a, 1.0; MOV @b, 1.0;",
          "result_size"},
         {kF1, "SHORT OUTPUT a = result.color; MOV a, 1.0; MOV @result.color, 1.0;", "result_size"},
         {kV2, "@SHORT TEMP a;", "unknown_instruction"}});
}

TEST(NvGrammar, BlocksFit) {
  judge({{kF2, "IF GT.x; MOV result.color, 1.0; ELSE; MOV result.color, 0.0; ENDIF;", ""},
         {kF2, "LOOP {4, 0, 1}; REP program.local[0].y; BRK (EQ.x); ENDREP; ENDLOOP;", ""},
         {kF2, "REP -|program.local[0]|; ENDREP;", ""},
         {kF2, "TEMP a; REP @a; ENDREP;", "flow_control"},
         {kF2, "IF @(TR); ENDIF;", "syntax"},
         {kF2, "IF TR; ELSE; @ELSE; ENDIF;", "flow_control"},
         {kF2, "IF TR;", "flow_control"},
         {kF2, "IF TR; REP 2; @ENDIF; ENDREP;", "flow_control"},
         {kF2, "LOOP {1,0,0}; @ENDREP;", "flow_control"},
         {kF2, "IF TR; @BRK; ENDIF;", "flow_control"},
         {kF2, "REP 2; BRK @EQ.x; ENDREP;", "syntax"},
         {kF1, "@IF TR; ENDIF;", "unknown_instruction"}});
}

TEST(NvGrammar, Labels) {
  judge({{kF2, "CAL a (GT.x); RET; a: b: MOV result.color, 1.0; RET (TR);", ""},
         {kF2, "TEMP a; CAL a; RET; a: MOV a, 1.0;", ""}, // NVIDIA's driver crashes
         {kF2, "CAL @a;", "undeclared_name"},
         {kF2, "a: @a: RET;", "redeclared_name"},
         {kF2, "IF TR; @a: ENDIF; CAL a;", "flow_control"},
         {kF2, "CAL a; a: @CAL a;", "flow_control"},
         {kF2, "@BRA a; a: RET;", "unknown_instruction"},
         {kV2, "BRA a (EQ.x); MOV result.position, 1.0; a: BRA b; b: RET;", ""},
         {kV2, "a: BRA a (NE.x);", ""},
         {kV2, "BRA a @EQ.x; a: RET;", "syntax"}});
}

TEST(NvGrammar, WhatAnAddressRegisterIndexes) {
  judge({{kF2, "LOOP {3,0,1}; MOV result.color, fragment.texcoord[A0.x + 3]; ENDLOOP;", ""},
         {kF2, "MOV result.color, fragment.texcoord[A0.x + @10];", "relative_offset"},
         {kF2, "MOV result.color, fragment.texcoord[A0.x @- 1];", "syntax"},
         {kF2, "ATTRIB a = fragment.texcoord[@A0.x];", "relative_addressing"},
         {kV2,
          "ADDRESS A; PARAM c[] = {1, 2}; ARL A.yw, vertex.color; MOV result.position, c[A.w + 1];",
          ""},
         {kV2, "ADDRESS A, B; ARL A, vertex.color; ARA B.xy, A;", ""},
         {kV2, "ADDRESS A, B; ARA B.xy, A@.x;", "syntax"},
         {kV2, "ADDRESS A; MOV result.position, vertex.attrib[@A.x];", "relative_addressing"},
         {kV3, "ADDRESS A; ARL A, vertex.color; MOV result.position, vertex.attrib[A.y + 1];", ""},
         {kV3, "ADDRESS A; ARL A, vertex.color; MOV result.texcoord[A.y], vertex.texcoord[A.x];",
          ""}});
}

TEST(NvGrammar, TheStackOfAddresses) {
  judge({{kV3, "ADDRESS A; PUSHA A; POPA A; POPA A.xyzw (TR);", ""},
         {kV3, "ADDRESS A; PUSHA A; POPA @A.x;", "bad_mask"},
         {kV3, "ADDRESS A; PUSHA A; POPA A @(EQ.x);", "flow_control"},
         {kV3, "ADDRESS A; PUSHA A@.x;", "syntax"},
         {kV2, "ADDRESS A; @PUSHA A;", "unknown_instruction"}});
}

TEST(NvGrammar, EveryOpcodeOfTheOptionsAndNoOther) {
  const auto operands = [](const ir::OpInfo &op, std::string statement) {
    for (int i = 0; i < op.operandCount(); ++i)
      statement += op.shapes[i] == 'S' ? ", a.x" : ", a";
    return statement + (op.has(ir::Texture) ? ", texture[0], 2D;" : ";");
  };
  for (const std::string_view option : {kF1, kF2, kV2, kV3}) {
    const bool vertex = option == kV2 || option == kV3;
    const bool second = option == kF2 || option == kV3;
    for (int i = ir::kOpcodeCount; i < ir::kOpcodeRowCount; ++i) {
      const ir::OpInfo &op = info(ir::Opcode(i));
      if (op.has(ir::Flow) || ir::Opcode(i) == ir::Opcode::Ara || ir::Opcode(i) == ir::Opcode::Arr)
        continue; // above
      const std::uint32_t first = vertex ? ir::OfV2 : ir::OfF1,
                          later = vertex ? ir::OfV3 : ir::OfF2;
      const bool has = (op.traits & (second ? first | later : first)) != 0;
      const std::string program =
          text(option, "TEMP a; " + operands(op, std::string(op.mnemonic) + " a.xyz"));
      EXPECT_EQ(check(program, nvidiaOptions(2)).ok(), has) << program;
    }
  }
}

TEST(NvGrammar, WeightIsGenericAttributeOne) {
  judge({{kV2, "MOV result.position, vertex.weight;", ""},
         {kV3, "MOV result.position, vertex.weight[0];", ""},
         {kV2, "ATTRIB w = vertex.weight; ADD result.position, w, vertex.attrib[1];", ""},
         {kV2, "MOV result.position, vertex.weight[@1];", "attribute_index"},
         {kV2, "MOV result.position, vertex.@matrixindex[0];", "attribute_extension"}});
  // The same holds without an option, if the profile has them.
  const std::string plain = "!!ARBvp1.0\nMOV result.position, vertex.weight;\nEND\n";
  const CheckResult loads = check(plain, nvidiaOptions(1));
  ASSERT_TRUE(loads.ok());
  ASSERT_EQ(loads.program->attributes.size(), 1u);
  EXPECT_EQ(loads.program->attributes[0].kind, ir::AttributeKind::Generic);
  EXPECT_EQ(loads.program->attributes[0].index, 1);
  EXPECT_EQ(loads.diagnostics.size(), 1u) << "a warning";
  EXPECT_EQ(firstError(check(plain, nvidiaOptions(0))), "attribute_extension");
}

} // namespace
} // namespace arbiter::fp
