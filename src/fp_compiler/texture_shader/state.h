#pragma once
#include <array>
#include <cstdint>

#include "fp_compiler/combiners/state.h"
#include "fp_compiler/ir/interface.h"

/// The state of NV_texture_shader ("TS"), NV_texture_shader2 ("TS2") and NV_texture_shader3 ("TS3")
/// that resolve() and lower() depend on, as plain bytes. Matrices, scales, biases and eye vectors
/// are parameters and not part of it.
namespace arbiter::fp::texture_shader {

inline constexpr int kUnits = 8; ///< texture units, each with a stage

/// SHADER_OPERATION_NV, in the order of sections 3.8.13.1.1 to 3.8.13.1.37.
enum class Operation : std::uint8_t {
  None,
  Texture1D,
  Texture2D,
  TextureRectangle,
  TextureCubeMap,
  PassThrough,
  CullFragment,
  Offset2D,
  Offset2DScale,
  OffsetRectangle,
  OffsetRectangleScale,
  DependentAR2D,
  DependentGB2D,
  DotProduct,
  DotProduct2D,
  DotProductRectangle,
  DotProductCubeMap,
  DotProductReflectCubeMap,
  DotProductConstEyeReflectCubeMap,
  DotProductDiffuseCubeMap,
  DotProductDepthReplace,
  Texture3D,    // TS2
  DotProduct3D, // TS2
  OffsetProjective2D,
  OffsetProjective2DScale,
  OffsetProjectiveRectangle,
  OffsetProjectiveRectangleScale,
  OffsetHilo2D,
  OffsetHiloRectangle,
  OffsetHiloProjective2D,
  OffsetHiloProjectiveRectangle,
  DependentHilo2D,
  DependentRgb3D,
  DependentRgbCubeMap,
  DotProductPassThrough,
  DotProduct1D,
  DotProductAffineDepthReplace,
};
inline constexpr int kOperations = 37;

/// RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV.
enum class Mapping : std::uint8_t { UnsignedIdentity, ExpandNormal, ForceBlueToOne };

/// The stage of one unit.
struct Stage {
  Operation operation = Operation::None;
  std::uint8_t previous = 0; ///< PREVIOUS_TEXTURE_INPUT_NV, the number of a unit
  std::uint8_t cullLess = 0; ///< CULL_MODES_NV: bit i is set for LESS of component i, else GEQUAL
  Mapping mapping = Mapping::UnsignedIdentity;
  bool operator==(const Stage &) const = default;
};

/// The base internal format of a texture (table 3.15).
enum class Base : std::uint8_t {
  None, ///< the target is not consistent, so that no texture can be sampled
  Alpha,
  Luminance,
  LuminanceAlpha,
  Intensity,
  Rgb,
  Rgba,
  Hilo,
  Dsdt,
  DsdtMag,
  DsdtMagIntensity,
  Dudv, ///< from ATI_envmap_bumpmap
};
/// The signedness of a texture's components.
enum class Signs : std::uint8_t {
  Unsigned,
  Signed,
  SignedRgb, ///< signed red, green and blue, and unsigned alpha
};

/// The texture of a stage's target.
struct Texture {
  Base base = Base::None;
  Signs signs = Signs::Unsigned;
  bool compares = false; ///< a depth texture with TEXTURE_COMPARE_MODE
  bool operator==(const Texture &) const = default;
};
/// True for format type RGBA in the consistency rules, which includes ALPHA, LUMINANCE and
/// INTENSITY. DSDT_MAG_INTENSITY is not one, though texture environments read it so.
[[nodiscard]] constexpr bool isRgba(Base base) { return base >= Base::Alpha && base <= Base::Rgba; }

/// The stages and their textures. It has no padding, so that it can be compared and hashed as
/// bytes.
struct State {
  std::array<Stage, kUnits> stages;
  std::array<Texture, kUnits> textures;
  /// ATI_envmap_bumpmap with conventional texturing. A unit that bumps adds its rotated texel to
  /// the coordinates of another unit, its target. The entry is 1 plus the target's number, or 0 if
  /// the unit does not bump.
  std::array<std::uint8_t, kUnits> bumps{};
  std::uint8_t units = kUnits; ///< number of units
  /// True for conventional texturing (TEXTURE_SHADER_NV disabled) expressed as stages. A texel of
  /// an ALPHA texture is then (0, 0, 0, A). In texture shaders it is (1, 1, 1, A).
  bool conventional = false;
  bool operator==(const State &) const = default;
};

/// Returns the state with irrelevant parts reset to their initial values. Inconsistent stages
/// become NONE, and fields that an operation does not read get their default.
[[nodiscard]] State essential(const State &state);

/// The env parameters of a unit. Register combiners have the numbers before them. Each unit has
/// three in a row: OFFSET_TEXTURE_MATRIX_NV as (a1, a2, a3, a4), then (OFFSET_TEXTURE_SCALE_NV,
/// OFFSET_TEXTURE_BIAS_NV), then CONST_EYE_NV. BUMP_ROT_MATRIX_ATI as (r00, r01, r10, r11) comes
/// after those of all units, one row for each. Program texts cannot set it.
enum class Row : std::uint8_t { Matrix, ScaleBias, Eye, Bump };
inline constexpr int kRows = 4;
[[nodiscard]] constexpr int parameter(int unit, Row row) {
  return combiners::kConstants + (row == Row::Bump ? 3 * kUnits + unit : 3 * unit + int(row));
}
inline constexpr int kParameters = combiners::kConstants + kRows * kUnits;

} // namespace arbiter::fp::texture_shader
