#pragma once
#include <atomic>
#include <cstdint>

/// Where what watches the application's drawing is called: state/control and state/hud. They stand
/// above the rooms that draw; what these know of them is here.
namespace arbiter::state {

class Context;

struct ControlHooks {
  /// A frame ends, and is not shown yet. The context is current.
  void (*frameEnds)(Context &context);
  /// Before a draw of a context that has ended no frame.
  void (*beforeDraw)(Context &context);
  /// Other programs, or none, may be chosen next; those that draws now use have been chosen.
  void (*programsLeave)(Context &context);
  void (*programsEnter)(Context &context);
};

/// Null, for good, in a process that is not watched.
inline constinit std::atomic<const ControlHooks *> g_controlHooks{nullptr};

/// The context whose draws of this frame are looked at one by one, for which they are all the
/// host's; null mostly.
inline constinit std::atomic<const Context *> g_observed{nullptr};

[[nodiscard]] inline bool isObserved(const Context &context) {
  return g_observed.load(std::memory_order_relaxed) == &context;
}

/// What a list of the host's holds that the observed context calls.
enum class ListHolds : std::uint8_t {
  Anything, ///< what the application recorded
  State,    ///< and no draw
  Vertices, ///< one primitive, or several alike: a draw
};
inline constinit std::atomic<ListHolds> g_listHolds{ListHolds::Anything};

/// While it lives, lists that are called hold no more than that.
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
