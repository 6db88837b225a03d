// Tests the ways to end a process during draws or compilations.
#include <csetjmp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include <dlfcn.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include "foreign.h"
#include "rows.h"

namespace foreign {

namespace {

/// Draws until the alarm calls `end`.
template <void (*end)(int)> void drawUntil() {
  openContext();
  drawFrame();
  alarmAfter(someMilliseconds(), end);
  drawForEver(false);
}
template <void (*end)(int)> void compileUntil() {
  openContext();
  drawFrame();
  alarmAfter(someMilliseconds(), end);
  drawForEver(true);
}

template <void (*end)(int)> void drawBitmapsUntil() {
  openContext();
  drawBitmaps();
  alarmAfter(someMilliseconds(), end);
  for (;;)
    drawBitmaps();
}

void callExit(int) { std::exit(7); }
void callUnderscoreExit(int) { _exit(7); }
void callQuickExit(int) { std::quick_exit(7); }
void callAbort(int) { std::abort(); }
template <int signal> void raiseIt(int) { kill(getpid(), signal); }
template <int signal> void die() { drawUntil<raiseIt<signal>>(); }

/// Calls `end` on another thread, while this one draws.
template <void (*end)(int), bool fresh> void endFromThread() {
  openContext();
  drawFrame();
  std::thread([] {
    usleep(useconds_t(1000 * someMilliseconds()));
    end(0);
  }).detach();
  drawForEver(fresh);
}

/// Calls an exit() that continues long after libGLX's destructor, while this thread draws on.
void endSlowlyFromThread() {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe");
  const std::string library = self.substr(0, self.rfind('/')) + "/foreign_slow_end.so";
  need(dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL) != nullptr, "foreign_slow_end.so");
  endFromThread<callExit, false>();
}

sigjmp_buf g_back;
void jump(int) { siglongjmp(g_back, 1); }
/// Jumps out of a draw that never continues, then calls exit().
void longjmpThenExit() {
  openContext();
  drawFrame();
  if (sigsetjmp(g_back, 1) == 0) {
    alarmAfter(someMilliseconds(), jump);
    drawForEver(false);
  }
  std::puts("jumped");
}

void drawAtExit() {
  openContext();
  drawAndPrint();
  static struct Last {
    ~Last() { drawAndPrint(); }
  } s_last;
  (void)s_last;
  std::atexit(drawAndPrint);
}

void returnFromMain() {
  openContext();
  for (int i = 0; i < 3; ++i)
    drawAndPrint();
}

void exitWhileOtherDraws() {
  openContext();
  drawFrame();
  makeCurrent(false);
  std::thread([] {
    makeCurrent(true);
    drawForEver(false);
  }).detach();
  usleep(useconds_t(1000 * someMilliseconds()));
  std::exit(7);
}

/// Draws until it is killed from outside.
void drawForEverSaying() {
  openContext();
  for (int i = 0; i < 3; ++i)
    drawFrame();
  std::printf("drawing %d\n", int(getpid()));
  std::fflush(stdout);
  drawForEver(false);
}

/// Ends the process by its last thread.
void mainEndsFirst() {
  std::thread([] {
    usleep(20000);
    openContext();
    drawAndPrint();
    std::exit(5);
  }).detach();
  pthread_exit(nullptr);
}

void fileTooLarge() {
  openContext();
  drawFrame();
  rlimit limit = {4096, 4096};
  setrlimit(RLIMIT_FSIZE, &limit);
  drawFrame(true);
  std::FILE *const file = std::tmpfile();
  need(file != nullptr, "a file");
  static char s_block[65536];
  std::fwrite(s_block, 1, sizeof s_block, file);
  std::fflush(file); // SIGXFSZ
}

void brokenPipe() {
  openContext();
  drawFrame();
  int ends[2];
  need(pipe(ends) == 0, "a pipe");
  close(ends[0]);
  const ssize_t written = write(ends[1], "x", 1); // SIGPIPE
  std::printf("%zd\n", written);
}

} // namespace

void endRows(void (*add)(Row)) {
  add({"return-from-main", returnFromMain});
  add({"exit-in-handler-drawing", drawUntil<callExit>});
  add({"exit-in-handler-compiling", compileUntil<callExit>});
  add({"exit-in-handler-drawing-bitmaps", drawBitmapsUntil<callExit>});
  add({"_exit-in-handler-drawing", drawUntil<callUnderscoreExit>});
  add({"quick_exit-in-handler-drawing", drawUntil<callQuickExit>});
  add({"abort-in-handler-compiling", compileUntil<callAbort>});
  add({"exit-in-thread-drawing", endFromThread<callExit, false>});
  add({"exit-slowly-in-thread-drawing", endSlowlyFromThread});
  add({"exit-in-thread-compiling", endFromThread<callExit, true>});
  add({"abort-in-thread-drawing", endFromThread<callAbort, false>});
  add({"exit-while-other-draws", exitWhileOtherDraws});
  add({"main-ends-first", mainEndsFirst});
  add({"draw-for-ever", drawForEverSaying});
  add({"longjmp-then-exit", longjmpThenExit});
  add({"draw-at-exit", drawAtExit});
  add({"sigint", die<SIGINT>});
  add({"sigterm", die<SIGTERM>});
  add({"sighup", die<SIGHUP>});
  add({"sigpipe", die<SIGPIPE>});
  add({"sigxfsz", die<SIGXFSZ>});
  add({"sigsegv", die<SIGSEGV>});
  add({"sigkill", die<SIGKILL>});
  add({"sigkill-compiling", compileUntil<raiseIt<SIGKILL>>});
  add({"file-too-large", fileTooLarge});
  add({"broken-pipe", brokenPipe});
}

} // namespace foreign
