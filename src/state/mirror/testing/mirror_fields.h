#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "state/mirror/mirror.h"
#include "state/testing/real_host.h"

/// Pieces of GL state, each with a way to set it at random and to check what the mirror made of it.
namespace arbiter::state::software::testing {

/// Fails the running test where the mirror differs from what was set.
using Check = std::function<void(const Mirror &)>;
struct Field {
  const char *name;
  std::uint32_t dirty; ///< the bit that an entry point of it sets
  Check (*set)(Numbers &numbers);
};
[[nodiscard]] std::span<const Field> rasterFields();
[[nodiscard]] std::span<const Field> pixelFields();
[[nodiscard]] std::span<const Field> vertexFields();

} // namespace arbiter::state::software::testing
