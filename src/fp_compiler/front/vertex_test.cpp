// ARBvp1.0: what vertex programs have and fragment programs lack.
#include <gtest/gtest.h>

#include "fp_compiler/front/test_support.h"
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
      EXPECT_EQ(firstError(check(wrapVertex(statement + "r, r;"))), "fragment-only") << statement;
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

} // namespace
} // namespace arbiter::fp
