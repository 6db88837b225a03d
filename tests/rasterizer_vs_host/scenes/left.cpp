// Draws windows that the rasterizer cannot serve: rasterizer-left FRAMES samples|mixed. Lists,
// Begin and End, arrays and a program draw in each frame. With `samples` the window has four
// samples a pixel, and the last 300 frames also draw to a texture. With `mixed` all frames but the
// last 300 contain pixels that only the host draws.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "glx_windows.h"
#include "surface.h"

namespace software {
namespace {

constexpr int kEdge = 64;
constexpr int kLast = 300; ///< frames with draws for the rasterizer

GLXFBConfig choose(Display *display, int samples) {
  const int wanted[] = {GLX_RENDER_TYPE,
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
                        samples != 0 ? 1 : 0,
                        GLX_SAMPLES,
                        samples,
                        None};
  int count = 0;
  GLXFBConfig *const all = glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
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

GLuint makeTarget() {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kEdge, kEdge, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  const GLuint framebuffer = makeFramebuffer(texture);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return framebuffer;
}

/// Draws pixels whose components are scaled, which the host does.
void drawPixels() {
  constexpr unsigned char kPixels[16] = {255, 128, 64, 255, 10,  20, 30, 255,
                                         200, 0,   0,  255, 255, 1,  2,  255};
  glPixelTransferf(GL_RED_SCALE, 0.5f);
  glRasterPos2f(-0.5f, 0.5f);
  glDrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, kPixels);
  glPixelTransferf(GL_RED_SCALE, 1);
}

void recordSome(int frame) {
  if (frame < 20 || frame % 50 == 0)
    record("frame " + std::to_string(frame), readRgba(0, 0, kEdge, kEdge));
}

void drawSampled(Display *display, GLXDrawable window, int frames) {
  const GLuint list = makeList(), framebuffer = makeTarget();
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
    recordSome(frame);
    glXSwapBuffers(display, window);
  }
}

void drawMixed(Display *display, GLXDrawable window, int frames) {
  const GLuint list = makeList();
  for (int frame = 0; frame < frames; ++frame) {
    drawScene(list, float(frame % 7) / 8);
    if (frame < frames - kLast)
      drawPixels();
    recordSome(frame);
    glXSwapBuffers(display, window);
  }
}

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  const bool sampled = argc == 3 && std::string_view(argv[2]) == "samples";
  Display *const display = XOpenDisplay(nullptr);
  GLXFBConfig const config = display ? choose(display, sampled ? 4 : 0) : nullptr;
  if (!display || argc != 3)
    return 1;
  if (!config)
    return 77; // Debian 13's X server has no windows of several samples
  const GLXDrawable window = glXCreateWindow(
      display, config, software::makeWindow(display, config, kEdge, kEdge), nullptr);
  GLXContext const context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
  if (!context || !glXMakeContextCurrent(display, window, window, context))
    return 1;
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  if (samples != (sampled ? 4 : 0))
    return 1;
  (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                    "!!ARBfp1.0\nMUL result.color, fragment.color, {1, 0.5, 0.25, 1};\nEND\n");
  glViewport(0, 0, kEdge, kEdge);
  (sampled ? drawSampled : drawMixed)(display, window, std::atoi(argv[1]));
  record("errors" + takeErrors(), {});
  return 0;
}
