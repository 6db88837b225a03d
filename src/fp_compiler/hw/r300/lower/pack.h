#pragma once
#include "fp_compiler/hw/r300/lower/flow.h"

namespace arbiter::fp::hw::r300 {

/// The addresses of a pair before registers are allocated, and which of them each argument takes.
struct Packed {
  static constexpr std::uint32_t kFree = 0xFFFFFFFF, kRow = 0x80000000;
  /// A web's root, or kRow plus a row.
  std::array<std::uint32_t, 3> rgb = {kFree, kFree, kFree}, alpha = {kFree, kFree, kFree};
  std::array<std::uint8_t, 3> rgbSource = {}, alphaSource = {};
};

/// Puts the arguments of an RGB and an alpha operation (either may be null; an operation of both
/// halves is both) into three RGB and three alpha addresses. False if they do not fit.
[[nodiscard]] bool pack(const Flow &flow, const Item *rgb, const Item *alpha, Packed &packed);

/// Whether the operation fits when it stands alone: two arguments and a presubtract result, or a
/// Dp4's alpha half that takes x, y or z, may ask for four addresses.
[[nodiscard]] bool packsAlone(const Flow &flow, const Item &item);

} // namespace arbiter::fp::hw::r300
