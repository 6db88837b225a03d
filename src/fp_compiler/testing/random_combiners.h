#pragma once
#include <cstdint>

#include "fp_compiler/combiners/state.h"
#include "fp_compiler/testing/random.h"

/// Random states of register combiners, as the commands of NV_register_combiners and 2 can set
/// them, from a seed and the same on every machine.
namespace arbiter::fp::testing {

struct RandomCombinersOptions {
  int stages = combiners::kStages;  ///< general stages that there are
  int units = combiners::kTextures; ///< that have a register
  std::uint8_t textures = 0xFF;     ///< registers that inputs name, bit 0 = unit 0
};

/// No register is read that is undefined.
[[nodiscard]] combiners::State randomCombiners(Random &random,
                                               const RandomCombinersOptions &options = {});

} // namespace arbiter::fp::testing
