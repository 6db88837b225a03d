#include "state/objects/name_ranges.h"

#include <gtest/gtest.h>

namespace arbiter::state {
namespace {

TEST(NameRanges, RowsAreTheLowestThatFit) {
  NameRanges names;
  EXPECT_EQ(names.reserveRow(0), 0u);
  EXPECT_EQ(names.reserveRow(3), 1u);
  names.reserve(6);
  EXPECT_EQ(names.reserveRow(2), 4u) << "the gap before 6";
  EXPECT_EQ(names.reserveRow(1), 7u);
  names.release(2);
  EXPECT_FALSE(names.contains(2));
  EXPECT_TRUE(names.contains(1));
  EXPECT_TRUE(names.contains(3));
  EXPECT_EQ(names.reserveRow(2), 8u) << "two do not fit where one was freed";
  EXPECT_EQ(names.reserveRow(1), 2u);
}

TEST(NameRanges, AllNames) {
  NameRanges names;
  EXPECT_EQ(names.reserveRow(0xFFFFFFFFu), 1u);
  EXPECT_EQ(names.reserveRow(1), 0u) << "none is left";
  EXPECT_TRUE(names.contains(0xFFFFFFFFu));
  names.release(0xFFFFFFFFu);
  names.release(77);
  EXPECT_EQ(names.reserveRow(2), 0u);
  EXPECT_EQ(names.reserveRow(1), 77u);
  EXPECT_EQ(names.reserveRow(1), 0xFFFFFFFFu);
}

TEST(NameRanges, ReservingTwiceAndReleasingWhatIsFree) {
  NameRanges names;
  names.reserve(5);
  names.reserve(5);
  names.release(9);
  names.release(5);
  EXPECT_FALSE(names.contains(5));
  EXPECT_EQ(names.reserveRow(5), 1u);
}

} // namespace
} // namespace arbiter::state
