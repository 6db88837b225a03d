#pragma once
#include <vector>

#include "fp_compiler/ir/evaluate.h"

namespace arbiter::r300 {

/// The inputs of one fragment, derived from a number and the bindings, in the ranges of tame
/// programs. ir::evaluate() and the chip's interpreter use the same: a shadow target's sample is
/// the comparison with the plain target's.
class Surroundings {
public:
  Surroundings(const fp::ir::Program &program, std::uint64_t fragment);
  [[nodiscard]] const fp::ir::Inputs &inputs() const { return m_inputs; }
  /// Copying is disabled because the inputs refer to this object.
  Surroundings(const Surroundings &) = delete;
  Surroundings &operator=(const Surroundings &) = delete;

private:
  std::vector<fp::ir::Vec4> m_attributes;
  fp::ir::Inputs m_inputs;
};

[[nodiscard]] fp::ir::Vec4 sampleTexture(const fp::ir::Sample &sample);

} // namespace arbiter::r300
