// Runs one scene of what no careful program does: rasterizer-safety NAME, or --list.
#include "safety.h"

#include <cstdio>

namespace software {

void note(const std::string &what) {
  record(what + ":" + takeErrors(), {});
  std::fflush(stdout);
}

void picture(const std::string &what) {
  record("picture " + what, readRgba(0, 0, kSide, kSide));
  note(what);
}

void useFragments(const std::string &body) {
  (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB, "!!ARBfp1.0\n" + body + "END\n");
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
}

void wholeQuad(float s0, float t0, float s1, float t1) {
  glBegin(GL_QUADS);
  glTexCoord2f(s0, t0), glVertex2f(-1, -1);
  glTexCoord2f(s1, t0), glVertex2f(1, -1);
  glTexCoord2f(s1, t1), glVertex2f(1, 1);
  glTexCoord2f(s0, t1), glVertex2f(-1, 1);
  glEnd();
}

GLuint smoothTexture(int width, int height, GLenum minFilter) {
  GLuint name = 0;
  std::vector<unsigned char> texels;
  texels.reserve(std::size_t(width) * std::size_t(height) * 4);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int value : {x * 255 / width, y * 255 / height, (x + y) % 64, 255})
        texels.push_back(static_cast<unsigned char>(value));
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GLint(minFilter));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texels.data());
  return name;
}

} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  std::vector<Hazard> all = kVertexHazards;
  all.insert(all.end(), kTextureHazards.begin(), kTextureHazards.end());
  all.insert(all.end(), kCommandHazards.begin(), kCommandHazards.end());
  const Hazard *const hazard = rowNamed(all, argc, argv);
  if (!hazard) {
    std::fprintf(stderr, "usage: rasterizer-safety NAME | --list\n");
    return 2;
  }
  software::Screen screen;
  if (!screen.open())
    return 1;
  const GLXDrawable window = screen.makeWindow(kSide, kSide);
  const GLXContext context = screen.makeContext();
  screen.makeCurrent(window, context);
  glDisable(GL_DITHER);
  glViewport(0, 0, kSide, kSide);
  glClearColor(0.1f, 0.2f, 0.3f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  hazard->run();
  // After any hazard a simple picture must still be right.
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, kSide, kSide);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_VERTEX_PROGRAM_ARB);
  useFragments("MOV result.color, fragment.color;\n");
  glColor4ub(10, 200, 30, 255);
  wholeQuad();
  picture("afterwards");
  screen.swap(window);
  screen.destroy(context);
  return 0;
}
