#include "apps/tools/launch/supervise.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "apps/tools/input.h"
#include "apps/tools/launch/child.h"

namespace arbiter::tools {

namespace {

/// Signals that end or notify a process, and have no meaning for the supervisor itself.
constexpr int kPassedOn[] = {SIGTERM, SIGHUP,  SIGINT,    SIGQUIT, SIGUSR1,
                             SIGUSR2, SIGALRM, SIGVTALRM, SIGWINCH};

volatile std::sig_atomic_t g_child = 0;

/// Passes a signal on to the child. Skips signals sent by the kernel, such as a terminal's: the
/// child is in the same process group and receives them itself.
void pass(int signal, siginfo_t *info, void *) {
  if (g_child > 0 && info->si_code <= 0)
    ::kill(pid_t(g_child), signal);
}

sigset_t passedOn() {
  sigset_t set;
  ::sigemptyset(&set);
  for (const int signal : kPassedOn)
    ::sigaddset(&set, signal);
  return set;
}

/// Waits until the parent has closed the other end of `pipe`. If it did not report that all is
/// done, it was killed: waits for the child's end and calls `afterwards`.
[[noreturn]] void watch(int pipe, pid_t child, const std::function<void()> &afterwards) {
  ::setsid(); // a signal to the group must not end this process
  char done = 0;
  while (::read(pipe, &done, 1) < 0 && errno == EINTR) {
  }
  if (done != 0)
    ::_exit(0);
  // The kernel kills the child with its parent.
  for (int i = 0; i < 500 && (::kill(child, 0) == 0 || errno != ESRCH); ++i)
    ::usleep(10000);
  afterwards();
  ::_exit(0);
}

/// Starts the helper of supervise(). It closes all inherited descriptors, because others may wait
/// for their end.
/// \returns the pipe end that tells the helper to exit, or -1
int startHelper(pid_t child, const std::function<void()> &afterwards) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    return -1;
  const pid_t helper = ::fork();
  if (helper == 0) {
    if (::fork() != 0) // forks twice: no process must wait for the helper
      ::_exit(0);
    const int own = ::fcntl(ends[0], F_DUPFD_CLOEXEC, 3);
    for (int i = 0; i < own; ++i)
      ::close(i);
    ::close_range(unsigned(own) + 1, ~0u, 0);
    watch(own, child, afterwards);
  }
  ::close(ends[0]);
  if (helper > 0)
    ::waitpid(helper, nullptr, 0);
  return ends[1];
}

/// Waits for the child's end; stops this process while the child is stopped.
int awaitEnd(pid_t child) {
  int status = 0;
  for (;;) {
    const pid_t changed = ::waitpid(child, &status, WUNTRACED);
    if (changed < 0 && errno == EINTR)
      continue;
    if (changed != child || !WIFSTOPPED(status))
      return status;
    ::raise(SIGSTOP);
    ::kill(child, SIGCONT);
  }
}

} // namespace

int supervise(const std::vector<Assignment> &environment, const std::vector<std::string> &command,
              const std::function<void()> &afterwards) {
  // Block the signals until there is a child to pass them on to. Otherwise a signal between the
  // fork and the handlers would end this process and leave the command running.
  const sigset_t passed = passedOn();
  sigset_t before;
  ::sigprocmask(SIG_BLOCK, &passed, &before);
  const pid_t child = startChild([&] {
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    return execute(environment, command);
  });
  if (child < 0) {
    complain(std::string("fork: ") + std::strerror(errno));
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    return -1;
  }
  g_child = child;
  const int helper = startHelper(child, afterwards);
  struct sigaction action = {};
  action.sa_sigaction = pass;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  for (const int signal : kPassedOn) {
    struct sigaction inherited = {};
    if (::sigaction(signal, nullptr, &inherited) == 0 && inherited.sa_handler != SIG_IGN)
      ::sigaction(signal, &action, nullptr);
  }
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
  const int status = awaitEnd(child);
  g_child = 0;
  afterwards();
  if (helper >= 0 && ::write(helper, "d", 1) == 1)
    ::close(helper);
  return status;
}

void endAs(int status) {
  if (WIFSIGNALED(status)) {
    const rlimit none = {};
    ::setrlimit(RLIMIT_CORE, &none);
    ::signal(WTERMSIG(status), SIG_DFL);
    sigset_t set;
    ::sigemptyset(&set);
    ::sigaddset(&set, WTERMSIG(status));
    ::sigprocmask(SIG_UNBLOCK, &set, nullptr);
    ::raise(WTERMSIG(status));
    std::_Exit(128 + WTERMSIG(status));
  }
  std::exit(WEXITSTATUS(status));
}

} // namespace arbiter::tools
