#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"

/// The Radeon 9700's fragment unit as data: exactly what its program memory can express. Source:
/// Mesa 22.3.6's r300 driver and its register header. Register numbers may exceed the chip's: a
/// program that does not fit is still compiled, so that overflows() can report by how much.
namespace arbiter::fp::hw::r300 {

inline constexpr std::uint16_t kNone = 0xFFFF;

/// An address that a half of a pair sends to the register file. Each half has three.
struct Source {
  enum class Bank : std::uint8_t { None, Temporary, Constant };
  Bank bank = Bank::None;
  std::uint16_t index = 0; ///< a register, or an index into Code::constants
  bool operator==(const Source &) const = default;
};

/// Operations of the RGB unit. D is the result, A B C the arguments. They work per component unless
/// the comment says otherwise.
enum class RgbOp : std::uint8_t {
  None,      ///< the half is idle
  Mad,       ///< A*B + C
  Dp3,       ///< A.B over xyz, written to all three
  Dp4,       ///< A.B over xyz and the alpha half's A and B, written to all three
  Min,       ///< minimum of A and B
  Max,       ///< maximum of A and B
  Cnd,       ///< C > 1/2 ? A : B
  Cmp,       ///< C >= 0 ? A : B
  Frc,       ///< A - floor(A)
  ReplAlpha, ///< the alpha half's result, written to all three
};
enum class AlphaOp : std::uint8_t {
  None,
  Mad,
  Dp, ///< the result of the RGB half's Dp3 or Dp4
  Min,
  Max,
  Cnd,
  Cmp,
  Frc,
  Ex2, ///< takes A, as the next three do
  Lg2,
  Rcp,
  Rsq, ///< 1/sqrt(|A|)
};

/// Returns how many arguments the operation takes, from A on.
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

/// Returns how many arguments the operation takes. Beside a Dp4, Dp takes A and B as the fourth
/// component. Beside a Dp3 it takes none.
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

/// The components that an RGB argument selects from source n: a colour from the RGB source, or W
/// from the *alpha* source (Wzy uses both). The constants need no source.
enum class RgbSelect : std::uint8_t { Xyz, Xxx, Yyy, Zzz, Www, Yzx, Zxy, Wzy, Zero, One, Half };
/// The component that an alpha argument selects: X, Y, Z of RGB source n, or W of alpha source n.
enum class AlphaSelect : std::uint8_t { X, Y, Z, W, Zero, One, Half };

/// The source number of the half's presubtract result; other sources are 0..2. Xyz, Xxx, Yyy, Zzz
/// select from the RGB half's result, Www and W from the alpha half's. Yzx, Zxy and Wzy cannot.
inline constexpr std::uint8_t kPresubtracted = 3;
struct RgbArgument {
  RgbSelect select = RgbSelect::Zero;
  std::uint8_t source = 0;
  bool absolute = false; ///< applied before the sign
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

/// Computed from sources 0 and 1 of a half before the arguments are selected.
enum class Presubtract : std::uint8_t { None, OneMinusTwoS0, S1MinusS0, S1PlusS0, OneMinusS0 };

/// Multiplies the result, before the clamp.
enum class Modifier : std::uint8_t { One, X2, X4, X8, Half, Quarter, Eighth };

/// The reason why an operation is in the program. Together with the origin it explains a cost.
enum class Cause : std::uint8_t {
  Instruction,    ///< the IR instruction itself, or its part of a longer expansion
  Swizzle,        ///< a swizzle or a sign that the unit does not have
  TextureOperand, ///< a coordinate moved to a plain register
  TextureResult,  ///< mask, saturation, output or comparison of a sample
  Rectangle,      ///< texels scaled to [0,1] coordinates
  Position,       ///< computes fragment.position from the interpolated clip position
  Fog,            ///< the fog option's blend
  Output,         ///< a copy to a result register
  EmptyNode,      ///< a node needs an ALU slot
};

/// One half of a pair.
template <typename Op, typename Argument> struct Half {
  Op op = Op::None;
  std::array<Source, 3> sources;
  Presubtract presubtract = Presubtract::None;
  std::array<Argument, 3> arguments;
  std::uint16_t temporary = kNone; ///< written under `mask`
  std::uint8_t mask = 0;           ///< RGB: bits 0..2; alpha: bit 3
  std::uint8_t output = 0;         ///< colour target written under `outputMask`
  std::uint8_t outputMask = 0;     ///< the same bits as mask
  bool depth = false;              ///< alpha only: the result is the fragment's depth
  bool clamp = false;              ///< to [0,1], NaN to 0
  Modifier modifier = Modifier::One;
  std::uint16_t origin = kNone; ///< index into ir::Program::code
  Cause cause = Cause::Instruction;
};

/// An ALU slot. All sources are read before anything is written.
struct Pair {
  Half<RgbOp, RgbArgument> rgb;
  Half<AlphaOp, AlphaArgument> alpha;
};

enum class TexOp : std::uint8_t { Load, Project, Bias, Kill };

/// A TEX slot. It reads a whole register without a swizzle, and writes a whole register.
struct Texture {
  TexOp op = TexOp::Load;
  std::uint8_t unit = 0;
  ir::TexTarget target = ir::TexTarget::Tex2D;
  std::uint16_t source = 0;          ///< temporary
  std::uint16_t destination = kNone; ///< temporary; kNone for Kill
  std::uint16_t origin = kNone;
};

/// A block of TEX, then a block of ALU. Each TEX reads its source as it was at the start of the
/// node. The results are available to the node's ALU block and to later nodes.
struct Node {
  std::uint32_t firstTexture = 0, textures = 0;
  std::uint32_t firstPair = 0, pairs = 0;
};

/// A row of constant memory.
struct Constant {
  enum class Kind : std::uint8_t {
    Parameter,      ///< ir::Program::parameters[index]
    Value,          ///< a constant that the driver adds
    RectangleScale, ///< (1/width, 1/height, 1, 1) of image unit `index`
    ViewportScale,  ///< for fragment.position
    ViewportOffset,
    FogColor,   ///< for a fog option: state.fog.color
    FogFactors, ///< for a fog option, from state.fog.params, so that the factor takes one or two
                ///< slots: (-1/(end-start), end/(end-start), -density/ln 2, density/sqrt(ln 2))
  };
  Kind kind = Kind::Value;
  std::uint16_t index = 0;
  ir::Vec4 value = {};
  std::uint16_t origin = kNone; ///< the first instruction that needs it
};

/// Values of Interpolant::attribute for what an option reads and the program does not declare.
inline constexpr std::uint16_t kFogCoordinate = 0xFFFE;  ///< for a fog option
inline constexpr std::uint16_t kSecondaryColor = 0xFFFD; ///< for Options::colorSum

/// A register that the rasterizer fills before the first node.
struct Interpolant {
  /// Index into ir::Program::attributes, kFogCoordinate or kSecondaryColor.
  std::uint16_t attribute = 0;
  std::uint16_t temporary = 0;
  /// fragment.position arrives as the clip position, in the interpolator of a texture coordinate.
  /// The fog coordinate arrives as (f, 0, 0, 1) in another.
};

/// A whole program in the chip's form.
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
