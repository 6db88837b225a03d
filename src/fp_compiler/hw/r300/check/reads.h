#pragma once
#include <vector>

#include "fp_compiler/hw/r300/machine.h"

/// What a pair reads, to the component: the facts that the checker, the interpreter and the
/// disassembly share.
namespace arbiter::fp::hw::r300 {

/// Where one component of an argument comes from.
struct Tap {
  enum class From : std::uint8_t { Rgb, Alpha, Zero, One, Half };
  From from = From::Zero;     ///< the RGB or the alpha address of the argument's number
  std::uint8_t component = 0; ///< of the register: 0..2 of an RGB address, 3 of an alpha one
};
/// \p component 0..2 of an RGB argument.
[[nodiscard]] Tap tapOf(RgbSelect select, std::size_t component);
[[nodiscard]] Tap tapOf(AlphaSelect select);

/// Components of each RGB argument that matter: those written, all three of a dot product.
[[nodiscard]] std::uint8_t componentsRead(const Half<RgbOp, RgbArgument> &half);

/// One component of one address that a pair reads.
struct Read {
  bool alphaHalf = false;    ///< whose argument
  std::uint8_t argument = 0; ///< 0..2: A, B, C
  bool presubtracted = false;
  bool alphaAddress = false; ///< the address is one of the alpha half's
  std::uint8_t number = 0;   ///< of the address, 0..2
  std::uint8_t component = 0;
};
/// All of them; an argument that takes a presubtract result reads what that is made of.
[[nodiscard]] std::vector<Read> readsOf(const Pair &pair);

/// Components of its source register that a texture operation looks at. The reference of a shadow
/// target is not among them: the ALU compares.
[[nodiscard]] std::uint8_t componentsRead(const Texture &texture);

/// The target that the chip samples: shadow targets give the stored depth.
[[nodiscard]] ir::TexTarget sampledTarget(ir::TexTarget target);

} // namespace arbiter::fp::hw::r300
