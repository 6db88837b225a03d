#pragma once
#include <string>
#include <vector>

#include "fp_compiler/hw/r300/machine.h"

/// Whether a Code is one that the chip could be given, judged from the Code alone: nothing here
/// knows how it came about, so that it finds the compiler's faults too.
namespace arbiter::fp::hw::r300 {

/// What the hardware cannot do, one enumerator a rule.
enum class Rule : std::uint8_t {
  NoNode,             ///< a program is at least one node
  EmptyNode,          ///< a node has at least one pair
  NodeWithoutTexture, ///< only the first may have none
  NodeBlocks,         ///< the nodes' blocks follow each other and cover everything
  SourceNumber,       ///< arguments take 0, 1, 2 or the presubtract result
  SourceAddress,      ///< an argument takes a source that has no address
  SourceIndex,        ///< no such register or constant
  Presubtract,        ///< its half makes no presubtract result, or lacks an address for it
  PresubtractSelect,  ///< Yzx, Zxy, Wzy of a presubtract result
  DotProduct,         ///< Dp stands beside Dp3 or Dp4; Dp4 beside Dp
  ReplicatedAlpha,    ///< ReplAlpha needs an operation in the alpha half
  Mask,               ///< RGB writes x, y, z; alpha writes w
  IdleWrite,          ///< a half without operation writes
  Destination,        ///< no such register, or none at all
  Target,             ///< no such colour target: there are four
  Depth,              ///< depth is written by the alpha half
  TextureRegister,    ///< no such register, a sample without one, or a kill with one
  TextureUnit,        ///< no such image unit: there are sixteen
  TextureHazard,      ///< two TEX of a node want the same register
  Interpolants,       ///< two in one register, or one twice
  Unwritten,          ///< reads a component that nothing has written
  Registers,          ///< Code::temporaries is not the highest register plus one
  Reference,          ///< an origin, attribute or parameter that the program does not have
  Interpolators,      ///< Code::interpolators is not their number
};
inline constexpr int kRuleCount = int(Rule::Interpolators) + 1;

struct Fault {
  Rule rule = Rule::NoNode;
  std::string text; ///< "node 1, pair 3, RGB, argument B: Yzx of a presubtract result"
};

/// Everything in \p code that the chip cannot do. Programs that are too long for it are no fault:
/// overflows() lists those.
[[nodiscard]] std::vector<Fault> faults(const Code &code);
/// The same, and what does not fit the program that it was made of: origins, attributes,
/// parameters, the number of interpolators.
[[nodiscard]] std::vector<Fault> faults(const Code &code, const ir::Program &program);

/// The sizes of a chip. The defaults are the Radeon 9700's.
struct Chip {
  std::uint32_t pairs = 64;
  std::uint32_t textures = 32;
  std::uint32_t nodes = 4;
  std::uint32_t temporaries = 32;
  std::uint32_t constants = 32;
  std::uint32_t interpolators = kInterpolators;
};

/// One line for each size that the code goes beyond: "71 pairs of 64".
[[nodiscard]] std::vector<std::string> overflows(const Code &code, const Chip &chip = {});

} // namespace arbiter::fp::hw::r300
