// Points drawn by NV_point_sprite; each pixel is compared with the specification's formula.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "point_sprites.h"

namespace api {
namespace {

using Coordinates = std::array<GLfloat, 4>;

/// A point in window coordinates of the 32x32 framebuffer.
struct Point {
  GLfloat x = 16, y = 16, size = 20;
  Coordinates coordinates = {0, 0, 0, 1};
};

void vertexOf(const Point &point, GLfloat z = 0) {
  glMultiTexCoord4fv(GL_TEXTURE0, point.coordinates.data());
  glVertex3f(point.x / 16 - 1, point.y / 16 - 1, z);
}

void draw(const Point &point) {
  glPointSize(point.size);
  glBegin(GL_POINTS);
  vertexOf(point);
  glEnd();
}

/// Returns the coordinates at pixel (x, y) (section 3.3).
Coordinates spriteAt(const Point &point, GLenum mode, int x, int y) {
  const Coordinates &c = point.coordinates;
  return {0.5f + (GLfloat(x) + 0.5f - point.x) / point.size,
          0.5f - (GLfloat(y) + 0.5f - point.y) / point.size,
          mode == GL_S   ? c[0] / c[3]
          : mode == GL_R ? c[2] / c[3]
                         : 0,
          1};
}

using Pixels = std::vector<std::array<GLubyte, 4>>;

Pixels readPixels() {
  Pixels pixels(32 * 32);
  glReadPixels(0, 0, 32, 32, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

/// Compares each pixel's color within a tolerance; pixels on the point's edge may be either.
template <typename Color>
void expectSprite(const Point &point, GLenum mode, const Color &colorOf, int tolerance) {
  const Pixels pixels = readPixels();
  int inside = 0, wrong = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const auto &is = pixels[std::size_t(y * 32 + x)];
      const GLfloat dx = std::fabs(GLfloat(x) + 0.5f - point.x),
                    dy = std::fabs(GLfloat(y) + 0.5f - point.y);
      const GLfloat beyond = std::max(dx, dy) - point.size / 2;
      const bool covered = is[3] != 0;
      if (beyond > 0.51f ? covered : beyond < -0.51f && !covered)
        ++wrong;
      if (!covered)
        continue;
      ++inside;
      const std::array<GLfloat, 3> want = colorOf(spriteAt(point, mode, x, y));
      for (std::size_t i = 0; i < 3; ++i) {
        const int byte = int(std::lround(std::clamp(want[i], 0.0f, 1.0f) * 255));
        if (std::abs(byte - int(is[i])) <= tolerance)
          continue;
        if (++wrong <= 3)
          ADD_FAILURE() << "pixel " << x << ", " << y << ", component " << i << ": " << int(is[i])
                        << " in place of " << byte;
      }
    }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(inside, 0) << "nothing was drawn";
}

std::array<GLfloat, 3> coordinatesAsColor(const Coordinates &at) { return {at[0], at[1], at[2]}; }

constexpr char kShowCoordinates[] = "!!ARBfp1.0\nMOV result.color, fragment.texcoord[0];\nEND";

void showCoordinates() {
  glEnable(kFragment);
  makeProgram(kShowCoordinates);
}

void sprites(GLenum mode) {
  glEnable(GL_POINT_SPRITE_NV);
  glTexEnvi(GL_POINT_SPRITE_NV, GL_COORD_REPLACE_NV, GL_TRUE);
  glPointParameteriNV(GL_POINT_SPRITE_R_MODE_NV, GLint(mode));
}

void clearAll() {
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
}

TEST_F(EraPointSprites, ProgramsOfFragmentsReadTheThirdComponent) {
  showCoordinates();
  const Point point{.coordinates = {0.6f, 0.1f, 1.5f, 2}};
  for (const GLenum mode : {GL_S, GL_R, GL_ZERO, GL_R, GL_S}) {
    SCOPED_TRACE(mode);
    sprites(mode);
    clearAll();
    draw(point);
    expectSprite(point, mode, coordinatesAsColor, 2);
    EXPECT_EQ(replaces(), GL_TRUE);
  }
}

TEST_F(EraPointSprites, FourthComponentIsOne) {
  glEnable(kFragment);
  makeProgram("!!ARBfp1.0\nMUL result.color, fragment.texcoord[0].w, {0.5, 1, 0, 1};\nEND");
  const Point point{.coordinates = {0.25f, 0, 0.5f, 4}};
  for (const GLenum mode : {GL_S, GL_R}) {
    sprites(mode);
    clearAll();
    draw(point);
    expectSprite(
        point, mode,
        [](const Coordinates &) {
          return std::array<GLfloat, 3>{0.5f, 1, 0};
        },
        1);
  }
}

TEST_F(EraPointSprites, RandomPoints) {
  std::mt19937 random(20020604);
  const auto between = [&](GLfloat low, GLfloat high) {
    return low + (high - low) * GLfloat(random() % 65536u) / 65536.0f;
  };
  showCoordinates();
  constexpr std::array<GLenum, 3> kModes = {GL_ZERO, GL_S, GL_R};
  for (int i = 0; i < 200 && !HasFailure(); ++i) {
    const GLenum mode = kModes[random() % 3];
    const Point point{between(4, 28),
                      between(4, 28),
                      between(3, 30),
                      {between(0, 1), between(0, 1), between(0, 1), between(0.5f, 2)}};
    SCOPED_TRACE(testing::Message() << "point " << i << ", mode " << mode << ", size " << point.size
                                    << " at " << point.x << ", " << point.y);
    sprites(mode);
    clearAll();
    draw(point);
    // Hosts round a sprite's edges and size differently.
    expectSprite(point, mode, coordinatesAsColor, 2 + int(255.0f / point.size / 8));
  }
}

/// Returns the color of a texel; a texture of 4x4x4 texels has a distinct one for each.
std::array<GLfloat, 3> texelColor(int s, int t, int r) {
  return {GLfloat(s * 85) / 255, GLfloat(t * 85) / 255, GLfloat(r * 60 + 30) / 255};
}
GLuint makeTexels() {
  std::vector<GLubyte> texels;
  for (int i = 0; i < 64; ++i) {
    for (const GLfloat part : texelColor(i % 4, i / 4 % 4, i / 16))
      texels.push_back(GLubyte(std::lround(part * 255)));
    texels.push_back(255);
  }
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_3D, name);
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_3D, filter, GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
  return name;
}
std::array<GLfloat, 3> sampled(const Coordinates &at) {
  const auto texel = [](GLfloat c) { return std::clamp(int(std::floor(c * 4)), 0, 3); };
  return texelColor(texel(at[0]), texel(at[1]), texel(at[2]));
}

TEST_F(EraPointSprites, FixedFunctionOfAThreeDimensionalTexture) {
  const GLuint name = makeTexels();
  glEnable(GL_TEXTURE_3D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  for (const GLenum mode : {GL_R, GL_S, GL_ZERO})
    for (int slice = 0; slice < 4; ++slice) {
      SCOPED_TRACE(testing::Message() << mode << ", slice " << slice);
      const GLfloat r = (GLfloat(slice) + 0.5f) / 4;
      // The middle is between texels, where there is no pixel center.
      const Point point{.size = 16, .coordinates = {0.6f, 0.5f, r, 1}};
      sprites(mode);
      clearAll();
      draw(point);
      expectSprite(point, mode, sampled, 1);
    }
  // Triangles in between, and points after them, are drawn as usual. Mesa replaces coordinates in
  // triangles of fixed function too, as long as sprites are enabled.
  clearAll();
  sprites(GL_R);
  glDisable(GL_POINT_SPRITE_NV);
  glTexCoord3f(0.1f, 0.1f, 0.6f);
  glBegin(GL_TRIANGLES);
  glVertex2f(-1, -1);
  glVertex2f(3, -1);
  glVertex2f(-1, 3);
  glEnd();
  const auto whole = texelColor(0, 0, 2);
  EXPECT_NEAR(readPixels()[33][2], whole[2] * 255, 1);
  const Point last{.size = 16, .coordinates = {0, 0, 0.9f, 1}};
  clearAll();
  glEnable(GL_POINT_SPRITE_NV);
  draw(last);
  expectSprite(last, GL_R, sampled, 1);
  glDisable(GL_POINT_SPRITE_NV);
  clearAll();
  draw(last);
  EXPECT_NEAR(readPixels()[16 * 32 + 16][2], texelColor(0, 0, 3)[2] * 255, 1);
  glDeleteTextures(1, &name);
}

TEST_F(EraPointSprites, GeneratedCoordinatesAndTextureMatrices) {
  showCoordinates();
  sprites(GL_S);
  const GLfloat plane[] = {0, 0, 0, 0.25f};
  glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
  glTexGenfv(GL_S, GL_OBJECT_PLANE, plane);
  glEnable(GL_TEXTURE_GEN_S);
  glMatrixMode(GL_TEXTURE);
  glTranslatef(0.5f, 0, 0);
  glMatrixMode(GL_MODELVIEW);
  clearAll();
  Point point{.coordinates = {0.1f, 0, 0, 1}};
  draw(point);
  point.coordinates[0] = 0.75f; // the resulting value
  expectSprite(point, GL_S, coordinatesAsColor, 2);
}

TEST_F(EraPointSprites, ProgramsOfVertices) {
  makeProgram("!!ARBvp1.0\nMOV result.position, vertex.position;\n"
              "MUL result.texcoord[0], vertex.texcoord[0], {0.5, 1, 2, 1};\nEND",
              kVertex);
  glEnable(kVertex);
  showCoordinates();
  for (const GLenum mode : {GL_S, GL_R}) {
    sprites(mode);
    clearAll();
    Point point{.coordinates = {0.8f, 0, 0.3f, 1}};
    draw(point);
    point.coordinates = {0.4f, 0, 0.6f, 1};
    expectSprite(point, mode, coordinatesAsColor, 2);
  }
}

TEST_F(EraPointSprites, EachUnitHasItsOwnReplacement) {
  glEnable(kFragment);
  makeProgram("!!ARBfp1.0\nMOV result.color, fragment.texcoord[0];\n"
              "MOV result.color.z, fragment.texcoord[1].z;\nEND");
  sprites(GL_S);
  glTexEnvi(GL_POINT_SPRITE_NV, GL_COORD_REPLACE_NV, GL_FALSE);
  glActiveTexture(GL_TEXTURE1);
  glTexEnvi(GL_POINT_SPRITE_NV, GL_COORD_REPLACE_NV, GL_TRUE);
  glMultiTexCoord4f(GL_TEXTURE1, 0.25f, 0, 0.75f, 1);
  clearAll();
  Point point{.coordinates = {0.5f, 1, 0, 1}};
  draw(point);
  expectSprite(
      point, GL_S,
      [](const Coordinates &) {
        return std::array<GLfloat, 3>{0.5f, 1, 0.25f};
      },
      1);
  glActiveTexture(GL_TEXTURE0);
}

TEST_F(EraPointSprites, ArraysAndLists) {
  showCoordinates();
  sprites(GL_R);
  const Point point{.coordinates = {0.1f, 0, 0.7f, 1}};
  const GLfloat position[] = {0, 0};
  glPointSize(point.size);
  glVertexPointer(2, GL_FLOAT, 0, position);
  glTexCoordPointer(4, GL_FLOAT, 0, point.coordinates.data());
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  clearAll();
  glDrawArrays(GL_POINTS, 0, 1);
  expectSprite(point, GL_R, coordinatesAsColor, 2);
  clearAll();
  const GLubyte index = 0;
  glDrawElements(GL_POINTS, 1, GL_UNSIGNED_BYTE, &index);
  expectSprite(point, GL_R, coordinatesAsColor, 2);
  glNewList(1, GL_COMPILE);
  glClear(GL_COLOR_BUFFER_BIT);
  glBegin(GL_TRIANGLES); // none of it is visible
  for (int i = 0; i < 3; ++i)
    glVertex2f(-1, -1);
  glEnd();
  glDrawArrays(GL_POINTS, 0, 1);
  glEndList();
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glDisableClientState(GL_VERTEX_ARRAY);
  clearAll();
  glCallList(1);
  expectSprite(point, GL_R, coordinatesAsColor, 2);
  glNewList(1, GL_COMPILE);
  glTexEnvi(GL_POINT_SPRITE_NV, GL_COORD_REPLACE_NV, GL_FALSE);
  glPointParameteriNV(GL_POINT_SPRITE_R_MODE_NV, GL_S);
  glTexEnvi(GL_POINT_SPRITE_NV, GL_COORD_REPLACE_NV, GL_TRUE);
  glBegin(GL_POINTS);
  vertexOf(point);
  glEnd();
  glEndList();
  EXPECT_EQ(rMode(), GL_R);
  clearAll();
  glCallList(1);
  expectSprite(point, GL_S, coordinatesAsColor, 2);
  EXPECT_EQ(replaces(), GL_TRUE);
  glDeleteLists(1, 1);
}

TEST_F(EraPointSprites, FogAndEnvironmentsAreFixedFunctions) {
  sprites(GL_R);
  const GLfloat green[] = {0, 1, 0, 1};
  glFogfv(GL_FOG_COLOR, green);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 1);
  glEnable(GL_FOG);
  glColor4f(1, 0, 0, 1);
  clearAll();
  const Point point;
  glPointSize(point.size);
  glBegin(GL_POINTS);
  vertexOf(point, 0.5f);
  glEnd();
  expectSprite(
      point, GL_R,
      [](const Coordinates &) {
        return std::array<GLfloat, 3>{0.5f, 0.5f, 0};
      },
      1);
  glDisable(GL_FOG);
}

} // namespace
} // namespace api
