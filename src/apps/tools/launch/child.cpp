#include "apps/tools/launch/child.h"

#include <cerrno>
#include <csignal>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace arbiter::tools {

pid_t startChild(const std::function<int()> &work) {
  const pid_t self = ::getpid();
  const pid_t child = ::fork();
  if (child != 0)
    return child;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::_exit(::getppid() == self ? work() : 1);
}

bool awaitChild(pid_t child, std::chrono::milliseconds atMost, int &status) {
  using Clock = std::chrono::steady_clock;
  constexpr useconds_t kPoll = 10000;
  const auto end = Clock::now() + atMost;
  for (;;) {
    if (::waitpid(child, &status, WNOHANG) != 0)
      return true;
    if (Clock::now() >= end)
      return false;
    ::usleep(kPoll);
  }
}

void endChild(pid_t child, int signal) {
  ::kill(child, signal);
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
  }
}

} // namespace arbiter::tools
