// Tests exit(), or a jump out, in a handler that interrupted the layer's own code at any place.
// That code may hold any lock of the layer, and none of the host's or malloc's (watch.h). It is a
// program of its own, as it has its own malloc.
#include <csetjmp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>

#include <sys/time.h>
#include <unistd.h>

#include "foreign.h"
#include "rows.h"
#include "watch.h"

namespace foreign {

namespace {

/// The alarms come each millisecond. That many of the first ones wait for code of the layer; none
/// do on the bare host, where the program's own code serves.
int g_alarmsForLayer = 0;
volatile sig_atomic_t g_alarms = 0;
volatile sig_atomic_t g_stopped = 0;
/// The kind of drawing in which the layer's code is to be interrupted.
enum class What { Frame, Bitmaps, ManyPixels };
What g_what = What::Frame;

/// Prints the line that run.py requires from each process with the layer.
void reportPlace(bool inLayer) {
  static constexpr char kText[] = "foreign: interrupted the layer\n";
  if (inLayer && write(2, kText, sizeof kText - 1) < 0)
    _exit(3);
}

bool isPlaceWanted() {
  g_alarms = g_alarms + 1;
  const bool inLayer = interruptedInLayer() && (g_what == What::Frame || isInMidst());
  const bool wanted = inLayer || (g_alarms > g_alarmsForLayer && interruptedOutsideHost());
  if (wanted)
    reportPlace(inLayer);
  return wanted;
}

void exitThere(int) {
  if (!isPlaceWanted())
    return;
  watchLayer();
  std::exit(7);
}

void stopThere(int) {
  if (!isPlaceWanted())
    return;
  g_stopped = 1;
  for (;;)
    pause();
}

void draw(bool fresh) {
  switch (g_what) {
  case What::Frame:
    return drawFrame(fresh);
  case What::Bitmaps:
    return drawBitmaps();
  case What::ManyPixels:
    return drawManyPixels();
  }
}

void drawInterruptedBy(void (*handler)(int), bool fresh) {
  prepareWatch();
  openContext();
  g_alarmsForLayer = isLayerLoaded() ? 10000 : 0;
  draw(false);
  alarmAfter(someMilliseconds(), handler);
  itimerval timer = {{0, 1000}, {0, 1000 * someMilliseconds()}};
  setitimer(ITIMER_REAL, &timer, nullptr);
  for (;;) {
    draw(fresh);
    if (g_alarms > g_alarmsForLayer)
      usleep(1000);
  }
}

void exitInBitmap() {
  g_what = What::Bitmaps;
  drawInterruptedBy(exitThere, false);
}

template <bool fresh> void exitInLayer() { drawInterruptedBy(exitThere, fresh); }

/// Ends the process on another thread while the drawing thread stands still within the layer.
template <bool fresh> void exitBesideLayer() {
  std::thread([] {
    sigset_t alarm;
    sigemptyset(&alarm);
    sigaddset(&alarm, SIGALRM);
    pthread_sigmask(SIG_BLOCK, &alarm, nullptr);
    while (!g_stopped)
      usleep(500);
    watchLayer();
    std::exit(7);
  }).detach();
  drawInterruptedBy(stopThere, fresh);
}

sigjmp_buf g_back;
void jumpThere(int) {
  if (g_stopped || !isPlaceWanted()) // the jump lets the next alarm in
    return;
  g_stopped = 1;
  siglongjmp(g_back, 1);
}

/// Overwrites the stack below the caller's frame.
[[gnu::noinline]] void overwriteStack() {
  unsigned char bytes[256 * 1024];
  std::memset(bytes, 0xA5, sizeof bytes);
  asm volatile("" : : "r"(bytes) : "memory");
}

/// Jumps out of a draw that other threads work on. It never continues, and other functions reuse
/// its stack frames.
void jumpOutOfDraw() {
  g_what = What::ManyPixels;
  if (sigsetjmp(g_back, 1) == 0)
    drawInterruptedBy(jumpThere, false);
  const itimerval none = {};
  setitimer(ITIMER_REAL, &none, nullptr);
  for (int i = 0; i < 5000; ++i)
    overwriteStack();
  std::puts("jumped");
}

} // namespace

void watchedRows(void (*add)(Row)) {
  add({"exit-in-layer-drawing", exitInLayer<false>});
  add({"exit-in-layer-drawing-bitmaps", exitInBitmap});
  add({"exit-in-layer-compiling", exitInLayer<true>});
  add({"longjmp-out-of-layer-drawing", jumpOutOfDraw});
  add({"exit-beside-layer-drawing", exitBesideLayer<false>});
  add({"exit-beside-layer-compiling", exitBesideLayer<true>});
}

} // namespace foreign
