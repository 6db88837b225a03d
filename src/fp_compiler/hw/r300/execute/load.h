#pragma once
#include "fp_compiler/hw/r300/machine.h"
#include "fp_compiler/ir/evaluate.h"

/// Sets the state before the first node: constant memory and interpolants, in the forms that
/// execute.h describes.
namespace arbiter::fp::hw::r300 {

struct Surroundings {
  const ir::Program &program;
  const ir::Inputs &inputs;
  Numerics numerics;
};

[[nodiscard]] ir::Vec4 constantOf(const Constant &constant, const Surroundings &surroundings);
/// Returns the value of an interpolant.
/// \param attribute as in Interpolant
[[nodiscard]] ir::Vec4 interpolantOf(std::uint16_t attribute, const Surroundings &surroundings);

} // namespace arbiter::fp::hw::r300
