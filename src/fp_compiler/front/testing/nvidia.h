#pragma once
#include <cmath>
#include <gtest/gtest.h>

#include "fp_compiler/front/testing/test_support.h"
#include "fp_compiler/ir/validate.h"

/// Helpers for the tests of NVIDIA's options and languages.
namespace arbiter::fp::testing_support {

inline constexpr std::string_view kF1 = "NV_fragment_program", kF2 = "NV_fragment_program2",
                                  kV2 = "NV_vertex_program2", kV3 = "NV_vertex_program3";

/// Returns generous limits with the options of the first or of the second generation.
inline CompileOptions offering(std::uint32_t nvOptions) {
  CompileOptions options = generous();
  options.limits.nvOptions = nvOptions;
  return options;
}

/// Expects a program's first error, where it has '@', or none if the ID is empty. What loads must
/// be valid.
inline void judgeMarked(std::string program, std::string_view id, const CompileOptions &options) {
  const std::size_t at = program.find('@');
  if (at != std::string::npos)
    program.erase(at, 1);
  const CheckResult result = check(program, options);
  EXPECT_EQ(firstError(result), id) << program << result.errorString(program);
  if (at != std::string::npos) {
    EXPECT_EQ(result.errorPosition(), std::int32_t(at)) << program;
  }
  if (result.ok()) {
    EXPECT_TRUE(ir::validate(*result.program).empty()) << program;
  }
}

/// Expects numbers within a relative error. NaN and infinities are equal to themselves alone.
inline void expectNear(const ir::Vec4 &value, const ir::Vec4 &expected, float relative,
                       const std::string &what) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (std::isnan(expected[i]))
      EXPECT_TRUE(std::isnan(value[i])) << what << " component " << i << ": " << value[i];
    else if (std::isinf(expected[i]))
      EXPECT_EQ(value[i], expected[i]) << what << " component " << i;
    else
      EXPECT_NEAR(value[i], expected[i], relative * (1 + std::fabs(expected[i])))
          << what << " component " << i;
  }
}

} // namespace arbiter::fp::testing_support
