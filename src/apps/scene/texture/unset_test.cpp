#include "apps/scene/texture/unset.h"

#include <gtest/gtest.h>
#include <set>
#include <string>

namespace arbiter::scene {
namespace {

/// Returns the tile as text: '#' for white, from the top, every fifth texel.
std::string readable(const Image &image) {
  std::string text;
  for (int y = 47; y > 14; y -= 5) {
    for (int x = 6; x < 60; x += 5)
      text += image.at(x, y).g > 0.9f ? '#' : '.';
    text += '\n';
  }
  return text;
}

TEST(Unset, TheNumberIsReadableInTheTexels) {
  EXPECT_EQ(readable(makeUnset(12, 64, 64)), "..#....###.\n"
                                             ".##...#...#\n"
                                             "..#.......#\n"
                                             "..#......#.\n"
                                             "..#.....#..\n"
                                             "..#....#...\n"
                                             ".###..#####\n");
  std::set<std::vector<std::uint16_t>> all;
  for (unsigned unit = 0; unit < 32; ++unit)
    all.insert(makeUnset(unit, 64, 64).texels);
  EXPECT_EQ(all.size(), 32u) << "two units look the same";
}

TEST(Unset, RepeatsAndHasAnySize) {
  const Image large = makeUnset(7, 100, 130);
  for (int y = 0; y < 130; ++y)
    for (int x = 0; x < 100; ++x) {
      EXPECT_EQ(large.at(x, y), large.at(x % 64, y % 64));
      EXPECT_EQ(large.at(x, y).a, 1.0f);
    }
  const Image row = makeUnset(7, 64, 1);
  EXPECT_NE(row.at(0, 0), row.at(8, 0)) << "squares";
  for (int x = 0; x < 64; ++x)
    EXPECT_LT(row.at(x, 0).g, 0.9f) << "a slice through a number says nothing";
}

} // namespace
} // namespace arbiter::scene
