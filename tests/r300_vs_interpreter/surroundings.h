#pragma once
#include <vector>

#include "fp_compiler/ir/evaluate.h"

namespace arbiter::r300 {

/// What one fragment reads, made up of a number and of the bindings, in the ranges that tame
/// programs are made for. Serves ir::evaluate() and the chip's interpreter alike: a shadow target's
/// sample is the comparison with what the plain target gives.
class Surroundings {
public:
  Surroundings(const fp::ir::Program &program, std::uint64_t fragment);
  [[nodiscard]] const fp::ir::Inputs &inputs() const { return m_inputs; }
  /// The inputs refer to this.
  Surroundings(const Surroundings &) = delete;
  Surroundings &operator=(const Surroundings &) = delete;

private:
  std::vector<fp::ir::Vec4> m_attributes;
  fp::ir::Inputs m_inputs;
};

[[nodiscard]] fp::ir::Vec4 sampleTexture(const fp::ir::Sample &sample);

} // namespace arbiter::r300
