/// Disables exit handlers of this library: LLVM's static destructors and all others. A compilation
/// may run on another thread at exit(). It can neither be stopped nor waited for, because exit()
/// may come at any time, even from a signal handler. All objects linked here register their
/// handlers through this function, which the linker finds before libc's. The library is never
/// unmapped.
extern "C" __attribute__((visibility("hidden"))) int __cxa_atexit(void (*)(void *), void *,
                                                                  void *) {
  return 0;
}
