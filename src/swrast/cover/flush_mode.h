#pragma once
#if defined(__x86_64__) || defined(__i386__)
#include <xmmintrin.h>
#endif

namespace arbiter::swrast {

/// Sets the floating-point mode of the programs' machine code while this object lives: denormals
/// are zeros, no traps, round to nearest. The machine code sets the mode itself where it must. But
/// each change waits for all instructions in flight, which takes longer than shading a block or two
/// of pixels.
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
