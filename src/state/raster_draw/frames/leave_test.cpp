// Checks that a context that gains nothing is left alone.
#include "state/context/context.h"
#include "state/raster_draw/frames/leave.h"

#include <gtest/gtest.h>

#include "host/handlers.h"
#include "state/lists/list_compiler.h"
#include "state/raster_draw/context_state.h"
#include "state/testing/real_host.h"

namespace arbiter::state {
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
  RasterContext &context() { return m_host.context(); }
  /// Ends `count` frames with one refused draw each.
  void frames(int count, Fallback reason) {
    for (int i = 0; i < count; ++i) {
      if (context().software)
        context().software->fellBack(reason);
      ++context().counters.frames;
      leaveOrReturn(context(), m_now);
    }
  }

  /// Ends frames in which the rasterizer lacks something and the host draws for its sake.
  void gainless(int count) {
    for (int i = 0; i < count; ++i) {
      if (context().software) {
        context().software->lacked = true;
        context().software->fellBack(Fallback::State);
      }
      frames(1, Fallback::Mixed);
    }
  }
  /// Draws after enough frames, so that the context is looked at again.
  void returns() {
    frames(int(kFramesAlone), Fallback::Mixed);
    engage(context());
    ASSERT_TRUE(context().software);
  }
  std::chrono::steady_clock::time_point m_now{std::chrono::seconds(1)};

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
  engage(context()); // a draw calls this
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
    leaveOrReturn(context()); // no draw in these frames
  EXPECT_TRUE(context().software);
}

TEST_F(Leave, WhoseFramesTheHostDrawsForWhatIsLacked) {
  gainless(kGainlessFrames - 1);
  EXPECT_TRUE(context().software);
  gainless(1);
  EXPECT_FALSE(context().software);
  EXPECT_TRUE(keepsLists(context())) << "the rasterizer's own draws may come";
}

TEST_F(Leave, NotWhereTheRasterizerDrawsOrMayDrawSoon) {
  for (int i = 0; i < 2 * kGainlessFrames; ++i) {
    ++context().software->drawn;
    gainless(1);
  }
  ASSERT_TRUE(context().software);
  context().software->lacked = false;
  frames(2 * kGainlessFrames, Fallback::Mixed);
  ASSERT_TRUE(context().software) << "nothing is lacked";
  for (const Fallback passing : {Fallback::Compiling, Fallback::Shared})
    for (int i = 0; i < 2 * kGainlessFrames; ++i) {
      context().software->fellBack(passing);
      gainless(1);
    }
  EXPECT_TRUE(context().software);
}

TEST_F(Leave, FramesThatGainAgainAreWaitedForAsBefore) {
  gainless(kGainlessFrames);
  returns();
  gainless(kRefusedAgain - 1);
  ASSERT_TRUE(context().software);
  ++context().software->drawn;
  gainless(kGainlessFrames);
  EXPECT_TRUE(context().software);
  gainless(1);
  EXPECT_FALSE(context().software);
}

TEST_F(Leave, FramesOfAnotherTimeAreLookedAtSoon) {
  gainless(kGainlessFrames);
  const auto lasts = [&](int milliseconds, int most) {
    int count = 0;
    for (; context().softwareRefused && count < most; ++count) {
      m_now += std::chrono::milliseconds(milliseconds);
      ++context().counters.frames;
      leaveOrReturn(context(), m_now);
    }
    return count;
  };
  EXPECT_EQ(lasts(10, 500), 500) << "as they were";
  EXPECT_EQ(lasts(20, 500), kOtherFrames) << "behind a title, for one";
  engage(context());
  gainless(kRefusedAgain);
  ASSERT_FALSE(context().software);
  lasts(10, 20);
  EXPECT_EQ(20 + lasts(20, 500), int(2 * kLeastAlone) + 1) << "in vain before";
  engage(context());
  gainless(kRefusedAgain);
  const int since = 500 + kOtherFrames + int(2 * kLeastAlone) + 1 + 2 * kRefusedAgain;
  EXPECT_EQ(lasts(20, 1000), int(kFramesAlone) - since)
      << "as if it had not been looked at between";
}

TEST_F(Leave, ListsThatChangeMeanwhileAreTheHosts) {
  const auto compile = [&] {
    handlers::NewList(wholeOf(context()), 1, GL_COMPILE);
    handlers::Begin(wholeOf(context()), GL_POINTS);
    const bool kept = context().list->keeps();
    handlers::End(wholeOf(context()));
    handlers::EndList(wholeOf(context()));
    return kept;
  };
  EXPECT_TRUE(compile());
  EXPECT_TRUE(compile());
  gainless(kGainlessFrames);
  EXPECT_FALSE(compile());
  EXPECT_FALSE(compile()) << "known to the host alone";
  returns();
  EXPECT_TRUE(compile());
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
} // namespace arbiter::state
