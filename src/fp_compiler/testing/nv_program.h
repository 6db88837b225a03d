#pragma once
#include <gtest/gtest.h>
#include <string>
#include <utility>

#include "fp_compiler/compiler.h"

namespace arbiter::fp::testing {

/// Returns a checked fragment program under NV_fragment_program2, with 8 of each binding.
/// \param statements declarations and instructions, without header, option and END
inline ir::Program nvFragmentProgram(const std::string &statements) {
  CompileOptions options;
  options.policy = LimitPolicy::Report;
  options.limits.textureCoords = options.limits.textureImageUnits = 8;
  options.limits.localParameters = 8;
  options.limits.nvOptions = 2;
  const std::string text = "!!ARBfp1.0\nOPTION NV_fragment_program2;\n" + statements + "\nEND\n";
  CheckResult result = checkFragmentProgram(text, options);
  EXPECT_TRUE(result.ok()) << result.errorString(text);
  return result.ok() ? std::move(*result.program) : ir::Program{};
}

} // namespace arbiter::fp::testing
