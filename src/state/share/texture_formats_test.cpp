#include "state/share/texture_formats.h"

#include <gtest/gtest.h>

namespace arbiter::state {
namespace {

TEST(TextureFormats, AreOfAnImage) {
  TextureFormats formats;
  EXPECT_FALSE(formats.any());
  formats.set(7, GL_TEXTURE_2D, 0, 0);
  EXPECT_FALSE(formats.any()) << "the host's own are not kept";
  formats.set(7, GL_TEXTURE_2D, 0, GL_HILO16_NV);
  EXPECT_TRUE(formats.any());
  EXPECT_EQ(formats.find(7, GL_TEXTURE_2D, 0), GLenum(GL_HILO16_NV));
  EXPECT_EQ(formats.find(7, GL_TEXTURE_2D, 3), GLenum(GL_HILO16_NV)) << "as GenerateMipmap has it";
  formats.set(7, GL_TEXTURE_2D, 3, 0);
  EXPECT_EQ(formats.find(7, GL_TEXTURE_2D, 3), 0u);
  EXPECT_EQ(formats.find(8, GL_TEXTURE_2D, 0), 0u);
  EXPECT_EQ(formats.find(7, GL_TEXTURE_1D, 0), 0u);
}

TEST(TextureFormats, OfDefaultTexturesStayAndOthersGo) {
  TextureFormats formats;
  for (const GLuint name : {0u, 5u})
    formats.set(name, GL_TEXTURE_1D, 0, GL_DSDT_NV);
  const GLuint names[] = {0, 5, 6};
  formats.remove(-1, names);
  formats.remove(3, nullptr);
  EXPECT_EQ(formats.find(5, GL_TEXTURE_1D, 0), GLenum(GL_DSDT_NV));
  formats.remove(3, names);
  EXPECT_EQ(formats.find(5, GL_TEXTURE_1D, 0), 0u);
  EXPECT_EQ(formats.find(0, GL_TEXTURE_1D, 0), GLenum(GL_DSDT_NV));
}

} // namespace
} // namespace arbiter::state
