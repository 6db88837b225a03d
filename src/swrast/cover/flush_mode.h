#pragma once
#if defined(__x86_64__) || defined(__i386__)
#include <xmmintrin.h>
#endif

namespace arbiter::swrast {

/// The floating-point mode that the machine code of programs computes in, for as long as this
/// lives: denormals are zeros, nothing traps, results are rounded to nearest. A function sets it by
/// itself if it must, but each change waits until all that is under way has been computed, which
/// for a block or two of pixels takes longer than shading them.
class FlushMode {
public:
  FlushMode(const FlushMode &) = delete;
  FlushMode &operator=(const FlushMode &) = delete;
#if defined(__x86_64__) || defined(__i386__)
  FlushMode() : m_before(_mm_getcsr()) { _mm_setcsr(0x9FC0); }
  ~FlushMode() { _mm_setcsr(m_before); }

private:
  unsigned m_before;
#elif defined(__aarch64__)
  FlushMode() {
    unsigned long mode = 0;
    __asm__ volatile("mrs %0, fpcr" : "=r"(m_before));
    mode = 1ul << 24;
    __asm__ volatile("msr fpcr, %0" : : "r"(mode));
  }
  ~FlushMode() { __asm__ volatile("msr fpcr, %0" : : "r"(m_before)); }

private:
  unsigned long m_before = 0;
#else
  FlushMode() = default;
#endif
};

} // namespace arbiter::swrast
