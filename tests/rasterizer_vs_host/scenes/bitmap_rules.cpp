#include "bitmap_rules.h"

#include <cstddef>
#include <functional>

#include "surface.h"

namespace software {
namespace {

constexpr const char *kColorText = "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n";

/// Clears a pixel to the rules' color, for CopyPixels.
void clearSource(int x, int y) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(x, y, 1, 1);
  glClearColor(0.25f, 0.5f, 0.75f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glClearColor(0, 0, 0, 0);
  glDisable(GL_SCISSOR_TEST);
}

/// Draws one pixel each by Bitmap, DrawPixels and CopyPixels. The raster position was set with the
/// values below.
void rule(const char *name, const char *text, void (*state)()) {
  constexpr int kAt = kEdge * 5 / 8;
  constexpr float kColor[4] = {0.25f, 0.5f, 0.75f, 1};
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  clearSource(0, kEdge - 1);
  (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB, text ? text : kColorText);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glRectf(-1, -1, 1, 0);
  (text ? glEnable : glDisable)(GL_FRAGMENT_PROGRAM_ARB);
  glColor4fv(kColor);
  glSecondaryColor3f(0.125f, 0.25f, 0.0625f);
  glTexCoord4f(0.25f, 0.75f, 0.5f, 1);
  glMultiTexCoord4f(GL_TEXTURE3, 0.5f, 0.125f, 1, 1);
  state();
  glRasterPos2f(0.25f, 0.25f);
  const GLubyte bit = 0x80;
  glBitmap(1, 1, 0, 0, 1, 0, &bit);
  glColor4f(1, 1, 1, 1); // the raster position keeps its values
  glSecondaryColor3f(1, 1, 1);
  glTexCoord4f(0, 0, 0, 1);
  glMultiTexCoord4f(GL_TEXTURE3, 0, 0, 0, 1);
  glFogCoordf(0);
  glDrawPixels(1, 1, GL_RGBA, GL_FLOAT, kColor);
  glBitmap(0, 0, 0, 0, 1, 0, nullptr);
  glCopyPixels(0, kEdge - 1, 1, 1, GL_COLOR);
  record(std::string("rule ") + name, readRgba(kAt, kAt, 1, 1));
  record(std::string("rule ") + name + " of DrawPixels", readRgba(kAt + 1, kAt, 1, 1));
  record(std::string("rule ") + name + " of CopyPixels", readRgba(kAt + 2, kAt, 1, 1));
  for (const GLenum matrix : {GL_PROJECTION, GL_MODELVIEW}) {
    glMatrixMode(matrix);
    glLoadIdentity();
  }
  glDisable(GL_FOG);
  glDisable(GL_COLOR_SUM);
  glDisable(GL_TEXTURE_2D);
}

void setFog(GLenum source) {
  constexpr float kRed[4] = {1, 0, 0, 1};
  glEnable(GL_FOG);
  glFogi(GL_FOG_COORD_SRC, GLint(source));
  glFogCoordf(1);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 4);
  glFogfv(GL_FOG_COLOR, kRed);
}

} // namespace

void rules() {
  glViewport(0, 0, kEdge, kEdge);
  rule("texture coordinates", "!!ARBfp1.0\nMOV result.color, fragment.texcoord[0];\nEND\n", [] {});
  rule("texture coordinates of another unit",
       "!!ARBfp1.0\nMOV result.color, fragment.texcoord[3];\nEND\n", [] {});
  rule("secondary colour",
       "!!ARBfp1.0\nADD result.color, fragment.color, fragment.color.secondary;\nEND\n", [] {});
  rule("colour sum", nullptr, [] { glEnable(GL_COLOR_SUM); });
  rule("fog", nullptr, [] { setFog(GL_FOG_COORD); });
  rule("fog of a depth", nullptr, [] { // the eye is 1 before the plane, and 100 beside it
    setFog(GL_FRAGMENT_DEPTH);
    glMatrixMode(GL_PROJECTION);
    glOrtho(99, 101, -1, 1, -2, 2);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(100, 0, -1);
  });
  rule("fog of a program",
       "!!ARBfp1.0\nOPTION ARB_fog_linear;\nMOV result.color, fragment.color;\nEND\n", [] {
         setFog(GL_FRAGMENT_DEPTH);
         glDisable(GL_FOG);
         glMatrixMode(GL_PROJECTION);
         glFrustum(-0.5, 0.5, -0.5, 0.5, 0.5, 10);
         glMatrixMode(GL_MODELVIEW);
         glTranslatef(0, 0, -1);
       });
  rule("a texture", nullptr, [] {
    constexpr unsigned char kTexels[16] = {255, 0, 0,   255, 0,   255, 0,   255,
                                           0,   0, 255, 255, 255, 255, 255, 255};
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, kTexels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
  });
}

void frames(const std::function<void()> &swap) {
  constexpr float kColor[4] = {0.25f, 0.5f, 0.75f, 1};
  constexpr GLubyte kBit = 0x80;
  glViewport(0, 0, kEdge, kEdge);
  for (int frame = 0; frame < 40; ++frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_POINT_SMOOTH); // the host draws smooth sprites
    glEnable(GL_POINT_SPRITE);
    glBegin(GL_POINTS);
    glVertex2f(-0.5f, -0.5f);
    glEnd();
    glDisable(GL_POINT_SPRITE);
    setFog(GL_FOG_COORD);
    glColor4fv(kColor);
    glRasterPos2f(0.25f, 0.25f);
    glBitmap(1, 1, 0, 0, 1, 0, &kBit);
    glDrawPixels(1, 1, GL_RGBA, GL_FLOAT, kColor);
    glDisable(GL_FOG);
    record("frame " + std::to_string(frame), readRgba(kEdge * 5 / 8, kEdge * 5 / 8, 2, 1));
    swap();
  }
}

void letters(int change, int draw) {
  constexpr unsigned char kTexel[4] = {0, 255, 0, 255},
                          kBits[8] = {255, 255, 255, 255, 255, 255, 255, 255};
  constexpr GLfloat kCorners[6] = {0, 0, 1, 0, 0, 1};
  glViewport(0, 0, kEdge, kEdge);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const GLuint list = glGenLists(2);
  glNewList(list, GL_COMPILE);
  glRectf(0, 0, 1, 1);
  glEndList();
  glNewList(list + 1, GL_COMPILE);
  glBitmap(8, 8, 0, 0, 8, 0, kBits);
  glEndList();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kTexel);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  GLuint program = 0;
  if (change == 0) {
    glEnable(GL_TEXTURE_2D);
  } else {
    program = makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                          "!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
                          "MUL result.color, t, fragment.color;\nEND\n");
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
  }
  glColor3f(1, 1, 0);
  glRasterPos2f(-1, -1);
  for (int i = 0; i < 3; ++i)
    glBitmap(8, 8, 0, 0, 8, 0, kBits);
  if (change == 0)
    glDisable(GL_TEXTURE_2D);
  else if (change == 1)
    glDisable(GL_FRAGMENT_PROGRAM_ARB);
  else
    glDeleteProgramsARB(1, &program);
  if (change == 2)
    glDisable(GL_FRAGMENT_PROGRAM_ARB);
  if (draw == 1)
    glCallList(list);
  else if (draw == 2)
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, kTexel);
  else if (draw == 3)
    glRasterPos2f(0, 0);
  else if (draw == 5)
    glCallList(list + 1);
  glVertexPointer(2, GL_FLOAT, 0, kCorners);
  glEnableClientState(GL_VERTEX_ARRAY);
  if (draw == 4)
    glDrawArrays(GL_TRIANGLES, 0, 3);
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < 3; ++i)
    glVertex2fv(kCorners + 2 * i);
  glEnd();
  record("letters", readRgba(20, 4, 1, 1));
  record("triangle", readRgba(kEdge / 2 + 4, kEdge / 2 + 4, 1, 1));
}

} // namespace software
