/// Nothing of this library is done at exit(): not LLVM's static destructors, nor any other. A
/// thread may be in a compilation then, which neither can be stopped nor should be waited for, as
/// exit() may come at any time, from a signal's handler too. All objects that are linked in here
/// register what is to be done through this function, which is found before libc's. The library is
/// never unmapped.
extern "C" __attribute__((visibility("hidden"))) int __cxa_atexit(void (*)(void *), void *,
                                                                  void *) {
  return 0;
}
