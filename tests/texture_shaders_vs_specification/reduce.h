#pragma once
#include "fp_compiler/testing/evaluate_texture_shaders.h"
#include "fp_compiler/texture_shader/environment.h"

/// Reduces a state that differs to what is needed to differ.
namespace shaded {

/// The parts of a scene that may be simplified.
struct Kept {
  arbiter::fp::texture_shader::State state;
  arbiter::fp::texture_shader::Environments environments;
};

/// Returns how many parts of a state may be simplified.
[[nodiscard]] int partsOf(const arbiter::fp::texture_shader::State &state);
/// Simplifies one part; returns false if it was as simple already, or does not exist.
bool simplify(Kept &kept, int part);

/// Prints a state by its enumerators' numbers, and its units' results for a fragment.
void describe(const Kept &kept, bool withEnvironments,
              const arbiter::fp::texture_shader::Evaluated &evaluated);

} // namespace shaded
