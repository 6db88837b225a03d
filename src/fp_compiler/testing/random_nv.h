#pragma once
#include <cstdint>
#include <string>

#include "fp_compiler/ir/interface.h"

namespace arbiter::fp::testing {

struct RandomNvOptions {
  bool vertex = false;
  ir::NvOption option = ir::NvOption::Second;
  /// Operands outside of functions' domains and results of any size; nothing is sampled at them.
  bool wild = false;
  bool textures = true;
  /// Units 0 and up that a vertex program samples, each with its target of kUnitTargets; fragment
  /// programs sample unit 0.
  int vertexUnits = 1;
  /// Without what NVIDIA's driver does otherwise than the specifications say, or than others may:
  /// it rounds to half and fixed precision, which are the least that is asked for, PUSHA and POPA
  /// end its compiler or its draws, beyond an array and in registers that nothing wrote it reads
  /// other memory, it sets condition codes before it clamps, and KIL of a vector sets them too, it
  /// clamps no SSG, does not take BRA, BRK and RET by any of several components, writes the X2D's
  /// result while it reads, ignores the level of TXB in vertex programs, leaves the rest of an
  /// indexed result undefined, loses the sign of constants in condition codes, takes a condition
  /// for what it was before a subroutine that sets it, and makes a branch of a derivative with one
  /// (docs/write/nv_programs.md).
  bool peer = false;
  /// DDX and DDY also where fragments of a quad may have left the loop: undefined on hosts.
  bool loopDerivatives = false;
  int statements = 20; ///< of the main part, those of blocks included
};

/// The text of a program under one of NVIDIA's options: suffixes, condition codes with swizzles and
/// masks, blocks in blocks, loops, subroutines, branches (backward ones a few times), chains of
/// packing, vectors of addresses with their stack, indexed attributes and results. Every run of it
/// ends. Without `wild` values stay moderate and divisors away from 0; program.local[0] to [7] are
/// taken to be in [-2, 2], texture unit 0 to be a 2D one. A vertex program leaves the vertex where
/// it is.
[[nodiscard]] std::string randomNvProgram(std::uint64_t seed, const RandomNvOptions &options = {});

} // namespace arbiter::fp::testing
