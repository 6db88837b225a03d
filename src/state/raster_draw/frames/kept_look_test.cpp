#include "state/raster_draw/frames/kept_look.h"

#include <gtest/gtest.h>

namespace arbiter::state {
namespace {

TEST(KeptLook, TheFirstDrawDecides) {
  KeptLook look;
  EXPECT_EQ(look.side(), KeptLook::Side::Undecided);
  look.meets(false);
  EXPECT_TRUE(look.isRasterizers());
  for (int i = 0; i < 10'000; ++i)
    EXPECT_FALSE(look.frameEnded(i % 3 == 0));
  look.meets(true);
  EXPECT_TRUE(look.isRasterizers());
  KeptLook hosts;
  hosts.meets(true);
  hosts.meets(false);
  EXPECT_TRUE(hosts.isHosts());
}

/// Returns how many frames end before the looks are chosen anew.
int framesUntilUndecided(KeptLook &look, int most) {
  for (int i = 1; i <= most; ++i)
    if (look.frameEnded(true))
      return i;
  return 0;
}

TEST(KeptLook, TheHostsAreChosenAnewEachTimeLater) {
  KeptLook look;
  look.meets(true);
  const int first = framesUntilUndecided(look, 10'000);
  ASSERT_NE(first, 0);
  EXPECT_EQ(look.side(), KeptLook::Side::Undecided);
  look.becomesHosts();
  EXPECT_EQ(framesUntilUndecided(look, 2 * first - 1), 0);
  EXPECT_EQ(framesUntilUndecided(look, 1), 1);
  look.becomesHosts();
  EXPECT_EQ(framesUntilUndecided(look, 4 * first - 1), 0);
  EXPECT_FALSE(look.frameEnded(false)) << "another turn of the host's";
  EXPECT_EQ(framesUntilUndecided(look, 10'000), 4 * first);
}

TEST(KeptLook, AMixedFrameNowAndThenCostsLittle) {
  KeptLook look;
  look.meets(true);
  const int first = framesUntilUndecided(look, 10'000);
  for (int i = 0; i < 20; ++i) {
    look.meets(false);
    for (int frame = 0; frame < 100 * first; ++frame)
      EXPECT_FALSE(look.frameEnded(true));
    look.becomesHosts();
    EXPECT_EQ(framesUntilUndecided(look, 10'000), first);
  }
}

} // namespace
} // namespace arbiter::state
