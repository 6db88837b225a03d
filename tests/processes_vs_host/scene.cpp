// The scene of the process tests, through GLX or EGL as linked libraries.
#include "foreign.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <pthread.h>

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>

namespace foreign {

namespace {

constexpr int kSide = 64;
Display *g_display = nullptr;
Window g_window = 0;
GLXContext g_glx = nullptr;
EGLDisplay g_eglDisplay = EGL_NO_DISPLAY;
EGLSurface g_eglSurface = EGL_NO_SURFACE;
EGLContext g_egl = EGL_NO_CONTEXT;
XVisualInfo *g_visual = nullptr;
EGLConfig g_config = nullptr;
unsigned char g_pixels[kSide][kSide][4];
volatile std::sig_atomic_t g_inMidst = 0;

void openEgl() {
  g_eglDisplay = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  need(eglInitialize(g_eglDisplay, nullptr, nullptr) && eglBindAPI(EGL_OPENGL_API), "EGL");
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_DEPTH_SIZE,
                           16,
                           EGL_NONE};
  EGLint count = 0;
  need(eglChooseConfig(g_eglDisplay, wanted, &g_config, 1, &count) && count == 1, "EGL config");
  const EGLint size[] = {EGL_WIDTH, kSide, EGL_HEIGHT, kSide, EGL_NONE};
  g_eglSurface = eglCreatePbufferSurface(g_eglDisplay, g_config, size);
  g_egl = eglCreateContext(g_eglDisplay, g_config, EGL_NO_CONTEXT, nullptr);
  need(g_egl != EGL_NO_CONTEXT, "EGL context");
}

void openGlx() {
  g_display = XOpenDisplay(nullptr);
  need(g_display != nullptr, "display");
  int attributes[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 8, GLX_DEPTH_SIZE, 16, None};
  XVisualInfo *const visual = g_visual =
      glXChooseVisual(g_display, DefaultScreen(g_display), attributes);
  need(visual != nullptr, "visual");
  XSetWindowAttributes set = {};
  const Window root = DefaultRootWindow(g_display);
  set.colormap = XCreateColormap(g_display, root, visual->visual, AllocNone);
  g_window = XCreateWindow(g_display, root, 0, 0, kSide, kSide, 0, visual->depth, InputOutput,
                           visual->visual, CWColormap | CWBorderPixel, &set);
  XMapWindow(g_display, g_window);
  XSync(g_display, False);
  g_glx = glXCreateContext(g_display, visual, nullptr, True);
  need(g_glx != nullptr, "GLX context");
}

GLuint load(GLenum target, const std::string &text) {
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glBindProgramARB(target, name);
  glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.data());
  return name;
}

/// Returns a term that makes a program new to every process. A comment would not do, as machine
/// code is cached by a program's meaning. The term changes the color by less than a byte shows.
std::string freshTerm() {
  static unsigned s_count = 0;
  static const unsigned s_seed =
      unsigned(std::getenv("FOREIGN_SEED") ? std::atoi(std::getenv("FOREIGN_SEED")) : 1);
  char text[96];
  std::snprintf(text, sizeof text, "ADD c.x, c.x, 0.0000%04u%05u;\n", s_seed % 10000,
                ++s_count % 100000);
  for (char *at = text; *at; ++at) // a program's decimal point must not be the locale's comma
    if (*at == ',' && at[1] >= '0' && at[1] <= '9')
      *at = '.';
  return text;
}

struct Programs {
  GLuint vertex, fragment, texture, displacement;
};
Programs g_programs;

/// Makes a texture of ones: a vertex program that displaces vertices by it moves nothing.
GLuint makeDisplacement() {
  static unsigned char s_texels[16][16][4];
  std::memset(s_texels, 255, sizeof s_texels);
  GLuint name = 0;
  glActiveTexture(GL_TEXTURE1);
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, s_texels);
  glActiveTexture(GL_TEXTURE0);
  return name;
}

Programs makePrograms(const std::string &term) {
  Programs made = {};
  // The bare host draws the same without the texture.
  const bool samples = std::getenv("FOREIGN_VERTEX_TEXTURE") != nullptr;
  if (samples) {
    const auto *const extensions = reinterpret_cast<const char *>(glGetString(GL_EXTENSIONS));
    need(extensions && std::strstr(extensions, "GL_NV_vertex_program3"), "NV_vertex_program3");
    made.displacement = makeDisplacement();
  }
  const std::string moved = "TXL d, vertex.texcoord[0], texture[1], 2D;\nMUL p.xy, p, d;\n";
  made.vertex = load(
      GL_VERTEX_PROGRAM_ARB,
      std::string("!!ARBvp1.0\n") + (samples ? "OPTION NV_vertex_program3;\n" : "") +
          "PARAM scale = {0.75, 0.75, 1, 1};\nTEMP p, d;\n"
          "MUL p, vertex.position, scale;\n" +
          (samples ? moved : std::string()) +
          "DP4 result.position.x, state.matrix.mvp.row[0], p;\n"
          "DP4 result.position.y, state.matrix.mvp.row[1], p;\n"
          "DP4 result.position.z, state.matrix.mvp.row[2], p;\n"
          "DP4 result.position.w, state.matrix.mvp.row[3], p;\n"
          "MOV result.color, vertex.color;\nMOV result.texcoord[0], vertex.texcoord[0];\nEND\n");
  made.fragment =
      load(GL_FRAGMENT_PROGRAM_ARB,
           "!!ARBfp1.0\nTEMP c;\nTEX c, fragment.texcoord[0], texture[0], 2D;\n"
           "MUL c, c, fragment.color;\nMAD_SAT c, c, program.local[0], {0.125, 0.25, 0, 0};\n" +
               term + "MOV result.color, c;\nEND\n");
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 1.0f, 0.5f, 0.75f, 1.0f);
  glGenTextures(1, &made.texture);
  glBindTexture(GL_TEXTURE_2D, made.texture);
  unsigned char texels[8][8][4];
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const unsigned char texel[4] = {static_cast<unsigned char>(x * 32),
                                      static_cast<unsigned char>(y * 32), 128, 255};
      std::memcpy(texels[y][x], texel, 4);
    }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  return made;
}

void drop(Programs &programs) {
  glDeleteProgramsARB(1, &programs.vertex);
  glDeleteProgramsARB(1, &programs.fragment);
  glDeleteTextures(1, &programs.texture);
  glDeleteTextures(1, &programs.displacement);
}

/// Draws many triangles in few draws, so that several threads have work.
void drawGrid() {
  constexpr int kCells = 24;
  static float s_vertices[kCells * kCells * 6][5];
  static bool s_made = false;
  for (int i = 0; !s_made && i < kCells * kCells * 6; ++i) {
    static const int kCorners[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    const int *const corner = kCorners[i % 6];
    const float x = float(i / 6 % kCells + corner[0]) / kCells;
    const float y = float(i / 6 / kCells + corner[1]) / kCells;
    const float row[5] = {x, y, 2 * x - 1, 2 * y - 1, 0};
    std::memcpy(s_vertices[i], row, sizeof row);
  }
  s_made = true;
  glInterleavedArrays(GL_T2F_V3F, 0, s_vertices);
  glColor4f(1.0f, 0.75f, 0.5f, 1.0f);
  glDrawArrays(GL_TRIANGLES, 0, kCells * kCells * 6);
}

} // namespace

void need(bool good, const char *what) {
  if (good)
    return;
  std::fprintf(stderr, "foreign: %s failed\n", what);
  std::_Exit(4);
}

void makeCurrent(bool current) {
  if (g_egl != EGL_NO_CONTEXT)
    need(current ? eglMakeCurrent(g_eglDisplay, g_eglSurface, g_eglSurface, g_egl)
                 : eglMakeCurrent(g_eglDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT),
         "eglMakeCurrent");
  else
    need(glXMakeCurrent(g_display, current ? g_window : None, current ? g_glx : nullptr),
         "glXMakeCurrent");
}

void openContext() {
  if (std::getenv("FOREIGN_EGL"))
    openEgl();
  else
    openGlx();
  makeCurrent(true);
}

void onOtherContext(const std::function<void()> &body) {
  const bool egl = g_egl != EGL_NO_CONTEXT;
  GLXContext glx = nullptr;
  EGLContext context = EGL_NO_CONTEXT;
  EGLSurface surface = EGL_NO_SURFACE;
  const EGLint size[] = {EGL_WIDTH, 8, EGL_HEIGHT, 8, EGL_NONE};
  if (egl) {
    surface = eglCreatePbufferSurface(g_eglDisplay, g_config, size);
    context = eglCreateContext(g_eglDisplay, g_config, g_egl, nullptr);
    need(eglBindAPI(EGL_OPENGL_API) && eglMakeCurrent(g_eglDisplay, surface, surface, context),
         "another context");
  } else {
    glx = glXCreateContext(g_display, g_visual, g_glx, True);
    need(glx && glXMakeCurrent(g_display, g_window, glx), "another context");
  }
  body();
  need(glGetError() == GL_NO_ERROR, "a GL command of the other context");
  if (egl) {
    eglMakeCurrent(g_eglDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(g_eglDisplay, context);
    eglDestroySurface(g_eglDisplay, surface);
  } else {
    glXMakeCurrent(g_display, None, nullptr);
    glXDestroyContext(g_display, glx);
  }
}

void deleteTextures() {
  const GLuint names[] = {g_programs.texture, g_programs.displacement};
  glDeleteTextures(2, names);
  glFlush();
}

void drawFrame(bool fresh) {
  if (fresh || !g_programs.vertex) {
    if (g_programs.vertex)
      drop(g_programs);
    g_programs = makePrograms(fresh ? freshTerm() : std::string());
  }
  glViewport(0, 0, kSide, kSide);
  glClearColor(0.125f, 0.25f, 0.5f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_VERTEX_PROGRAM_ARB);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glBindProgramARB(GL_VERTEX_PROGRAM_ARB, g_programs.vertex);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, g_programs.fragment);
  drawGrid();
  glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, g_pixels);
  if (g_egl != EGL_NO_CONTEXT)
    eglSwapBuffers(g_eglDisplay, g_eglSurface);
  else
    glXSwapBuffers(g_display, g_window);
  need(glGetError() == GL_NO_ERROR, "a GL command");
}

void drawAndPrint() {
  drawFrame();
  char line[8 + kSide / 4 * kSide / 4 * 6 + 2] = "picture ";
  char *at = line + 8;
  for (int y = 2; y < kSide; y += 4)
    for (int x = 2; x < kSide; x += 4)
      for (int c = 0; c < 3; ++c)
        at += std::snprintf(at, 3, "%02x", g_pixels[y][x][c]);
  *at++ = '\n';
  std::fwrite(line, 1, std::size_t(at - line), stdout);
  std::fflush(stdout);
}

void drawBitmaps() {
  static GLuint s_program = 0;
  if (!s_program)
    s_program = load(GL_FRAGMENT_PROGRAM_ARB,
                     "!!ARBfp1.0\nMUL result.color, fragment.color, {1, 0.5, 0.75, 1};\nEND\n");
  glViewport(0, 0, kSide, kSide);
  glClearColor(0.25f, 0.125f, 0.5f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_VERTEX_PROGRAM_ARB);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, s_program);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  static unsigned char s_bits[kSide / 8 * kSide];
  for (int i = 0; i < kSide / 8 * kSide; ++i)
    s_bits[i] = static_cast<unsigned char>(37 * i);
  for (int i = 0; i < 40; ++i) {
    glColor4f(float(i % 4) / 4, float(i % 3) / 2, 1, 1);
    glWindowPos2i(i % 7, i % 5);
    g_inMidst = 1;
    glBitmap(kSide - 8, kSide - 8, 0, 0, 1, 1, s_bits);
    g_inMidst = 0;
  }
  glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, g_pixels);
  need(glGetError() == GL_NO_ERROR, "a GL command");
}

void drawManyPixels() {
  constexpr int kLarge = 512;
  static GLuint s_program = 0;
  if (!s_program) {
    std::string text = "!!ARBfp1.0\nTEMP c;\nMOV c, fragment.color;\n";
    for (int i = 0; i < 10; ++i)
      text += "POW c.x, c.x, c.y;\nEX2 c.y, c.x;\nLG2 c.z, c.y;\n";
    s_program = load(GL_FRAGMENT_PROGRAM_ARB, text + "MOV result.color, c;\nEND\n");
    GLuint texture = 0, framebuffer = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kLarge, kLarge, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glGenFramebuffersEXT(1, &framebuffer);
    glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, framebuffer);
    glFramebufferTexture2DEXT(GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_TEXTURE_2D, texture,
                              0);
  }
  glViewport(0, 0, kLarge, kLarge);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, s_program);
  glColor4f(0.5f, 0.75f, 0.25f, 1.0f);
  g_inMidst = 1;
  glRectf(-1, -1, 1, 1);
  g_inMidst = 0;
  need(glGetError() == GL_NO_ERROR, "a GL command");
}

bool isInMidst() { return g_inMidst != 0; }

void drawForEver(bool fresh) {
  for (;;)
    drawFrame(fresh);
}

void onThread(unsigned long stackBytes, const std::function<void()> &body) {
  pthread_attr_t attributes;
  pthread_t thread;
  pthread_attr_init(&attributes);
  need(pthread_attr_setstacksize(&attributes, stackBytes) == 0, "the stack's size");
  need(pthread_create(
           &thread, &attributes,
           [](void *argument) -> void * {
             (*static_cast<const std::function<void()> *>(argument))();
             return nullptr;
           },
           const_cast<std::function<void()> *>(&body)) == 0,
       "a thread");
  pthread_join(thread, nullptr);
}

} // namespace foreign
