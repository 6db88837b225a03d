// Checks programs that are longer than any card's profile allows. Runs with ARBITER_PROFILE=host.

#include <string>

#include <gtest/gtest.h>

#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

TEST(LongPrograms, AreTheHostsOwnAssembly) {
  FakeHost host;
  host.programLimit = 16384;
  const CurrentContext context(host);
  std::string text = "!!ARBfp1.0\nTEMP t;\nMOV t, fragment.color;\n";
  for (int i = 0; i < 5000; ++i)
    text += "POW t.x, t.y, t.x;\n";
  use(*context, text + "MOV result.color, t;\nEND\n");
  EXPECT_TRUE(draw(*context));
  EXPECT_EQ(drawsBy(*context, Path::HostAssembly), 1u);
  use(*context, "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n");
  EXPECT_TRUE(draw(*context));
  EXPECT_EQ(drawsBy(*context, Path::HostAssembly), 1u);
  EXPECT_EQ(drawsBy(*context, Path::HostGlsl), 1u);
  EXPECT_EQ(host.count("Disable " + std::to_string(kFragment)), 1) << "left enabled on the host";
}

TEST(LongPrograms, OfVerticesAreTooWithAShortFragmentProgramBesideThem) {
  FakeHost host;
  host.programLimit = 16384;
  const CurrentContext context(host);
  std::string text = "!!ARBvp1.0\nTEMP t;\nMOV t, vertex.color;\n";
  for (int i = 0; i < 5000; ++i)
    text += "MAD t, t, vertex.normal, t;\n";
  text += "MOV result.color, t;\nMOV result.position, vertex.position;\nEND\n";
  use(*context, text, kVertex);
  use(*context, "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n");
  EXPECT_TRUE(draw(*context));
  EXPECT_EQ(drawsBy(*context, Path::HostAssembly), 1u);
  EXPECT_EQ(host.count("Enable " + std::to_string(kVertex)), 1);
  EXPECT_EQ(host.count("Enable " + std::to_string(kFragment)), 1)
      << "one stage would be fixed function's";
  use(*context, "!!ARBvp1.0\nMOV result.position, vertex.position;\nEND\n", kVertex);
  EXPECT_TRUE(draw(*context));
  EXPECT_EQ(drawsBy(*context, Path::HostGlsl), 1u);
  EXPECT_TRUE(host.targets[kVertex]) << "short ones of vertices are the host's as well";
  EXPECT_FALSE(host.targets[kFragment]) << "left enabled on the host";
}

} // namespace
} // namespace arbiter::state
