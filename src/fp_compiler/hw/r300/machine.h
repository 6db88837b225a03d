#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"

/// The Radeon 9700's fragment unit as data: what its program memory can say, and nothing else.
/// Facts: Mesa 22.3.6's r300 driver and its register header. Register numbers may go beyond the
/// chip's: a program that does not fit is still compiled, so that overflows() can say by how much.
namespace arbiter::fp::hw::r300 {

inline constexpr std::uint16_t kNone = 0xFFFF;

/// One of the three addresses that each half of a pair sends to the register file.
struct Source {
  enum class Bank : std::uint8_t { None, Temporary, Constant };
  Bank bank = Bank::None;
  std::uint16_t index = 0; ///< Temporary: register; Constant: into Code::constants
  bool operator==(const Source &) const = default;
};

/// RGB unit. D is the result, A B C the arguments; each per component unless said otherwise.
enum class RgbOp : std::uint8_t {
  None,      ///< the half is idle
  Mad,       ///< A*B + C
  Dp3,       ///< A.B over xyz, in all three
  Dp4,       ///< A.B over xyz and the alpha half's A and B, in all three
  Min,       ///< of A and B
  Max,       ///< of A and B
  Cnd,       ///< C > 1/2 ? A : B
  Cmp,       ///< C >= 0 ? A : B
  Frc,       ///< A - floor(A)
  ReplAlpha, ///< the alpha half's result, in all three
};
enum class AlphaOp : std::uint8_t {
  None,
  Mad,
  Dp, ///< the RGB half's Dp3 or Dp4
  Min,
  Max,
  Cnd,
  Cmp,
  Frc,
  Ex2, ///< of A, as are the next three
  Lg2,
  Rcp,
  Rsq, ///< 1/sqrt(|A|)
};

/// How many arguments the operation takes, A first.
[[nodiscard]] constexpr std::size_t argumentCount(RgbOp op) {
  switch (op) {
  case RgbOp::None:
  case RgbOp::ReplAlpha:
    return 0;
  case RgbOp::Frc:
    return 1;
  case RgbOp::Dp3:
  case RgbOp::Dp4:
  case RgbOp::Min:
  case RgbOp::Max:
    return 2;
  case RgbOp::Mad:
  case RgbOp::Cnd:
  case RgbOp::Cmp:
    return 3;
  }
  return 0;
}

/// Dp takes A and B where the RGB half is Dp4, as the fourth component; none beside Dp3.
[[nodiscard]] constexpr std::size_t argumentCount(AlphaOp op, RgbOp beside) {
  switch (op) {
  case AlphaOp::None:
    return 0;
  case AlphaOp::Dp:
    return beside == RgbOp::Dp4 ? 2 : 0;
  case AlphaOp::Frc:
  case AlphaOp::Ex2:
  case AlphaOp::Lg2:
  case AlphaOp::Rcp:
  case AlphaOp::Rsq:
    return 1;
  case AlphaOp::Min:
  case AlphaOp::Max:
    return 2;
  case AlphaOp::Mad:
  case AlphaOp::Cnd:
  case AlphaOp::Cmp:
    return 3;
  }
  return 0;
}

/// What an RGB argument takes of its source: the colour of RGB source n, where W is the alpha of
/// *alpha* source n (Wzy: both); or a constant, which needs no source.
enum class RgbSelect : std::uint8_t { Xyz, Xxx, Yyy, Zzz, Www, Yzx, Zxy, Wzy, Zero, One, Half };
/// What an alpha argument takes: X, Y, Z of RGB source n, W of alpha source n.
enum class AlphaSelect : std::uint8_t { X, Y, Z, W, Zero, One, Half };

/// `source` 0..2, or kPresubtracted: the half's presubtract result (Xyz, Xxx, Yyy, Zzz of the RGB
/// one, Www and W of the alpha one; no Yzx, Zxy, Wzy).
inline constexpr std::uint8_t kPresubtracted = 3;
struct RgbArgument {
  RgbSelect select = RgbSelect::Zero;
  std::uint8_t source = 0;
  bool absolute = false; ///< before the sign
  bool negate = false;   ///< all three components
  bool operator==(const RgbArgument &) const = default;
};
struct AlphaArgument {
  AlphaSelect select = AlphaSelect::Zero;
  std::uint8_t source = 0;
  bool absolute = false;
  bool negate = false;
  bool operator==(const AlphaArgument &) const = default;
};

/// Computed of a half's sources 0 and 1 before the arguments are selected.
enum class Presubtract : std::uint8_t { None, OneMinusTwoS0, S1MinusS0, S1PlusS0, OneMinusS0 };

/// Multiplies the result before the clamp.
enum class Modifier : std::uint8_t { One, X2, X4, X8, Half, Quarter, Eighth };

/// Why an operation stands in the program; with the origin it is the reason of its cost.
enum class Cause : std::uint8_t {
  Instruction,    ///< the IR instruction itself, or its part of a longer expansion
  Swizzle,        ///< a swizzle or a sign that the unit does not have
  TextureOperand, ///< a coordinate brought into a plain register
  TextureResult,  ///< mask, saturation, output or comparison of a sample
  Rectangle,      ///< texels to [0,1] coordinates
  Position,       ///< fragment.position from the interpolated clip position
  Fog,            ///< the fog option's blend
  Output,         ///< a copy to a result register
  EmptyNode,      ///< a node needs an ALU slot
};

/// One half of a pair: the RGB one or the alpha one.
template <typename Op, typename Argument> struct Half {
  Op op = Op::None;
  std::array<Source, 3> sources;
  Presubtract presubtract = Presubtract::None;
  std::array<Argument, 3> arguments;
  std::uint16_t temporary = kNone; ///< written under `mask`
  std::uint8_t mask = 0;           ///< RGB: bits 0..2; alpha: bit 3
  std::uint8_t output = 0;         ///< colour target written under `outputMask`
  std::uint8_t outputMask = 0;     ///< as mask
  bool depth = false;              ///< alpha only: the result is the fragment's depth
  bool clamp = false;              ///< to [0,1], NaN to 0
  Modifier modifier = Modifier::One;
  std::uint16_t origin = kNone; ///< index into ir::Program::code
  Cause cause = Cause::Instruction;
};

/// One ALU slot. All sources are read before anything is written.
struct Pair {
  Half<RgbOp, RgbArgument> rgb;
  Half<AlphaOp, AlphaArgument> alpha;
};

enum class TexOp : std::uint8_t { Load, Project, Bias, Kill };

/// One TEX slot. Reads a whole register as it is, writes a whole register.
struct Texture {
  TexOp op = TexOp::Load;
  std::uint8_t unit = 0;
  ir::TexTarget target = ir::TexTarget::Tex2D;
  std::uint16_t source = 0;          ///< temporary
  std::uint16_t destination = kNone; ///< temporary; none for Kill
  std::uint16_t origin = kNone;
};

/// A block of TEX, then a block of ALU. All of a node's TEX read their sources as the node found
/// them; their results are there for its ALU block and for later nodes.
struct Node {
  std::uint32_t firstTexture = 0, textures = 0;
  std::uint32_t firstPair = 0, pairs = 0;
};

/// One row of constant memory.
struct Constant {
  enum class Kind : std::uint8_t {
    Parameter,      ///< ir::Program::parameters[index]
    Value,          ///< the driver's own
    RectangleScale, ///< (1/width, 1/height, 1, 1) of image unit `index`
    ViewportScale,  ///< of fragment.position
    ViewportOffset,
    FogColor,   ///< of a fog option: state.fog.color
    FogFactors, ///< likewise, from state.fog.params, so that the factor is of one or two slots:
                ///< (-1/(end-start), end/(end-start), -density/ln 2, density/sqrt(ln 2))
  };
  Kind kind = Kind::Value;
  std::uint16_t index = 0;
  ir::Vec4 value = {};
  std::uint16_t origin = kNone; ///< the first instruction that made it necessary
};

/// Interpolant::attribute of what an option reads and no attribute of the program names.
inline constexpr std::uint16_t kFogCoordinate = 0xFFFE;   ///< a fog option's
inline constexpr std::uint16_t kSecondaryColour = 0xFFFD; ///< Options::colorSum's

/// A register that the rasterizer fills before the first node.
struct Interpolant {
  /// Index into ir::Program::attributes, kFogCoordinate or kSecondaryColour.
  std::uint16_t attribute = 0;
  std::uint16_t temporary = 0;
  /// fragment.position arrives as the clip position, in a texture coordinate's interpolator; the
  /// fog coordinate as (f, 0, 0, 1) in another.
};

/// A whole program as the chip would hold it.
struct Code {
  std::vector<Node> nodes;
  std::vector<Texture> textures;
  std::vector<Pair> pairs;
  std::vector<Constant> constants;
  std::vector<Interpolant> interpolants;
  std::uint32_t temporaries = 0;   ///< highest register in use, plus one
  std::uint32_t interpolators = 0; ///< texture coordinate interpolators; the chip has 8
};

inline constexpr std::uint32_t kInterpolators = 8;

} // namespace arbiter::fp::hw::r300
