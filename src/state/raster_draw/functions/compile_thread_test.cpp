// Checks tasks that wait for the first frame's end. A process has one, so each case is a child
// process.
#include "state/raster_draw/functions/compile_thread.h"

#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace arbiter::state {
namespace {

using std::chrono::milliseconds;

std::atomic<int> g_done{0};
const auto kTask = [] { ++g_done; };

bool inChild(const std::function<bool()> &run) {
  const pid_t child = fork();
  if (child == 0)
    _exit(run() ? 0 : 1);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}
/// Tries inChild() several times, because a busy machine may delay it.
bool inSomeChild(const std::function<bool()> &run) {
  return inChild(run) || inChild(run) || inChild(run);
}
/// Waits until that many tasks are done, at most ten seconds. \return the time it took
milliseconds until(int done) {
  const auto begin = std::chrono::steady_clock::now();
  while (g_done.load() < done && std::chrono::steady_clock::now() - begin < milliseconds(10000))
    std::this_thread::sleep_for(milliseconds(1));
  return std::chrono::duration_cast<milliseconds>(std::chrono::steady_clock::now() - begin);
}

TEST(CompileThread, ItWaitsForTheFramesEnd) {
  EXPECT_TRUE(inSomeChild([] {
    compileLater(kTask, When::AfterFrame);
    compileLater(kTask);
    (void)until(1);
    std::this_thread::sleep_for(milliseconds(20));
    if (g_done.load() != 1) // the task that was posted later
      return false;
    frameEndsForCompiler();
    (void)until(2);
    compileLater(kTask, When::AfterFrame); // a task of a later frame
    return g_done.load() == 2 || until(3) < milliseconds(400);
  }));
}

TEST(CompileThread, ItWaitsNoLongerThanAFrameMayTake) {
  EXPECT_TRUE(inChild([] {
    compileLater(kTask, When::AfterFrame);
    const milliseconds time = until(1);
    return g_done.load() == 1 && time >= milliseconds(450);
  }));
}

TEST(CompileThread, WhoWaitsForItEndsTheWait) {
  EXPECT_TRUE(inChild([] {
    compileLater(kTask, When::AfterFrame);
    compileLater(kTask, When::AfterFrame);
    awaitCompiler(std::nullopt);
    return g_done.load() == 2;
  }));
}

TEST(CompileThread, AFrameMayEndBeforeThereIsAThread) {
  EXPECT_TRUE(inSomeChild([] {
    frameEndsForCompiler();
    compileLater(kTask, When::AfterFrame);
    return until(1) < milliseconds(400);
  }));
}

} // namespace
} // namespace arbiter::state
