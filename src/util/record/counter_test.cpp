#include "util/record/counter.h"

#include <atomic>
#include <cstdint>
#include <limits>
#include <thread>

#include <gtest/gtest.h>

namespace arbiter {
namespace {

TEST(Counter, AddsNumbersOfAnySize) {
  Counter counter = 5;
  ++counter;
  EXPECT_EQ(counter, 6u);
  // The largest of each kind of immediate operand, and numbers that need a register.
  std::uint64_t expected = 6;
  for (const std::uint64_t more : {std::uint64_t(0), std::uint64_t(0x7FFFFFFF),
                                   std::uint64_t(0x80000000), std::uint64_t(1) << 40}) {
    counter += more;
    expected += more;
    EXPECT_EQ(counter, expected);
  }
  counter += 0x7FFFFFFF;
  counter += 0x80000000;
  counter += 0xFFFFFFFF;
  EXPECT_EQ(counter, expected + 0x7FFFFFFF + 0x80000000 + 0xFFFFFFFF);
  counter = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(++counter, 0u);
}

TEST(Counter, ACopyCountsOnItsOwn) {
  Counter counter = 7;
  Counter copy = counter;
  ++copy;
  EXPECT_EQ(counter, 7u);
  EXPECT_EQ(copy, 8u);
  counter = copy;
  EXPECT_EQ(counter, 8u);
}

TEST(Counter, AnotherThreadReadsWhileItCounts) {
  constexpr std::uint64_t kTurns = 1'000'000;
  Counter counter;
  std::atomic<bool> descends = false;
  std::thread reader([&] {
    for (std::uint64_t last = 0, now = 0; now < kTurns; last = now) {
      std::atomic_signal_fence(std::memory_order_seq_cst); // it is read again
      now = counter;
      descends = descends || now < last;
    }
  });
  for (std::uint64_t i = 0; i < kTurns; ++i)
    ++counter;
  reader.join();
  EXPECT_FALSE(descends);
  EXPECT_EQ(counter, kTurns);
}

} // namespace
} // namespace arbiter
