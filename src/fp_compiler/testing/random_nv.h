#pragma once
#include <cstdint>
#include <string>

#include "fp_compiler/ir/interface.h"

namespace arbiter::fp::testing {

struct RandomNvOptions {
  bool vertex = false;
  ir::NvOption option = ir::NvOption::Second;
  /// Allows operands outside of functions' domains and results of any size. Nothing is sampled at
  /// them.
  bool wild = false;
  bool textures = true;
  /// How many units a vertex program samples, from 0 on, each with its target of kUnitTargets.
  /// Fragment programs sample unit 0.
  int vertexUnits = 1;
  /// Leaves out where NVIDIA's driver differs from the specifications, or makes a choice that
  /// others may not (docs/write/nv_programs.md):
  /// - It rounds to half and fixed precision, which are only minimum requirements.
  /// - PUSHA and POPA end its compiler or its draws.
  /// - It reads other memory beyond an array and in registers that nothing wrote.
  /// - It sets condition codes before it clamps. KIL of a vector sets them too.
  /// - It does not clamp SSG.
  /// - It does not take BRA, BRK and RET by any of several components.
  /// - It writes X2D's result while it reads.
  /// - It ignores the level of TXB in vertex programs.
  /// - It leaves the other components of an indexed result undefined.
  /// - It loses the sign of constants in condition codes.
  /// - After a subroutine that sets a condition, it uses the value from before the call.
  /// - It makes a branch of a derivative with a condition.
  bool peer = false;
  /// Allows DDX and DDY also where fragments of a quad may have left the loop, which hosts leave
  /// undefined.
  bool loopDerivatives = false;
  int statements = 20; ///< in the main part, including those of blocks
};

/// Returns the text of a program under one of NVIDIA's options. It has suffixes, condition codes
/// with swizzles and masks, nested blocks, loops, subroutines, and branches (backward ones a few
/// times). It also has chains of packing, vectors of addresses with their stack, and indexed
/// attributes and results. Every run ends. Without `wild`, values stay moderate and divisors away
/// from 0. It assumes that program.local[0] to [7] are in [-2, 2], and that texture unit 0 has a 2D
/// texture. A vertex program does not move the vertex.
[[nodiscard]] std::string randomNvProgram(std::uint64_t seed, const RandomNvOptions &options = {});

} // namespace arbiter::fp::testing
