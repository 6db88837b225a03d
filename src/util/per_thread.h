#pragma once
#include <new>
#include <utility>

namespace arbiter {

/// A T that each thread has of its own, made when first wanted and freed when the thread ends. Made
/// anew for who asks after that: an application's own destructors may draw after those of the
/// thread that exit() was called on. `Tag` keeps two of one type distinct.
template <typename T, typename Tag> class PerThread {
public:
  /// Null where there is no memory.
  static T *get() noexcept {
    if (!t_value) [[unlikely]]
      make();
    return t_value;
  }
  /// What the thread has stays allocated when it ends while this is so: other threads still read
  /// it. That happens where a signal's handler calls exit() in the midst of a draw.
  static void lend(bool lent) noexcept { t_lent = lent; }

private:
  struct Keeper {
    ~Keeper() {
      if (!t_lent)
        delete std::exchange(t_value, nullptr);
      t_value = nullptr;
    }
  };
  static void make() noexcept {
    t_value = new (std::nothrow) T;
    thread_local Keeper keeper __attribute__((tls_model("initial-exec")));
    (void)keeper;
  }
  // Apart from the keeper: a compiler may leave out what a destructor writes to its own object.
  static inline constinit thread_local T *t_value __attribute__((tls_model("initial-exec"))) =
      nullptr;
  static inline constinit thread_local bool t_lent __attribute__((tls_model("initial-exec"))) =
      false;
};

} // namespace arbiter
