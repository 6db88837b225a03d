#include "state/objects/feedback_tracker.h"

#include <gtest/gtest.h>

namespace arbiter::state {
namespace {

constexpr ColorBuffer kBack{0, 0x0405};
constexpr TextureLevel kLevel{7, 0x0DE1, 0};

TEST(Feedback, RemembersTheLastCopyIntoALevel) {
  FeedbackTracker tracker;
  EXPECT_EQ(tracker.lastCopy(kLevel), nullptr);
  tracker.record(kLevel, CopyKind::Image2D, kBack, {.width = 64, .height = 32}, 3);
  tracker.record(kLevel, CopyKind::SubImage2D, {5, 0x8CE0}, {.destX = 4, .width = 8, .height = 2},
                 9);
  const Copy *copy = tracker.lastCopy(kLevel);
  ASSERT_NE(copy, nullptr);
  EXPECT_EQ(copy->kind, CopyKind::SubImage2D);
  EXPECT_EQ(copy->source, (ColorBuffer{5, 0x8CE0}));
  EXPECT_EQ(copy->region.destX, 4);
  EXPECT_EQ(copy->frame, 9u);
  EXPECT_EQ(copy->sequence, 2u);
  EXPECT_EQ(tracker.levels(), 1u) << "both copies went into one level";
}

TEST(Feedback, CountsCopiesAndPixelsByKind) {
  FeedbackTracker tracker;
  tracker.record(kLevel, CopyKind::SubImage2D, kBack, {.width = 64, .height = 32}, 0);
  tracker.record(kLevel, CopyKind::SubImage2D, kBack, {.width = 64, .height = 32}, 1);
  tracker.record(kLevel, CopyKind::Image1D, kBack, {.width = -5, .height = 1}, 1);
  EXPECT_EQ(tracker.totals(CopyKind::SubImage2D).copies, 2u);
  EXPECT_EQ(tracker.totals(CopyKind::SubImage2D).pixels, 2u * 64 * 32);
  EXPECT_EQ(tracker.totals(CopyKind::Image1D).pixels, 0u) << "a refused copy moves nothing";
  EXPECT_EQ(tracker.copies(), 3u);
}

TEST(Feedback, FacesAndLevelsAreApart) {
  FeedbackTracker tracker;
  tracker.record({7, 0x8515, 0}, CopyKind::SubImage2D, kBack, {.width = 1, .height = 1}, 0);
  tracker.record({7, 0x8516, 0}, CopyKind::SubImage2D, kBack, {.width = 1, .height = 1}, 0);
  tracker.record({7, 0x8515, 1}, CopyKind::SubImage2D, kBack, {.width = 1, .height = 1}, 0);
  EXPECT_EQ(tracker.levels(), 3u);
  EXPECT_EQ(tracker.lastCopy({7, 0x8516, 1}), nullptr);
}

TEST(Feedback, ForgetsADeletedTexture) {
  FeedbackTracker tracker;
  tracker.record(kLevel, CopyKind::Image2D, kBack, {.width = 1, .height = 1}, 0);
  tracker.record({8, 0x0DE1, 0}, CopyKind::Image2D, kBack, {.width = 1, .height = 1}, 0);
  tracker.forget(7);
  EXPECT_EQ(tracker.lastCopy(kLevel), nullptr);
  EXPECT_NE(tracker.lastCopy({8, 0x0DE1, 0}), nullptr);
  EXPECT_EQ(tracker.copies(), 2u) << "what was counted stays counted";
}

TEST(Feedback, MemoryIsBounded) {
  FeedbackTracker tracker;
  const auto more = std::uint32_t(FeedbackTracker::kMaxLevels + 100);
  for (std::uint32_t i = 0; i < more; ++i)
    tracker.record({i, 0x0DE1, 0}, CopyKind::Image2D, kBack, {.width = 1, .height = 1}, 0);
  EXPECT_EQ(tracker.levels(), FeedbackTracker::kMaxLevels);
  EXPECT_EQ(tracker.copies(), more);
}

} // namespace
} // namespace arbiter::state
