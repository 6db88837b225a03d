#pragma once
#include <string>
#include <vector>

#include "fp_compiler/hw/r300/machine.h"

/// Checks that the chip could run a Code. The check uses the Code alone and shares nothing with the
/// compiler, so it also finds the compiler's faults.
namespace arbiter::fp::hw::r300 {

/// The rules of the hardware, one enumerator a rule.
enum class Rule : std::uint8_t {
  NoNode,             ///< a program is at least one node
  EmptyNode,          ///< a node has at least one pair
  NodeWithoutTexture, ///< only the first node may have no texture
  NodeBlocks,         ///< the nodes' blocks follow each other and cover everything
  SourceNumber,       ///< arguments take 0, 1, 2 or the presubtract result
  SourceAddress,      ///< an argument takes a source that has no address
  SourceIndex,        ///< no such register or constant
  Presubtract,        ///< the half computes no presubtract result, or lacks an address for it
  PresubtractSelect,  ///< Yzx, Zxy or Wzy of a presubtract result
  DotProduct,         ///< Dp must pair with Dp3 or Dp4, and Dp4 with Dp
  ReplicatedAlpha,    ///< ReplAlpha needs an operation in the alpha half
  Mask,               ///< RGB writes x, y, z; alpha writes w
  IdleWrite,          ///< an idle half writes
  Destination,        ///< no such register, or no register
  Target,             ///< no such colour target: the chip has four
  Depth,              ///< only the alpha half writes depth
  TextureRegister,    ///< no such register, a sample without one, or a kill with one
  TextureUnit,        ///< no such image unit: the chip has sixteen
  TextureHazard,      ///< two TEX of a node write the same register
  Interpolants,       ///< two in one register, or one in two registers
  Unwritten,          ///< reads a component that nothing has written
  Registers,          ///< Code::temporaries is not the highest register plus one
  Reference,          ///< the program has no such instruction, attribute or parameter
  Interpolators,      ///< Code::interpolators is not the number in use
};
inline constexpr int kRuleCount = int(Rule::Interpolators) + 1;

struct Fault {
  Rule rule = Rule::NoNode;
  std::string text; ///< "node 1, pair 3, RGB, argument B: Yzx of a presubtract result"
};

/// Returns everything in \p code that the chip cannot do. A program that is too long is not a
/// fault: overflows() lists sizes.
[[nodiscard]] std::vector<Fault> faults(const Code &code);
/// Returns these faults, and every reference to the program that does not fit it: origins,
/// attributes, parameters and the number of interpolators.
[[nodiscard]] std::vector<Fault> faults(const Code &code, const ir::Program &program);

/// The sizes of a chip. The defaults are those of the Radeon 9700.
struct Chip {
  std::uint32_t pairs = 64;
  std::uint32_t textures = 32;
  std::uint32_t nodes = 4;
  std::uint32_t temporaries = 32;
  std::uint32_t constants = 32;
  std::uint32_t interpolators = kInterpolators;
};

/// Returns one line for each size that the code exceeds: "71 pairs of 64".
[[nodiscard]] std::vector<std::string> overflows(const Code &code, const Chip &chip = {});

} // namespace arbiter::fp::hw::r300
