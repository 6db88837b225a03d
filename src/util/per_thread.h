#pragma once
#include <atomic>
#include <new>
#include <utility>

namespace arbiter {

/// A T that each thread has of its own, made when first wanted and left to the next thread that
/// wants one when the thread ends. Nothing is freed then: exit() ends the thread that calls it in
/// the same way, and may be called by a signal's handler that interrupted malloc. Who asks after
/// that has one again: an application's own destructors may draw after those of the thread that
/// exit() was called on. `Tag` keeps two of one type distinct.
template <typename T, typename Tag> class PerThread {
public:
  /// Null where there is no memory.
  static T *get() noexcept {
    if (!t_value) [[unlikely]]
      make();
    return t_value ? &t_value->value : nullptr;
  }
  /// What the thread has stays allocated when it ends between this and takeBack(): other threads
  /// still read it. That happens where a signal's handler calls exit() in the midst of a draw. Who
  /// lends what is lent gets another one: a handler draws in the midst of a draw, or has left one
  /// by siglongjmp(), and what it was at is half done.
  static void lend() noexcept {
    if (std::exchange(t_lent, true)) [[unlikely]]
      t_value = nullptr;
  }
  static void takeBack() noexcept { t_lent = false; }

private:
  /// Of a thread that ended.
  struct Left {
    T value;
    Left *next = nullptr;
  };
  struct Keeper {
    ~Keeper() {
      if (Left *const left = std::exchange(t_value, nullptr); left && !t_lent)
        leave(left);
    }
  };
  static void leave(Left *left) noexcept {
    left->next = g_left.load(std::memory_order_relaxed);
    while (!g_left.compare_exchange_weak(left->next, left, std::memory_order_release,
                                         std::memory_order_relaxed))
      ;
  }
  /// One of those that are left; the others are freed: as many threads as there were may never be
  /// again.
  static Left *take() noexcept {
    Left *const first = g_left.exchange(nullptr, std::memory_order_acquire);
    if (!first)
      return nullptr;
    for (Left *rest = std::exchange(first->next, nullptr); rest;)
      delete std::exchange(rest, rest->next);
    return first;
  }
  static void make() noexcept {
    t_value = take();
    if (!t_value)
      t_value = new (std::nothrow) Left;
    thread_local Keeper keeper __attribute__((tls_model("initial-exec")));
    (void)keeper;
  }
  // Apart from the keeper: a compiler may leave out what a destructor writes to its own object.
  static inline constinit thread_local Left *t_value __attribute__((tls_model("initial-exec"))) =
      nullptr;
  static inline constinit thread_local bool t_lent __attribute__((tls_model("initial-exec"))) =
      false;
  static inline constinit std::atomic<Left *> g_left{nullptr};
};

} // namespace arbiter
