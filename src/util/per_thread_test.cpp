#include "util/per_thread.h"

#include <atomic>
#include <latch>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace arbiter {
namespace {

std::atomic<int> g_made{0}, g_freed{0};

struct Value {
  Value() { ++g_made; }
  ~Value() { ++g_freed; }
};
template <int tag> struct Tag {};

template <int tag> Value *valueOfNewThread(bool lent = false) {
  Value *value = nullptr;
  std::thread([&] {
    value = PerThread<Value, Tag<tag>>::get();
    EXPECT_EQ((PerThread<Value, Tag<tag>>::get()), value);
    if (lent)
      PerThread<Value, Tag<tag>>::lend();
  }).join();
  return value;
}

class PerThreadTest : public testing::Test {
protected:
  PerThreadTest() { g_made = g_freed = 0; }
};

// exit() ends its thread too, and a signal handler may call it after it interrupted malloc.
TEST_F(PerThreadTest, AThreadThatEndsFreesNothing) {
  valueOfNewThread<0>();
  EXPECT_EQ(g_made, 1);
  EXPECT_EQ(g_freed, 0);
}

TEST_F(PerThreadTest, TheNextThreadTakesWhatIsLeft) {
  Value *const first = valueOfNewThread<1>();
  EXPECT_EQ(valueOfNewThread<1>(), first);
  EXPECT_EQ(g_made, 1);
}

TEST_F(PerThreadTest, WhatIsLentIsNobodyElses) {
  Value *const first = valueOfNewThread<2>(true);
  EXPECT_NE(valueOfNewThread<2>(), first);
  EXPECT_EQ(g_freed, 0);
}

// A handler draws during a draw, or the first draw comes after a jump out of one.
TEST_F(PerThreadTest, WhoLendsWhatIsLentGetsAnotherOne) {
  using Own = PerThread<Value, Tag<4>>;
  std::thread([] {
    Value *const first = Own::get();
    Own::lend();
    EXPECT_EQ(Own::get(), first);
    Own::lend();
    Value *const second = Own::get();
    EXPECT_NE(second, first);
    Own::takeBack();
    Own::lend();
    EXPECT_EQ(Own::get(), second);
    Own::takeBack();
  }).join();
  EXPECT_EQ(g_freed, 0);
}

TEST_F(PerThreadTest, OfManyThreadsThatEndedOneIsKept) {
  constexpr int kThreads = 8;
  std::latch all(kThreads);
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i)
    threads.emplace_back([&all] {
      EXPECT_NE((PerThread<Value, Tag<3>>::get()), nullptr);
      all.arrive_and_wait();
    });
  for (std::thread &each : threads)
    each.join();
  EXPECT_EQ(g_made, kThreads);
  EXPECT_EQ(g_freed, 0);
  valueOfNewThread<3>();
  EXPECT_EQ(g_made, kThreads);
  EXPECT_EQ(g_freed, kThreads - 1);
}

} // namespace
} // namespace arbiter
