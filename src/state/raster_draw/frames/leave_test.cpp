// A context that gains nothing is left alone.
#include "state/raster_draw/frames/leave.h"

#include <gtest/gtest.h>

#include "state/raster_draw/context_state.h"
#include "state/testing/real_host.h"

namespace arbiter::state::software {
namespace {

using testing::RealHost;

class Leave : public ::testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(m_host.valid());
    context().offered = context().caps.onProcessor = true;
    engage(context());
    ASSERT_TRUE(context().software);
  }
  Context &context() { return m_host.context(); }
  /// A frame with such a draw, several times.
  void frames(int count, Fallback reason) {
    for (int i = 0; i < count; ++i) {
      if (context().software)
        context().software->fellBack(reason);
      ++context().frames;
      leaveOrReturn(context());
    }
  }

private:
  RealHost m_host;
};

TEST_F(Leave, WhoseDrawsAreAllRefusedForTheirTarget) {
  frames(kRefusedFrames - 1, Fallback::Target);
  EXPECT_TRUE(context().software);
  context().attention = 0;
  frames(1, Fallback::Target);
  EXPECT_FALSE(context().software);
  EXPECT_FALSE(context().softwarePossible || context().softwareListens || context().hostIsBehind);
  EXPECT_NE(context().attention & attention::kProgram, 0u) << "the next draw chooses its way anew";
  EXPECT_FALSE(keepsLists(context()));
  Figures figures;
  figures.add(context());
  EXPECT_EQ(figures.contexts, 1u);
  EXPECT_EQ(figures.fallbacks[std::size_t(Fallback::Target)], std::uint64_t(kRefusedFrames));
}

TEST_F(Leave, IsLookedAtAgainAfterManyFrames) {
  frames(kRefusedFrames + int(kFramesAlone) - 1, Fallback::Target);
  engage(context());
  EXPECT_FALSE(context().software);
  context().attention = 0;
  frames(1, Fallback::Target);
  EXPECT_NE(context().attention & attention::kProgram, 0u);
  engage(context()); // as a draw does
  ASSERT_TRUE(context().software);
  frames(kRefusedAgain, Fallback::Target);
  EXPECT_FALSE(context().software) << "it is known";
  Figures figures;
  figures.add(context());
  EXPECT_EQ(figures.fallbacks[std::size_t(Fallback::Target)],
            std::uint64_t(kRefusedFrames + kRefusedAgain));
}

TEST_F(Leave, NotWhereAnythingElseIsDrawnOrRefused) {
  frames(2 * kRefusedFrames, Fallback::Texture);
  EXPECT_TRUE(context().software);
  for (int i = 0; i < 2 * kRefusedFrames; ++i) {
    ++context().software->drawn;
    frames(1, Fallback::Target);
  }
  EXPECT_TRUE(context().software);
  for (int i = 0; i < 2 * kRefusedFrames; ++i)
    leaveOrReturn(context()); // frames without a draw
  EXPECT_TRUE(context().software);
}

TEST_F(Leave, NotInTheMiddleOfAListOrWhereTheRasterizerIsChosen) {
  context().listMode = GL_COMPILE;
  frames(2 * kRefusedFrames, Fallback::Target);
  EXPECT_TRUE(context().software);
  context().listMode = 0;
  context().software->steady = true;
  frames(2 * kRefusedFrames, Fallback::Target);
  EXPECT_TRUE(context().software);
}

} // namespace
} // namespace arbiter::state::software
