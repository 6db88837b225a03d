// Still pictures of programs, vertex sources, images and framebuffers.
#include <array>
#include <cstddef>

#include "still_parts.h"
#include "still_scenes.h"
#include "surface.h"

namespace software {
namespace {

// --- Programs ---

void makeMathProgram() {
  makeTexture();
  (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                    "!!ARBfp1.0\nTEMP t, u;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
                    "DP3 u.w, t, t;\nRSQ u.w, u.w;\nMUL u.xyz, t, u.w;\n"
                    "LIT u, u.xyxz;\nPOW t.x, t.x, u.y;\nEX2 t.y, u.z;\nLG2 t.z, t.y;\n"
                    "MAD result.color, t, 0.5, fragment.color;\nEND\n");
}

void makeVertexProgram() {
  makeTexture();
  (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB, kTexturedText);
  (void)makeProgram(
      GL_VERTEX_PROGRAM_ARB,
      "!!ARBvp1.0\nOPTION ARB_position_invariant;\nMOV result.color, {1, 1, 0.5, 1};\n"
      "MUL result.texcoord[0], vertex.texcoord[0], 0.5;\nEND\n");
}

void floorByPrograms() {
  floorView();
  glEnable(GL_VERTEX_PROGRAM_ARB);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  floorQuads();
}

void floorByFragments() {
  floorView();
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glColor3f(0.2F, 0.1F, 0.3F);
  floorQuads();
}

// --- Environments and other kinds of textures ---

void environments() {
  glEnable(GL_TEXTURE_2D);
  glColor4f(0.9F, 0.5F, 0.7F, 0.5F);
  int i = 0;
  for (const GLint mode : {GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD, GL_REPLACE, GL_COMBINE}) {
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
    flatQuad(-1 + 0.3F * float(i), -0.8F + 0.1F * float(i), 0.4F, 0.7F, 0);
    ++i;
  }
}

void makeCube() {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_CUBE_MAP, texture);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  for (GLenum face = 0; face < 6; ++face) {
    std::array<unsigned char, std::size_t(4) * 4 * 4> texels{};
    for (std::size_t i = 0; i < texels.size(); ++i)
      texels[i] = (unsigned char)(i * 7 + face * 31);
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, 4, 4, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, texels.data());
  }
}

void cube() {
  floorView();
  glEnable(GL_TEXTURE_CUBE_MAP);
  for (const GLenum coordinate : {GL_S, GL_T, GL_R})
    glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP);
  for (const GLenum coordinate : {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R})
    glEnable(coordinate);
  ball();
}

void makeShadow() {
  constexpr int kTexels = 16;
  std::array<float, std::size_t(kTexels) * kTexels> depths{};
  for (std::size_t i = 0; i < depths.size(); ++i)
    depths[i] = float(i % 13) / 13;
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kTexels, kTexels, 0, GL_DEPTH_COMPONENT,
               GL_FLOAT, depths.data());
}

void shadow() {
  glEnable(GL_TEXTURE_2D);
  glMultiTexCoord3f(GL_TEXTURE0, 0, 0, 0.5F);
  flatQuad(-0.8F, -0.8F, 1.6F, 1.6F, 0);
}

/// Draws to a buffer of few bits a component, and from it.
void makePacked() {
  makeTexture();
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_FALSE);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB565, kStillEdge, kStillEdge, 0, GL_RGB,
               GL_UNSIGNED_SHORT_5_6_5, nullptr);
  makeFramebuffer(texture);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void packed() {
  const GLuint own = boundTexture();
  glEnable(GL_TEXTURE_2D);
  glBindFramebuffer(GL_FRAMEBUFFER, 1);
  glViewport(0, 0, kStillEdge, kStillEdge);
  glBindTexture(GL_TEXTURE_2D, own - 1);
  glColor3f(1, 0.8F, 0.7F);
  flatQuad(-1, -1, 2, 2, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glBindTexture(GL_TEXTURE_2D, own);
  glColor3f(1, 1, 1);
  flatQuad(-0.9F, -0.9F, 1.5F, 1.8F, 0);
}

/// Uses the picture so far as a texture of the next draw.
void makeCopy() {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, kStillEdge, kStillEdge, 0, GL_RGB, GL_UNSIGNED_BYTE,
               nullptr);
}

void copied() {
  gradientTriangle(0.3F);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, kStillEdge, kStillEdge);
  glEnable(GL_TEXTURE_2D);
  glColor3f(1, 1, 1);
  flatQuad(-0.5F, -0.5F, 1.4F, 1.3F, 0);
}

/// Makes a copy with a filter that samples along the longer axis.
void makeAnisotropicCopy() {
  makeTexture();
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
  makeCopy();
}

void copiedAnisotropic() {
  const GLuint copy = boundTexture();
  glBindTexture(GL_TEXTURE_2D, copy - 1);
  glEnable(GL_TEXTURE_2D);
  glPushAttrib(GL_TRANSFORM_BIT);
  floorView();
  floorQuads();
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glPopAttrib();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, copy);
  copied();
}

void drawnPixels() {
  gradientTriangle(0.5F);
  std::array<unsigned char, std::size_t(16) * 16 * 4> pixels{};
  for (std::size_t i = 0; i < pixels.size(); ++i)
    pixels[i] = (unsigned char)(i * 5);
  glRasterPos2f(-0.4F, -0.3F);
  glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  glCopyPixels(10, 10, 30, 20, GL_COLOR);
  gradientTriangle(0.9F);
}

// --- Where vertices come from ---

GLuint g_list = 0;

void makeLists() {
  makeTexture();
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 4);
  g_list = glGenLists(2);
  glNewList(g_list, GL_COMPILE);
  floorQuads();
  glEndList();
  glNewList(g_list + 1, GL_COMPILE);
  ball();
  glEndList();
}

void calledLists() {
  floorView();
  glCallList(g_list + 1);
  glEnable(GL_TEXTURE_2D);
  glCallList(g_list);
}

void arrays() {
  static const std::array<float, 24> kPlaces = {-0.9F, -0.9F, 0,    0.9F,  -0.7F, 0.2F, 0.2F, 0.8F,
                                                0.4F,  -0.5F, 0.9F, 0,     0.8F,  0.7F, 0,    -0.8F,
                                                0.3F,  0.1F,  0.1F, -0.2F, 0,     0.5F, 0.3F, 0.6F};
  static const std::array<float, 24> kColors = {1, 0, 0, 0, 1, 0, 0,    0,    1, 1, 1,    0,
                                                0, 1, 1, 1, 0, 1, 0.5F, 0.2F, 1, 0, 0.3F, 0.9F};
  static const std::array<GLushort, 9> kIndices = {0, 1, 2, 3, 4, 5, 6, 7, 0};
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, kPlaces.data());
  glColorPointer(3, GL_FLOAT, 0, kColors.data());
  glEnable(GL_DEPTH_TEST);
  glDrawElements(GL_TRIANGLES, GLsizei(kIndices.size()), GL_UNSIGNED_SHORT, kIndices.data());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 8);
}

/// Sets a material for each vertex of a primitive.
void materials() {
  floorView();
  enableLight();
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < 9; ++i) {
    const std::array<float, 4> color = {0.1F * float(i), 1 - 0.1F * float(i), 0.4F, 1};
    glMaterialfv(GL_FRONT, GL_DIFFUSE, color.data());
    glNormal3f(0.3F * float(i % 3), 0.2F, 1);
    glVertex3f(-3 + 0.7F * float(i), i % 3 == 1 ? 2.5F : 0.2F, -3 - 0.2F * float(i));
  }
  glEnd();
}

void flatShaded() {
  glShadeModel(GL_FLAT);
  gradientTriangle(0.2F);
  gradientTriangle(0.9F);
}

} // namespace

const std::vector<StillScene> &otherStillScenes() {
  static const std::vector<StillScene> s_scenes = {
      {"math", makeMathProgram, floorByFragments},
      {"vertex-program", makeVertexProgram, floorByPrograms},
      {"environments", makeTexture, environments},
      {"cube", makeCube, cube},
      {"shadow", makeShadow, shadow},
      {"packed", makePacked, packed},
      {"copied", makeCopy, copied},
      {"copied-anisotropic", makeAnisotropicCopy, copiedAnisotropic},
      {"drawn-pixels", nullptr, drawnPixels},
      {"lists", makeLists, calledLists},
      {"arrays", nullptr, arrays},
      {"materials", nullptr, materials},
      {"flat", nullptr, flatShaded},
  };
  return s_scenes;
}

} // namespace software
