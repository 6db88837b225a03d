#pragma once
#include "fp_compiler/testing/evaluate_texture_shaders.h"

/// The rules of consistency as 3.8.13.1 words them, section by section: the second reading's, apart
/// from fp_compiler/texture_shader/operations.h.
namespace arbiter::fp::texture_shader {

enum class ResultType : std::uint8_t { Invalid, Float, Colors, Hilo, Offsets };

/// A texture shader result, or what one is without its value.
struct Result {
  ResultType type = ResultType::Invalid;
  Base base = Base::None;
  Signs signs = Signs::Unsigned;
  Color value{};
};

/// SHADER_CONSISTENT_NV of a unit.
[[nodiscard]] bool isConsistent(const State &state, int unit);
/// What the result of a consistent stage is, without its value.
[[nodiscard]] Result kindOfResult(const State &state, int unit);

} // namespace arbiter::fp::texture_shader
