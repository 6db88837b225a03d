// The limit of magnification (OpenGL 4.1, 3.9.12): a level of detail of 0 for all filters. It is
// one of the two that the specification allows, and what Mesa's software drivers use.
#include <cmath>
#include <vector>

#include "fixture.h"

namespace api {
namespace {

constexpr int kPattern = 64;

/// Returns how many pixels are neither black nor white, if a texture of only such texels is drawn
/// at a level of detail of `lambda`.
int grey(GLenum minify, float lambda) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GLint(minify));
  const float end = 2 * std::exp2(-lambda) - 1; // of a square with as many pixels as texels
  glClear(GL_COLOR_BUFFER_BIT);
  glBegin(GL_QUADS);
  glTexCoord2f(0, 0), glVertex2f(-1, -1), glTexCoord2f(1, 0), glVertex2f(end, -1);
  glTexCoord2f(1, 1), glVertex2f(end, end), glTexCoord2f(0, 1), glVertex2f(-1, end);
  glEnd();
  const Picture picture = readPicture(kPattern);
  int count = 0;
  for (std::size_t i = 0; i < picture.size(); i += 4)
    count += picture[i] > 8 && picture[i] < 247 ? 1 : 0;
  return count;
}

class MagnificationPrimitives : public ApiTest {};

TEST_F(MagnificationPrimitives, EndsAtALevelOfZeroForAllFilters) {
  if (mesaRelease() == 0)
    GTEST_SKIP() << "the host is not Mesa: either end is right";
  glViewport(0, 0, kPattern, kPattern);
  std::vector<GLubyte> texels(std::size_t(3) * kPattern * kPattern);
  GLint level = 0;
  for (int size = kPattern; size != 0; size /= 2, ++level) {
    for (int i = 0; i < size * size; ++i)
      texels[std::size_t(3 * i)] = texels[std::size_t(3 * i + 1)] = texels[std::size_t(3 * i + 2)] =
          (i % size / 3 + i / size / 3) % 2 != 0 ? 255 : 0;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, level, GL_RGB, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 texels.data());
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glEnable(GL_TEXTURE_2D);
  for (const float lambda : {0.1f, 0.3f, 0.45f, 0.7f})
    EXPECT_EQ(grey(GL_NEAREST_MIPMAP_NEAREST, lambda), 0) << lambda;
  EXPECT_GT(grey(GL_NEAREST_MIPMAP_NEAREST, -0.3f), 100) << "magnified by LINEAR";
  EXPECT_GT(grey(GL_LINEAR_MIPMAP_NEAREST, 0.3f), 100);
}

} // namespace
} // namespace api
