#pragma once
#include <cstdint>

namespace arbiter::state {

/// The window system, or its like, that a context is of.
enum class Provider : std::uint8_t { Glx, Egl, OsMesa };

} // namespace arbiter::state
