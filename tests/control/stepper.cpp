// Does what its standard input says, line by line, on threads with a window of 200x120 each,
// without knowing Arbiter:
//
//   K frame SCENE    thread K (0 or 1) draws a scene, prints the middle's color, and shows it
//   K context N      makes its Nth context (0 to 2) current
//   K destroy        draws, and destroys its current context without showing the drawing; the next
//                    one has the same number
//   K signal         thread K handles a signal, and prints so
//   K pester         500 signals, a millisecond apart; prints how many were handled
//   K exit           thread K calls exit(7) in a signal handler
//
// It answers "K done" to all but the last three, and before that "K middle R G B", "K framebuffer
// N" (for the scene `object`) or "K error N" for GL errors.
//
//   quad      a quad between Begin and End
//   list      the quad in a list
//   early     the quad in a list that was compiled before any program
//   executed  the quad in a list that was executed while it was compiled
//   state     a list that only sets state, then a quad
//   object    two quads to a framebuffer object of 48x32, of which depth hides the second; then one
//             to the window
//   equal     slanting triangles, then the same again with equal depths
#include <array>
#include <atomic>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <iostream>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <unistd.h>

#include <epoxy/gl.h>
#include <epoxy/glx.h>

namespace {

constexpr int kWidth = 200, kHeight = 120, kObjectWidth = 48, kObjectHeight = 32;
constexpr int kThreads = 2, kContexts = 3;
constexpr const char *kProgram = "!!ARBfp1.0\n"
                                 "PARAM scale = program.local[0];\n"
                                 "MUL result.color, fragment.color, scale;\n"
                                 "END\n";

std::mutex g_printing;
thread_local int t_number = -1;
std::atomic<int> g_handled{0};
std::atomic<bool> g_pesters{false};

void say(int number, const std::string &text) {
  const std::lock_guard lock(g_printing);
  std::printf("%d %s\n", number, text.c_str());
  std::fflush(stdout);
}

void handle(int signal) {
  if (signal == SIGUSR2)
    std::exit(7);
  ++g_handled;
  if (g_pesters)
    return;
  char line[] = "0 handled\n";
  line[0] = char('0' + t_number);
  (void)!write(STDOUT_FILENO, line, sizeof line - 1);
}

void corner(float x, float y, float z) { glVertex3f(x, y, z); }

void quad(float z = 0) {
  glBegin(GL_QUADS);
  glColor4f(1, 1, 1, 1);
  corner(-1, -1, z);
  corner(1, -1, z);
  corner(1, 1, z);
  corner(-1, 1, z);
  glEnd();
}

void scale(float red, float green, float blue) {
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, red, green, blue, 1);
}

/// Draws triangles that lean away, one behind another.
void slanting() {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-0.7, 0.7, -0.45, 0.45, 0.37, 41);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glRotatef(17, 0.3f, 1, 0.2f);
  glBegin(GL_TRIANGLES);
  glColor4f(1, 1, 1, 1);
  for (int i = 0; i < 7; ++i) {
    const float far = 1.3f + 1.7f * float(i);
    corner(-3.1f * far, -2.3f * far, -far);
    corner(3.7f * far, -1.9f * far, -1.9f * far);
    corner(0.2f * far, 2.9f * far, -1.4f * far);
  }
  glEnd();
  glLoadIdentity();
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
}

/// The objects of a context.
struct Objects {
  GLuint lists = 0, framebuffer = 0, texture = 0, depths = 0;
};

void compile(GLuint list, GLenum mode) {
  glNewList(list, mode);
  quad();
  glEndList();
}

Objects makeObjects() {
  Objects objects;
  objects.lists = glGenLists(4);
  // The list is compiled twice, as libepoxy asks GL for its version at a function's first call,
  // within the list.
  compile(objects.lists, GL_COMPILE);
  compile(objects.lists, GL_COMPILE);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, 7);
  glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB,
                     GLsizei(std::strlen(kProgram)), kProgram);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glViewport(0, 0, kWidth, kHeight);
  compile(objects.lists + 1, GL_COMPILE);
  compile(objects.lists + 2, GL_COMPILE_AND_EXECUTE);
  glNewList(objects.lists + 3, GL_COMPILE);
  glDepthFunc(GL_LESS);
  glEndList();
  glGenTextures(1, &objects.texture);
  glBindTexture(GL_TEXTURE_2D, objects.texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kObjectWidth, kObjectHeight, 0, GL_RGBA,
               GL_UNSIGNED_BYTE, nullptr);
  glBindTexture(GL_TEXTURE_2D, 0);
  glGenRenderbuffers(1, &objects.depths);
  glBindRenderbuffer(GL_RENDERBUFFER, objects.depths);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kObjectWidth, kObjectHeight);
  glGenFramebuffers(1, &objects.framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, objects.framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, objects.texture, 0);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, objects.depths);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return objects;
}

class Worker {
public:
  explicit Worker(int number) : m_number(number), m_thread([this] { run(); }) {}

  void take(const std::string &words) {
    const std::lock_guard lock(m_mutex);
    m_waiting.push_back(words);
    m_arrived.notify_one();
  }
  [[nodiscard]] pthread_t handle() { return m_thread.native_handle(); }

private:
  bool open() {
    m_display = XOpenDisplay(nullptr);
    if (!m_display)
      return false;
    int wanted[] = {
        GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 8, GLX_DEPTH_SIZE, 24, GLX_STENCIL_SIZE, 8, None};
    const int screen = DefaultScreen(m_display);
    m_visual = glXChooseVisual(m_display, screen, wanted);
    if (!m_visual)
      return false;
    const Window root = RootWindow(m_display, screen);
    XSetWindowAttributes set = {};
    set.colormap = XCreateColormap(m_display, root, m_visual->visual, AllocNone);
    m_window = XCreateWindow(m_display, root, 0, 0, kWidth, kHeight, 0, m_visual->depth,
                             InputOutput, m_visual->visual, CWColormap | CWBorderPixel, &set);
    XMapWindow(m_display, m_window);
    XSync(m_display, False);
    makeCurrent(0);
    return true;
  }

  void makeCurrent(int index) {
    m_current = std::size_t(index);
    const bool isNew = !m_contexts[m_current];
    if (isNew)
      m_contexts[m_current] = glXCreateContext(m_display, m_visual, nullptr, True);
    glXMakeCurrent(m_display, m_window, m_contexts[m_current]);
    if (isNew)
      m_objects[m_current] = makeObjects();
  }

  void destroy() {
    draw("quad");
    glXMakeCurrent(m_display, None, nullptr);
    glXDestroyContext(m_display, m_contexts[m_current]);
    m_contexts[m_current] = nullptr;
    makeCurrent(int(m_current));
  }

  void drawObject() {
    glBindFramebuffer(GL_FRAMEBUFFER, m_objects[m_current].framebuffer);
    glViewport(0, 0, kObjectWidth, kObjectHeight);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    scale(0, 1, 0);
    quad(0.25f);
    scale(0, 0, 1);
    quad(0.5f);
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, kWidth, kHeight);
    say(m_number, "framebuffer " + std::to_string(m_objects[m_current].framebuffer));
  }

  void drawEqual() {
    glEnable(GL_DEPTH_TEST);
    scale(1, 0, 0);
    slanting();
    glDepthFunc(GL_EQUAL);
    scale(1, 1, 0);
    slanting();
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
  }

  void draw(const std::string &scene) {
    const GLuint lists = m_objects[m_current].lists;
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    scale(1, 1, 0);
    if (scene == "early")
      return glCallList(lists);
    if (scene == "list")
      return glCallList(lists + 1);
    if (scene == "executed")
      return glCallList(lists + 2);
    if (scene == "equal")
      return drawEqual();
    if (scene == "state")
      glCallList(lists + 3);
    if (scene == "object") {
      drawObject();
      scale(1, 1, 0);
    }
    quad();
  }

  void frame(const std::string &scene) {
    draw(scene);
    unsigned char pixel[4] = {};
    glReadPixels(kWidth / 2, kHeight / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    say(m_number, "middle " + std::to_string(pixel[0]) + " " + std::to_string(pixel[1]) + " " +
                      std::to_string(pixel[2]));
    GLint before[3] = {}, after[3] = {};
    constexpr GLenum kNames[] = {GL_ATTRIB_STACK_DEPTH, GL_DRAW_FRAMEBUFFER_BINDING, GL_DEPTH_FUNC};
    for (int i = 0; i < 3; ++i)
      glGetIntegerv(kNames[i], &before[i]);
    glXSwapBuffers(m_display, m_window);
    for (int i = 0; i < 3; ++i)
      glGetIntegerv(kNames[i], &after[i]);
    if (std::memcmp(before, after, sizeof before) != 0)
      say(m_number, "state");
  }

  void obey(const std::string &line) {
    std::istringstream words(line);
    std::string verb, more;
    words >> verb >> more;
    if (verb == "frame")
      frame(more);
    else if (verb == "context")
      makeCurrent(std::atoi(more.c_str()) % kContexts);
    else if (verb == "destroy")
      destroy();
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
      say(m_number, "error " + std::to_string(error));
    say(m_number, "done");
  }

  void run() {
    t_number = m_number;
    if (!open())
      return say(m_number, "no window");
    say(m_number, "ready");
    while (true) {
      std::unique_lock lock(m_mutex);
      m_arrived.wait(lock, [&] { return !m_waiting.empty(); });
      const std::string line = m_waiting.front();
      m_waiting.pop_front();
      lock.unlock();
      obey(line);
    }
  }

  const int m_number;
  Display *m_display = nullptr;
  XVisualInfo *m_visual = nullptr;
  Window m_window = 0;
  std::array<GLXContext, kContexts> m_contexts{};
  std::array<Objects, kContexts> m_objects{};
  std::size_t m_current = 0;
  std::mutex m_mutex;
  std::condition_variable m_arrived;
  std::deque<std::string> m_waiting;
  std::thread m_thread; ///< must be last, as the thread begins at once
};

void pester(Worker &worker, int number) {
  constexpr int kTimes = 500;
  g_pesters = true;
  g_handled = 0;
  for (int i = 0; i < kTimes; ++i) {
    pthread_kill(worker.handle(), SIGUSR1);
    usleep(1000);
  }
  g_pesters = false;
  say(number, "pestered " + std::to_string(g_handled));
}

} // namespace

int main() {
  // Reading must not use stdin's lock: in glibc 2.41 exit() waits for it while a read holds it.
  std::ios_base::sync_with_stdio(false);
  XInitThreads();
  struct sigaction action = {};
  action.sa_handler = handle; // without SA_RESTART, so that waits are interrupted
  sigaction(SIGUSR1, &action, nullptr);
  sigaction(SIGUSR2, &action, nullptr);
  static std::array<Worker *, kThreads> workers{};
  std::string line;
  while (std::getline(std::cin, line)) {
    const int number = line.empty() ? 0 : line[0] - '0';
    if (number < 0 || number >= kThreads || line.size() < 3)
      continue;
    Worker *&worker = workers[std::size_t(number)];
    if (!worker)
      worker = new Worker(number);
    const std::string words = line.substr(2);
    if (words == "signal")
      pthread_kill(worker->handle(), SIGUSR1);
    else if (words == "pester")
      pester(*worker, number);
    else if (words == "exit")
      pthread_kill(worker->handle(), SIGUSR2);
    else
      worker->take(words);
  }
  _exit(0);
}
