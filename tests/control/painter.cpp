// Draws a textured quad with a fragment program in a window of 200x120, at some hundred frames a
// second, without knowing Arbiter. It prints each of these when it changes:
//
//   middle R G B     the middle of what it drew, read before the frame is shown
//   shown N          how many pixels of the shown window's lower left quarter are not the quad's
//   upper right N    how many of its upper right quarter
//   state NAME       a GL value that is not what it set it to, after a frame
//   error N          a GL error
//
//   painter [FRAMES [fbo|depth]]
//
// fbo: a framebuffer object stays bound, also at the end of frames. depth: draws three quads by
// arrays with the depth test: the left half, far; the whole window, near; the whole window, between
// the two.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <unistd.h>
#include <vector>

#include <epoxy/gl.h>
#include <epoxy/glx.h>

namespace {

constexpr int kWidth = 200, kHeight = 120;
constexpr const char *kProgram = "!!ARBfp1.0\n"
                                 "PARAM scale = program.local[0];\n"
                                 "PARAM tint = program.env[3];\n"
                                 "TEMP texel;\n"
                                 "TEX texel, fragment.texcoord[0], texture[0], 2D;\n"
                                 "MUL texel, texel, tint;\n"
                                 "MUL result.color, texel, scale;\n"
                                 "END\n";

Display *g_display = nullptr;
Window g_window = 0;

bool openWindow() {
  g_display = XOpenDisplay(nullptr);
  if (!g_display)
    return false;
  const int screen = DefaultScreen(g_display);
  int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 8, GLX_DEPTH_SIZE, 16, None};
  XVisualInfo *const visual = glXChooseVisual(g_display, screen, wanted);
  if (!visual)
    return false;
  const Window root = RootWindow(g_display, screen);
  XSetWindowAttributes set = {};
  set.colormap = XCreateColormap(g_display, root, visual->visual, AllocNone);
  g_window = XCreateWindow(g_display, root, 0, 0, kWidth, kHeight, 0, visual->depth, InputOutput,
                           visual->visual, CWColormap | CWBorderPixel, &set);
  XMapWindow(g_display, g_window);
  XSync(g_display, False);
  const GLXContext context = glXCreateContext(g_display, visual, nullptr, True);
  return context && glXMakeCurrent(g_display, g_window, context);
}

/// State that a frame must not change; the values differ from GL's initial ones if possible.
struct State {
  GLenum name;
  const char *word;
};
constexpr State kStates[] = {
    {GL_ACTIVE_TEXTURE, "ACTIVE_TEXTURE"},
    {GL_TEXTURE_BINDING_2D, "TEXTURE_BINDING_2D"},
    {GL_PACK_ALIGNMENT, "PACK_ALIGNMENT"},
    {GL_PACK_ROW_LENGTH, "PACK_ROW_LENGTH"},
    {GL_PACK_SKIP_ROWS, "PACK_SKIP_ROWS"},
    {GL_UNPACK_ALIGNMENT, "UNPACK_ALIGNMENT"},
    {GL_UNPACK_ROW_LENGTH, "UNPACK_ROW_LENGTH"},
    {GL_PIXEL_PACK_BUFFER_BINDING, "PIXEL_PACK_BUFFER_BINDING"},
    {GL_PIXEL_UNPACK_BUFFER_BINDING, "PIXEL_UNPACK_BUFFER_BINDING"},
    {GL_READ_FRAMEBUFFER_BINDING, "READ_FRAMEBUFFER_BINDING"},
    {GL_DRAW_FRAMEBUFFER_BINDING, "DRAW_FRAMEBUFFER_BINDING"},
    {GL_READ_BUFFER, "READ_BUFFER"},
    {GL_DRAW_BUFFER, "DRAW_BUFFER"},
    {GL_SCISSOR_TEST, "SCISSOR_TEST"},
    {GL_FRAGMENT_PROGRAM_ARB, "FRAGMENT_PROGRAM"},
    {GL_CURRENT_PROGRAM, "CURRENT_PROGRAM"},
    {GL_MATRIX_MODE, "MATRIX_MODE"},
    {GL_GREEN_SCALE, "GREEN_SCALE"},
    {GL_MAP_COLOR, "MAP_COLOR"},
    {GL_ATTRIB_STACK_DEPTH, "ATTRIB_STACK_DEPTH"},
};
using Values = std::array<GLint, std::size(kStates)>;

Values valuesNow() {
  Values values{};
  for (std::size_t i = 0; i < values.size(); ++i)
    glGetIntegerv(kStates[i].name, &values[i]);
  return values;
}

GLuint makeBuffer(GLenum target) {
  GLuint name = 0;
  glGenBuffers(1, &name);
  glBindBuffer(target, name);
  glBufferData(target, 4096, nullptr, GL_STREAM_READ);
  return name;
}

/// Makes a texture of each base format, named 11 and up on unit 3 and up, and one without a name.
void makeLooks() {
  constexpr GLenum kFormats[] = {GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_ALPHA, GL_RGB};
  std::array<unsigned char, 16> texels{};
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    texels[i] = 64;
    texels[i + 1] = 32;
    texels[i + 2] = 16;
    texels[i + 3] = 8;
  }
  for (GLuint i = 0; i < std::size(kFormats); ++i) {
    glActiveTexture(GL_TEXTURE3 + i);
    glBindTexture(GL_TEXTURE_2D, 11 + i);
    glTexImage2D(GL_TEXTURE_2D, 0, GLint(kFormats[i]), 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
  }
  glActiveTexture(GL_TEXTURE0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
}

void makeObjects(bool framebuffer) {
  makeLooks();
  // GenTextures did not return this name.
  glBindTexture(GL_TEXTURE_2D, 5);
  std::vector<unsigned char> white(16 * 16 * 4, 255);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, 7);
  glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB,
                     GLsizei(std::strlen(kProgram)), kProgram);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  if (framebuffer) {
    GLuint name = 0, color = 0;
    glGenRenderbuffers(1, &color);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 32, 32);
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
  }
}

/// Sets the state as an application might leave it at the end of a frame.
void setOddState(bool framebuffer, GLuint name, const std::array<GLuint, 2> &buffers) {
  glActiveTexture(GL_TEXTURE2);
  glPixelStorei(GL_PACK_ALIGNMENT, 8);
  glPixelStorei(GL_PACK_ROW_LENGTH, 77);
  glPixelStorei(GL_PACK_SKIP_ROWS, 3);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 33);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffers[0]);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffers[1]);
  glPixelTransferf(GL_GREEN_SCALE, 0);
  glEnable(GL_SCISSOR_TEST);
  glScissor(1, 1, 2, 2);
  glMatrixMode(GL_TEXTURE);
  if (framebuffer)
    glBindFramebuffer(GL_FRAMEBUFFER, name);
}

void setPlainState() {
  glActiveTexture(GL_TEXTURE0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glPixelStorei(GL_PACK_SKIP_ROWS, 0);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glPixelTransferf(GL_GREEN_SCALE, 1);
  glDisable(GL_SCISSOR_TEST);
  glMatrixMode(GL_MODELVIEW);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void drawFrame() {
  glViewport(0, 0, kWidth, kHeight);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 1, 1, 0, 1);
  glProgramEnvParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 3, 1, 1, 1, 1);
  glColor4f(0, 0, 1, 1);
  glBegin(GL_QUADS);
  for (const auto &[x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    glTexCoord2f(GLfloat(x + 1) / 2, GLfloat(y + 1) / 2);
    glVertex2i(x, y);
  }
  glEnd();
}

void drawQuad(float left, float depth, bool byElements) {
  const std::array<float, 12> corners = {left, -1, depth, 1,    -1, depth,
                                         1,    1,  depth, left, 1,  depth};
  const std::array<GLushort, 4> order = {0, 1, 2, 3};
  glVertexPointer(3, GL_FLOAT, 0, corners.data());
  if (byElements)
    glDrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, order.data());
  else
    glDrawArrays(GL_QUADS, 0, 4);
}

void drawDepths() {
  glViewport(0, 0, kWidth, kHeight);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glProgramEnvParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 3, 1, 1, 1, 1);
  glEnable(GL_DEPTH_TEST);
  glEnableClientState(GL_VERTEX_ARRAY);
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 1, 0, 0, 1);
  glScissor(0, 0, kWidth / 2, kHeight);
  glEnable(GL_SCISSOR_TEST);
  drawQuad(-1, 0.75f, false);
  glDisable(GL_SCISSOR_TEST);
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 1, 1, 0, 1);
  drawQuad(-1, 0.25f, true);
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 0, 0, 1, 1);
  drawQuad(-1, 0.5f, false);
  glDisableClientState(GL_VERTEX_ARRAY);
  glDisable(GL_DEPTH_TEST);
}

/// Prints a line if it differs from the last one of its kind.
void say(std::string &last, const std::string &line) {
  if (line == last)
    return;
  std::puts(line.c_str());
  std::fflush(stdout);
  last = line;
}

std::string middle() {
  unsigned char pixel[4] = {};
  glReadPixels(kWidth / 2, kHeight / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  return "middle " + std::to_string(pixel[0]) + " " + std::to_string(pixel[1]) + " " +
         std::to_string(pixel[2]);
}

/// Counts the pixels in a quarter of the window that differ from the pixel next to the middle.
std::string othersOf(const char *word, int left, int top) {
  XSync(g_display, False);
  XImage *const image =
      XGetImage(g_display, g_window, left, top, kWidth / 2, kHeight / 2, AllPlanes, ZPixmap);
  if (!image)
    return std::string(word) + " nothing";
  int other = 0;
  const unsigned long quad =
      XGetPixel(image, left == 0 ? kWidth / 2 - 1 : 0, top == 0 ? kHeight / 2 - 1 : 0);
  for (int y = 0; y < kHeight / 2; ++y)
    for (int x = 0; x < kWidth / 2; ++x)
      other += XGetPixel(image, x, y) != quad;
  XDestroyImage(image);
  return std::string(word) + " " + std::to_string(other);
}

} // namespace

int main(int argc, char **argv) {
  const long frames = argc > 1 ? std::atol(argv[1]) : -1;
  const bool framebuffer = argc > 2 && std::strcmp(argv[2], "fbo") == 0;
  const bool depth = argc > 2 && std::strcmp(argv[2], "depth") == 0;
  if (!openWindow()) {
    std::puts("no window");
    return 1;
  }
  makeObjects(framebuffer);
  GLint name = 0;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &name);
  const std::array<GLuint, 2> buffers = {makeBuffer(GL_PIXEL_PACK_BUFFER),
                                         makeBuffer(GL_PIXEL_UNPACK_BUFFER)};
  std::string lastMiddle, lastShown, lastUpper, lastState;
  for (long frame = 0; frame != frames; ++frame) {
    setPlainState();
    depth ? drawDepths() : drawFrame();
    say(lastMiddle, middle());
    setOddState(framebuffer, GLuint(name), buffers);
    const Values before = valuesNow();
    glXSwapBuffers(g_display, g_window);
    const Values after = valuesNow();
    for (std::size_t i = 0; i < after.size(); ++i)
      if (after[i] != before[i])
        say(lastState, std::string("state ") + kStates[i].word);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
      say(lastState, "error " + std::to_string(error));
    if (frame % 5 == 4) {
      say(lastShown, othersOf("shown", 0, kHeight / 2));
      say(lastUpper, othersOf("upper right", kWidth / 2, 0));
    }
    usleep(8000);
  }
  return 0;
}
