#include "state/share/texture_ranges.h"

#include <gtest/gtest.h>

namespace arbiter::state {
namespace {

TEST(TextureRanges, AreOfATexture) {
  TextureRanges ranges;
  ranges.set({7, GL_TEXTURE_2D}, {});
  EXPECT_FALSE(ranges.any()) << "what every texture begins with is not kept";
  const int memory = 0;
  const TextureRange range = {4, &memory, GL_STORAGE_SHARED_APPLE};
  ranges.set({7, GL_TEXTURE_2D}, range);
  EXPECT_TRUE(ranges.any());
  EXPECT_EQ(ranges.find({7, GL_TEXTURE_2D}), range);
  EXPECT_EQ(ranges.find({8, GL_TEXTURE_2D}), TextureRange{});
  ranges.set({7, GL_TEXTURE_2D}, {});
  EXPECT_EQ(ranges.find({7, GL_TEXTURE_2D}), TextureRange{});
}

TEST(TextureRanges, DefaultTexturesAreApartByTargetAndStay) {
  TextureRanges ranges;
  const TextureRange one = {1}, two = {2}, three = {3};
  ranges.set({0, GL_TEXTURE_1D}, one);
  ranges.set({0, GL_TEXTURE_2D}, two);
  ranges.set({5, GL_TEXTURE_2D}, three);
  const GLuint names[] = {0, 5, 6};
  ranges.remove(-1, names);
  ranges.remove(3, nullptr);
  EXPECT_EQ(ranges.find({5, GL_TEXTURE_2D}), three);
  ranges.remove(3, names);
  EXPECT_EQ(ranges.find({5, GL_TEXTURE_2D}), TextureRange{});
  EXPECT_EQ(ranges.find({0, GL_TEXTURE_1D}), one);
  EXPECT_EQ(ranges.find({0, GL_TEXTURE_2D}), two);
}

} // namespace
} // namespace arbiter::state
