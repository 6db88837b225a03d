#pragma once
#include <memory>
#include <string>

#include "fp_compiler/jit.h"
#include "fp_compiler/jit_boundary.h"

namespace arbiter::fp::jit {

/// Returns an engine of the library behind the types of jit.h. Its results, including shapes and
/// programs, are in this side's memory. Returns null and a reason if the library makes none.
[[nodiscard]] std::unique_ptr<Engine> connect(const boundary::Interface &library,
                                              const EngineOptions &options, std::string &reason);

} // namespace arbiter::fp::jit
