// The context, programs and textures that the scenes of sharing-storage share.
#include <cstdlib>
#include <string>

#include <epoxy/egl.h>

#include "storage.h"

namespace storage {

namespace {

struct World {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLConfig config = nullptr;
  EGLContext context = EGL_NO_CONTEXT;
  GLuint plain = 0, sampling = 0; ///< programs
  GLuint target = 0;              ///< a framebuffer
};
World g_world;

EGLContext makeContext(EGLContext share, EGLint profile) {
  const EGLint attributes[] = {EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               profile,
                               EGL_CONTEXT_MAJOR_VERSION,
                               4,
                               EGL_CONTEXT_MINOR_VERSION,
                               3,
                               EGL_NONE};
  return eglCreateContext(g_world.display, g_world.config, share, attributes);
}

} // namespace

void skip(const char *why) {
  std::fprintf(stderr, "sharing-storage: skipped: %s\n", why);
  std::exit(77);
}

void open() {
  World &world = g_world;
  world.display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                           EGL_NONE};
  EGLint count = 0;
  if (!eglInitialize(world.display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API) ||
      !eglChooseConfig(world.display, wanted, &world.config, 1, &count) || count == 0)
    skip("no EGL display");
  world.context = makeContext(EGL_NO_CONTEXT, EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT);
  if (!eglMakeCurrent(world.display, EGL_NO_SURFACE, EGL_NO_SURFACE, world.context))
    skip("no context of OpenGL 4.3");
  makeObjects();
}

void makeObjects() {
  World &world = g_world;
  world.plain = software::makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                                      "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n");
  world.sampling = software::makeProgram(
      GL_FRAGMENT_PROGRAM_ARB,
      "!!ARBfp1.0\nTEX result.color, fragment.texcoord[0], texture[0], 2D;\nEND\n");
  GLuint color = 0;
  glGenFramebuffers(1, &world.target);
  glBindFramebuffer(GL_FRAMEBUFFER, world.target);
  glGenRenderbuffers(1, &color);
  glBindRenderbuffer(GL_RENDERBUFFER, color);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kEdge, kEdge);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
  glViewport(0, 0, kEdge, kEdge);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
}

void unfiltered(GLuint texture) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

GLuint makeTexture(bool immutable) {
  GLuint name = 0;
  glGenTextures(1, &name);
  unfiltered(name);
  if (immutable)
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, kEdge, kEdge);
  else
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kEdge, kEdge, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  return name;
}

GLuint viewOf(GLuint texture) {
  GLuint view = 0;
  glGenTextures(1, &view);
  glTextureView(view, GL_TEXTURE_2D, texture, GL_RGBA8, 0, 1, 0, 1);
  unfiltered(view);
  return view;
}

GLuint framebufferOf(GLuint texture) {
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  return framebuffer;
}

void drawFilled(int value) {
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, g_world.plain);
  glColor4ub(GLubyte(value), 25, 75, 255);
  glRectf(-1, -1, 1, 1);
}

void fill(GLuint texture, int value) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebufferOf(texture));
  drawFilled(value);
}

void show(GLuint texture, const char *name) {
  glBindFramebuffer(GL_FRAMEBUFFER, g_world.target);
  glBindTexture(GL_TEXTURE_2D, texture);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, g_world.sampling);
  glBegin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 4; ++i) {
    glTexCoord2i(i % 2, i / 2);
    glVertex2i(2 * (i % 2) - 1, 2 * (i / 2) - 1);
  }
  glEnd();
  software::record(name, software::readRgba(0, 0, kEdge, kEdge));
}

GLuint makeShaders(const char *text) {
  const GLuint shader = glCreateShader(GL_FRAGMENT_SHADER), program = glCreateProgram();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) {
    char log[600] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    skip(log);
  }
  return program;
}

void runShaders(GLuint program, const std::function<void()> &prepare) {
  prepare();
  glUseProgram(program);
  glBindFramebuffer(GL_FRAMEBUFFER, g_world.target);
  glRectf(-1, -1, 1, 1);
  glUseProgram(0);
}

void inCoreContext(const std::function<void()> &what) {
  const EGLContext other = makeContext(g_world.context, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT);
  if (!eglMakeCurrent(g_world.display, EGL_NO_SURFACE, EGL_NO_SURFACE, other))
    skip("no context of the core profile");
  what();
  eglMakeCurrent(g_world.display, EGL_NO_SURFACE, EGL_NO_SURFACE, g_world.context);
  eglDestroyContext(g_world.display, other);
}

} // namespace storage
