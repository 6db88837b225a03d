#pragma once
#include <memory>
#include <string>

#include "fp_compiler/jit.h"
#include "fp_compiler/jit_boundary.h"

namespace arbiter::fp::jit {

/// An engine of the library's behind the types of jit.h. What it answers, shapes and programs
/// included, is memory of this side. Null, with a reason, where the library makes none.
[[nodiscard]] std::unique_ptr<Engine> connect(const boundary::Interface &library,
                                              const EngineOptions &options, std::string &reason);

} // namespace arbiter::fp::jit
