#include "swrast/threads.h"

#include <atomic>
#include <chrono>
#include <csetjmp>
#include <csignal>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace arbiter::swrast {
namespace {

class Threads : public testing::TestWithParam<int> {
protected:
  void SetUp() override { setThreadCount(GetParam()); }
  void TearDown() override { setThreadCount(0); }
};

/// More than one.
class ThreadsOfAPool : public Threads {};

/// Expects that every index is done once.
void expectAllOnce(std::uint32_t count) {
  std::vector<std::atomic<int>> calls(count);
  auto work = [&](std::uint32_t i) { calls[i].fetch_add(1, std::memory_order_relaxed); };
  parallel(count, work);
  for (std::uint32_t i = 0; i < count; ++i)
    ASSERT_EQ(calls[i].load(), 1) << "index " << i << " of " << count;
}

TEST_P(Threads, CallsEveryIndexOnce) {
  EXPECT_EQ(threadCount(), GetParam());
  for (int round = 0; round < 2000; ++round)
    expectAllOnce(std::uint32_t(round % 37));
  expectAllOnce(100000);
}

TEST_P(Threads, WhatWasWrittenIsSeenAfterwards) {
  std::vector<int> values(64);
  for (int round = 0; round < 500; ++round) {
    auto work = [&](std::uint32_t i) { values[i] += int(i); };
    parallel(64, work);
    for (int i = 0; i < 64; ++i)
      ASSERT_EQ(values[std::size_t(i)], i * (round + 1));
  }
}

TEST_P(Threads, JobsOfManyCallersAndNestedOnesEnd) {
  std::atomic<int> total{0};
  std::vector<std::thread> callers;
  for (int t = 0; t < 3; ++t)
    callers.emplace_back([&] {
      for (int round = 0; round < 200; ++round) {
        auto inner = [&](std::uint32_t) { total.fetch_add(1); };
        auto outer = [&](std::uint32_t) { parallel(4, inner); };
        parallel(5, outer);
      }
    });
  for (std::thread &caller : callers)
    caller.join();
  EXPECT_EQ(total.load(), 3 * 200 * 5 * 4);
}

// A handler may leave a job by siglongjmp(). No thread may use the caller's stack after that.
TEST_P(Threads, AJumpOutOfAJobEndsIt) {
  static std::jmp_buf s_back;
  static std::atomic<int> s_inside, s_calls;
  static std::thread::id s_caller;
  s_inside = s_calls = 0;
  s_caller = std::this_thread::get_id();
  auto work = [](std::uint32_t) {
    s_calls.fetch_add(1);
    if (std::this_thread::get_id() == s_caller) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5)); // lets the workers begin
      std::longjmp(s_back, 1);
    }
    s_inside.fetch_add(1);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    s_inside.fetch_sub(1);
  };
  if (setjmp(s_back) == 0) {
    parallel(1000, work);
    FAIL() << "no jump";
  }
  EXPECT_EQ(s_inside.load(), 0);
  const int calls = s_calls.load();
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  EXPECT_EQ(s_calls.load(), calls) << "indices are taken of a job that is over";
  // The next job must use all threads again.
  std::atomic<int> others{0};
  auto next = [&](std::uint32_t) {
    others.fetch_add(std::this_thread::get_id() != s_caller);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  parallel(64, next);
  EXPECT_EQ(others.load() > 0, GetParam() > 1);
  expectAllOnce(1000);
}

struct Calls {
  std::vector<std::atomic<int>> of;
  explicit Calls(std::uint32_t count) : of(count) {}
  static void work(void *self, std::uint32_t i) {
    static_cast<Calls *>(self)->of[i].fetch_add(1, std::memory_order_relaxed);
  }
};

TEST_P(Threads, APostedJobIsDoneWithoutTheCallerAndWithHim) {
  for (int round = 0; round < 500; ++round) {
    const auto count = std::uint32_t(1 + round % 61);
    Calls calls(count);
    const PostedJob job = post(count, Calls::work, &calls);
    EXPECT_EQ(job.number != 0, GetParam() > 1);
    if (job.number == 0)
      continue;
    expectAllOnce(17); // the caller does other work meanwhile
    if (round % 2 == 0)
      while (!isOver(job)) // the workers must finish it alone
        std::this_thread::yield();
    else
      join(job);
    EXPECT_TRUE(isOver(job));
    join(job);
    for (std::uint32_t i = 0; i < count; ++i)
      ASSERT_EQ(calls.of[i].load(), 1) << "index " << i << " of " << count;
  }
}

TEST_P(Threads, ManyCallersPost) {
  std::vector<std::thread> callers;
  for (int t = 0; t < 3; ++t)
    callers.emplace_back([&] {
      for (int round = 0; round < 300; ++round) {
        Calls calls(9);
        const PostedJob job = post(9, Calls::work, &calls);
        if (job.number == 0)
          continue; // another thread's job is running
        join(job);
        for (std::atomic<int> &each : calls.of)
          ASSERT_EQ(each.load(), 1);
      }
    });
  for (std::thread &caller : callers)
    caller.join();
}

TEST_P(ThreadsOfAPool, AJumpOutOfJoinWaitsForTheOthers) {
  static std::jmp_buf s_back;
  static std::atomic<int> s_inside;
  static std::thread::id s_caller;
  s_caller = std::this_thread::get_id();
  const auto work = [](void *, std::uint32_t) {
    if (std::this_thread::get_id() == s_caller)
      std::longjmp(s_back, 1);
    s_inside.fetch_add(1);
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
    s_inside.fetch_sub(1);
  };
  const PostedJob job = post(40, work, nullptr);
  ASSERT_NE(job.number, 0u);
  if (setjmp(s_back) == 0) {
    join(job);
    FAIL() << "no jump";
  }
  EXPECT_TRUE(isOver(job)) << "the index that was left counts as done";
  EXPECT_EQ(s_inside.load(), 0);
  expectAllOnce(1000);
}

TEST_P(Threads, WorkAfterFork) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "ThreadSanitizer ends a child of a process with threads that starts one";
#endif
  expectAllOnce(100);
  const pid_t child = fork();
  if (child == 0) {
    std::atomic<int> calls{0};
    auto work = [&](std::uint32_t) { calls.fetch_add(1); };
    for (int round = 0; round < 50; ++round)
      parallel(20, work);
    _exit(calls.load() == 1000 ? 0 : 1);
  }
  ASSERT_GT(child, 0);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  expectAllOnce(100);
}

TEST_P(Threads, WorkersTakeNoSignals) {
  std::atomic<int> blocked{0};
  const std::thread::id caller = std::this_thread::get_id();
  auto work = [&](std::uint32_t) {
    sigset_t mask;
    pthread_sigmask(SIG_SETMASK, nullptr, &mask);
    if (std::this_thread::get_id() == caller || sigismember(&mask, SIGALRM) == 1)
      blocked.fetch_add(1);
    usleep(100);
  };
  parallel(40, work);
  EXPECT_EQ(blocked.load(), 40);
}

TEST_P(Threads, IdleWorkersSleep) {
  expectAllOnce(1000);
  usleep(20000);
  timespec before{}, after{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &before);
  usleep(200000);
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &after);
  const double used =
      double(after.tv_sec - before.tv_sec) + 1e-9 * double(after.tv_nsec - before.tv_nsec);
  EXPECT_LT(used, 0.02) << "seconds of processor time in 0.2 s of nothing to do";
}

INSTANTIATE_TEST_SUITE_P(Counts, Threads, testing::Values(1, 2, 4));
INSTANTIATE_TEST_SUITE_P(Counts, ThreadsOfAPool, testing::Values(2, 4));

} // namespace
} // namespace arbiter::swrast
