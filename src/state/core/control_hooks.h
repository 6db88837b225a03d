#pragma once
#include <atomic>
#include <cstdint>

/// Hooks for state/control and state/hud, which watch what the application draws. These rooms stand
/// above the rooms that draw, so the latter call them through this table.
namespace arbiter::state {

struct CoreContext;

struct ControlHooks {
  /// Called at the end of a frame, before it is shown. The context is current.
  void (*frameEnds)(CoreContext &context);
  /// Called before a draw in a context that has ended no frame.
  void (*beforeDraw)(CoreContext &context);
  /// `programsLeave` is called before the effective programs may change, `programsEnter` after.
  void (*programsLeave)(CoreContext &context);
  void (*programsEnter)(CoreContext &context);
};

/// The hooks. Stays null in a process that nobody watches.
inline constinit std::atomic<const ControlHooks *> g_controlHooks{nullptr};

/// The context whose draws in this frame are inspected one by one, or null. The host draws all of
/// them.
inline constinit std::atomic<const CoreContext *> g_observed{nullptr};

[[nodiscard]] inline bool isObserved(const CoreContext &context) {
  return g_observed.load(std::memory_order_relaxed) == &context;
}

/// The contents of a host list that the observed context calls.
enum class ListHolds : std::uint8_t {
  Anything, ///< commands that the application recorded
  State,    ///< state, and no draw
  Vertices, ///< one draw: a primitive, or several of one kind
};
inline constinit std::atomic<ListHolds> g_listHolds{ListHolds::Anything};

/// Declares, while it lives, what the called lists contain.
class ListHoldsScope {
public:
  explicit ListHoldsScope(ListHolds what) { g_listHolds.store(what, std::memory_order_relaxed); }
  ~ListHoldsScope() { g_listHolds.store(ListHolds::Anything, std::memory_order_relaxed); }
  ListHoldsScope(const ListHoldsScope &) = delete;
  ListHoldsScope &operator=(const ListHoldsScope &) = delete;
};

[[nodiscard]] inline const ControlHooks *controlHooks() {
  return g_controlHooks.load(std::memory_order_acquire);
}

} // namespace arbiter::state
