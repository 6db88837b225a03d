#pragma once
#include <array>
#include <functional>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/texture_shader/state.h"

/// Texture environments (OpenGL 1.4, 3.8.13) as NV_texture_shader amends them for signed textures
/// (3.8.9), with those of ARB_texture_env_combine, ATI_texture_env_combine3 and
/// NV_texture_env_combine4.
namespace arbiter::fp::texture_shader {

enum class EnvironmentMode : std::uint8_t { None, Replace, Modulate, Decal, Blend, Add, Combine };

/// Functions of COMBINE_RGB and COMBINE_ALPHA. Those with four arguments are from COMBINE4_NV.
enum class CombineFunction : std::uint8_t {
  Replace,
  Modulate,
  Add,
  AddSigned,
  Interpolate,
  Subtract,
  Dot3Rgb,
  Dot3Rgba,
  ModulateAdd,
  ModulateSignedAdd,
  ModulateSubtract,
  AddProducts,
  AddSignedProducts,
  BumpEnvmap, ///< ATI_envmap_bumpmap, COMBINE_RGB only: the colour is passed on
};
[[nodiscard]] int argumentsOf(CombineFunction function);

/// The source of an argument. Values from Unit0 on name the texture of a unit.
enum class CombineSource : std::uint8_t { Texture, Constant, Primary, Previous, Zero, One, Unit0 };

struct CombineArgument {
  CombineSource source = CombineSource::Texture;
  bool alpha = false;
  bool complement = false;
  bool operator==(const CombineArgument &) const = default;
};

/// The RGB or alpha half of COMBINE.
struct CombineHalf {
  CombineFunction function = CombineFunction::Modulate;
  std::uint8_t scale = 1; ///< 1, 2 or 4
  std::array<CombineArgument, 4> arguments{};
  bool operator==(const CombineHalf &) const = default;
};

struct Environment {
  EnvironmentMode mode = EnvironmentMode::None;
  CombineHalf color, alpha;
  bool operator==(const Environment &) const = default;
};
using Environments = std::array<Environment, kUnits>;

/// Returns the texture unit RGBA result of a unit.
using UnitColor = std::function<ir::Source(int unit)>;

/// Emits the colour after all environments. An environment counts as NONE if its unit's base is
/// None, HILO, or a texture offset format without intensity.
[[nodiscard]] ir::Source writeEnvironments(ir::Builder &builder, const Environments &environments,
                                           const std::array<Base, kUnits> &bases,
                                           const UnitColor &texel);

} // namespace arbiter::fp::texture_shader
