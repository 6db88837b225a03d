// Checks the numerics that programs are compiled with, for every way in which programs are made.
// Runs with ARBITER_NUMERICS=fp24.
#include <gtest/gtest.h>

#include "state/identity/active_profile.h"
#include "state/lifecycle/lifecycle.h"
#include "state/objects/linked_program.h"
#include "state/programs/program_cache.h"
#include "state/programs/variants/clipped_variant.h"
#include "state/statistics/statistics.h"
#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

constexpr std::string_view kFragmentText =
    "!!ARBfp1.0\nMUL result.color, fragment.texcoord[0], program.local[0];\nEND";
constexpr std::string_view kTexcoordText =
    "!!ARBvp1.0\nMUL result.color, vertex.texcoord[0], program.local[0];\n"
    "MOV result.position, vertex.position;\nEND";

void addExtensions(FakeHost &host) {
  for (const char *const name : {"GL_EXT_gpu_shader4", "GL_ARB_shader_bit_encoding"})
    host.extensions.emplace_back(name);
}

bool has(const CompiledProgram &compiled, std::string_view part) {
  return compiled.glsl.text.find(part) != std::string::npos;
}

TEST(Numerics, TheEnvironmentAsks) { EXPECT_EQ(activeNumerics(), fp::Numerics::Fp24); }

TEST(Numerics, AHostWithoutTheExtensionsIsGivenLegacy) {
  FakeHost plain;
  {
    const CurrentContext context(plain);
    EXPECT_EQ(context->numerics, fp::Numerics::Legacy);
    use(*context, kFragmentText);
    ASSERT_TRUE(draw(*context));
    EXPECT_TRUE(has(*context->effective.linkedProgram->fragment.compiled, "arb_mul("));
    EXPECT_FALSE(has(*context->effective.linkedProgram->fragment.compiled, "arb_round("));
  }
  FakeHost able;
  addExtensions(able);
  const CurrentContext context(able);
  EXPECT_EQ(context->numerics, fp::Numerics::Fp24);
}

TEST(Numerics, EveryStageAndFormFollows) {
  FakeHost host;
  addExtensions(host);
  const CurrentContext context(host);
  use(*context, kFragmentText);
  use(*context, kTexcoordText, kVertex);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(has(*context->effective.linkedProgram->fragment.compiled, "arb_round("));
  EXPECT_TRUE(has(*context->effective.linkedProgram->vertex.compiled, "arb_mul("));
  EXPECT_FALSE(has(*context->effective.linkedProgram->vertex.compiled, "arb_round("));
  handlers::Enable(*context, GL_CLIP_PLANE0);
  host.enabled.insert(GL_CLIP_PLANE0);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(has(*context->effective.linkedProgram->vertex.compiled, "gl_ClipVertex"));
  EXPECT_TRUE(has(*context->effective.linkedProgram->vertex.compiled, "arb_mul("));
}

TEST(Numerics, AnAtiShaderFollows) {
  FakeHost host;
  addExtensions(host);
  const CurrentContext context(host);
  ASSERT_TRUE(context->row(Target::AtiText).offered);
  use(*context,
      "!!ATIfs1.0\nStartConstants;\nEndConstants;\nStartOutputPass;\nSampleMap r0, t0.str;\n"
      "MUL r0, r0, color0;\nEndPass;\n",
      GL_TEXT_FRAGMENT_SHADER_ATI);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(has(*context->effective.linkedProgram->fragment.compiled, "arb_round("))
      << context->effective.linkedProgram->fragment.compiled->glsl.text;
}

TEST(Numerics, TheStatisticsSayBoth) {
  FakeHost host;
  const CurrentContext context(host);
  EXPECT_NE(statisticsJson().find("\"numerics\""), std::string::npos);
  EXPECT_NE(statisticsJson().find("fp24"), std::string::npos);
}

} // namespace
} // namespace arbiter::state
