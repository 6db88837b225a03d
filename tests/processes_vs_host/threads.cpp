// Tests the application's threads (small, cancelled, or ending with a context) and the layer's.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <X11/Xlib.h>
#include <dirent.h>
#include <pthread.h>
#include <unistd.h>

#include "foreign.h"
#include "rows.h"

namespace foreign {

namespace {

void drawMore() {
  drawAndPrint();
  drawFrame(true);
  drawAndPrint();
}

template <unsigned long bytes> void smallStack() {
  openContext();
  makeCurrent(false);
  onThread(bytes, [] {
    makeCurrent(true);
    drawMore();
    makeCurrent(false);
  });
}

/// Links a GLSL program that resembles a vertex program with a texture. Returns whether that
/// worked.
bool linksGlsl() {
  const GLuint program = glCreateProgram();
  const auto attach = [program](GLenum stage, const char *text) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  };
  attach(GL_VERTEX_SHADER,
         "#version 120\nuniform sampler2D t;\nvoid main() {\n"
         "  gl_Position = ftransform() * texture2DLod(t, gl_MultiTexCoord0.xy, 0.0);\n"
         "  gl_TexCoord[0] = gl_MultiTexCoord0;\n}\n");
  attach(GL_FRAGMENT_SHADER, "#version 120\nuniform sampler2D t;\nvoid main() {\n"
                             "  gl_FragColor = texture2D(t, gl_TexCoord[0].xy);\n}\n");
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  return linked != 0;
}

/// Tests whether the host's linker works with such a small stack: Mesa 25's takes 57 of its 64 KB
/// in one function.
void smallStackLinks() {
  openContext();
  makeCurrent(false);
  onThread(64 << 10, [] {
    makeCurrent(true);
    std::printf("linked %d\n", linksGlsl());
    makeCurrent(false);
  });
}

/// Makes the first draw with a large stack, as most programs do; then a small thread continues.
void smallStackLater() {
  openContext();
  drawAndPrint();
  makeCurrent(false);
  onThread(64 << 10, [] {
    makeCurrent(true);
    drawAndPrint();
    makeCurrent(false);
  });
}

void endsWithContext() {
  openContext();
  drawAndPrint();
  makeCurrent(false);
  for (int i = 0; i < 3; ++i)
    onThread(1 << 20, [] {
      makeCurrent(true);
      drawAndPrint();
    });
}

/// Cancels a thread during a frame; it ends at its first wait, which is the host's or the layer's.
/// The host's locks then stay locked, so that the process ends without destructors.
template <bool first> void cancelledInFrame() {
  openContext();
  makeCurrent(false);
  pthread_t thread;
  need(pthread_create(
           &thread, nullptr,
           [](void *) -> void * {
             makeCurrent(true);
             if (!first)
               drawFrame();
             pthread_cancel(pthread_self());
             drawFrame();
             pthread_testcancel();
             return nullptr;
           },
           nullptr) == 0,
       "a thread");
  void *result = nullptr;
  pthread_join(thread, &result);
  std::printf("cancelled %d\n", result == PTHREAD_CANCELED);
  std::fflush(stdout);
  _exit(0);
}

template <bool fresh> void cancelled() {
  openContext();
  makeCurrent(false);
  pthread_t thread;
  need(pthread_create(
           &thread, nullptr,
           [](void *) -> void * {
             makeCurrent(true);
             for (;;) {
               drawFrame(fresh);
               pthread_testcancel();
             }
             return nullptr;
           },
           nullptr) == 0,
       "a thread");
  usleep(useconds_t(1000 * (100 + someMilliseconds())));
  pthread_cancel(thread);
  void *result = nullptr;
  pthread_join(thread, &result);
  std::printf("cancelled %d\n", result == PTHREAD_CANCELED);
  std::fflush(stdout);
  _exit(0);
}

/// Deletes textures in another thread and context at any time, while draws here use them.
void otherContextDeletes() {
  XInitThreads();
  openContext();
  drawAndPrint();
  std::atomic<bool> done = false;
  std::thread other([&] {
    onOtherContext([] {
      usleep(useconds_t(1000 * someMilliseconds()));
      deleteTextures();
    });
    done = true;
  });
  while (!done)
    drawFrame();
  other.join();
  drawAndPrint();
}

/// Tests that threads of the layer take no signals: an application's handlers run on its own
/// threads.
void threadsOfTheLayer() {
  openContext();
  for (int i = 0; i < 4; ++i)
    drawFrame(i == 1);
  int open = 0;
  DIR *const tasks = opendir("/proc/self/task");
  while (const dirent *const entry = tasks ? readdir(tasks) : nullptr) {
    char text[4096] = {};
    const std::string path = std::string("/proc/self/task/") + entry->d_name + "/status";
    std::FILE *const file = std::fopen(path.c_str(), "r");
    if (!file)
      continue;
    if (std::fread(text, 1, sizeof text - 1, file) && std::strstr(text, "arbiter")) {
      const char *const blocked = std::strstr(text, "SigBlk:\t");
      // The mask has all but SIGKILL, SIGSTOP and glibc's own two.
      open += !blocked || (std::strtoull(blocked + 8, nullptr, 16) | 0x180040100ull) != ~0ull;
    }
    std::fclose(file);
  }
  closedir(tasks);
  std::printf("threads of ours that take signals: %d\n", open);
}

} // namespace

void threadRows(void (*add)(Row)) {
  add({"small-stack", smallStack<64 << 10>});
  add({"small-stack-128k", smallStack<128 << 10>});
  add({"small-stack-later", smallStackLater});
  add({"small-stack-links", smallStackLinks});
  add({"thread-ends-with-context", endsWithContext});
  add({"cancelled-in-first-frame", cancelledInFrame<true>});
  add({"cancelled-in-frame", cancelledInFrame<false>});
  add({"cancelled-drawing", cancelled<false>});
  add({"cancelled-compiling", cancelled<true>});
  add({"other-context-deletes-drawing", otherContextDeletes});
  add({"threads-of-ours", threadsOfTheLayer});
}

} // namespace foreign
