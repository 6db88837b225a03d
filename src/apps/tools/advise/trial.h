#pragma once
#include <cstdint>

#include "apps/tools/advise/proposal.h"
#include "fp_compiler/ir/evaluate.h"

/// Tests whether a program and its rewritten form give the same results in the interpreter.
namespace arbiter::tools::advise {

/// The number of inputs on which a rewrite is tested before it is offered.
inline constexpr std::uint32_t kTrials = 256;

/// True if two results count as equal. Exact requires equal numbers; zeros of both signs are equal,
/// and so are NaNs. Rounding allows a difference of 2^-14, relative to the larger of 1 and the
/// numbers.
[[nodiscard]] bool near(float a, float b, Nearness nearness);

/// True if both programs give equal results on generated inputs, from number \p first on.
/// Attributes, parameters and texels depend only on that number and the binding. Their ranges are
/// typical of programs of the time: [0,1] for colors and texels, [-2,2] for parameters, [0,1024]
/// for window positions. Texture coordinates are in [-1.5,2.5], and their q in [0.5,2]. One
/// component in eight is 0, 1/2, 1, 2 or -1 if its range allows it. Textures are continuous
/// functions of the coordinate. Inputs with a discarded fragment do not count; if nearly all are
/// discarded, the result is false. \param derived inputs of the rewritten program that are
/// registers of the original
[[nodiscard]] bool equal(const fp::ir::Program &original, const fp::ir::Program &rewritten,
                         const std::vector<Derived> &derived, Nearness nearness,
                         std::uint64_t first = 0, std::uint32_t count = kTrials);

} // namespace arbiter::tools::advise
