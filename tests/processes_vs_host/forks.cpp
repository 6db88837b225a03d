// Tests fork, vfork and exec at various moments.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "foreign.h"
#include "rows.h"

extern char **environ;

namespace foreign {

namespace {

void await(pid_t child) {
  int status = 0;
  need(child > 0 && waitpid(child, &status, 0) == child, "a child");
  std::printf("child %d %d\n", WIFEXITED(status) ? WEXITSTATUS(status) : -1,
              WIFSIGNALED(status) ? WTERMSIG(status) : 0);
  std::fflush(stdout);
}

pid_t forked() {
  std::fflush(stdout);
  return fork();
}

/// Draws in both processes, each with a context of its own.
void beforeContext() {
  const pid_t child = forked();
  if (child != 0)
    await(child);
  openContext();
  drawAndPrint();
}

void childUnderscoreExits() {
  openContext();
  for (int i = 0; i < 5; ++i) {
    drawAndPrint();
    const pid_t child = forked();
    if (child == 0)
      _exit(i);
    await(child);
  }
  drawAndPrint();
}

/// Lets the child call exit(), which runs the functions that this process registered for its own
/// end.
void childExits() {
  openContext();
  for (int i = 0; i < 3; ++i) {
    drawAndPrint();
    const pid_t child = forked();
    if (child == 0)
      std::exit(i);
    await(child);
  }
  drawAndPrint();
}

void childExecs() {
  openContext();
  for (int i = 0; i < 3; ++i) {
    drawAndPrint();
    const pid_t child = forked();
    if (child == 0) {
      execl("/bin/sh", "sh", "-c", "exit 6", nullptr);
      _exit(1);
    }
    await(child);
  }
  std::printf("system %d\n", WEXITSTATUS(std::system("exit 9")));
  drawAndPrint();
}

/// Lets the child execute this program from the start.
void childExecsDrawing() {
  openContext();
  drawAndPrint();
  const pid_t child = forked();
  if (child == 0) {
    execl("/proc/self/exe", "foreign", "plain", nullptr);
    _exit(1);
  }
  await(child);
  drawAndPrint();
}

void execsItself() {
  openContext();
  drawAndPrint();
  execl("/proc/self/exe", "foreign", "plain", nullptr);
  _exit(1);
}

void spawns() {
  openContext();
  for (int i = 0; i < 3; ++i) {
    drawAndPrint();
    std::fflush(stdout);
    pid_t child = vfork();
    if (child == 0)
      _exit(3);
    await(child);
    char name[] = "sh", flag[] = "-c", command[] = "exit 4";
    char *const arguments[] = {name, flag, command, nullptr};
    need(posix_spawn(&child, "/bin/sh", nullptr, nullptr, arguments, environ) == 0, "spawn");
    await(child);
  }
}

/// Forks on another thread while this one draws with new programs.
void whileCompiling() {
  openContext();
  drawFrame();
  std::atomic<bool> done{false};
  std::atomic<int> right{0};
  std::thread forker([&] {
    for (int i = 0; i < 12; ++i) {
      const pid_t child = fork();
      if (child == 0) {
        if (i % 2)
          execl("/bin/sh", "sh", "-c", "exit 5", nullptr);
        _exit(5);
      }
      int status = 0;
      right += waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 5;
    }
    done = true;
  });
  while (!done)
    drawFrame(true);
  forker.join();
  std::printf("right %d\n", right.load());
  drawAndPrint();
}

} // namespace

void forkRows(void (*add)(Row)) {
  add({"fork-before-context", beforeContext});
  add({"fork-child-_exits", childUnderscoreExits});
  add({"fork-child-exits", childExits});
  add({"fork-child-execs", childExecs});
  add({"fork-child-execs-drawing", childExecsDrawing});
  add({"exec-itself", execsItself});
  add({"spawn-and-vfork", spawns});
  add({"fork-while-compiling", whileCompiling});
}

} // namespace foreign
