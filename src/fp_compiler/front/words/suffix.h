#pragma once
#include <cstdint>
#include <string_view>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp {

/// The reason why a suffix is wrong, and the first wrong letter. It converts to false if the suffix
/// is right.
struct SuffixError {
  const char *reason = nullptr;
  std::uint32_t offset = 0;
  explicit operator bool() const { return reason != nullptr; }
};

// `colors`: r, g, b and a are components too (fragment programs).

/// Reads a swizzle without its dot: one component, which is repeated, or four. If `scalar`, only
/// one.
[[nodiscard]] SuffixError readSwizzle(std::string_view word, bool colors, bool scalar,
                                      ir::Swizzle &swizzle);

/// Reads a write mask without its dot: one to four components in order; bit 0 is x.
[[nodiscard]] SuffixError readMask(std::string_view word, bool colors, std::uint8_t &mask);

/// Reads one selector of an extended swizzle. `set` is 0, or a letter of the set that the earlier
/// selectors belong to. It is updated.
[[nodiscard]] SuffixError readSelector(std::string_view word, bool colors, char &set,
                                       ir::Select &select);

} // namespace arbiter::fp
