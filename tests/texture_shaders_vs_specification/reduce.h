#pragma once
#include "fp_compiler/testing/evaluate_texture_shaders.h"
#include "fp_compiler/texture_shader/environment.h"

/// A state that differs is cut down to what it takes to differ.
namespace shaded {

/// What may be made simpler of a scene.
struct Kept {
  arbiter::fp::texture_shader::State state;
  arbiter::fp::texture_shader::Environments environments;
};

/// How many parts of a state there are that may be simpler.
[[nodiscard]] int partsOf(const arbiter::fp::texture_shader::State &state);
/// Makes one of them simpler; false where it was as simple, or there is none.
bool simplify(Kept &kept, int part);

/// Prints a state by the numbers of its enumerations, and what its units give a fragment.
void describe(const Kept &kept, bool withEnvironments,
              const arbiter::fp::texture_shader::Evaluated &evaluated);

} // namespace shaded
