// A window of four samples a pixel, in which nothing is the rasterizer's: rasterizer-left FRAMES.
// Lists, Begin and End, arrays and a program draw in each frame. In the last hundred frames a
// texture is drawn to as well.
#include <cstdio>
#include <cstdlib>

#include "glx_windows.h"
#include "surface.h"

namespace software {
namespace {

constexpr int kEdge = 64;
constexpr int kLast = 100; ///< frames that draw to a texture too

GLXFBConfig chooseSampled(Display *display) {
  constexpr int kWanted[] = {GLX_RENDER_TYPE,
                             GLX_RGBA_BIT,
                             GLX_RED_SIZE,
                             8,
                             GLX_GREEN_SIZE,
                             8,
                             GLX_BLUE_SIZE,
                             8,
                             GLX_DEPTH_SIZE,
                             24,
                             GLX_DOUBLEBUFFER,
                             True,
                             GLX_SAMPLE_BUFFERS,
                             1,
                             GLX_SAMPLES,
                             4,
                             None};
  int count = 0;
  GLXFBConfig *const all = glXChooseFBConfig(display, DefaultScreen(display), kWanted, &count);
  return count > 0 ? all[0] : nullptr;
}

GLuint makeList() {
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glBegin(GL_TRIANGLES);
  glColor4f(1, 0.5f, 0, 0.5f);
  glVertex3f(-1, -1, 0.2f);
  glVertex3f(0.75f, -0.5f, -0.2f);
  glVertex3f(-0.25f, 1, 0);
  glEnd();
  glDisable(GL_BLEND);
  glEndList();
  return list;
}

void drawScene(GLuint list, float place) {
  constexpr GLfloat kCorners[6] = {0, 0, 1, 0.25f, 0.25f, 1};
  glClearColor(0.1f, 0.2f, 0.3f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glBegin(GL_QUADS);
  glColor3f(0, 1, 0.5f);
  glVertex2f(-0.9f, place - 0.5f);
  glVertex2f(0.1f, -0.9f);
  glVertex2f(0.3f, 0.2f);
  glVertex2f(-0.7f, 0.4f);
  glEnd();
  glCallList(list);
  glColor3f(0.25f, 0.5f, 1);
  glVertexPointer(2, GL_FLOAT, 0, kCorners);
  glEnableClientState(GL_VERTEX_ARRAY);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glRectf(0.5f, -1, 1, place);
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
}

GLuint makeFramebuffer() {
  GLuint texture = 0, framebuffer = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kEdge, kEdge, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return framebuffer;
}

void draw(Display *display, GLXDrawable window, int frames) {
  (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                    "!!ARBfp1.0\nMUL result.color, fragment.color, {1, 0.5, 0.25, 1};\nEND\n");
  const GLuint list = makeList(), framebuffer = makeFramebuffer();
  glViewport(0, 0, kEdge, kEdge);
  for (int frame = 0; frame < frames; ++frame) {
    const float place = float(frame % 7) / 8;
    if (frame >= frames - kLast) {
      glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      drawScene(list, place);
      if (frame % 10 == 0)
        record("texture in frame " + std::to_string(frame), readRgba(0, 0, kEdge, kEdge));
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }
    drawScene(list, place);
    if (frame < 20 || frame % 50 == 0)
      record("frame " + std::to_string(frame), readRgba(0, 0, kEdge, kEdge));
    glXSwapBuffers(display, window);
  }
  record("errors" + takeErrors(), {});
}

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  Display *const display = XOpenDisplay(nullptr);
  GLXFBConfig const config = display ? chooseSampled(display) : nullptr;
  if (!config || argc != 2)
    return 1;
  const GLXDrawable window = glXCreateWindow(
      display, config, software::makeWindow(display, config, kEdge, kEdge), nullptr);
  GLXContext const context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
  if (!context || !glXMakeContextCurrent(display, window, window, context))
    return 1;
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  if (samples != 4)
    return 1;
  draw(display, window, std::atoi(argv[1]));
  return 0;
}
