#include "still_parts.h"

#include <array>
#include <cmath>
#include <vector>

namespace software {

const char *const kTexturedText = "!!ARBfp1.0\nTEMP t;\n"
                                  "TEX t, fragment.texcoord[0], texture[0], 2D;\n"
                                  "MUL result.color, t, fragment.color;\nEND\n";

void makeTexture() {
  constexpr int kTexels = 64;
  std::vector<unsigned char> texels;
  for (int y = 0; y < kTexels; ++y)
    for (int x = 0; x < kTexels; ++x) {
      const bool light = ((x / 8) ^ (y / 8)) % 2 != 0;
      for (const int value : {light ? 190 : 150, light ? 170 : x * 3, light ? y * 3 : 40, x * 4})
        texels.push_back((unsigned char)value);
    }
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kTexels, kTexels, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texels.data());
}

GLuint boundTexture() {
  GLint name = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &name);
  return GLuint(name);
}

void floorView() {
  glEnable(GL_DEPTH_TEST);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-1, 1, -1, 1, 1, 60);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glTranslatef(0, -1.2F, 0);
  glRotatef(15, 0, 1, 0);
}

void floorQuads() {
  constexpr std::array<std::array<int, 2>, 4> kCorners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  glNormal3f(0, 1, 0);
  glBegin(GL_QUADS);
  for (int z = 0; z < 12; ++z)
    for (int x = -5; x < 5; ++x)
      for (const auto &[right, far] : kCorners) {
        glTexCoord2f(float(x + right), float(z + far));
        glVertex3f(2 * float(x + right), 0, -2 * float(z + far));
      }
  glEnd();
}

void flatQuad(float x, float y, float width, float height, float z) {
  constexpr std::array<std::array<int, 2>, 4> kCorners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  glBegin(GL_QUADS);
  for (const auto &[right, up] : kCorners) {
    glTexCoord2f(float(right), float(up));
    glVertex3f(x + width * float(right), y + height * float(up), z);
  }
  glEnd();
}

void gradientTriangle(float turn, float alpha) {
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < 3; ++i) {
    const float angle = turn + 2.1F * float(i);
    glColor4f(i == 0 ? 1.0F : 0.1F, i == 1 ? 0.9F : 0.2F, i == 2 ? 0.8F : 0.0F,
              alpha * float(i + 1) / 3);
    glVertex3f(0.95F * std::cos(angle), 0.9F * std::sin(angle), 0.1F * turn - 0.2F);
  }
  glEnd();
}

void ball() {
  constexpr int kSlices = 16, kStacks = 8;
  constexpr float kTurn = 6.2831853F;
  glPushMatrix();
  glTranslatef(0, 1.2F, -4);
  for (int stack = 0; stack < kStacks; ++stack) {
    glBegin(GL_QUAD_STRIP);
    for (int slice = 0; slice <= kSlices; ++slice)
      for (const int upper : {1, 0}) {
        const float down = kTurn * 0.5F * float(stack + 1 - upper) / kStacks;
        const float around = kTurn * float(slice) / kSlices;
        const std::array<float, 3> at = {std::sin(down) * std::cos(around), std::cos(down),
                                         std::sin(down) * std::sin(around)};
        glNormal3fv(at.data());
        glVertex3f(2 * at[0], 2 * at[1], 2 * at[2]);
      }
    glEnd();
  }
  glPopMatrix();
}

void enableLight() {
  constexpr std::array<float, 4> kWhite = {1, 1, 1, 1}, kAmber = {0.9F, 0.7F, 0.2F, 1},
                                 kAt = {1, 2, 1, 1};
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glLightfv(GL_LIGHT0, GL_POSITION, kAt.data());
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, kWhite.data());
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, kAmber.data());
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
}

void enableFog(GLenum mode) {
  constexpr std::array<float, 4> kFog = {0.2F, 0.2F, 0.3F, 1};
  glEnable(GL_FOG);
  glFogfv(GL_FOG_COLOR, kFog.data());
  glFogi(GL_FOG_MODE, GLint(mode));
  glFogf(GL_FOG_DENSITY, 0.15F);
  glFogf(GL_FOG_START, -1);
  glFogf(GL_FOG_END, 9);
}

void enableSmooth() {
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

void strokes(GLenum mode) {
  glBegin(mode);
  for (int i = 0; i < 8; ++i) {
    glColor3f(0.1F * float(i), 1 - 0.1F * float(i), i % 2 == 0 ? 1.0F : 0.3F);
    glVertex2f(-0.87F + 0.23F * float(i), i % 2 == 0 ? -0.71F : 0.83F - 0.1F * float(i));
  }
  glEnd();
}

} // namespace software
