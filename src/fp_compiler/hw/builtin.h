#pragma once
#include <cstdint>
#include <span>

#include "fp_compiler/hw/profile.h"

/// The table of built-in profiles that generate_profiles.py writes. It holds plain constants, so
/// loading the library runs no code.
namespace arbiter::fp::hw {

struct BuiltinRow {
  std::uint32_t value;
  const char *source;
};

struct BuiltinText {
  const char *value;
  const char *source;
};
inline constexpr int kIdentityKeyCount = 6;

struct BuiltinProfile {
  const char *name;
  const char *description;
  const char *aliases; ///< "radeon9700|9700"
  bool fromHost;
  BuiltinRow rows[kRowCount];              ///< in the order of rows.def
  BuiltinRow choices[kChoiceCount];        ///< in the order of choices.def
  BuiltinText identity[kIdentityKeyCount]; ///< in the order of identityKeys()
};

[[nodiscard]] std::span<const BuiltinProfile> builtinTable();

} // namespace arbiter::fp::hw
