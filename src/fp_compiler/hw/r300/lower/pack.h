#pragma once
#include "fp_compiler/hw/r300/lower/flow.h"

namespace arbiter::fp::hw::r300 {

/// The addresses of a pair before register allocation, and the address that each argument uses.
struct Packed {
  static constexpr std::uint32_t kFree = 0xFFFFFFFF, kRow = 0x80000000;
  /// The root of a web, or kRow plus a row.
  std::array<std::uint32_t, 3> rgb = {kFree, kFree, kFree}, alpha = {kFree, kFree, kFree};
  std::array<std::uint8_t, 3> rgbSource = {}, alphaSource = {};
};

/// Fits the arguments of an RGB and an alpha operation into three RGB and three alpha addresses.
/// Either operation may be null; an operation of both halves is passed as both. Returns false if
/// they do not fit.
[[nodiscard]] bool pack(const Flow &flow, const Item *rgb, const Item *alpha, Packed &packed);

/// True if the operation fits in a slot of its own. It may need four addresses: for two arguments
/// and a presubtract result, or for a Dp4 whose alpha half takes x, y or z.
[[nodiscard]] bool packsAlone(const Flow &flow, const Item &item);

} // namespace arbiter::fp::hw::r300
