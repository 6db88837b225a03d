#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "state/mirror/mirror.h"
#include "state/testing/real_host.h"

/// Pieces of GL state. Each can be set at random, and checks what the mirror reports for it.
namespace arbiter::state::testing {

inline void turn(GLenum cap, bool on) { (on ? glEnable : glDisable)(cap); }

/// Fails the running test if the mirror differs from what was set.
using Check = std::function<void(const Mirror &)>;
struct Field {
  const char *name;
  std::uint32_t dirty; ///< the bit that its entry point sets
  Check (*set)(Numbers &numbers);
};
[[nodiscard]] std::span<const Field> rasterFields();
[[nodiscard]] std::span<const Field> pixelFields();
[[nodiscard]] std::span<const Field> vertexFields();

} // namespace arbiter::state::testing
