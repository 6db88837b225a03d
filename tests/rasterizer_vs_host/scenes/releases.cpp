// Tests a window whose context is released, or made current again, as toolkits do in each frame:
// rasterizer-releases NAME, or --list. Writes the window's visible content, its back buffer and its
// depths, for comparison between two sides.
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "glx_windows.h"
#include "surface.h"

namespace software {
namespace {

constexpr int kWide = 96, kHigh = 64;
constexpr int kFrames = 24;

[[noreturn]] void fail(const char *what) {
  std::fprintf(stderr, "releases: %s\n", what);
  std::exit(2);
}

/// A window, and contexts that do not share.
class Scene {
public:
  Scene() : m_display(XOpenDisplay(nullptr)) {
    m_config = m_display ? chooseGlxConfig(m_display, GLX_WINDOW_BIT) : nullptr;
    if (!m_config)
      fail("no X display, or no GLX configuration");
    window = makeWindow(0);
    m_context = makeContext();
  }
  ~Scene() {
    release();
    XCloseDisplay(m_display);
  }
  Scene(const Scene &) = delete;
  Scene &operator=(const Scene &) = delete;

  Window window = 0;

  Window makeWindow(int x) {
    return software::makeWindow(m_display, m_config, kWide, kHigh, {.x = x});
  }
  GLXWindow makeGlxWindow() { return glXCreateWindow(m_display, m_config, window, nullptr); }
  void destroyGlxWindow(GLXWindow made) { glXDestroyWindow(m_display, made); }
  GLXContext makeContext() {
    return glXCreateNewContext(m_display, m_config, GLX_RGBA_TYPE, nullptr, True);
  }
  GLXContext makeCoreContext() {
    const int attributes[] = {GLX_CONTEXT_MAJOR_VERSION_ARB,
                              3,
                              GLX_CONTEXT_MINOR_VERSION_ARB,
                              3,
                              GLX_CONTEXT_PROFILE_MASK_ARB,
                              GLX_CONTEXT_CORE_PROFILE_BIT_ARB,
                              None};
    return glXCreateContextAttribsARB(m_display, m_config, nullptr, True, attributes);
  }
  void makeCurrent(GLXDrawable drawable, GLXContext context) {
    if (!glXMakeContextCurrent(m_display, drawable, drawable, context))
      fail("the context does not become current");
  }
  void release() { makeCurrent(0, nullptr); }
  /// Makes the scene's own context current.
  void use(GLXDrawable drawable) {
    makeCurrent(drawable, m_context);
    if (m_program == 0) {
      m_program = makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                              "!!ARBfp1.0\nMAD result.color, fragment.texcoord[0], "
                              "program.local[0], program.local[1];\nEND\n");
      glEnable(GL_FRAGMENT_PROGRAM_ARB);
      glEnable(GL_DEPTH_TEST);
      glDisable(GL_DITHER);
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }
  }
  void use() { use(window); }
  void swap(GLXDrawable drawable) { glXSwapBuffers(m_display, drawable); }
  void swap() { swap(window); }
  void resize(int width, int height) {
    XResizeWindow(m_display, window, unsigned(width), unsigned(height));
    XSync(m_display, False);
  }

  void grab(int number, int width = kWide, int height = kHigh) {
    record("shown " + std::to_string(number), grabWindow(m_display, window, width, height));
  }

private:
  Display *m_display;
  GLXFBConfig m_config = nullptr;
  GLXContext m_context = nullptr;
  GLuint m_program = 0;
};

/// Draws a different tilted quad for each number, which intersects those before: that shows whether
/// depths were kept.
void draw(int number) {
  const auto part = [&](int factor) { return float(number * factor % 32) / 31; };
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, part(5), part(3), part(11), 1);
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 1, part(7), part(13), part(17), 0);
  const float x = 1.2f * part(9) - 0.9f, y = 1.2f * part(19) - 0.9f;
  const float near = part(23) - 0.8f, far = part(29) - 0.2f;
  glBegin(GL_QUADS);
  glTexCoord2f(0, 0), glVertex3f(x, y, near);
  glTexCoord2f(1, 0), glVertex3f(x + 0.7f, y, far);
  glTexCoord2f(1, 1), glVertex3f(x + 0.7f, y + 0.9f, far);
  glTexCoord2f(0, 1), glVertex3f(x, y + 0.9f, near);
  glEnd();
}

/// Records the content of the context's buffers.
void read(int number) {
  record("back " + std::to_string(number) + takeErrors(), readRgba(0, 0, kWide, kHigh));
  std::vector<unsigned short> depths(std::size_t(kWide) * kHigh);
  glReadPixels(0, 0, kWide, kHigh, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, depths.data());
  std::vector<unsigned char> bytes;
  for (const unsigned short depth : depths)
    bytes.insert(bytes.end(), {0, 0, 0, static_cast<unsigned char>(depth >> 8)});
  record("depths " + std::to_string(number), bytes);
}

/// Clears a part of the window, to a color and a depth.
void clearPart(int number) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(number % 5 * 8, number % 3 * 8, 40, 30);
  glClearColor(float(number % 4) / 3, 0.5f, float(number % 7) / 6, 1);
  glClearDepth(double(number % 6) / 5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

/// Clears, draws, shows and releases each frame.
void cleared() {
  Scene scene;
  for (int i = 0; i < kFrames; ++i) {
    scene.use();
    glClearColor(0.2f, 0.3f, float(i) / kFrames, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw(i);
    draw(i + 1);
    scene.swap();
    scene.release();
    scene.grab(i);
  }
}

/// Continues each frame from the colors and depths of the previous one.
void kept() {
  Scene scene;
  for (int i = 0; i < kFrames; ++i) {
    scene.use();
    draw(i);
    scene.swap();
    scene.release();
    scene.grab(i);
  }
  scene.use();
  read(kFrames);
}

/// Releases the context between two draws of a frame.
void withinFrames() {
  Scene scene;
  for (int i = 0; i < kFrames; ++i) {
    scene.use();
    draw(2 * i);
    scene.release();
    scene.use();
    if (i % 8 == 5)
      clearPart(i);
    draw(2 * i + 1);
    scene.swap();
    scene.grab(i);
  }
  read(kFrames);
}

/// Makes the context current again without releasing it.
void again() {
  Scene scene;
  for (int i = 0; i < kFrames; ++i) {
    scene.use();
    draw(2 * i);
    scene.use();
    draw(2 * i + 1);
    scene.swap();
    scene.grab(i);
  }
  read(kFrames);
}

/// Shows frames while no context is current.
void shownOutside() {
  Scene scene;
  for (int i = 0; i < kFrames; ++i) {
    scene.use();
    draw(i);
    scene.release();
    scene.swap();
    scene.grab(i);
  }
  scene.use();
  read(kFrames);
}

/// Draws to the window with another context in between.
void alternate(Scene &scene, GLXContext other, bool onThread) {
  for (int i = 0; i < kFrames; ++i) {
    scene.use();
    draw(2 * i);
    if (i % 2 == 0)
      scene.release();
    const auto drawOther = [&] {
      scene.makeCurrent(scene.window, other);
      clearPart(i);
      if (i % 3 == 0)
        scene.swap();
      scene.release();
    };
    if (onThread) {
      scene.release();
      std::thread(drawOther).join();
    } else if (i % 5 != 4) {
      drawOther();
    }
    scene.use();
    draw(2 * i + 1);
    read(i);
    scene.swap();
    scene.grab(i);
    scene.release();
  }
}

void anotherContext() {
  Scene scene;
  alternate(scene, scene.makeContext(), false);
}
void anotherThread() {
  Scene scene;
  alternate(scene, scene.makeContext(), true);
}
/// Uses a context that bypasses the layer.
void coreContext() {
  Scene scene;
  alternate(scene, scene.makeCoreContext(), false);
}

/// Moves one context from window to window.
void twoWindows() {
  Scene scene;
  const Window windows[] = {scene.window, scene.makeWindow(200)};
  for (int i = 0; i < kFrames; ++i) {
    const Window window = windows[i % 3 == 2];
    scene.use(window);
    if (i < 6)
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw(i);
    scene.swap(window);
    if (i % 2 == 0)
      scene.release();
    scene.grab(i);
  }
  scene.use();
  read(kFrames);
}

/// Resizes the window while it has no context, with and without restoring the size.
void resized() {
  Scene scene;
  const int sizes[][2] = {{kWide, kHigh}, {70, 50}, {120, 40}, {kWide, kHigh}};
  for (int i = 0; i < kFrames; ++i) {
    const int *const size = sizes[i / 3 % 4];
    if (i % 3 == 1)
      scene.resize(150, 20);
    scene.resize(size[0], size[1]);
    scene.use();
    glViewport(0, 0, size[0], size[1]);
    if (i % 3 == 0)
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw(i);
    scene.swap();
    scene.release();
    scene.grab(i, size[0], size[1]);
  }
}

/// Destroys a GLX window, and makes another of the same X window.
void madeAnew() {
  Scene scene;
  for (int i = 0; i < 8; ++i) {
    const GLXWindow window = scene.makeGlxWindow();
    for (int frame = 0; frame < 3; ++frame) {
      scene.use(window);
      if (frame == 0)
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      draw(3 * i + frame);
      scene.swap(window);
      scene.release();
      scene.grab(3 * i + frame);
    }
    scene.destroyGlxWindow(window);
  }
}

struct Case {
  const char *name;
  void (*run)();
};
constexpr Case kCases[] = {{"cleared", cleared},
                           {"kept", kept},
                           {"within-frames", withinFrames},
                           {"again", again},
                           {"shown-outside", shownOutside},
                           {"another-context", anotherContext},
                           {"another-thread", anotherThread},
                           {"core-context", coreContext},
                           {"two-windows", twoWindows},
                           {"resized", resized},
                           {"made-anew", madeAnew}};

} // namespace
} // namespace software

int main(int argc, char **argv) { return software::runNamed(software::kCases, argc, argv); }
