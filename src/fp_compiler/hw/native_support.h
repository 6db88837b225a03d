#pragma once
#include <gtest/gtest.h>
#include <span>
#include <string>

#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/profile.h"

/// Helpers for the tests of the models: small programs, and what a profile's model reports for
/// them.
namespace arbiter::fp::hw::testing {

inline constexpr std::string_view kHead =
    "!!ARBfp1.0\nTEMP r, s, t, u; PARAM k = {1, 2, 3, 4};\n"
    "PARAM l = {5, 6, 7, 8}; ATTRIB a = fragment.texcoord[0];\n"
    "ATTRIB b = fragment.texcoord[1]; OUTPUT o = result.color;\n";

inline CheckResult checked(std::string_view profile, const std::string &text) {
  CompileOptions options{findBuiltin(profile)->fragment, LimitPolicy::Report};
  CheckResult result = checkFragmentProgram(text, options);
  EXPECT_TRUE(result.ok()) << text << result.errorString(text);
  return result;
}

inline std::string whole(std::string_view body) {
  return std::string(kHead) + std::string(body) + "\nEND";
}

inline NativeReport explained(std::string_view profile, std::string_view body) {
  const std::string text = whole(body);
  const CheckResult result = checked(profile, text);
  return explainNative(result.program.value(), result.counts, findBuiltin(profile)->fragment);
}

struct SlotRow {
  const char *body;
  std::uint32_t alu, tex;
};

inline void expectSlots(std::string_view profile, std::span<const SlotRow> rows) {
  for (const SlotRow &row : rows) {
    const ResourceCounts counts = explained(profile, row.body).counts;
    EXPECT_EQ(counts.aluInstructions, row.alu) << profile << ": " << row.body;
    EXPECT_EQ(counts.texInstructions, row.tex) << profile << ": " << row.body;
    EXPECT_EQ(counts.instructions, row.alu + row.tex) << profile << ": " << row.body;
  }
}

inline const Reason *find(const NativeReport &report, std::string_view text) {
  for (const Reason &reason : report.reasons)
    if (reason.text == text)
      return &reason;
  return nullptr;
}

inline std::string all(const NativeReport &report) {
  std::string text;
  for (const Reason &reason : report.reasons)
    text += std::to_string(reason.amount) + " " + reason.text + "\n";
  return text;
}

} // namespace arbiter::fp::hw::testing
