#pragma once
#include <atomic>
#include <new>
#include <utility>

namespace arbiter {

/// A T for each thread, created at first use. When the thread ends, its T is kept for the next
/// thread that needs one. Nothing is freed then, as exit() may be called by a signal handler that
/// interrupted malloc. A later get() in the same thread returns a T again: the application's own
/// destructors may still draw after exit(). `Tag` separates two uses of one type.
template <typename T, typename Tag> class PerThread {
public:
  /// Returns null if there is no memory.
  static T *get() noexcept {
    if (!t_value) [[unlikely]]
      make();
    return t_value ? &t_value->value : nullptr;
  }
  /// Marks the thread's value as used until takeBack(). If the thread ends meanwhile, the value is
  /// never reused, as other threads still read it; that happens if a signal handler calls exit()
  /// during a draw. Lending it twice gives the thread a new value: a handler draws during a draw,
  /// or left one by siglongjmp(), and the first value is half done.
  static void lend() noexcept {
    if (std::exchange(t_lent, true)) [[unlikely]]
      t_value = nullptr;
  }
  static void takeBack() noexcept { t_lent = false; }

private:
  /// The value of a thread that ended.
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
  /// Takes one of the values that are left and frees the others: there may never be as many threads
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
  // This is not a member of the keeper, because a compiler may drop what a destructor writes to its
  // own object.
  static inline constinit thread_local Left *t_value __attribute__((tls_model("initial-exec"))) =
      nullptr;
  static inline constinit thread_local bool t_lent __attribute__((tls_model("initial-exec"))) =
      false;
  static inline constinit std::atomic<Left *> g_left{nullptr};
};

} // namespace arbiter
