#pragma once
#include <optional>

#include "fp_compiler/texture_shader/state.h"

/// What tables 3.A to 3.C say of each operation.
namespace arbiter::fp::texture_shader {

enum class Family : std::uint8_t {
  None,
  Texture,     ///< samples by the unit's own coordinates
  PassThrough, ///< coordinates become a colour
  Cull,
  Offset,    ///< samples by coordinates that a previous result moves
  Dependent, ///< samples by a previous result
  Dot,       ///< a dot product with a previous result, alone
  DotSample, ///< samples by dot products
  Reflect,
  Diffuse,
  DotColor, ///< a dot product becomes a colour
  DotDepth, ///< the fragment's depth
};

struct OperationInfo {
  Family family = Family::None;
  std::optional<ir::TexTarget> target = {};
  std::uint8_t dots = 0;   ///< dot products: its own, and those of the stages before it
  bool projective = false; ///< Offset: the coordinates are divided by q
  bool scale = false;      ///< Offset: the magnitude scales the colour
  bool hilo = false;       ///< Offset and Dependent: of a HILO result
  /// The first unit that may have it (3.8.13.2).
  std::uint8_t firstUnit = 0;
};

[[nodiscard]] const OperationInfo &infoOf(Operation operation);

/// Reads the result of the stage that PREVIOUS_TEXTURE_INPUT_NV names.
[[nodiscard]] constexpr bool readsPrevious(Family family) { return family >= Family::Offset; }
/// Computes a dot product of its own.
[[nodiscard]] constexpr bool computesDot(Family family) { return family >= Family::Dot; }

/// The stages of `state` that are consistent, one bit a unit (3.8.13.1).
[[nodiscard]] std::uint32_t consistentStages(const State &state);

/// What a consistent stage's shader result is: base and signedness; Base::None where it is invalid
/// or a floating-point value.
[[nodiscard]] Texture resultOf(const State &state, int unit);

} // namespace arbiter::fp::texture_shader
