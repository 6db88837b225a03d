// A libarbiter_jit.so of another version, with the right name and functions that must never be
// called.
#include <cstdlib>

#include "fp_compiler/jit_boundary.h"
#include "fp_compiler/jit_version.h"

namespace {

using namespace arbiter::fp::jit::boundary;

/// Stands for any function of the interface.
template <typename Result, typename... Arguments> Result never(Arguments...) { std::abort(); }

constexpr Interface kOther = {kVersion ^ 1, never, never, never, never, never, never, never, never,
                              never,        never, never, never, never, never, never, never};

} // namespace

extern "C" __attribute__((visibility("default"))) const Interface *arbiter_jit_interface() {
  return &kOther;
}
