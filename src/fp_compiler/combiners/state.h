#pragma once
#include <array>
#include <cstdint>

#include "fp_compiler/ir/interface.h"

/// The state of NV_register_combiners ("RC") and NV_register_combiners2 that lower() depends on, as
/// plain numbers. Constant colours are parameters and not part of it.
namespace arbiter::fp::combiners {

inline constexpr int kStages = 8;   ///< COMBINER0_NV to COMBINER7_NV
inline constexpr int kTextures = 8; ///< TEXTURE0_ARB to TEXTURE7_ARB

/// Registers: table RC.1, the two pseudo-registers of the final combiner (3.8.12.3), and
/// DISCARD_NV.
enum class Register : std::uint8_t {
  Zero,
  Constant0,
  Constant1,
  Fog,
  Primary,
  Secondary,
  Spare0,
  Spare1,
  Texture0, ///< first of kTextures texture registers
  TexturesEnd = Texture0 + kTextures,
  ETimesF = TexturesEnd,
  Spare0PlusSecondary,
  Discard, ///< only as an output
};
inline constexpr int kRegisters = int(Register::TexturesEnd);

[[nodiscard]] constexpr Register textureRegister(int unit) {
  return Register(int(Register::Texture0) + unit);
}
/// Returns the unit of a texture register, or -1 for other registers.
[[nodiscard]] constexpr int textureUnit(Register name) {
  const int unit = int(name) - int(Register::Texture0);
  return unit >= 0 && unit < kTextures ? unit : -1;
}

/// Mappings of table RC.4, in the order of their enumerants. The final combiner has only the first
/// two.
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
/// Scales, in the order of the enumerants after NONE.
enum class Scale : std::uint8_t { None, ByTwo, ByFour, ByOneHalf };

/// The source of a variable.
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

/// Returns the initial state of a portion (table RC.5).
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

/// The state of all combiners. It has no padding, so that it can be compared and hashed as bytes.
struct State {
  std::array<Stage, kStages> stages;
  /// Variables A to G, as in table RC.6.
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

/// Returns the env parameter of CONSTANT_COLOR<which>_NV: the global one, or that of a stage.
[[nodiscard]] constexpr int globalConstant(int which) { return which; }
[[nodiscard]] constexpr int stageConstant(int stage, int which) { return 2 + 2 * stage + which; }
inline constexpr int kConstants = 2 + 2 * kStages;

/// The contents of a texture register (table RC.2).
enum class Texel : std::uint8_t {
  None,  ///< no texture is enabled: undefined, zero here
  Color, ///< as for texture environments
  /// Depth texture: (0, 0, 0, D), or the comparison's result in all four components. A sample has
  /// it in x, unless DEPTH_TEXTURE_MODE is ALPHA.
  Depth,
  DepthInAlpha ///< as Depth, but the sample has it in w
};

/// The other GL state that the code depends on.
struct Surroundings {
  std::array<ir::TexTarget, kTextures> targets{}; ///< shadow targets compare
  std::array<Texel, kTextures> texels{};
  ir::FogMode fog = ir::FogMode::None; ///< FOG_MODE, or None if fog is disabled
  bool fx9 = false;                    ///< use the numbers of Numerics::Fx9
  bool operator==(const Surroundings &) const = default;
};

/// Returns the image units whose initial texture registers may be read, one bit each.
[[nodiscard]] std::uint32_t texturesRead(const State &state);

/// Returns the number of registers that the active stages write.
[[nodiscard]] std::uint32_t registersWritten(const State &state);

/// Returns the state with irrelevant parts reset to their initial values: inactive stages, and E
/// and F if nothing reads their product.
[[nodiscard]] State essential(const State &state);

} // namespace arbiter::fp::combiners
