/// Tests that the refusal of a text in NVIDIA's languages names the profiles that accept it.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"

namespace arbiter::fp {
namespace {

using ir::Language;
using Names = std::vector<std::string_view>;

struct Text {
  Language language;
  const char *text;
  Names takers; ///< the profiles
  const char *hint;
};

constexpr const char *kFromNv30 = "the profiles from nv30 to nv40 and host have it";

const Text kTextsAndTakers[] = {
    {Language::ArbFragment,
     "!!FP1.0\nMOV o[COLR], f[COL0];\nEND",
     {"nv30", "nv35", "nv40", "host"},
     kFromNv30},
    {Language::ArbVertex,
     "!!VP1.0\nMOV o[HPOS], v[OPOS];\nEND",
     {"nv10", "nv20", "nv25", "nv30", "nv35", "nv40", "i915", "host"},
     "the profiles from nv10 to nv40, i915 and host have it"},
    {Language::ArbVertex,
     "!!VP1.1\nMOV o[HPOS], v[OPOS];\nEND",
     {"nv10", "nv20", "nv25", "nv30", "nv35", "nv40", "i915", "host"},
     "the profiles from nv10 to nv40, i915 and host have it"},
    {Language::ArbVertex,
     "!!VP2.0\nMOV o[HPOS], v[OPOS];\nEND",
     {"nv30", "nv35", "nv40", "host"},
     kFromNv30},
    {Language::ArbVertex,
     "!!VSP1.0\nMOV c[90], v[0];\nEND",
     {"nv10", "nv20", "nv25", "nv30", "nv35", "nv40", "i915", "host"},
     "the profiles from nv10 to nv40, i915 and host have it"},
    {Language::ArbFragment,
     "!!ARBfp1.0\nOPTION NV_fragment_program;\nMOV result.color, fragment.color;\nEND",
     {"nv30", "nv35", "nv40", "host"},
     kFromNv30},
    {Language::ArbFragment,
     "!!ARBfp1.0\nOPTION NV_fragment_program2;\nMOV result.color, fragment.color;\nEND",
     {"nv40", "host"},
     "the profiles nv40 and host have it"},
    {Language::ArbVertex,
     "!!ARBvp1.0\nOPTION NV_vertex_program2;\nMOV result.position, vertex.position;\nEND",
     {"nv30", "nv35", "nv40", "host"},
     kFromNv30},
    {Language::ArbVertex,
     "!!ARBvp1.0\nOPTION NV_vertex_program3;\nMOV result.position, vertex.position;\nEND",
     {"nv40", "host"},
     "the profiles nv40 and host have it"},
    {Language::ArbFragment, "!!FCP1.0\nEND", {}, "which no profile has"},
    {Language::ArbFragment, "!!ARBfp1.0\nOPTION NV_gpu_program4;\nEND", {}, "no profile has it"},
};

TEST(NvHints, NameTheProfilesThatTakeTheText) {
  for (const Text &row : kTextsAndTakers)
    for (const std::string_view name : hw::builtinNames()) {
      const hw::Profile &profile = *hw::findBuiltin(name);
      CompileOptions options;
      options.limits = row.language == Language::ArbVertex ? profile.vertex : profile.fragment;
      const CheckResult result = checkProgram(row.language, row.text, options);
      const bool takes = std::find(row.takers.begin(), row.takers.end(), name) != row.takers.end();
      EXPECT_EQ(result.ok(), takes) << name << "\n" << result.errorString(row.text) << row.text;
      // A profile with other languages of NVIDIA reports a header that belongs to none of them.
      const bool none = row.takers.empty() && profile.vertex.nvVertexProgram != 0;
      if (!result.ok() && !none) {
        EXPECT_NE(result.errorString(row.text).find(row.hint), std::string::npos)
            << name << ": " << result.errorString(row.text);
      }
    }
}

TEST(NvHints, WordsOfTheOptionsSayHowTheyAreHad) {
  constexpr std::string_view kText = "!!ARBfp1.0\nTEMP r;\nDDX r, fragment.color;\nEND";
  const auto said = [&](std::string_view profile) {
    return checkFragmentProgram(kText, {hw::findBuiltin(profile)->fragment}).errorString(kText);
  };
  EXPECT_NE(said("r300").find("the profiles from nv30 to nv40 have them, and host"),
            std::string::npos)
      << said("r300");
  EXPECT_NE(said("nv30").find("an OPTION directly after the header"), std::string::npos)
      << said("nv30");
  constexpr std::string_view kLater = "!!ARBfp1.0\nTEMP r;\nTXL r, r, texture[0], 2D;\nEND";
  const std::string later =
      checkFragmentProgram(kLater, {hw::findBuiltin("nv30")->fragment}).errorString(kLater);
  EXPECT_NE(later.find("the profiles nv40 and host have them"), std::string::npos) << later;
}

} // namespace
} // namespace arbiter::fp
