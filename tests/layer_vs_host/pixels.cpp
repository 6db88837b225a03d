// Pixel rectangles under a fragment program (AFP 368-373), accumulation, copies to textures.
#include "harness.h"

namespace paths {

namespace {

std::vector<GLubyte> ramp(int size) {
  std::vector<GLubyte> pixels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (const int c : {255 * x / size, 255 * y / size, 128, 255})
        pixels.push_back(GLubyte(c));
  return pixels;
}

void drawPixels(Recorder &r) {
  usePrograms();
  load("!!ARBfp1.0\nMUL result.color, fragment.color.gbra, program.local[0];\nEND");
  const std::vector<GLubyte> pixels = ramp(16);
  glRasterPos2f(-0.9f, -0.9f);
  glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  glRasterPos2f(0, -0.9f);
  glPixelZoom(1.5f, 2);
  glPixelTransferf(GL_GREEN_SCALE, 0.5f);
  tint(1, 1, 0.5f);
  glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  glPixelTransferf(GL_GREEN_SCALE, 1);
  glPixelZoom(1, 1);
  glRasterPos2f(-0.9f, 0.25f);
  glDrawPixels(16, 16, GL_LUMINANCE, GL_UNSIGNED_BYTE, pixels.data());
  glDisable(kFragment);
  glRasterPos2f(0.25f, 0.25f);
  glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  r.picture("rectangles");
  r.errors("rectangles");
}

/// Tests a texture that the program samples while pixels are drawn.
void drawPixelsTextured(Recorder &r) {
  usePrograms();
  checkered(4);
  load("!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
       "MUL result.color, t, fragment.color;\nEND");
  const std::vector<GLubyte> pixels = ramp(32);
  for (int i = 0; i < 4; ++i) {
    glDisable(kVertex);
    glTexCoord2f(float(i) / 4 + 0.1f, 0.6f);
    glRasterPos2f(i % 2 ? 0.f : -1.f, i / 2 ? 0.f : -1.f);
    glDrawPixels(32, 32, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  }
  r.picture("four tints");
}

void depthAndStencil(Recorder &r) {
  usePrograms();
  std::vector<GLfloat> depths;
  std::vector<GLubyte> stencils;
  for (int i = 0; i < 32 * 32; ++i) {
    depths.push_back(float(i % 32) / 32);
    stencils.push_back(GLubyte(i / 32 % 2));
  }
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glColor4f(0.5f, 0.25f, 1, 1);
  glRasterPos2f(-1, -1);
  glDrawPixels(32, 32, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  glDepthFunc(GL_LESS);
  glDrawPixels(32, 32, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencils.data());
  gradient(-1, -1, 1, 1);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 1, 1);
  load(kGreen);
  gradient(-1, -1, 0, 0);
  r.picture("tested");
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_DEPTH_TEST);
  glRasterPos2f(0, 0);
  glCopyPixels(0, 0, 32, 32, GL_DEPTH);
  glCopyPixels(0, 0, 32, 32, GL_STENCIL);
  glRasterPos2f(0, -1);
  load("!!ARBfp1.0\nMOV result.color, fragment.color.bgra;\nEND");
  glCopyPixels(0, 0, 32, 32, GL_COLOR);
  r.picture("copied");
  r.errors("copied");
}

void bitmaps(Recorder &r) {
  usePrograms();
  std::vector<GLubyte> bits;
  for (int i = 0; i < 32; ++i)
    bits.push_back(GLubyte(i % 2 ? 0xCC : 0x33));
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  load("!!ARBfp1.0\nMUL result.color, fragment.color, fragment.position.x;\n"
       "MUL result.color, fragment.color.gbra, program.local[0];\nEND");
  for (int i = 0; i < 4; ++i) {
    glColor4f(float(i) / 3, 1, 0.5f, 1);
    tint(1, float(i) / 3, 1);
    glRasterPos2f(-0.9f, float(i) * 0.5f - 0.9f);
    glBitmap(16, 16, 0, 0, 20, 0, bits.data());
    glBitmap(16, 16, 0, 0, 20, 0, bits.data());
    glFlush(); // Mesa collects bitmaps, and draws them later with the then current parameters
  }
  r.picture("eight bitmaps");
}

void accumulation(Recorder &r) {
  usePrograms();
  glClearAccum(0, 0, 0, 0);
  glClear(GL_ACCUM_BUFFER_BIT);
  for (int i = 0; i < 4; ++i) {
    glClear(GL_COLOR_BUFFER_BIT);
    glProgramEnvParameter4fARB(kVertex, 0, float(i) * 0.2f - 0.3f, 0, 0, 0);
    tint(1, float(i) / 3, 1);
    gradient(-0.5f, -0.5f, 0.5f, 0.5f);
    glAccum(i == 0 ? GL_LOAD : GL_ACCUM, 0.25f);
  }
  glAccum(GL_MULT, 1.5f);
  glAccum(GL_RETURN, 1);
  r.picture("motion");
  gradient(-1, -1, -0.5f, -0.5f);
  r.picture("drawn over");
  r.errors("accumulation");
}

/// Tests glReadBuffer and glCopyTex(Sub)Image, the era's method for multipass.
void copiesToTextures(Recorder &r) {
  usePrograms();
  checkered(64);
  gradient(-1, -1, 1, 1);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, kSize, kSize, 0);
  const char *const blur = "!!ARBfp1.0\nTEMP a, b;\nADD a, fragment.texcoord[0], {0.03, 0.06, 0, "
                           "0};\nTEX a, a, texture[0], 2D;\n"
                           "TEX b, fragment.texcoord[0], texture[0], 2D;\n"
                           "SUB a, 1, a;\nLRP result.color, 0.5, a, b;\nEND";
  load(blur);
  for (int pass = 0; pass < 5; ++pass) {
    glClear(GL_COLOR_BUFFER_BIT);
    gradient(-1, -1, 1, 1);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 3 * pass, 0, 0, 0, kSize - 3 * pass, kSize);
  }
  r.picture("five passes");
}

} // namespace

const std::vector<Case> kPixelCases = {
    {"pixels-draw", drawPixels},
    {"pixels-draw-textured", drawPixelsTextured},
    {"pixels-depth-and-stencil", depthAndStencil},
    {"pixels-bitmaps", bitmaps},
    {"pixels-accumulation", accumulation},
    {"pixels-feedback", copiesToTextures},
};

} // namespace paths
