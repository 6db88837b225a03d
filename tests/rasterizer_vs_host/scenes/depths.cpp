// Draws to depth buffers without stencil, as most applications request: rasterizer-depths SEED
// COUNT. Each seed is a random frame in a window with at least 1 to 24 bits of depth, and in
// framebuffer objects with DEPTH_COMPONENT32. The drawn depths are also sampled and compared.
// Writes colors and all 32 bits of depths as records, which comparisons.py compares.
#include <cstdio>
#include <cstdlib>

#include "glx_windows.h"
#include "surface.h"

namespace software {
namespace {

constexpr int kEdge = 64; // of all targets, in pixels

struct Window {
  Display *display = nullptr;
  GLXWindow drawable = 0;
  GLXContext context = nullptr;
};

/// Every host has this many bits of depth for a window; newer Mesa has no more.
constexpr int kMaxPromised = 24;

/// Opens a window as glxgears and GLUT do, with a least depth and no stencil. Makes no context if
/// more depth is requested than every host has.
Window open(int depthBits) {
  Window made;
  made.display = XOpenDisplay(nullptr);
  const int wanted[] = {GLX_X_RENDERABLE,
                        True,
                        GLX_RED_SIZE,
                        8,
                        GLX_GREEN_SIZE,
                        8,
                        GLX_BLUE_SIZE,
                        8,
                        GLX_DEPTH_SIZE,
                        depthBits,
                        GLX_DOUBLEBUFFER,
                        True,
                        None};
  int count = 0;
  GLXFBConfig *const all =
      made.display ? glXChooseFBConfig(made.display, DefaultScreen(made.display), wanted, &count)
                   : nullptr;
  for (int i = 0; i < count && !made.context; ++i) {
    int stencil = 0, samples = 0, visual = 0;
    glXGetFBConfigAttrib(made.display, all[i], GLX_STENCIL_SIZE, &stencil);
    glXGetFBConfigAttrib(made.display, all[i], GLX_SAMPLES, &samples);
    glXGetFBConfigAttrib(made.display, all[i], GLX_VISUAL_ID, &visual);
    if (stencil != 0 || samples != 0 || visual == 0)
      continue;
    made.context = glXCreateNewContext(made.display, all[i], GLX_RGBA_TYPE, nullptr, True);
    const ::Window window = makeWindow(made.display, all[i], kEdge, kEdge);
    made.drawable = glXCreateWindow(made.display, all[i], window, nullptr);
  }
  if (!made.context && depthBits > kMaxPromised)
    return made;
  if (!made.context ||
      !glXMakeContextCurrent(made.display, made.drawable, made.drawable, made.context)) {
    std::fprintf(stderr, "rasterizer-depths: no window with depth and without stencil\n");
    std::exit(1);
  }
  return made;
}

class Frame {
public:
  explicit Frame(std::uint64_t seed) : m_random(seed) { m_random.bits(); }

  void draw(const std::string &name) {
    glViewport(0, 0, kEdge, kEdge);
    glDisable(GL_DITHER);
    glClearDepth(double(m_random.below(65)) / 64);
    glClearColor(0.1f, 0.2f, 0.3f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 12; ++i)
      layer();
    state(false);
    if (m_random.once(3)) { // a part of it again
      glEnable(GL_SCISSOR_TEST);
      glScissor(5, 9, 31, 22);
      glClearDepth(0.3);
      glClear(GL_DEPTH_BUFFER_BIT);
      glDisable(GL_SCISSOR_TEST);
      layer();
    }
    glFlush();
    record(name + " color", readRgba(0, 0, kEdge, kEdge));
    std::vector<unsigned char> depths(std::size_t(kEdge) * kEdge * 4);
    glReadPixels(0, 0, kEdge, kEdge, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths.data());
    record(name + " depth", depths);
    record(name + " errors" + takeErrors(), {});
  }

private:
  float unit() { return float(m_random.below(1025)) / 1024; }

  void state(bool random) {
    glDepthFunc(random ? GLenum(GL_NEVER + m_random.below(8)) : GLenum(GL_LESS));
    glDepthMask(GLboolean(!random || !m_random.once(4)));
    glDepthRange(random && m_random.once(4) ? 0.25 : 0, random && m_random.once(4) ? 0.5 : 1);
    (random && m_random.once(3) ? glEnable : glDisable)(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0, float(m_random.between(-4000, 4000)));
  }

  /// Draws rectangles that face the viewer, with one depth, and triangles, small and large, with
  /// slopes of eighths, so that two rasterizers agree on most pixels.
  void layer() {
    state(true);
    const int count = m_random.once(3) ? 150 : m_random.between(1, 3);
    const bool facing = m_random.once(2);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < count; ++i) {
      glColor3f(unit(), unit(), unit());
      const float size = count > 3 ? 0.125f : 1.0f;
      const float x = float(m_random.between(-64, 48)) / 64,
                  y = float(m_random.between(-64, 48)) / 64;
      const float z = 2 * unit() - 1;
      for (int corner = 0; corner < 3; ++corner)
        glVertex3f(x + (corner == 1 ? size : 0), y + (corner == 2 ? size : 0),
                   facing ? z : z * 0.5f + 0.125f * float(m_random.below(3)));
    }
    glEnd();
  }

  Random m_random;
};

/// Makes a framebuffer object whose depths are a renderbuffer or a texture.
GLuint attach(bool texture, GLuint &depth) {
  const GLuint framebuffer = makeFramebuffer();
  attachBuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, kEdge, kEdge);
  if (texture) {
    glGenTextures(1, &depth);
    glBindTexture(GL_TEXTURE_2D, depth);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32, kEdge, kEdge, 0, GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
  } else {
    depth = attachBuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32, kEdge, kEdge);
  }
  return framebuffer;
}

/// Draws a depth texture over the window, sampled by a program.
void sample(GLuint depth, const std::string &name) {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glClearDepth(1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glBindTexture(GL_TEXTURE_2D, depth);
  glBegin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 4; ++i) {
    glTexCoord2i(i % 2, i / 2);
    glVertex2i(2 * (i % 2) - 1, 2 * (i / 2) - 1);
  }
  glEnd();
  record(name + " sampled", readRgba(0, 0, kEdge, kEdge));
}

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  if (argc != 3)
    return 2;
  const int first = std::atoi(argv[1]), count = std::atoi(argv[2]);
  constexpr int kBits[] = {1, 16, 24, 32};
  for (const int bits : kBits) {
    const software::Window window = open(bits);
    if (!window.context)
      continue;
    const GLuint plain = makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                                     "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n");
    const GLuint sampling =
        makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                    "!!ARBfp1.0\nTEX result.color, fragment.texcoord[0], texture[0], 2D;\nEND\n");
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
    GLint held = 0;
    glGetIntegerv(GL_DEPTH_BITS, &held);
    for (int seed = first; seed < first + count; ++seed) {
      const std::string name = "asked for " + std::to_string(bits) + ", has " +
                               std::to_string(held) + ", seed " + std::to_string(seed);
      glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, plain);
      Frame(std::uint64_t(seed)).draw(name);
      for (const bool texture : {false, true}) {
        if (bits != kBits[0])
          break;
        GLuint depth = 0;
        const GLuint framebuffer = attach(texture, depth);
        glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, plain);
        const std::string object = texture ? "texture" : "renderbuffer";
        Frame(std::uint64_t(seed) + 1000).draw(object + " seed " + std::to_string(seed));
        glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, sampling);
        if (texture)
          sample(depth, "seed " + std::to_string(seed));
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &framebuffer);
      }
      glXSwapBuffers(window.display, window.drawable);
    }
    glXMakeContextCurrent(window.display, None, None, nullptr);
    glXDestroyContext(window.display, window.context);
  }
  return 0;
}
