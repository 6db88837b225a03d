// Tests two contexts that share only an EGLImage: one draws to its texture, the other samples and
// reads it in its own. Exits with status 0 if everything is right.
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "../rasterizer_vs_host/surface.h"

namespace {

constexpr int kEdge = 16;

[[noreturn]] void die(const char *what) {
  std::fprintf(stderr, "sharing-images: %s\n", what);
  std::exit(1);
}

struct Side {
  EGLContext context = EGL_NO_CONTEXT;
  GLuint texture = 0, framebuffer = 0, program = 0;
};

class Scene {
public:
  Scene() {
    m_display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                             EGL_NONE};
    EGLint count = 0;
    if (!eglInitialize(m_display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API) ||
        !eglChooseConfig(m_display, wanted, &m_config, 1, &count) || count == 0)
      die("no EGL display");
    for (Side &side : m_sides) {
      side.context = eglCreateContext(m_display, m_config, EGL_NO_CONTEXT, nullptr);
      use(side);
      glGenTextures(1, &side.texture);
      glBindTexture(GL_TEXTURE_2D, side.texture);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      const std::vector<unsigned char> black(std::size_t(kEdge) * kEdge * 4);
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kEdge, kEdge, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                   black.data());
      glGenFramebuffers(1, &side.framebuffer);
      glBindFramebuffer(GL_FRAMEBUFFER, side.framebuffer);
      glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, side.texture, 0);
      glViewport(0, 0, kEdge, kEdge);
      side.program = software::makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                                           "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n");
      draw(side, 0); // the rasterizer has used the texture by now
    }
  }

  bool offered() const {
    return epoxy_has_egl_extension(m_display, "EGL_KHR_gl_texture_2D_image") &&
           epoxy_has_gl_extension("GL_OES_EGL_image");
  }

  /// Makes the second side's texture an image of the first one's.
  void join() {
    use(m_sides[0]);
    const EGLImageKHR image = eglCreateImageKHR(
        m_display, m_sides[0].context, EGL_GL_TEXTURE_2D_KHR,
        reinterpret_cast<EGLClientBuffer>(std::uintptr_t(m_sides[0].texture)), nullptr);
    if (image == EGL_NO_IMAGE_KHR)
      die("no EGLImage");
    use(m_sides[1]);
    glBindTexture(GL_TEXTURE_2D, m_sides[1].texture);
    glEGLImageTargetTexture2DOES(GL_TEXTURE_2D, image);
  }

  /// Returns what side `to` reads after side `from` drew value `value`.
  int after(int from, int to, int value) {
    use(m_sides[from]);
    draw(m_sides[from], value);
    glFinish();
    use(m_sides[to]);
    glBindTexture(GL_TEXTURE_2D, m_sides[to].texture);
    std::vector<unsigned char> bytes(std::size_t(kEdge) * kEdge * 4);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return bytes[4 * (kEdge + 1)];
  }

private:
  void use(const Side &side) {
    if (!eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, side.context))
      die("a context does not become current");
  }
  static void draw(const Side &side, int value) {
    glBindFramebuffer(GL_FRAMEBUFFER, side.framebuffer);
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, side.program);
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
    glColor4ub(GLubyte(value), 0, 0, 255);
    glRectf(-1, -1, 1, 1);
    glDisable(GL_FRAGMENT_PROGRAM_ARB);
  }

  EGLDisplay m_display = EGL_NO_DISPLAY;
  EGLConfig m_config = nullptr;
  Side m_sides[2];
};

} // namespace

int main() {
  Scene scene;
  if (!scene.offered()) {
    std::puts("skipped: the host lacks it: images of shaders");
    return 77;
  }
  scene.join();
  int wrong = 0;
  for (int i = 0; i < 6; ++i) {
    const int value = 40 + 20 * i, from = 0;
    const int seen = scene.after(from, 1, value);
    if (seen != value)
      std::fprintf(stderr, "sharing-images: round %d: %d is read, %d was drawn\n", i, seen, value);
    wrong += seen != value;
  }
  return wrong == 0 ? 0 : 1;
}
