#pragma once
#include <cstdint>

#include "fp_compiler/combiners/state.h"
#include "fp_compiler/testing/random.h"

/// Random states of register combiners that the commands of NV_register_combiners and
/// NV_register_combiners2 can set. A seed gives the same state on every machine.
namespace arbiter::fp::testing {

struct RandomCombinersOptions {
  int stages = combiners::kStages;  ///< general stages in the state
  int units = combiners::kTextures; ///< units with a texture register
  std::uint8_t textures = 0xFF;     ///< texture registers that inputs may read; bit 0 is unit 0
};

/// Returns a state that reads no undefined register.
[[nodiscard]] combiners::State randomCombiners(Random &random,
                                               const RandomCombinersOptions &options = {});

} // namespace arbiter::fp::testing
