#pragma once
#include <cstdint>

namespace arbiter::state {

/// The window system, or the like, that a context belongs to.
enum class Provider : std::uint8_t { Glx, Egl, OsMesa };

} // namespace arbiter::state
