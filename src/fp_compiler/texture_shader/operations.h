#pragma once
#include <optional>

#include "fp_compiler/texture_shader/state.h"

/// Groups of operations with common rules (tables 3.A to 3.C).
namespace arbiter::fp::texture_shader {

enum class Family : std::uint8_t {
  None,
  Texture,     ///< samples at the unit's own coordinates
  PassThrough, ///< turns coordinates into a colour
  Cull,
  Offset,    ///< samples at coordinates offset by an earlier result
  Dependent, ///< samples at an earlier result
  Dot,       ///< only computes a dot product with an earlier result
  DotSample, ///< samples at dot products
  Reflect,
  Diffuse,
  DotColor, ///< turns a dot product into a colour
  DotDepth, ///< replaces the fragment's depth
};

struct OperationInfo {
  Family family = Family::None;
  std::optional<ir::TexTarget> target = {};
  std::uint8_t dots = 0;   ///< number of dot products, including those of the stages before it
  bool projective = false; ///< Offset: divides the coordinates by q
  bool scale = false;      ///< Offset: scales the colour by the magnitude
  bool hilo = false;       ///< Offset and Dependent: reads a HILO result
  /// The first unit that may use the operation (3.8.13.2).
  std::uint8_t firstUnit = 0;
};

[[nodiscard]] const OperationInfo &infoOf(Operation operation);

/// True if the operation reads the result of the stage that PREVIOUS_TEXTURE_INPUT_NV names.
[[nodiscard]] constexpr bool readsPrevious(Family family) { return family >= Family::Offset; }
/// True if the operation computes a dot product of its own.
[[nodiscard]] constexpr bool computesDot(Family family) { return family >= Family::Dot; }

/// Returns the consistent stages of `state`, one bit for each unit (3.8.13.1).
[[nodiscard]] std::uint32_t consistentStages(const State &state);

/// Returns the format of a consistent stage's shader result. The base is Base::None if the result
/// is invalid or a floating-point value.
[[nodiscard]] Texture resultOf(const State &state, int unit);

} // namespace arbiter::fp::texture_shader
