#include "state/raster_draw/frames/back_off.h"

#include <gtest/gtest.h>

namespace arbiter::state {
namespace {

using Clock = std::chrono::steady_clock;

/// Simulates an application's frames, whose time depends on who draws.
class Frames {
public:
  explicit Frames(BackOff &backOff) : m_backOff(backOff) {}
  void run(int count, bool moved, int softwareMilliseconds, int hostMilliseconds,
           bool plain = false) {
    for (int i = 0; i < count; ++i) {
      const bool software = m_backOff.engaged();
      m_onHost += !software;
      m_onRasterizer += software;
      m_now += std::chrono::milliseconds(software ? softwareMilliseconds : hostMilliseconds);
      // The host moves no images while it draws.
      m_backOff.frameEnded({moved && software, plain && software}, m_now);
    }
  }
  [[nodiscard]] int onHost() const { return m_onHost; }
  [[nodiscard]] int onRasterizer() const { return m_onRasterizer; }

private:
  BackOff &m_backOff;
  Clock::time_point m_now = Clock::time_point(std::chrono::seconds(1));
  int m_onHost = 0, m_onRasterizer = 0;
};

TEST(BackOff, FramesThatMoveNothingAreNeverTried) {
  BackOff backOff;
  Frames frames(backOff);
  frames.run(5000, false, 10, 1);
  EXPECT_EQ(frames.onHost(), 0);
  EXPECT_EQ(backOff.statistics().trials, 0u);
}

TEST(BackOff, TheHostIsKeptWhereItIsFaster) {
  BackOff backOff;
  Frames frames(backOff);
  frames.run(200, true, 10, 4);
  EXPECT_FALSE(backOff.engaged());
  EXPECT_EQ(backOff.statistics().trials, 1u);
  EXPECT_EQ(backOff.statistics().lastSoftwareMilliseconds, 10.0);
  EXPECT_EQ(backOff.statistics().lastHostMilliseconds, 4.0);
  EXPECT_GT(frames.onHost(), 150);
  EXPECT_EQ(backOff.statistics().framesBackedOff, std::uint64_t(frames.onHost()));
}

TEST(BackOff, TheRasterizerIsKeptWhereItIsFaster) {
  BackOff backOff;
  Frames frames(backOff);
  frames.run(900, true, 4, 10);
  EXPECT_TRUE(backOff.engaged());
  EXPECT_EQ(backOff.statistics().trials, 1u) << "tried again at once";
  EXPECT_LT(frames.onHost(), 10);
}

TEST(BackOff, AnApplicationThatChangesIsTriedAgain) {
  BackOff backOff;
  Frames frames(backOff);
  frames.run(200, true, 10, 4);
  ASSERT_FALSE(backOff.engaged());
  frames.run(1200, true, 2, 4);
  EXPECT_TRUE(backOff.engaged());
  EXPECT_EQ(backOff.statistics().trials, 2u);
}

/// A title that the host draws faster is followed by the application's real frames.
TEST(BackOff, FramesOfAnotherTimeAreTriedSoon) {
  BackOff backOff;
  Frames frames(backOff);
  frames.run(60, true, 3, 2);
  ASSERT_FALSE(backOff.engaged());
  frames.run(100, true, 20, 40);
  EXPECT_TRUE(backOff.engaged());
  EXPECT_EQ(backOff.statistics().trials, 2u);
  frames.run(100, true, 50, 40); // and back again
  EXPECT_FALSE(backOff.engaged());
}

/// If two kinds of frames alternate, at most a tenth of them is drawn by the slower side.
TEST(BackOff, FramesThatAlwaysChangeAreNotTriedForEver) {
  BackOff backOff;
  Frames frames(backOff);
  for (int i = 0; i < 250; ++i) {
    frames.run(20, true, 2, 4);
    frames.run(20, true, 20, 40);
  }
  EXPECT_LT(frames.onHost(), 1000);
  EXPECT_LT(backOff.statistics().trials, 60u);
}

TEST(BackOff, OneFrameThatMovesIsNoDoubt) {
  BackOff backOff;
  Frames frames(backOff);
  for (int i = 0; i < 100; ++i) {
    frames.run(7, true, 10, 1);
    frames.run(1, false, 10, 1);
  }
  EXPECT_EQ(frames.onHost(), 0);
}

TEST(BackOff, PlainFramesAreTriedThoughTheyMoveNothing) {
  BackOff backOff;
  Frames frames(backOff);
  frames.run(500, false, 10, 7, true);
  EXPECT_FALSE(backOff.engaged());
  EXPECT_EQ(backOff.statistics().trials, 1u);
}

TEST(BackOff, PlainFramesThatAreEquallyFastAreTheRasterizers) {
  BackOff backOff;
  Frames frames(backOff);
  frames.run(500, false, 16, 16, true);
  EXPECT_TRUE(backOff.engaged());
  EXPECT_EQ(backOff.statistics().trials, 1u);
}

TEST(BackOff, MovingFramesThatAreEquallyFastAreTheHosts) {
  BackOff backOff;
  Frames frames(backOff);
  frames.run(200, true, 50, 51);
  EXPECT_FALSE(backOff.engaged());
  BackOff faster;
  Frames others(faster);
  others.run(200, true, 50, 56);
  EXPECT_TRUE(faster.engaged());
}

TEST(BackOff, FramesThatMoveNothingAnyMoreAreTriedAsSuch) {
  BackOff backOff;
  Frames frames(backOff);
  frames.run(200, true, 50, 51);
  ASSERT_FALSE(backOff.engaged());
  frames.run(1100, false, 50, 51, true);
  EXPECT_TRUE(backOff.engaged());
  EXPECT_EQ(backOff.statistics().trials, 2u);
}

TEST(BackOff, MovingFramesAreTheHostsAgainAfterAnotherTrial) {
  BackOff backOff;
  Frames frames(backOff);
  frames.run(3000, true, 50, 51);
  EXPECT_FALSE(backOff.engaged());
  EXPECT_GE(backOff.statistics().trials, 3u);
}

TEST(BackOff, TrialsThatTheRasterizerWinsClearlyBecomeRare) {
  BackOff backOff;
  Frames frames(backOff);
  frames.run(1'000'000, false, 4, 10, true);
  EXPECT_TRUE(backOff.engaged());
  EXPECT_LT(backOff.statistics().trials, 25u);
  EXPECT_GT(backOff.statistics().trials, 10u);
}

/// Slow frames are visible, so few of them suffice if each says the same.
TEST(BackOff, TrialsThatAreClearTakeFewFrames) {
  BackOff slow;
  Frames frames(slow);
  frames.run(500, true, 40, 10);
  EXPECT_FALSE(slow.engaged());
  EXPECT_LT(frames.onRasterizer(), 23) << "doubt 9, its frames 9, confirmed by 4";
  BackOff close;
  Frames others(close);
  others.run(500, true, 11, 10);
  EXPECT_FALSE(close.engaged());
  EXPECT_GT(others.onRasterizer(), 23);
  BackOff fast;
  Frames faster(fast);
  faster.run(500, true, 10, 40);
  EXPECT_TRUE(fast.engaged());
  EXPECT_LT(faster.onHost(), 5);
}

/// A clearly slower rasterizer is tried again ever more rarely, each time for a moment.
TEST(BackOff, LooksAtASlowRasterizerBecomeRareAndShort) {
  BackOff backOff;
  Frames frames(backOff);
  frames.run(500, true, 40, 10);
  const int before = frames.onRasterizer();
  frames.run(100'000, true, 40, 10);
  EXPECT_FALSE(backOff.engaged());
  EXPECT_GT(frames.onRasterizer(), before + 20);
  EXPECT_LT(frames.onRasterizer(), before + 50);
  frames.run(20'000, true, 5, 10); // finds that the rasterizer has become faster
  EXPECT_TRUE(backOff.engaged());
}

/// One slow frame in a trial, as when code is compiled for it, must not decide.
TEST(BackOff, ASlowFrameOfALookIsOutvoted) {
  BackOff backOff;
  Frames frames(backOff);
  frames.run(500, true, 40, 10);
  ASSERT_FALSE(backOff.engaged());
  while (!backOff.engaged())
    frames.run(1, true, 5, 10);
  frames.run(2, true, 90, 10);
  frames.run(40, true, 5, 10);
  EXPECT_TRUE(backOff.engaged());
  EXPECT_EQ(backOff.statistics().lastSoftwareMilliseconds, 5.0);
}

TEST(BackOff, FramesOfALookAreNeverTheHostsToTry) {
  BackOff backOff;
  Clock::time_point now(std::chrono::seconds(1));
  const auto frame = [&](bool keeps) {
    now += std::chrono::milliseconds(backOff.engaged() ? 10 : 1);
    backOff.frameEnded({false, backOff.engaged(), keeps}, now);
  };
  for (int i = 0; i < 3000; ++i) {
    frame(true);
    ASSERT_TRUE(backOff.engaged()) << i;
  }
  EXPECT_EQ(backOff.statistics().trials, 0u);
  // A trial ends when the rasterizer first draws a look.
  while (backOff.engaged())
    frame(false);
  EXPECT_FALSE(backOff.followsHost());
  while (!backOff.engaged())
    frame(false);
  frame(true);
  for (int i = 0; i < 100; ++i) {
    frame(true);
    ASSERT_TRUE(backOff.engaged()) << i;
  }
}

TEST(BackOff, ATrialOfTheHostsFramesFollowsIt) {
  BackOff backOff;
  Frames frames(backOff);
  EXPECT_FALSE(backOff.followsHost());
  frames.run(200, true, 10, 4);
  ASSERT_FALSE(backOff.engaged());
  while (!backOff.engaged())
    frames.run(1, true, 10, 4);
  EXPECT_TRUE(backOff.followsHost());
}

/// Two kinds of frames alternate; a median would be one of them.
TEST(BackOff, FramesByTurnsAreComparedByBothKinds) {
  for (const bool heavyFirst : {false, true}) {
    BackOff backOff;
    Clock::time_point now(std::chrono::seconds(1));
    bool heavy = heavyFirst;
    for (int i = 0; i < 200; ++i, heavy = !heavy) {
      const int took = (heavy ? 20 : 10) + (backOff.engaged() ? 2 : 0);
      now += std::chrono::milliseconds(took);
      backOff.frameEnded({backOff.engaged(), false}, now);
    }
    EXPECT_FALSE(backOff.engaged()) << heavyFirst;
    EXPECT_EQ(backOff.statistics().lastSoftwareMilliseconds, 17.0);
    EXPECT_EQ(backOff.statistics().lastHostMilliseconds, 15.0);
  }
}

/// Frames that wait for a tick take the same time whoever draws.
TEST(BackOff, FramesThatWaitAreComparedByTheProcessorsTime) {
  for (const bool softwareIsCheap : {false, true}) {
    BackOff backOff;
    Clock::time_point now(std::chrono::seconds(1));
    std::chrono::nanoseconds processor(1);
    for (int i = 0; i < 200; ++i) {
      const bool software = backOff.engaged();
      now += std::chrono::milliseconds(20 + (software == softwareIsCheap ? i % 3 : 0));
      processor += std::chrono::milliseconds(software == softwareIsCheap ? 2 : 4);
      backOff.frameEnded({false, software, false, processor}, now);
    }
    EXPECT_EQ(backOff.statistics().trials, 1u);
    EXPECT_EQ(backOff.engaged(), softwareIsCheap);
  }
}

TEST(BackOff, ForcedItIsNeverInDoubt) {
  BackOff backOff;
  backOff.setForced(true);
  Frames frames(backOff);
  frames.run(500, true, 10, 1);
  EXPECT_EQ(frames.onHost(), 0);
}

} // namespace
} // namespace arbiter::state
