#pragma once
#include <vector>

#include "fp_compiler/hw/r300/machine.h"

/// Finds the components that a pair reads. The checker, the interpreter and the disassembly share
/// these facts.
namespace arbiter::fp::hw::r300 {

/// The source of one component of an argument.
struct Tap {
  enum class From : std::uint8_t { Rgb, Alpha, Zero, One, Half };
  From from = From::Zero;     ///< whether it uses the RGB or the alpha address
  std::uint8_t component = 0; ///< of the register: 0..2 for an RGB address, 3 for an alpha one
};
/// Returns the source of one component of an RGB argument.
/// \param component 0..2
[[nodiscard]] Tap tapOf(RgbSelect select, std::size_t component);
[[nodiscard]] Tap tapOf(AlphaSelect select);

/// Returns the components of each RGB argument that matter: those written, or all three for a dot
/// product.
[[nodiscard]] std::uint8_t componentsRead(const Half<RgbOp, RgbArgument> &half);

/// One component that a pair reads through one address.
struct Read {
  bool alphaHalf = false;    ///< the argument belongs to the alpha half
  std::uint8_t argument = 0; ///< 0..2: A, B, C
  bool presubtracted = false;
  bool alphaAddress = false; ///< the address belongs to the alpha half
  std::uint8_t number = 0;   ///< of the address, 0..2
  std::uint8_t component = 0;
};
/// Returns all reads of a pair. An argument that takes a presubtract result reads the sources of
/// it.
[[nodiscard]] std::vector<Read> readsOf(const Pair &pair);

/// Returns the components of its source register that a texture operation reads. The reference of a
/// shadow target is not among them: the ALU compares.
[[nodiscard]] std::uint8_t componentsRead(const Texture &texture);

/// Returns the target that the chip samples. For a shadow target it samples the stored depth.
[[nodiscard]] ir::TexTarget sampledTarget(ir::TexTarget target);

} // namespace arbiter::fp::hw::r300
