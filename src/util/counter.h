#pragma once
#include <atomic>
#include <cstdint>

namespace arbiter {

/// A count that one thread advances and any thread may read. Advancing it costs no more than a
/// plain number: no other thread advances it, so the sum needs no locked instruction.
class Counter {
public:
  constexpr Counter(std::uint64_t value = 0) : m_value(value) {}
  Counter(const Counter &other) : m_value(std::uint64_t(other)) {}
  Counter &operator=(const Counter &other) { return *this = std::uint64_t(other); }
  Counter &operator=(std::uint64_t value) {
    m_value.store(value, std::memory_order_relaxed);
    return *this;
  }
  operator std::uint64_t() const { return m_value.load(std::memory_order_relaxed); }
  Counter &operator+=(std::uint64_t more) { return *this = *this + more; }
  Counter &operator++() { return *this += 1; }

private:
  std::atomic<std::uint64_t> m_value;
};

} // namespace arbiter
