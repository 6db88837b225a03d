// Draws frames in which an allocation of the layer fails: rasterizer-allocations SCENE FROM STEP
// COUNT MODE, under libfailing_memory.so. Allocation FROM fails, then FROM + STEP, and so on: COUNT
// of them, or until a frame has fewer. MODE is once, or forgood: all later ones fail too. Between
// two of those frames the frame is drawn with all memory, and must look as at first. Prints "at N"
// before each, "wrong: ..." for each fault, and at the end "done: LAST failing allocations, MOST in
// a frame".
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>

#include "../rasterizer_vs_host/glx_windows.h"
#include "../rasterizer_vs_host/surface.h"
#include "allocations.h"
#include "failing_memory.h"

namespace memory {

namespace {

template <typename Function> Function *found(Function *, const char *name) {
  void *const function = dlsym(RTLD_DEFAULT, name);
  if (!function) {
    std::fprintf(stderr, "allocations: libfailing_memory.so is not preloaded\n");
    std::exit(2);
  }
  return reinterpret_cast<Function *>(function);
}

struct Errors {
  bool outOfMemory = false;
  std::string text;
};

Errors takeErrors() {
  Errors errors;
  for (int i = 0; i < 8; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR)
      break;
    errors.outOfMemory = errors.outOfMemory || error == GL_OUT_OF_MEMORY;
    char code[16];
    std::snprintf(code, sizeof code, " 0x%04x", error);
    errors.text += code;
  }
  return errors;
}

/// Returns how many pixels differ by more than the two rasterizers' rounding.
long unlike(const Pixels &a, const Pixels &b) {
  if (a.size() != b.size())
    return long(a.size() > b.size() ? a.size() : b.size());
  long count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    count += std::abs(a[i] - b[i]) > 1;
  return count;
}

class Test {
public:
  Test(Surface &window, const Scene &scene, bool forGood)
      : m_window(window), m_scene(scene), m_forGood(forGood) {
    m_scene.prepare(m_window);
    for (int i = 0; i < 4; ++i)
      m_reference = m_scene.frame(m_window, m_round++);
    if (const Errors errors = takeErrors(); !errors.text.empty())
      say(0, "errors with all memory:" + errors.text);
    const Pixels again = m_scene.frame(m_window, m_round++);
    if (unlike(again, m_reference) != 0)
      say(0, "two frames with all memory differ");
  }

  /// Draws a frame with a failing allocation. Returns false once a frame has fewer allocations.
  bool fail(long at) {
    std::printf("at %ld\n", at);
    std::fflush(stdout);
    m_arm(at, m_forGood ? 1 : 0);
    m_window.refused = false;
    const Pixels picture = m_scene.frame(m_window, m_round++);
    long made = 0;
    const long failures = m_disarm(&made);
    m_most = made > m_most ? made : m_most;
    const Errors errors = takeErrors();
    if (unlike(picture, m_reference) != 0 && !errors.outOfMemory && !m_window.refused)
      say(at, "another picture and no OUT_OF_MEMORY:" + errors.text);
    if (failures == 0 && !errors.text.empty())
      say(at, "no allocation failed, and there are errors:" + errors.text);
    m_window.refused = false;
    const Pixels after = m_scene.frame(m_window, m_round++);
    const Errors left = takeErrors();
    if (const long pixels = unlike(after, m_reference); pixels != 0)
      say(at, "the next frame differs in " + std::to_string(pixels) + " bytes:" + left.text);
    else if (!left.text.empty())
      say(at, "the next frame raises" + left.text);
    return failures != 0;
  }
  [[nodiscard]] long most() const { return m_most; }

private:
  static void say(long at, const std::string &what) {
    std::printf("wrong: at %ld: %s\n", at, what.c_str());
    std::fflush(stdout);
  }

  Surface &m_window;
  const Scene &m_scene;
  const bool m_forGood;
  decltype(failing_memory_arm) *m_arm = found(failing_memory_arm, "failing_memory_arm");
  decltype(failing_memory_disarm) *m_disarm = found(failing_memory_disarm, "failing_memory_disarm");
  Pixels m_reference;
  int m_round = 0;
  long m_most = 0;
};

} // namespace

bool Surface::open() {
  display = XOpenDisplay(nullptr);
  if (!display)
    return false;
  // The rasterizer must be able to draw to it: the host's first configuration may have another
  // layout.
  config = software::chooseGlxConfig(display, GLX_PBUFFER_BIT | GLX_WINDOW_BIT);
  if (!config)
    return false;
  x = software::makeWindow(display, config, kSide, kSide);
  drawable = glXCreateWindow(display, config, x, nullptr);
  context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
  return context && use(drawable, context);
}

bool Surface::use(GLXDrawable to, GLXContext with) {
  if (glXMakeContextCurrent(display, to, to, with))
    return true;
  refused = true;
  return false;
}

Pixels readPixels() {
  Pixels bytes(std::size_t(kSide) * kSide * 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  return bytes;
}

void reset() {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
  glDisable(GL_VERTEX_PROGRAM_ARB);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_TEXTURE_2D);
  glDisable(GL_DITHER);
  glDisableClientState(GL_VERTEX_ARRAY);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glPointSize(1);
  glColor4f(1, 1, 1, 1);
  glTexCoord4f(0, 0, 0, 1);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glViewport(0, 0, kSide, kSide);
  glClearColor(0.1f, 0.2f, 0.3f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

} // namespace memory

int main(int argc, char **argv) {
  using namespace memory;
  const Scene *const scene = software::rowNamed(kScenes, argc, argv);
  Surface window;
  if (!scene || argc != 6 || !window.open()) {
    std::fprintf(stderr, "allocations: no such scene, or no window\n");
    return 2;
  }
  const long from = std::atol(argv[2]), step = std::atol(argv[3]), count = std::atol(argv[4]);
  Test test(window, *scene, !std::strcmp(argv[5], "forgood"));
  long last = 0;
  for (long i = 0; i < count; ++i) {
    const long at = from + i * step;
    if (!test.fail(at))
      break;
    last = at;
  }
  std::printf("done: %ld %ld\n", last, test.most());
  return 0;
}
