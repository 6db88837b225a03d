// Lists the scenes by name, and defines what they share.
#include "allocation_scenes.h"

namespace memory {

GLuint load(GLenum target, const std::string &text) {
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glBindProgramARB(target, name);
  glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.data());
  return name;
}

std::string fresh(const std::string &body, const char *header, int round) {
  return std::string(header) + "\n# " + std::to_string(round) + "\n" + body + "END\n";
}
void setParameters() {
  glProgramEnvParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 1, 0.7f, 0.6f, 0.9f, 1);
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 2, 0.1f, 0.2f, 0.05f, 0);
  glProgramLocalParameter4fARB(GL_VERTEX_PROGRAM_ARB, 0, 1, 0.8f, 0.9f, 1);
}

void enablePrograms() {
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glEnable(GL_VERTEX_PROGRAM_ARB);
}

std::vector<unsigned char> texelsOf(int side, int seed) {
  std::vector<unsigned char> texels(std::size_t(side) * std::size_t(side) * 4);
  for (std::size_t i = 0; i < texels.size(); ++i)
    texels[i] = static_cast<unsigned char>(i * 37 + std::size_t(seed) * 91 + (i >> 5));
  return texels;
}

GLuint makeTexture(int side, int seed) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texelsOf(side, seed).data());
  return name;
}

void quad(float left, float right) {
  glBegin(GL_QUADS);
  glColor4f(1, 0.9f, 0.8f, 1);
  glTexCoord2f(kOff, kOff), glVertex2f(left, -1);
  glTexCoord2f(1 + kOff, kOff), glVertex2f(right, -1);
  glTexCoord2f(1 + kOff, 1 + kOff), glVertex2f(right, 1);
  glTexCoord2f(kOff, 1 + kOff), glVertex2f(left, 1);
  glEnd();
}

Kept g_kept;

void makeKept(Surface &) {
  g_kept.fragment = load(GL_FRAGMENT_PROGRAM_ARB, fresh(kFragment, "!!ARBfp1.0", -1));
  g_kept.vertex = load(GL_VERTEX_PROGRAM_ARB, fresh(kVertex, "!!ARBvp1.0", -1));
  setParameters();
  g_kept.texture = makeTexture(16, 3);
  g_kept.list = glGenLists(1);
  glNewList(g_kept.list, GL_COMPILE);
  quad(-0.5f, 0.5f);
  glEndList();
}

void useKept() {
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, g_kept.fragment);
  glBindProgramARB(GL_VERTEX_PROGRAM_ARB, g_kept.vertex);
  glBindTexture(GL_TEXTURE_2D, g_kept.texture);
  setParameters();
  enablePrograms();
}

GLenum takeErrorOf(Surface &window) {
  const GLenum error = glGetError();
  window.refused = window.refused || error == GL_OUT_OF_MEMORY;
  return error;
}

const std::vector<Scene> kScenes = {
    {"programs", makeKept, programs},
    {"compiles", makeKept, compiles},
    {"draws", makeKept, draws},
    {"triangles", makeKept, manyTriangles},
    {"lists", makeKept, lists},
    {"copies", makeKept, copies},
    {"textures", makeKept, textures},
    {"shown", makeKept, shown},
    {"contexts", makeKept, contexts},
    {"first-draws", makeKept, firstDraws},
    {"shaders", makeKept, fragmentShaders},
    {"named", makeKept, named},
};

} // namespace memory
