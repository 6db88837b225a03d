#pragma once
#include "fp_compiler/testing/evaluate_texture_shaders.h"

/// The consistency rules as 3.8.13.1 words them, section by section. This implementation for tests
/// shares nothing with fp_compiler/texture_shader/operations.h.
namespace arbiter::fp::texture_shader {

enum class ResultType : std::uint8_t { Invalid, Float, Colors, Hilo, Offsets };

/// A texture shader result, or its kind without a value.
struct Result {
  ResultType type = ResultType::Invalid;
  Base base = Base::None;
  Signs signs = Signs::Unsigned;
  Color value{};
};

/// Returns SHADER_CONSISTENT_NV of a unit.
[[nodiscard]] bool isConsistent(const State &state, int unit);
/// Returns the kind of a consistent stage's result.
[[nodiscard]] Result kindOfResult(const State &state, int unit);

} // namespace arbiter::fp::texture_shader
