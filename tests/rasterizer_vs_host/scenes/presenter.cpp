// Shows frames in windows, one scene for each process: rasterizer-presenter NAME, or --list. Reads
// what the server shows after each swap and writes it, for comparison between two sides.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "glx_windows.h"
#include "surface.h"

namespace software {
namespace {

constexpr int kWide = 160, kHigh = 120;

/// Windows of one display, and a context that draws to them.
class Scene {
public:
  Scene() : m_display(XOpenDisplay(nullptr)) {
    if (!m_display)
      fail("no X display");
    m_config =
        firstGlxConfig(m_display, {GLX_DRAWABLE_TYPE, GLX_WINDOW_BIT, GLX_RED_SIZE, 8,
                                   GLX_GREEN_SIZE, 8, GLX_BLUE_SIZE, 8, GLX_DOUBLEBUFFER, True});
    if (!m_config)
      fail("no GLX configuration");
    m_context = glXCreateNewContext(m_display, m_config, GLX_RGBA_TYPE, nullptr, True);
    if (!m_context)
      fail("no context");
  }

  [[noreturn]] static void fail(const char *what) {
    std::fprintf(stderr, "presenter: %s\n", what);
    std::exit(2);
  }
  [[nodiscard]] Display *display() const { return m_display; }

  Window makeWindow(int x, int width, int height) {
    const Window window = software::makeWindow(m_display, m_config, width, height, {.x = x});
    return window;
  }
  void use(GLXDrawable drawable) {
    if (!glXMakeCurrent(m_display, drawable, drawable ? m_context : nullptr))
      fail("the context does not become current");
    if (drawable && !m_program) {
      m_program = makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                              "!!ARBfp1.0\nMAD result.color, fragment.texcoord[0], "
                              "program.local[0], program.local[1];\nEND\n");
      glEnable(GL_FRAGMENT_PROGRAM_ARB);
      glDisable(GL_DITHER);
    }
  }
  /// Draws a different picture for each number.
  void draw(int number, float left = -1) {
    const auto part = [&](int factor) { return float(number * factor % 32) / 31; };
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, part(5), part(3), part(11), 1);
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 1, part(7), part(13), part(17), 0);
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0), glVertex2f(left, -1);
    glTexCoord2f(1, 0), glVertex2f(1, -1);
    glTexCoord2f(1, 1), glVertex2f(1, 1);
    glTexCoord2f(0, 1), glVertex2f(left, 1);
    glEnd();
  }
  void swap(GLXDrawable drawable) { glXSwapBuffers(m_display, drawable); }

  /// Records the window's visible content, without other requests than the scene's before it.
  void grab(const char *what, int number, Window window, int width = kWide, int height = kHigh) {
    record(std::string(what) + " " + std::to_string(number) + takeErrors(),
           grabWindow(m_display, window, width, height));
  }
  void resize(Window window, int width, int height) {
    XResizeWindow(m_display, window, unsigned(width), unsigned(height));
  }
  /// Closes the display with its context. It is not current, which Mesa would not survive.
  void closeWithContext() {
    use(0);
    XCloseDisplay(m_display);
  }
  void close() {
    use(0);
    glXDestroyContext(m_display, m_context);
    XCloseDisplay(m_display);
    m_display = nullptr;
  }

private:
  Display *m_display;
  GLXFBConfig m_config = nullptr;
  GLXContext m_context = nullptr;
  GLuint m_program = 0;
};

int g_xErrors = 0;
/// Reports X errors; none may come from requests that are not the application's.
int count(Display *, XErrorEvent *event) {
  if (event->request_code < 128 || event->error_code == BadDrawable)
    std::fprintf(stderr, "presenter: X error %d of request %d\n", event->error_code,
                 event->request_code);
  ++g_xErrors;
  return 0;
}

void frames() {
  Scene scene;
  const Window window = scene.makeWindow(0, kWide, kHigh);
  scene.use(window);
  for (int i = 0; i < 40; ++i) {
    scene.draw(i);
    scene.swap(window);
    scene.grab("frame", i, window);
  }
  record("events" + std::to_string(XPending(scene.display())), {});
  scene.close();
}

/// Shows frames that nobody reads: the server may lag behind, and the last one counts.
void unread() {
  Scene scene;
  const Window window = scene.makeWindow(0, kWide, kHigh);
  scene.use(window);
  for (int i = 0; i < 200; ++i) {
    scene.draw(i);
    scene.swap(window);
    if (i % 50 == 49)
      scene.grab("frame", i, window);
  }
  glFinish();
  scene.grab("finished", 0, window);
  scene.swap(window);
  scene.swap(window);
  scene.grab("swapped again", 0, window);
  scene.close();
}

/// Draws over the previous frame, which the host keeps in its back buffer.
void kept() {
  Scene scene;
  const Window window = scene.makeWindow(0, kWide, kHigh);
  scene.use(window);
  scene.draw(3);
  for (int i = 0; i < 24; ++i) {
    scene.draw(i, -1 + float(i) / 12);
    scene.swap(window);
    if (i % 3 != 0)
      scene.grab("frame", i, window);
  }
  scene.close();
}

/// Makes a feedback copy that keeps the memory which the server reads; a later draw reuses it.
void feedback() {
  Scene scene;
  const Window window = scene.makeWindow(0, kWide, kHigh);
  scene.use(window);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 0, 0, kWide, kHigh, 0);
  const GLuint mix = makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                                 "!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], "
                                 "2D;\nADD t, -t.yzxw, 1;\nMOV result.color, t;\nEND\n");
  scene.draw(9);
  for (int i = 0; i < 30; ++i) {
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, kWide, kHigh);
    scene.swap(window);
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, mix);
    scene.draw(i);
    if (i % 4 == 0)
      scene.grab("shown", i, window);
    record("read", readRgba(0, 0, kWide, kHigh));
  }
  scene.close();
}

void twoWindows() {
  Scene scene;
  const Window windows[] = {scene.makeWindow(0, kWide, kHigh), scene.makeWindow(200, kWide, kHigh)};
  for (int i = 0; i < 30; ++i) {
    const Window window = windows[i % 3 == 2];
    scene.use(window);
    scene.draw(i);
    scene.swap(window);
    scene.grab("left", i, windows[0]);
    scene.grab("right", i, windows[1]);
  }
  scene.close();
}

/// Resizes windows by the application's own requests, with and without glViewport.
void resized() {
  Scene scene;
  const Window window = scene.makeWindow(0, kWide, kHigh);
  scene.use(window);
  const int sizes[][2] = {{kWide, kHigh}, {100, 90}, {101, 200}, {kWide, kHigh}, {240, 30}};
  for (int i = 0; i < 40; ++i) {
    const auto [width, height] = sizes[i / 4 % 5];
    if (i % 4 == 0)
      scene.resize(window, width, height);
    if (i < 20)
      glViewport(0, 0, width, height);
    // The undrawn part of a window that grew is undefined.
    glClear(GL_COLOR_BUFFER_BIT);
    scene.draw(i);
    scene.swap(window);
    scene.grab("frame", i, window, width, height);
  }
  scene.close();
}

/// Resizes a window by another client, of which the application learns by an event or in its own
/// way.
void resizedByAnother() {
  Scene scene;
  const Window window = scene.makeWindow(0, kWide, kHigh);
  XSelectInput(scene.display(), window, StructureNotifyMask);
  scene.use(window);
  Display *const other = XOpenDisplay(nullptr);
  const int sizes[][2] = {{kWide, kHigh}, {100, 90}, {101, 200}, {kWide, kHigh}, {240, 30}};
  int width = kWide, height = kHigh;
  for (int i = 0; i < 40; ++i) {
    if (i % 4 == 2) {
      width = sizes[i / 4 % 5][0];
      height = sizes[i / 4 % 5][1] + i;
      XResizeWindow(other, window, unsigned(width), unsigned(height));
      XSync(other, False);
      if (i % 8 == 2) {
        XEvent event;
        do
          XNextEvent(scene.display(), &event);
        while (event.type != ConfigureNotify || event.xconfigure.height != height);
      } else {
        glViewport(0, 0, width, height);
      }
    }
    glClear(GL_COLOR_BUFFER_BIT);
    scene.draw(i);
    scene.swap(window);
    if (i % 4 == 3) {
      scene.swap(window);
      scene.grab("frame", i, window, width, height);
    }
  }
  XCloseDisplay(other);
  scene.close();
}

/// Shows frames of a destroyed window: errors, if any, are the host's own.
void destroyed() {
  Scene scene;
  XSetErrorHandler(count);
  const Window stays = scene.makeWindow(200, kWide, kHigh);
  for (int round = 0; round < 5; ++round) {
    const Window window = scene.makeWindow(0, kWide, kHigh);
    scene.use(window);
    for (int i = 0; i < 3; ++i) {
      scene.draw(i);
      scene.swap(window);
    }
    scene.grab("before", round, window);
    // The window is destroyed while a frame may be under way, which is no error.
    scene.draw(7);
    scene.swap(window);
    XDestroyWindow(scene.display(), window);
    scene.use(stays);
    scene.draw(round);
    scene.swap(stays);
    scene.grab("after", round, stays);
  }
  XSync(scene.display(), False);
  record("errors " + std::to_string(g_xErrors), {});
  scene.close();
}

/// Closes a display with a frame under way, and opens another.
void closed() {
  for (int round = 0; round < 4; ++round) {
    Scene scene;
    const Window window = scene.makeWindow(0, kWide, kHigh);
    scene.use(window);
    for (int i = 0; i < 5; ++i) {
      scene.draw(i + round);
      scene.swap(window);
    }
    scene.grab("last", round, window);
    scene.draw(round);
    scene.swap(window);
    if (round % 2 == 0)
      scene.close();
    else
      scene.closeWithContext();
  }
}

/// Swaps in one thread while another uses the same display.
void threads() {
  XInitThreads();
  Scene scene;
  const Window window = scene.makeWindow(0, kWide, kHigh);
  std::atomic<bool> ends = false;
  std::thread other([&] {
    while (!ends) {
      XLockDisplay(scene.display());
      XSync(scene.display(), False);
      XUnlockDisplay(scene.display());
      (void)XInternAtom(scene.display(), "PRESENTER", False);
    }
  });
  scene.use(window);
  for (int i = 0; i < 120; ++i) {
    scene.draw(i);
    scene.swap(window);
    if (i % 20 == 19)
      scene.grab("frame", i, window);
  }
  ends = true;
  other.join();
  scene.close();
}

struct Case {
  const char *name;
  void (*run)();
};
constexpr Case kCases[] = {{"frames", frames},
                           {"unread", unread},
                           {"kept", kept},
                           {"feedback", feedback},
                           {"two-windows", twoWindows},
                           {"resized", resized},
                           {"resized-by-another", resizedByAnother},
                           {"destroyed", destroyed},
                           {"closed", closed},
                           {"threads", threads}};

} // namespace
} // namespace software

int main(int argc, char **argv) { return software::runNamed(software::kCases, argc, argv); }
