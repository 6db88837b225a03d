// The table knows which textures of a share group share texels.
#include "state/share/texture_views.h"

#include <gtest/gtest.h>

namespace arbiter::state {
namespace {

TEST(TextureViews, BothSidesAreNoted) {
  TextureViews views;
  EXPECT_FALSE(views.contains(5));
  views.add(7, 5);
  EXPECT_TRUE(views.contains(5));
  EXPECT_TRUE(views.contains(7));
  EXPECT_FALSE(views.contains(6));
}

TEST(TextureViews, Texture0IsNone) {
  TextureViews views;
  views.add(0, 3); // an error, which the host raises
  EXPECT_FALSE(views.contains(0));
}

TEST(TextureViews, ADeletedNameIsAnothersNext) {
  TextureViews views;
  const GLuint names[] = {7, 40};
  views.remove(2, names);
  views.add(7, 5);
  views.remove(-1, names);
  views.remove(2, nullptr);
  EXPECT_TRUE(views.contains(7));
  views.remove(2, names);
  EXPECT_FALSE(views.contains(7));
  EXPECT_TRUE(views.contains(5)) << "others may be views of it still";
}

} // namespace
} // namespace arbiter::state
