#pragma once
#include <array>
#include <cstdint>

#include "fp_compiler/ir/interface.h"

/// The state of NV_register_combiners ("RC") and NV_register_combiners2 that decides what is
/// computed, as plain numbers: what lower() reads. Constant colours are parameters and no
/// part of it.
namespace arbiter::fp::combiners {

inline constexpr int kStages = 8;   ///< COMBINER0_NV to COMBINER7_NV
inline constexpr int kTextures = 8; ///< TEXTURE0_ARB to TEXTURE7_ARB

/// Table RC.1, the two pseudo-registers of the final combiner (3.8.12.3), and DISCARD_NV.
enum class Register : std::uint8_t {
  Zero,
  Constant0,
  Constant1,
  Fog,
  Primary,
  Secondary,
  Spare0,
  Spare1,
  Texture0, ///< and those that follow
  TexturesEnd = Texture0 + kTextures,
  ETimesF = TexturesEnd,
  Spare0PlusSecondary,
  Discard, ///< as an output
};
inline constexpr int kRegisters = int(Register::TexturesEnd);

[[nodiscard]] constexpr Register textureRegister(int unit) {
  return Register(int(Register::Texture0) + unit);
}
/// The unit of a texture register; -1 for any other.
[[nodiscard]] constexpr int textureUnit(Register name) {
  const int unit = int(name) - int(Register::Texture0);
  return unit >= 0 && unit < kTextures ? unit : -1;
}

/// Table RC.4, in the order of its enumerants. The final combiner has the first two.
enum class Mapping : std::uint8_t {
  UnsignedIdentity,
  UnsignedInvert,
  ExpandNormal,
  ExpandNegate,
  HalfBiasNormal,
  HalfBiasNegate,
  SignedIdentity,
  SignedNegate,
};
inline constexpr int kMappings = 8;

enum class Usage : std::uint8_t { Rgb, Alpha, Blue };
/// In the order of the enumerants, behind NONE.
enum class Scale : std::uint8_t { None, ByTwo, ByFour, ByOneHalf };

/// A variable's assignment.
struct Input {
  Register source = Register::Zero;
  Mapping mapping = Mapping::UnsignedIdentity;
  Usage usage = Usage::Rgb;
  bool operator==(const Input &) const = default;
};

/// One portion, RGB or alpha, of a general stage (3.8.12.2).
struct Portion {
  std::array<Input, 4> inputs; ///< A to D
  Register ab = Register::Discard;
  Register cd = Register::Discard;
  Register sum = Register::Spare0;
  Scale scale = Scale::None;
  bool bias = false; ///< by negative one half
  bool abDot = false;
  bool cdDot = false;
  bool mux = false;
  bool operator==(const Portion &) const = default;
};

/// Table RC.5.
[[nodiscard]] constexpr Portion initialPortion(Usage usage) {
  Portion portion;
  portion.inputs = {{{Register::Primary, Mapping::UnsignedIdentity, usage},
                     {Register::Zero, Mapping::UnsignedInvert, usage},
                     {Register::Zero, Mapping::UnsignedIdentity, usage},
                     {Register::Zero, Mapping::UnsignedIdentity, usage}}};
  return portion;
}

struct Stage {
  Portion rgb = initialPortion(Usage::Rgb);
  Portion alpha = initialPortion(Usage::Alpha);
  bool operator==(const Stage &) const = default;
};

/// What the combiners compute. Bytes without holes, to be compared and hashed as such.
struct State {
  std::array<Stage, kStages> stages;
  /// A to G, as in table RC.6.
  std::array<Input, 7> finals = {
      {{Register::Fog, Mapping::UnsignedIdentity, Usage::Alpha},
       {Register::Spare0PlusSecondary, Mapping::UnsignedIdentity, Usage::Rgb},
       {Register::Fog, Mapping::UnsignedIdentity, Usage::Rgb},
       {Register::Zero, Mapping::UnsignedIdentity, Usage::Rgb},
       {Register::Zero, Mapping::UnsignedIdentity, Usage::Rgb},
       {Register::Zero, Mapping::UnsignedIdentity, Usage::Rgb},
       {Register::Spare0, Mapping::UnsignedIdentity, Usage::Alpha}}};
  std::uint8_t count = 1; ///< NUM_GENERAL_COMBINERS_NV, 1 to kStages
  bool sumClamp = true;   ///< COLOR_SUM_CLAMP_NV
  bool perStageConstants = false;
  bool operator==(const State &) const = default;
};

/// The env parameter that holds CONSTANT_COLOR<which>_NV: the global one, or a stage's own.
[[nodiscard]] constexpr int globalConstant(int which) { return which; }
[[nodiscard]] constexpr int stageConstant(int stage, int which) { return 2 + 2 * stage + which; }
inline constexpr int kConstants = 2 + 2 * kStages;

/// What a texture register holds (table RC.2).
enum class Texel : std::uint8_t {
  None,  ///< no texture is enabled: undefined, zero here
  Color, ///< as the texture environments' own
  /// Of a depth texture: (0, 0, 0, D), or what a shadow target's comparison gives in all four. A
  /// sample has it in x, unless DEPTH_TEXTURE_MODE is ALPHA.
  Depth,
  DepthInAlpha ///< the same in w
};

/// The state of the rest of GL that the code depends on.
struct Surroundings {
  std::array<ir::TexTarget, kTextures> targets{}; ///< shadow targets compare
  std::array<Texel, kTextures> texels{};
  ir::FogMode fog = ir::FogMode::None; ///< FOG's mode where it is enabled
  bool fx9 = false;                    ///< numbers are those of Numerics::Fx9
  bool operator==(const Surroundings &) const = default;
};

/// The image units whose texture registers may be read as they are initialised, one bit each.
[[nodiscard]] std::uint32_t texturesRead(const State &state);

/// How many registers the active stages write.
[[nodiscard]] std::uint32_t registersWritten(const State &state);

/// The state with what it does not depend on as it is initially: stages that are not active, and
/// E and F where nothing reads their product.
[[nodiscard]] State essential(const State &state);

} // namespace arbiter::fp::combiners
