#include "util/thread.h"

#include <cfenv>
#include <csignal>
#include <new>

#include <pthread.h>

namespace arbiter {

namespace {

struct Start {
  void (*run)(void *);
  void *argument;
  char name[16];
};

void *begin(void *argument) {
  const Start start = *static_cast<Start *>(argument);
  delete static_cast<Start *>(argument);
  // The new thread inherits the drawing thread's floating-point environment, whose traps would end
  // the process.
  (void)std::fesetenv(FE_DFL_ENV);
  (void)pthread_setname_np(pthread_self(), start.name);
  start.run(start.argument);
  return nullptr;
}

} // namespace

bool startThread(const char *name, std::size_t stackBytes, void (*run)(void *),
                 void *argument) noexcept {
  auto *const start = new (std::nothrow) Start{run, argument, {}};
  if (!start)
    return false;
  for (std::size_t i = 0; i + 1 < sizeof start->name && name[i]; ++i)
    start->name[i] = name[i];
  pthread_attr_t attributes;
  bool started = false;
  if (pthread_attr_init(&attributes) == 0) {
    sigset_t all, before;
    sigfillset(&all);
    pthread_t thread;
    pthread_sigmask(SIG_SETMASK, &all, &before);
    started = pthread_attr_setstacksize(&attributes, stackBytes) == 0 &&
              pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED) == 0 &&
              pthread_create(&thread, &attributes, begin, start) == 0;
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    pthread_attr_destroy(&attributes);
  }
  if (!started)
    delete start;
  return started;
}

NoCancel::NoCancel() noexcept { (void)pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &m_before); }
NoCancel::~NoCancel() { (void)pthread_setcancelstate(m_before, nullptr); }

} // namespace arbiter
