#pragma once
#include <string>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/numerics.h"

namespace arbiter::fp::glsl {

/// Returns GLSL text that defines the helper functions which \p code calls: arb_address() for ARL,
/// arb_log() for LOG, and those of the modes of arithmetic:
///  arb_mul(a, b)   product where either factor may be zero and the other infinite or NaN
///  arb_mulz(z, x)  product where only z may be zero
///  arb_sum(v)      the components' sum, and arb_sum(v, w) DPH's, in the order of ir/semantics.h
///  arb_round(x)    fp24::rounded(), arb_truncate(x) fp24::truncated(), arb_colour(x)
///                  fp24::colour(), arb_pow(a, b) POW's three steps
/// \param numerics the arithmetic that the program follows
[[nodiscard]] std::string helpers(const ir::Program &program, Numerics numerics,
                                  const std::string &code);

} // namespace arbiter::fp::glsl
