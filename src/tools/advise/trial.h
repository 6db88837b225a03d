#pragma once
#include <cstdint>

#include "fp_compiler/ir/evaluate.h"
#include "tools/advise/proposal.h"

/// Runs a program and its rewritten form in the interpreter on the same inputs.
namespace arbiter::tools::advise {

/// Inputs that a rewrite is tried on before it is offered.
inline constexpr std::uint32_t kTrials = 256;

/// Results that count as equal. Exact: the same numbers, zeros of either sign being one and NaNs
/// too. Rounding: within 2^-14 of the larger of 1 and the numbers.
[[nodiscard]] bool near(float a, float b, Nearness nearness);

/// Whether both programs give equal results on the inputs number \p first and on: attributes,
/// parameters and texels made up from the number, the binding and nothing else, in the ranges that
/// programs of the time work in: colours and texels of [0,1], texture coordinates of [-1.5,2.5]
/// (q of [0.5,2]), window positions of [0,1024], parameters of [-2,2]. One component in eight is
/// 0, 1/2, 1, 2 or -1, where its range has them. Textures are continuous functions of the
/// coordinate. Inputs whose fragment is discarded do not count; if hardly one is not, the answer is
/// no.
/// \param derived inputs of the rewritten program that are registers of the original
[[nodiscard]] bool equal(const fp::ir::Program &original, const fp::ir::Program &rewritten,
                         const std::vector<Derived> &derived, Nearness nearness,
                         std::uint64_t first = 0, std::uint32_t count = kTrials);

} // namespace arbiter::tools::advise
