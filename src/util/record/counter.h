#pragma once
#include <cstdint>

namespace arbiter {

/// A count that one thread advances and any thread may read. Advancing it costs no more than a
/// plain number, because no other thread does: the sum needs no locked instruction. On a processor
/// of 32 bits, a reader may see the halves of two values while the lower half overflows.
class Counter {
public:
  constexpr Counter(std::uint64_t value = 0) : m_value(value) {}
  Counter(const Counter &other) : m_value(other) {}
  Counter &operator=(const Counter &other) { return *this = std::uint64_t(other); }

#ifdef __LP64__
  Counter &operator=(std::uint64_t value) {
    __atomic_store_n(&m_value, value, __ATOMIC_RELAXED);
    return *this;
  }
  operator std::uint64_t() const { return __atomic_load_n(&m_value, __ATOMIC_RELAXED); }
#else
  // Atomic access to 64 bits would go through the x87 stack, which an application may use for MMX.
  Counter &operator=(std::uint64_t value) {
    m_value = value;
    return *this;
  }
  operator std::uint64_t() const { return m_value; }
#endif

  Counter &operator+=(std::uint64_t more) {
#ifdef __x86_64__
    // Compilers make three instructions of the load, the sum and the store.
    __asm__("addq %1, %0" : "+m"(m_value) : "er"(more) : "cc");
    return *this;
#else
    return *this = *this + more;
#endif
  }
  Counter &operator++() { return *this += 1; }

private:
  std::uint64_t m_value;
};

} // namespace arbiter
