// Tests environments that a process makes for itself, or is given.
#include <cerrno>
#include <cfenv>
#include <clocale>
#include <csetjmp>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "foreign.h"
#include "rows.h"

namespace foreign {

namespace {

void drawTwo() {
  openContext();
  drawAndPrint();
  drawFrame(true);
  drawAndPrint();
}

void trapsOnFloats() {
  openContext();
  std::feclearexcept(FE_ALL_EXCEPT);
  feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
  drawAndPrint();
  drawFrame(true);
  drawAndPrint();
  std::printf("traps %d\n", fegetexcept());
}

void oddRounding() {
  openContext();
  std::fesetround(FE_UPWARD);
#if defined(__x86_64__)
  _mm_setcsr(_mm_getcsr() | 0x8040u); // flush to zero, denormals are zero
#endif
  drawAndPrint();
  drawFrame(true);
  drawAndPrint();
  std::printf("rounding %d\n", std::fegetround() == FE_UPWARD);
#if defined(__x86_64__)
  std::printf("flush %x\n", _mm_getcsr() & 0x8040u);
#endif
}

/// Makes mmap and mprotect refuse PROT_EXEC from now on.
void refuseExecutableMemory() {
  const unsigned protection = offsetof(seccomp_data, args[2]);
  sock_filter filter[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_mmap, 1, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_mprotect, 0, 3),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, protection),
      BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, PROT_EXEC, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  sock_fprog program = {sizeof filter / sizeof *filter, filter};
  need(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program) == 0,
       "seccomp");
}
void sandboxedBefore() {
  refuseExecutableMemory();
  drawTwo();
}
void sandboxedAfterAFrame() {
  openContext();
  drawAndPrint();
  drawAndPrint();
  refuseExecutableMemory();
  for (int i = 0; i < 5; ++i)
    drawAndPrint();
}

/// Tests closed standard descriptors: files that libraries open get their numbers.
void withoutStandardDescriptors() {
  const int kept = fcntl(1, F_DUPFD, 100);
  close(0);
  close(1);
  close(2);
  openContext();
  for (int i = 0; i < 3; ++i)
    drawFrame(i == 1);
  dup2(kept, 1);
  drawAndPrint();
}

/// Tests a program that closes all descriptors, as daemons do. Files that it then opens have the
/// same numbers, and must contain only what it wrote itself.
void closesAllDescriptors() {
  for (int i = 3; i < 64; ++i)
    close(i);
  int own[16];
  for (int &descriptor : own) {
    descriptor = memfd_create("own", 0);
    need(write(descriptor, "mine", 4) == 4, "write");
  }
  openContext();
  drawAndPrint();
  drawFrame(true);
  for (const int descriptor : own) {
    struct stat status = {};
    need(fstat(descriptor, &status) == 0 && status.st_size == 4, "a file of the program's own");
  }
  drawAndPrint();
}

template <int what, unsigned long value> void limited() {
  const rlimit limit = {value, value};
  need(setrlimit(__rlimit_resource(what), &limit) == 0, "setrlimit");
  drawTwo();
}

volatile sig_atomic_t g_alarms = 0;
void count(int) { g_alarms = g_alarms + 1; }
/// Tests calls that are interrupted a thousand times a second, and not restarted by the kernel.
void interrupted() {
  openContext();
  alarmAfter(1, count);
  itimerval timer = {{0, 1000}, {0, 1000}};
  setitimer(ITIMER_REAL, &timer, nullptr);
  for (int i = 0; i < 60; ++i)
    drawFrame(i % 8 == 7);
  timer = {};
  setitimer(ITIMER_REAL, &timer, nullptr);
  drawAndPrint();
  std::printf("alarms %d\n", g_alarms > 10);
}

void drawInHandler(int) { drawAndPrint(); }
void handlerDraws() {
  openContext();
  drawAndPrint();
  alarmAfter(20, drawInHandler);
  while (usleep(1000000) == 0) {
  }
  drawAndPrint();
}

sigjmp_buf g_recover;
void recover(int) { siglongjmp(g_recover, 1); }
/// Tests a program that handles its own faults on an alternate stack, before, between and after
/// frames.
void ownFaults() {
  static char s_stack[65536];
  const stack_t stack = {s_stack, 0, sizeof s_stack};
  sigaltstack(&stack, nullptr);
  struct sigaction action = {};
  action.sa_handler = recover;
  action.sa_flags = SA_ONSTACK;
  sigaction(SIGSEGV, &action, nullptr);
  for (int i = 0; i < 4; ++i) {
    if (sigsetjmp(g_recover, 1) == 0) {
      static int *volatile s_nowhere = nullptr;
      *s_nowhere = 1;
    }
    if (i == 0)
      openContext();
    drawAndPrint();
  }
  struct sigaction after = {};
  sigaction(SIGSEGV, nullptr, &after);
  std::printf("handler %d\n", after.sa_handler == recover);
}

void signalsAsBefore() {
  struct sigaction before[32], after = {};
  for (int i = 1; i < 32; ++i)
    sigaction(i, nullptr, &before[i]);
  openContext();
  for (int i = 0; i < 4; ++i)
    drawFrame(i == 2);
  int changed = 0;
  for (int i = 1; i < 32; ++i) {
    sigaction(i, nullptr, &after);
    changed += after.sa_handler != before[i].sa_handler;
  }
  sigset_t blocked;
  pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
  std::printf("changed %d blocked %d umask %o\n", changed, sigismember(&blocked, SIGALRM),
              umask(0));
}

void chrooted() {
  openContext();
  drawAndPrint();
  need(chdir("/proc") == 0 || chdir("/") == 0, "chdir");
  if (chroot("/proc") != 0)
    std::puts("not allowed");
  drawFrame(true);
  drawAndPrint();
}

void noEnvironment() {
  const std::string display = std::getenv("DISPLAY") ? std::getenv("DISPLAY") : "";
  clearenv();
  setenv("DISPLAY", display.c_str(), 1);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  drawTwo();
}

void noWritesAllowed() {
  umask(0777);
  drawTwo();
}

void commaLocale() {
  const bool set = std::setlocale(LC_ALL, std::getenv("FOREIGN_LOCALE")) != nullptr;
  std::printf("%d %g\n", set, 0.5);
  drawTwo();
}

/// The application's exceptions, by their base class.
struct Refused : std::exception {};
struct Odd {};

/// Tests a debug callback that throws within a command of the host, and an application that catches
/// the exception around the command.
template <typename Exception> void callbackThrows() {
  openContext();
  drawAndPrint();
  const auto listen = reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKPROC>(
      glXGetProcAddressARB(reinterpret_cast<const GLubyte *>("glDebugMessageCallback")));
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  listen([](GLenum, GLenum, GLuint, GLenum, GLsizei, const GLchar *,
            const void *) { throw Exception(); },
         nullptr);
  void (*const wrong[])() = {
      [] { glTexImage2D(GL_TEXTURE_2D, -1, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); },
      [] { glCopyTexSubImage2D(GL_TEXTURE_2D, -1, 0, 0, 0, 0, 4, 4); },
      [] { glDrawArrays(0x7777, 0, 3); },
      [] { glBindTexture(0x7777, 1); },
      [] { glReadPixels(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); },
      [] { glBindFramebuffer(0x7777, 0); },
      [] { glDeleteTextures(-1, nullptr); },
  };
  for (void (*const command)() : wrong) {
    bool caught = false;
    try {
      command();
    } catch (const Exception &) {
      caught = true;
    }
    std::printf("caught %d, error %#x\n", caught, glGetError());
  }
  listen(nullptr, nullptr);
  drawFrame(true);
  drawAndPrint();
}

} // namespace

void surroundingRows(void (*add)(Row)) {
  add({"plain", drawTwo});
  add({"traps-on-floats", trapsOnFloats});
  add({"odd-rounding", oddRounding});
  add({"no-executable-memory", sandboxedBefore});
  add({"no-executable-memory-after", sandboxedAfterAFrame});
  add({"no-standard-descriptors", withoutStandardDescriptors});
  add({"closes-all-descriptors", closesAllDescriptors});
  add({"limit-file-size", limited<RLIMIT_FSIZE, 0>});
  add({"limit-address-space", limited<RLIMIT_AS, 3ul << 30>});
  add({"limit-descriptors", limited<RLIMIT_NOFILE, 24>});
  add({"limit-stack", limited<RLIMIT_STACK, 256 << 10>});
  add({"interrupted", interrupted});
  add({"handler-draws", handlerDraws});
  add({"own-faults", ownFaults});
  add({"signals-as-before", signalsAsBefore});
  add({"callback-throws", callbackThrows<Refused>});
  add({"callback-throws-odd", callbackThrows<Odd>});
  add({"chroot", chrooted});
  add({"no-environment", noEnvironment});
  add({"umask", noWritesAllowed});
  add({"comma-locale", commaLocale});
}

} // namespace foreign
